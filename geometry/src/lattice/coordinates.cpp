#include "hwffd/lattice/coordinates.hpp"

#include <fmt/format.h>

#include <limits>

#include "hwffd/error.hpp"

namespace hwffd {

void check_coordinates(const char* what, const Points& points) {
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    if (has_coordinates(points.row(row))) continue;
    if (!points.row(row).allFinite()) {
      throw Error(fmt::format("{} {} is not finite; give finite coordinates", what, row));
    }
    throw Error(fmt::format("{} {} has a coordinate beyond {}; give smaller ones", what, row,
                            kLargestCoordinate));
  }
}

std::optional<Eigen::Index> beyond_float(const Points& points) {
  constexpr double kMost = std::numeric_limits<float>::max();
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    if ((points.row(row).array().abs() > kMost).any()) return row;
  }
  return std::nullopt;
}

}  // namespace hwffd
