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
    corners.row(c) =
        lattice.point((c >> 2 & 1) * (d[0] - 1), (c >> 1 & 1) * (d[1] - 1), (c & 1) * (d[2] - 1));
  }
  return corners;
}

Points fractions_by_index(const Index3& dims) {
  Points fractions(static_cast<Eigen::Index>(dims[0]) * dims[1] * dims[2], 3);
  Eigen::Index row = 0;
  for (int i = 0; i < dims[0]; ++i) {
    for (int j = 0; j < dims[1]; ++j) {
      for (int k = 0; k < dims[2]; ++k) {
        fractions.row(row++) << i / (dims[0] - 1.0), j / (dims[1] - 1.0), k / (dims[2] - 1.0);
      }
    }
  }
  return fractions;
}

}  // namespace

Frame::Frame(const Lattice& lattice, bool joined) : dims_(lattice.dims()) {
  if (!joined) {
    corners_ = corners_of(lattice);
    fractions_ = fractions_by_index(dims_);
    return;
  }
  const Eigen::RowVector3d low = lattice.points().colwise().minCoeff();
  const Eigen::RowVector3d extent = lattice.points().colwise().maxCoeff() - low;
  for (int c = 0; c < 8; ++c) {
    const Eigen::RowVector3d end(c >> 2 & 1, c >> 1 & 1, c & 1);
    corners_.row(c) = low + end.cwiseProduct(extent);
  }
  // Along an axis without extent all are at the beginning.
  const Eigen::RowVector3d divisor = (extent.array() > 0.0).select(extent, 1.0);
  fractions_ = (lattice.points().rowwise() - low).array().rowwise() / divisor.array();
}

double Frame::level(int top) const {
  double sum = 0.0;
  for (int c = 0; c < 8; ++c) {
    if ((c >> 1 & 1) == top) sum += corners_(c, 1);
  }
  return sum / 4.0;
}

Eigen::Matrix3d Frame::spacing() const {
  Eigen::Matrix3d spacing = Eigen::Matrix3d::Zero();
  for (int c = 0; c < 8; ++c) {
    for (int a = 0; a < 3; ++a) {
      const double sign = (c >> (2 - a) & 1) != 0 ? 1.0 : -1.0;
      spacing.row(a) += sign * corners_.row(c) / (4.0 * (dims_[static_cast<std::size_t>(a)] - 1));
    }
  }
  return spacing;
}

void Frame::interpolate(Points& points, const Corners& displacement) const {
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d at = fractions_.row(i);
    for (int c = 0; c < 8; ++c) {
      const double weight = ((c >> 2 & 1) != 0 ? at[0] : 1.0 - at[0]) *
                            ((c >> 1 & 1) != 0 ? at[1] : 1.0 - at[1]) *
                            ((c & 1) != 0 ? at[2] : 1.0 - at[2]);
      points.row(i) += weight * displacement.row(c);
    }
  }
}

void twist(Points& points, const Frame& frame, double degrees) {
  const Corners& corners = frame.corners();
  const Eigen::RowVector3d centre = frame.centre();
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(degrees * kRadiansPerDegree, Eigen::Vector3d::UnitY()).toRotationMatrix();
  Corners displacement = Corners::Zero();
  for (int c = 0; c < 8; ++c) {
    if ((c >> 1 & 1) == 0) continue;
    const Eigen::RowVector3d arm = corners.row(c) - centre;
    displacement.row(c) = arm * turn.transpose() - arm;
  }
  frame.interpolate(points, displacement);
}

void shear(Points& points, const Frame& frame, double amount) {
  const double lift = amount * frame.height();
  Corners displacement = Corners::Zero();
  for (int c = 0; c < 8; ++c) {
    if ((c >> 1 & 1) == 0) displacement(c, 1) = (c >> 2 & 1) != 0 ? lift : -lift;
  }
  frame.interpolate(points, displacement);
}

void bend(Points& points, const Frame& frame, double degrees) {
  const double bottom = frame.bottom();
  const double height = frame.height();
  const double angle = degrees * kRadiansPerDegree;
  if (angle == 0.0 || height == 0.0) return;
  const double radius = height / angle;
  const double middle = frame.centre()[0];
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double turn = angle * (points(i, 1) - bottom) / height;
    const double arm = radius - (points(i, 0) - middle);
    points(i, 0) = middle + radius - arm * std::cos(turn);
    points(i, 1) = bottom + arm * std::sin(turn);
  }
}

void taper(Points& points, const Frame& frame, double factor) {
  const Eigen::RowVector3d centre = frame.centre();
  const double bottom = frame.bottom();
  const double height = frame.height();
  if (height == 0.0) return;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double growth = (factor - 1.0) * ((points(i, 1) - bottom) / height);
    for (const int a : {0, 2}) points(i, a) += growth * (points(i, a) - centre[a]);
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
