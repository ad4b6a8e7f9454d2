#include "hwffd/lattice/embedder.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <limits>

#include "bounds.hpp"
#include "cell_search.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/coordinates.hpp"
#include "hwffd/on_threads.hpp"
#include "newton.hpp"

namespace hwffd {
namespace {

constexpr double kDone = 1e-14;       // residual at which Newton stops, of the size
constexpr double kTolerance = 1e-12;  // residual that counts as inside, of the size
constexpr double kFlat = 1e-9;        // least extent of a lattice, of its largest
constexpr std::size_t kNearCells = 4;
constexpr std::size_t kPointsOfABlock = 1 << 17;
constexpr std::size_t kPointsAtOnce = 64;  // points that a thread embeds at once
constexpr std::size_t kPointsOfABoxAtOnce = 1024;

}  // namespace

bool span_volume(const Points& points) {
  Eigen::ColPivHouseholderQR<Points> arms(points.rowwise() - points.colwise().mean());
  arms.setThreshold(kFlat);
  return arms.rank() == 3;
}

Embedder::Embedder(Lattice lattice, const Family& family)
    : lattice_(std::move(lattice)), family_(family) {
  family_.check_dims(lattice_.dims());
  if (family_.regular()) box_ = Box::of(lattice_);
  const Points& points = lattice_.points();
  if (!span_volume(points)) {
    throw Error("lattice at rest: its points lie in one plane and span no volume; give others");
  }
  centre_ = middle_of(points);
  if (box_) {
    const Family::Evaluable evaluable =
        family_.evaluable(Lattice(lattice_.dims(), points.rowwise() - centre_.transpose()));
    evaluator_.emplace(evaluable.lattice, evaluable.blending);
  }
  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  Point high = -low;
  for (const Index3& cell : places(family_.cells(lattice_.dims()))) {
    Watch::look();
    Support support = family_.support(lattice_, cell);
    support.rowwise() -= centre_.transpose();
    BezierVolume hull = BezierVolume::of_cell(support);
    const Point least = hull.coefficients().colwise().minCoeff();
    const Point most = hull.coefficients().colwise().maxCoeff();
    const Point middle = oracle_.evaluate(support, 0.5, 0.5, 0.5);
    low = low.cwiseMin(least);
    high = high.cwiseMax(most);
    cells_.push_back({cell, support, std::move(hull), least, most, middle});
  }
  size_ = (high - low).maxCoeff();
  // Far from the origin, points of the cells and points to embed are rounded themselves.
  const double farthest = points.cwiseAbs().maxCoeff();
  tolerance_ = kTolerance * size_ + 2 * std::numeric_limits<double>::epsilon() * farthest;
}

Point Embedder::point(const Embedded& at) const {
  const Index3 count = family_.cells(lattice_.dims());
  const int number = (at.cell[0] * count[1] + at.cell[1]) * count[2] + at.cell[2];
  const Support& support = cells_.at(static_cast<std::size_t>(number)).support;
  return centre_ + oracle_.evaluate(support, at.local[0], at.local[1], at.local[2]);
}

std::vector<const Embedder::Cell*> Embedder::candidates(const Point& point) const {
  std::vector<const Cell*> result;
  for (const Cell& cell : cells_) {
    if (distance_to_box(point, cell.low, cell.high) <= tolerance_) result.push_back(&cell);
  }
  std::sort(result.begin(), result.end(), [&](const Cell* a, const Cell* b) {
    return (point - a->middle).squaredNorm() < (point - b->middle).squaredNorm();
  });
  return result;
}

Embedding Embedder::outside(const Point& point) const {
  std::vector<const Cell*> near;
  for (const Cell& cell : cells_) near.push_back(&cell);
  const std::size_t tried = std::min(kNearCells, near.size());
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(tried), near.end(),
                    [&](const Cell* a, const Cell* b) {
                      return distance_to_box(point, a->low, a->high) <
                             distance_to_box(point, b->low, b->high);
                    });
  Embedding result;
  result.residual = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < tried; ++c) {
    const Attempt attempt =
        nearest(oracle_, near[c]->support, point, Eigen::Vector3d::Constant(0.5));
    if (attempt.residual >= result.residual) continue;
    result.at = {near[c]->index, attempt.local, false};
    result.residual = attempt.residual;
  }
  return result;
}

