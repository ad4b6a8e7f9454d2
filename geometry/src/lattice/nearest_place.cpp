#include "hwffd/lattice/nearest_place.hpp"

#include <algorithm>
#include <limits>

#include "bounds.hpp"
#include "hwffd/lattice/closure.hpp"
#include "hwffd/on_threads.hpp"
#include "newton.hpp"

namespace hwffd {
namespace {

constexpr double kClose = 1e-7;  // of the size: how much nearer a place may be and be missed
constexpr int kMaxParts = 2000;
constexpr double kRightAngle = 1e-12;

bool has_right_angles(const Box& box) {
  const Eigen::Matrix3d direction = box.edges().colwise().normalized();
  return (direction.transpose() * direction).isIdentity(kRightAngle);
}

Lattice relative_to(const Point& centre, const Lattice& lattice) {
  return Lattice(lattice.dims(), lattice.points().rowwise() - centre.transpose());
}

/// Whether the lattice is joined to itself at the ends of an axis, so that nothing ends there.
bool joined(const Closure& closure, int axis, int end) {
  const auto here = [&](const Closure::Collapsed& face) {
    return face.axis == axis && face.end == end;
  };
  return closure.closed(axis) ||
         std::any_of(closure.collapsed().begin(), closure.collapsed().end(), here);
}

/// A patch of a face: its corner nearest to s = t = u = 0, and its extent along s, t, u.
struct Patch {
  double bound;
  Index3 cell;
  BezierVolume hull;
  Eigen::Vector3d low;
  Eigen::Vector3d extent;

  Eigen::Vector3d middle() const { return low + extent / 2; }
  bool operator<(const Patch& other) const { return bound > other.bound; }  // heap: least on top
};

}  // namespace

NearestPlace::NearestPlace(const Lattice& lattice, const Family& family)
    : family_(family),
      box_(family.regular() ? Box::of(lattice) : std::nullopt),
      centre_(middle_of(lattice.points())),
      lattice_(relative_to(centre_, lattice)) {
  family.check_dims(lattice.dims());
  if (box_ && !has_right_angles(*box_)) box_.reset();
  if (box_) return;
  const Closure closure(lattice, family);
  const Index3 count = family.cells(lattice.dims());
  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  Point high = -low;
  for (const Index3& cell : places(count)) {
    Watch::look();
    const BezierVolume hull = BezierVolume::of_cell(support(cell));
    for (int f = 0; f < 6; ++f) {
      const int axis = f / 2;
      const int end = f % 2;
      const auto a = static_cast<std::size_t>(axis);
      if (cell[a] != end * (count[a] - 1)) continue;
      if (family.regular() && joined(closure, axis, end)) continue;
      BezierVolume face = hull.face(axis, end);
      const Point least = face.coefficients().colwise().minCoeff();
      const Point most = face.coefficients().colwise().maxCoeff();
      low = low.cwiseMin(least);
      high = high.cwiseMax(most);
      faces_.push_back({cell, axis, end, std::move(face), least, most});
    }
  }
  size_ = (high - low).maxCoeff();
}

/// The search for one point.
class NearestPlace::Search {
 public:
  Search(const NearestPlace& of, const Point& point) : of_(of), point_(point) {}

  /// @returns the place, relative to centre_
  Result run() {
    search_faces();
    std::make_heap(open_.begin(), open_.end());
    while (!open_.empty() && best_.parts < kMaxParts) {
      std::pop_heap(open_.begin(), open_.end());
      const Patch patch = std::move(open_.back());
      open_.pop_back();
      if (patch.bound >= limit()) break;
      split(patch);
    }
    return best_;
  }

 private:
  double limit() const { return best_.distance - kClose * of_.size_; }

