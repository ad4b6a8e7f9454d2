#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hwffd::model {

/// The words of a lattice that a core keeps: x, y, z and a fourth of each point, u fastest.
struct ResidentPoints {
  using Point = std::array<std::uint32_t, 4>;

  /// Of a cell's first point.
  const std::uint32_t* at(const std::array<int, 3>& cell) const {
    return points.front().data() + offset(cell);
  }
  /// From one point to that which lies so many points further along each axis, in words.
  std::size_t offset(const std::array<int, 3>& further) const {
    const int points_further = (further[0] * dims[1] + further[1]) * dims[2] + further[2];
    return 4 * static_cast<std::size_t>(points_further);
  }

  std::array<int, 3> dims{};
  int exponent = 0;  ///< of the points, where the format has one for all (bfp32)
  std::vector<Point> points;
};

/// A vertex of such a lattice, whose cell is one of its cells.
struct ResidentVertex {
  std::array<std::uint32_t, 3> local{};
  std::array<int, 3> cell{};
};

/// x, y, z as the stream returns them, and whether any of them saturated or is NaN.
struct ResultWords {
  std::array<std::uint32_t, 3> words{};
  bool saturated = false;
  bool nan = false;
};

}  // namespace hwffd::model