Embedding Embedder::embed_by_newton(const Point& point) const {
  const double done = kDone * size_;
  const std::vector<const Cell*> cells = candidates(point);
  int iterations = 0;
  const auto inside = [&](const Cell& cell, const Attempt& attempt) {
    return Embedding{
        {cell.index, attempt.local, true}, EmbeddingStatus::kInside, attempt.residual, iterations};
  };
  for (const Cell* cell : cells) {
    const Attempt attempt =
        newton(oracle_, cell->support, point, Eigen::Vector3d::Constant(0.5), done);
    iterations += attempt.iterations;
    if (attempt.residual <= tolerance_) return inside(*cell, attempt);
  }
  bool excluded = true;
  for (const Cell* cell : cells) {
    const CellSearch search =
        search_cell(oracle_, cell->support, cell->hull, point, done, tolerance_);
    iterations += search.iterations;
    if (search.outcome == CellSearch::Outcome::kFound) return inside(*cell, search.attempt);
    excluded = excluded && search.outcome == CellSearch::Outcome::kExcluded;
  }
  Embedding result = outside(point);
  result.iterations = iterations;
  result.status = excluded ? EmbeddingStatus::kOutside : EmbeddingStatus::kNotConverged;
  return result;
}

Embedding Embedder::embed(const Point& point) const {
  Embedding result;
  result.residual = std::numeric_limits<double>::infinity();
  if (!has_coordinates(point)) return result;
  if (!box_) return embed_by_newton(point - centre_);
  embed_in_box(point.transpose(), 0, 1, &result);
  return result;
}

void Embedder::embed_in_box(const Points& points, std::size_t first, std::size_t count,
                            Embedding* to) const {
  VertexArrays<double> there;
  there.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Point point = points.row(static_cast<Eigen::Index>(first + i));
    to[i] = Embedding{};
    if (has_coordinates(point)) to[i].at = box_->embed(lattice_.dims(), point);
    if (to[i].at.inside) to[i].status = EmbeddingStatus::kInside;
    there.origins[i] = evaluator_->origin(to[i].at.cell);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      there.local[axis][i] = to[i].at.local[static_cast<Eigen::Index>(axis)];
    }
  }
  evaluator_->evaluate(there);
  for (std::size_t i = 0; i < count; ++i) {
    const Point point = points.row(static_cast<Eigen::Index>(first + i));
    Point back = centre_ + Point(there.position[0][i], there.position[1][i], there.position[2][i]);
    // Beyond the cells by the map itself: the powers of coordinates far away overflow in eq. (1).
    if (!to[i].at.inside) back = box_->point(lattice_.dims(), to[i].at);
    to[i].residual =
        has_coordinates(point) ? (back - point).norm() : std::numeric_limits<double>::infinity();
  }
}

std::vector<Embedding> Embedder::embed(const Points& points) const {
  const auto count = static_cast<std::size_t>(points.rows());
  std::vector<Embedding> result;
  result.reserve(count);
  // Block by block, since to make room for millions takes time in which nobody looks at a Watch.
  for (std::size_t begin = 0; begin < count; begin = result.size()) {
    result.resize(std::min(count, begin + kPointsOfABlock));
    const std::size_t at_once = box_ ? kPointsOfABoxAtOnce : kPointsAtOnce;
    on_ranges(result.size() - begin, at_once, [&](std::size_t first, std::size_t end) {
      if (box_) return embed_in_box(points, begin + first, end - first, &result[begin + first]);
      for (std::size_t i = begin + first; i < begin + end; ++i) {
        result[i] = embed(Point(points.row(static_cast<Eigen::Index>(i))));
      }
    });
  }
  return result;
}

EmbeddingSummary summarize(const std::vector<Embedding>& embeddings) {
  EmbeddingSummary summary;
  summary.points = embeddings.size();
  double iterations = 0.0;
  for (const Embedding& e : embeddings) {
    if (e.status == EmbeddingStatus::kOutside) ++summary.outside;
    if (e.status == EmbeddingStatus::kNotConverged) ++summary.not_converged;
    if (e.status != EmbeddingStatus::kInside) continue;
    ++summary.inside;
    iterations += e.iterations;
    summary.worst_residual = std::max(summary.worst_residual, e.residual);
  }
  if (summary.inside > 0)
    summary.mean_iterations = iterations / static_cast<double>(summary.inside);
  return summary;
}

EmbeddingSummary joined(const EmbeddingSummary& a, const EmbeddingSummary& b) {
  EmbeddingSummary both;
  both.points = a.points + b.points;
  both.inside = a.inside + b.inside;
  both.outside = a.outside + b.outside;
  both.not_converged = a.not_converged + b.not_converged;
  both.worst_residual = std::max(a.worst_residual, b.worst_residual);
  if (both.inside > 0) {
    both.mean_iterations = (a.mean_iterations * static_cast<double>(a.inside) +
                            b.mean_iterations * static_cast<double>(b.inside)) /
                           static_cast<double>(both.inside);
  }
  return both;
}

}  // namespace hwffd
