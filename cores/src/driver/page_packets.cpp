// Packets of pages for the core that was found.
#include <algorithm>
#include <string>

#include "hwffd/driver.hpp"
#include "hwffd/registers.h"

namespace hwffd {
namespace {

/// @throws DriverError for a cell that the beat of a vertex has no bits for
void check_cells(const CoreIdentity& core, const std::vector<VertexBeat>& vertices, bool large) {
  const int points = static_cast<int>(core.points_axis);
  const int most = large ? kLargeAxisPoints : nameable_cells(std::min(points, kSmallAxisPoints));
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int cell = vertices[v].cell[axis];
      if (cell >= 0 && cell < most) continue;
      const bool flag = !large && core.points_axis > kSmallAxisPoints;
      throw DriverError("vertex " + std::to_string(v) + ": cell " + std::to_string(cell) +
                        " along axis " + "stu"[axis] + ": 0 to " + std::to_string(most - 1) +
                        " can be said to this core; " +
                        (flag ? "set large" : "cut the lattice into pages, or build with AXIS"));
    }
  }
}

}  // namespace

PointStore Driver::store() const {
  if (!core_) throw DriverError("the core is not known yet: probe it first");
  if (core_->points_axis == 0) {
    throw DriverError(
        "this core keeps no lattice: send interleaved vertices, or build it with "
        "RESIDENT = 1");
  }
  PointStore store;
  store.axis_points = static_cast<int>(core_->points_axis);
  const bool pages = (core_->features & HWFFD_FEATURES_PAGES_MASK) != 0;
  store.pages = pages ? static_cast<int>(core_->pages) : 0;
  store.spans = pages && (core_->features & HWFFD_FEATURES_SPANS_MASK) != 0;
  return store;
}

std::vector<Beat> Driver::page(int page, const LatticeWords& lattice,
                               const std::array<int, 3>& origin) const {
  std::vector<Beat> packet = page_packet(page, lattice, origin);
  check(packet.front().words);
  return packet;
}

std::vector<Beat> Driver::points(int page, const LatticeWords& lattice, std::size_t first,
                                 std::size_t count) const {
  std::vector<Beat> packet = points_packet(page, lattice, first, count);
  check(packet.front().words);
  return packet;
}

std::vector<Beat> Driver::page_vertices(int page, const std::vector<VertexBeat>& vertices,
                                        const PageVertices& how) const {
  std::vector<Beat> packet = page_vertices_packet(page, vertices, how);
  check(packet.front().words);
  check_cells(*core_, vertices, how.large);
  return packet;
}

}  // namespace hwffd