  /// A lower bound of the distance: to the bounding box of the coefficients, and how far all of
  /// them lie beyond the point towards the best place and towards their own middle.
  double bound(const BezierVolume& hull) const {
    const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> arms =
        hull.coefficients().rowwise() - point_.transpose();
    const Eigen::RowVector3d low = arms.colwise().minCoeff();
    const Eigen::RowVector3d high = arms.colwise().maxCoeff();
    double result = low.cwiseMax(-high).cwiseMax(0.0).norm();
    const Eigen::RowVector3d middle = arms.colwise().mean();
    const Eigen::Vector3d to_best = best_.point - point_;
    for (const Eigen::Vector3d& way : {to_best, Eigen::Vector3d(middle)}) {
      const double length = way.norm();
      if (!(length > 0.0) || !std::isfinite(length)) continue;
      result = std::max(result, (arms * way).minCoeff() / length);
    }
    return result;
  }

  /// Newton's method in a cell from a place in it.
  void descend(const Index3& cell, const Support& support, const Eigen::Vector3d& start) {
    const Attempt attempt = nearest(oracle_, support, point_, start);
    if (attempt.residual >= best_.distance) return;
    best_.at = {cell, attempt.local, true};
    best_.distance = attempt.residual;
    best_.point = oracle_.evaluate(support, attempt.local[0], attempt.local[1], attempt.local[2]);
  }

  /// Searches all faces that may be nearer than the best place, the nearest first, from the middle
  /// of each; leaves them in open_.
  void search_faces() {
    std::vector<std::pair<double, const Face*>> order;
    for (const Face& face : of_.faces_) {
      order.emplace_back(distance_to_box(point_, face.low, face.high), &face);
    }
    std::sort(order.begin(), order.end());
    best_.distance = std::numeric_limits<double>::infinity();
    best_.point = Point::Constant(best_.distance);
    for (const auto& [distance, face] : order) {
      if (distance >= best_.distance) break;
      ++best_.parts;
      const double least = bound(face->hull);
      if (least >= best_.distance) continue;
      Patch patch{least, face->cell, face->hull, Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()};
      patch.low[face->axis] = face->end;
      patch.extent[face->axis] = 0.0;
      descend(face->cell, of_.support(face->cell), patch.middle());
      open_.push_back(std::move(patch));
    }
  }

  /// Quarters a patch; keeps the quarters that may be nearer than the best place.
  void split(const Patch& patch) {
    std::vector<Patch> patches{patch};
    for (int axis = 0; axis < 3; ++axis) {
      if (patch.extent[axis] == 0.0) continue;
      std::vector<Patch> halves;
      for (const Patch& whole : patches) {
        auto hulls = whole.hull.halves(axis);
        Patch half = whole;
        half.extent[axis] /= 2;
        half.hull = std::move(hulls[0]);
        halves.push_back(half);
        half.low[axis] += half.extent[axis];
        half.hull = std::move(hulls[1]);
        halves.push_back(std::move(half));
      }
      patches = std::move(halves);
    }
    const Support support = of_.support(patch.cell);
    for (Patch& quarter : patches) {
      ++best_.parts;
      quarter.bound = bound(quarter.hull);
      if (quarter.bound >= limit()) continue;
      const Eigen::Vector3d middle = quarter.middle();
      const Point there = oracle_.evaluate(support, middle[0], middle[1], middle[2]);
      if ((there - point_).norm() < best_.distance) descend(patch.cell, support, middle);
      open_.push_back(std::move(quarter));
      std::push_heap(open_.begin(), open_.end());
    }
  }

  const NearestPlace& of_;
  Oracle oracle_;
  Point point_;
  Result best_;
  std::vector<Patch> open_;
};

NearestPlace::Result NearestPlace::find(const Point& point) const {
  if (box_) {
    Result result;
    result.at = box_->embed(lattice_.dims(), point);
    result.at.local = result.at.local.cwiseMax(0.0).cwiseMin(1.0);
    result.at.inside = true;
    result.point = box_->point(lattice_.dims(), result.at);
    result.distance = (result.point - point).norm();
    return result;
  }
  Result result = Search(*this, point - centre_).run();
  result.point += centre_;
  return result;
}

}  // namespace hwffd
