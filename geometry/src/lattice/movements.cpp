#include "movements.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace hwffd {
namespace {

using Corners = Frame::Corners;

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;
constexpr double kRandomAmplitude = 0.3;  // of the spacing

Corners corners_of(const Lattice& lattice) {
  const Index3& d = lattice.dims();
  Corners corners;
  for (int c = 0; c < 8; ++c) {
    Index3 at = d;
    for (int a = 0; a < 3; ++a) {
      int& n = at[static_cast<std::size_t>(a)];
      n = Frame::at_end(c, a) ? n - 1 : 0;
    }
    corners.row(c) = lattice.point(at[0], at[1], at[2]);
  }
  return corners;
}

Points fractions_by_index(const Index3& dims) {
  Points fractions(static_cast<Eigen::Index>(dims[0]) * dims[1] * dims[2], 3);
  Eigen::Index row = 0;
  for (const auto& [i, j, k] : places(dims)) {
    fractions.row(row++) << i / (dims[0] - 1.0), j / (dims[1] - 1.0), k / (dims[2] - 1.0);
  }
  return fractions;
}

Eigen::Matrix3d turn_about(int axis, double degrees) {
  return Eigen::AngleAxisd(degrees * kRadiansPerDegree, Eigen::Vector3d::Unit(axis))
      .toRotationMatrix();
}

}  // namespace

Frame::Frame(const Lattice& lattice, const std::optional<Points>& joined, int up)
    : dims_(lattice.dims()), up_(up) {
  if (!joined) {
    corners_ = corners_of(lattice);
    fractions_ = fractions_by_index(dims_);
    return;
  }
  const Eigen::RowVector3d low = joined->colwise().minCoeff();
  const Eigen::RowVector3d extent = joined->colwise().maxCoeff() - low;
  for (int c = 0; c < 8; ++c) {
    const Eigen::RowVector3d end(at_end(c, 0), at_end(c, 1), at_end(c, 2));
    corners_.row(c) = low + end.cwiseProduct(extent);
  }
  // Along an axis without extent all are at the beginning.
  const Eigen::RowVector3d divisor = (extent.array() > 0.0).select(extent, 1.0);
  fractions_ = (lattice.points().rowwise() - low).array().rowwise() / divisor.array();
}

double Frame::level(bool top) const {
  double sum = 0.0;
  for (int c = 0; c < 8; ++c) {
    if (is_top(c) == top) sum += corners_(c, up_);
  }
  return sum / 4.0;
}

Eigen::Matrix3d Frame::spacing() const {
  Eigen::Matrix3d spacing = Eigen::Matrix3d::Zero();
  for (int c = 0; c < 8; ++c) {
    for (int a = 0; a < 3; ++a) {
      const double sign = at_end(c, a) ? 1.0 : -1.0;
      spacing.row(a) += sign * corners_.row(c) / (4.0 * (dims_[static_cast<std::size_t>(a)] - 1));
    }
  }
  return spacing;
}

void Frame::interpolate(Points& points, const Corners& displacement) const {
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d at = fractions_.row(i);
    for (int c = 0; c < 8; ++c) {
      double weight = 1.0;
      for (int a = 0; a < 3; ++a) weight *= at_end(c, a) ? at[a] : 1.0 - at[a];
      points.row(i) += weight * displacement.row(c);
    }
  }
}

void helix(Points& points, const Frame& frame, double degrees, const std::array<double, 2>& cells) {
  const Eigen::RowVector3d centre = frame.centre();
  const double height = cells[1] - cells[0];
  if (height == 0.0) return;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double part = (points(i, frame.up()) - cells[0]) / height;
    const Eigen::RowVector3d arm = points.row(i) - centre;
    points.row(i) = centre + arm * turn_about(frame.up(), part * degrees).transpose();
  }
}

void twist(Points& points, const Frame& frame, double degrees) {
  const Corners& corners = frame.corners();
  const Eigen::RowVector3d centre = frame.centre();
  const Eigen::Matrix3d turn = turn_about(frame.up(), degrees);
  Corners displacement = Corners::Zero();
  for (int c = 0; c < 8; ++c) {
    if (!frame.is_top(c)) continue;
    const Eigen::RowVector3d arm = corners.row(c) - centre;
    displacement.row(c) = arm * turn.transpose() - arm;
  }
  frame.interpolate(points, displacement);
}

void shear(Points& points, const Frame& frame, double amount) {
  const double lift = amount * frame.height();
  Corners displacement = Corners::Zero();
  for (int c = 0; c < 8; ++c) {
    if (!frame.is_top(c)) displacement(c, frame.up()) = Frame::at_end(c, 0) ? lift : -lift;
  }
  frame.interpolate(points, displacement);
}

void bend(Points& points, const Frame& frame, double degrees, int towards) {
  const double bottom = frame.bottom();
  const double height = frame.height();
  const double angle = degrees * kRadiansPerDegree;
  if (angle == 0.0 || height == 0.0) return;
  const double radius = height / angle;
  const int up = frame.up();
  const double middle = frame.centre()[towards];
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double turn = angle * (points(i, up) - bottom) / height;
    const double arm = radius - (points(i, towards) - middle);
    points(i, towards) = middle + radius - arm * std::cos(turn);
    points(i, up) = bottom + arm * std::sin(turn);
  }
}

void taper(Points& points, const Frame& frame, double factor) {
  const Eigen::RowVector3d centre = frame.centre();
  const double bottom = frame.bottom();
  const double height = frame.height();
  if (height == 0.0) return;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double growth = (factor - 1.0) * ((points(i, frame.up()) - bottom) / height);
    for (int a = 0; a < 3; ++a) {
      if (a != frame.up()) points(i, a) += growth * (points(i, a) - centre[a]);
    }
  }
}

void scale(Points& points, const Frame& frame, const Eigen::Vector3d& factors) {
  const Eigen::RowVector3d growth = factors.transpose().array() - 1.0;
  const Eigen::RowVector3d centre = frame.centre();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    points.row(i) += growth.cwiseProduct(points.row(i) - centre);
  }
}

void jitter(Points& points, const Frame& frame, std::uint64_t seed) {
  const Eigen::Matrix3d spacing = frame.spacing();
  std::mt19937_64 random(seed);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (int a = 0; a < 3; ++a) {
      const double unit = static_cast<double>(random() >> 11) * 0x1p-53;  // [0, 1)
      points.row(i) += kRandomAmplitude * (2.0 * unit - 1.0) * spacing.row(a);
    }
  }
}

}  // namespace hwffd
