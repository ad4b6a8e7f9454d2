#include "mesh/weld.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace hwffd {
namespace {

std::size_t hash_of(const double* row) {
  std::uint64_t hash = 0;
  for (int c = 0; c < 3; ++c) {
    const double value = row[c] + 0.0;  // -0 becomes +0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15ull;
    hash ^= hash >> 29;
  }
  return static_cast<std::size_t>(hash);
}

}  // namespace

/// Of one table of whole numbers, since a node for each of millions of positions costs more time
/// and room than all else of a mesh.
Welded weld(Points points) {
  constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();
  const auto rows = static_cast<std::size_t>(points.rows());
  std::size_t size = 2;
  while (size < 2 * rows) size *= 2;
  std::vector<std::uint32_t> table(size, kFree);
  std::vector<std::uint32_t> vertices;
  vertices.reserve(rows);
  double* const values = points.data();
  std::uint32_t count = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    const double* const at = values + 3 * row;
    const auto equal = [&](std::uint32_t other) {
      const double* const seen = values + std::size_t{3} * other;
      return seen[0] == at[0] && seen[1] == at[1] && seen[2] == at[2];
    };
    std::size_t place = hash_of(at) & (size - 1);
    while (table[place] != kFree && !equal(table[place])) place = (place + 1) & (size - 1);
    if (table[place] == kFree) {
      // Those before it are in their places: this one has room in front of what is to be read.
      std::copy_n(at, 3, values + std::size_t{3} * count);
      table[place] = count++;
    }
    vertices.push_back(table[place]);
  }
  if (count < rows) points.conservativeResize(count, 3);
  return {std::move(points), std::move(vertices)};
}

}  // namespace hwffd
