#include "hwffd/lattice/deformation.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <charconv>
#include <cmath>
#include <random>

#include "hwffd/error.hpp"

namespace hwffd {
namespace {

using Kind = Deformation::Kind;

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;
constexpr double kRandomAmplitude = 0.3;  // of the spacing
constexpr const char* kAccepted =
    "accepted are none, twist:DEGREES, shear:AMOUNT, bend:DEGREES and random:SEED";

struct Entry {
  std::string_view name;
  Kind kind;
  double amount;
  std::uint64_t seed;
};
constexpr std::array<Entry, 5> kEntries{{{"none", Kind::kNone, 0.0, 0},
                                         {"twist", Kind::kTwist, 90.0, 0},
                                         {"shear", Kind::kShear, 0.5, 0},
                                         {"bend", Kind::kBend, 90.0, 0},
                                         {"random", Kind::kRandom, 0.0, 1}}};

/// Reads all of text as one number.
template <typename T>
bool read_number(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// The 8 corner points (or their displacements): corner (a, b, c), each 0 or 1 along s, t, u, is
/// row a*4 + b*2 + c.
using Corners = Eigen::Matrix<double, 8, 3, Eigen::RowMajor>;

Corners corners_of(const Lattice& lattice) {
  const Index3& d = lattice.dims();
  Corners corners;
  for (int c = 0; c < 8; ++c) {
    corners.row(c) =
        lattice.point((c >> 2 & 1) * (d[0] - 1), (c >> 1 & 1) * (d[1] - 1), (c & 1) * (d[2] - 1));
  }
  return corners;
}

/// Moves every point by the trilinear interpolation of the corners' displacements.
Points move_by_corners(const Lattice& lattice, const Corners& displacement) {
  const Index3& d = lattice.dims();
  Points points = lattice.points();
  for (int i = 0; i < d[0]; ++i) {
    for (int j = 0; j < d[1]; ++j) {
      for (int k = 0; k < d[2]; ++k) {
        const std::array<double, 3> at{i / (d[0] - 1.0), j / (d[1] - 1.0), k / (d[2] - 1.0)};
        for (int c = 0; c < 8; ++c) {
          const double weight = ((c >> 2 & 1) != 0 ? at[0] : 1.0 - at[0]) *
                                ((c >> 1 & 1) != 0 ? at[1] : 1.0 - at[1]) *
                                ((c & 1) != 0 ? at[2] : 1.0 - at[2]);
          points.row(lattice.index(i, j, k)) += weight * displacement.row(c);
        }
      }
    }
  }
  return points;
}

/// Height of the middle of the top (1) or bottom (0) corners.
double height_of(const Corners& corners, int top) {
  double sum = 0.0;
  for (int c = 0; c < 8; ++c) {
    if ((c >> 1 & 1) == top) sum += corners(c, 1);
  }
  return sum / 4.0;
}

Points twist(const Lattice& lattice, double degrees) {
  const Corners corners = corners_of(lattice);
  const Eigen::RowVector3d centre = corners.colwise().mean();
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(degrees * kRadiansPerDegree, Eigen::Vector3d::UnitY()).toRotationMatrix();
  Corners displacement = Corners::Zero();
  for (int c = 0; c < 8; ++c) {
    if ((c >> 1 & 1) == 0) continue;
    const Eigen::RowVector3d arm = corners.row(c) - centre;
    displacement.row(c) = arm * turn.transpose() - arm;
  }
  return move_by_corners(lattice, displacement);
}

Points shear(const Lattice& lattice, double amount) {
  const Corners corners = corners_of(lattice);
  const double lift = amount * (height_of(corners, 1) - height_of(corners, 0));
  Corners displacement = Corners::Zero();
  for (int c = 0; c < 8; ++c) {
    if ((c >> 1 & 1) == 0) displacement(c, 1) = (c >> 2 & 1) != 0 ? lift : -lift;
  }
  return move_by_corners(lattice, displacement);
}

Points bend(const Lattice& lattice, double degrees) {
  const Corners corners = corners_of(lattice);
  const double bottom = height_of(corners, 0);
  const double height = height_of(corners, 1) - bottom;
  const double angle = degrees * kRadiansPerDegree;
  if (angle == 0.0 || height == 0.0) return lattice.points();
  const double radius = height / angle;
  const double middle = corners.col(0).mean();
  Points points = lattice.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double turn = angle * (points(i, 1) - bottom) / height;
    const double arm = radius - (points(i, 0) - middle);
    points(i, 0) = middle + radius - arm * std::cos(turn);
    points(i, 1) = bottom + arm * std::sin(turn);
  }
  return points;
}

Points jitter(const Lattice& lattice, std::uint64_t seed) {
  const Corners corners = corners_of(lattice);
  const Index3& d = lattice.dims();
  Eigen::Matrix3d spacing = Eigen::Matrix3d::Zero();  // row a: mean step along axis a
  for (int c = 0; c < 8; ++c) {
    for (int a = 0; a < 3; ++a) {
      const double sign = (c >> (2 - a) & 1) != 0 ? 1.0 : -1.0;
      spacing.row(a) += sign * corners.row(c) / (4.0 * (d[static_cast<std::size_t>(a)] - 1));
    }
  }
  std::mt19937_64 random(seed);
  Points points = lattice.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (int a = 0; a < 3; ++a) {
      const double unit = static_cast<double>(random() >> 11) * 0x1p-53;  // [0, 1)
      points.row(i) += kRandomAmplitude * (2.0 * unit - 1.0) * spacing.row(a);
    }
  }
  return points;
}

}  // namespace

Deformation Deformation::parse(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  for (const Entry& entry : kEntries) {
    if (entry.name != name) continue;
    Deformation result(entry.kind, entry.amount, entry.seed);
    if (colon == std::string_view::npos) return result;
    const std::string_view argument = text.substr(colon + 1);
    const bool is_seed = entry.kind == Kind::kRandom;
    if (entry.kind == Kind::kNone) {
      throw UsageError(
          fmt::format("deformation '{}': none takes no argument; {}", text, kAccepted));
    }
    const bool good =
        is_seed ? read_number(argument, result.seed_) : read_number(argument, result.amount_);
    if (good && std::isfinite(result.amount_)) return result;
    throw UsageError(fmt::format("deformation '{}': '{}' is not {}; {}", text, argument,
                                 is_seed ? "an integer from 0 to 2^64 - 1" : "a finite number",
                                 kAccepted));
  }
  throw UsageError(fmt::format("deformation '{}' is unknown; {}", text, kAccepted));
}

Lattice Deformation::apply(const Lattice& lattice) const {
  switch (kind_) {
    case Kind::kTwist:
      return Lattice(lattice.dims(), twist(lattice, amount_));
    case Kind::kShear:
      return Lattice(lattice.dims(), shear(lattice, amount_));
    case Kind::kBend:
      return Lattice(lattice.dims(), bend(lattice, amount_));
    case Kind::kRandom:
      return Lattice(lattice.dims(), jitter(lattice, seed_));
    case Kind::kNone:
      break;
  }
  return lattice;
}

}  // namespace hwffd
