#include "hwffd/stream/large_lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "hwffd/error.hpp"

namespace hwffd {
namespace {

constexpr int kSeam = 3;   // layers of points that neighbouring pages share
constexpr int kBanks = 4;  // of an axis: pages begin at multiples

/// How an axis is cut.
struct AxisPages {
  AxisPages(int points, int axis_points) : cells(points - kSeam) {
    if (points <= kSeam) {
      throw UsageError(
          fmt::format("a lattice of {} points along an axis: 4 or more are wanted", points));
    }
    if (points <= axis_points) return;
    step = (axis_points - kSeam) / kBanks * kBanks;
    if (step == 0) {
      throw UsageError(
          fmt::format("pages of {} points an axis: 7 or more are wanted for a lattice of {}",
                      axis_points, points));
    }
    // The last one may have more cells than a step.
    count = 1 + (points - axis_points + step - 1) / step;
  }

  int page_of(int cell) const { return std::min(cell / step, count - 1); }
  int points_of(int page) const { return (page == count - 1 ? cells - page * step : step) + kSeam; }

  int cells;
  int step = 1 << 30;
  int count = 1;
};

std::array<AxisPages, 3> axes_of(const std::array<int, 3>& dims, int axis_points) {
  return {AxisPages(dims[0], axis_points), AxisPages(dims[1], axis_points),
          AxisPages(dims[2], axis_points)};
}

LatticePage page_at(const LatticeWords& lattice, const std::array<AxisPages, 3>& axes,
                    const std::array<int, 3>& at) {
  LatticePage page;
  page.lattice.exponent = lattice.exponent;
  for (int axis = 0; axis < 3; ++axis) {
    page.origin[axis] = at[axis] == 0 ? 0 : at[axis] * axes[axis].step;
    page.lattice.dims[axis] = axes[axis].points_of(at[axis]);
  }
  const auto& size = page.lattice.dims;
  const auto& first = page.origin;
  for (int i = first[0]; i < first[0] + size[0]; ++i) {
    for (int j = first[1]; j < first[1] + size[1]; ++j) {
      const auto row =
          lattice.points.begin() +
          ((static_cast<std::ptrdiff_t>(i) * lattice.dims[1] + j) * lattice.dims[2] + first[2]);
      page.lattice.points.insert(page.lattice.points.end(), row, row + size[2]);
    }
  }
  return page;
}

}  // namespace

std::vector<LatticePage> pages_of(const LatticeWords& lattice, int axis_points) {
  const auto axes = axes_of(lattice.dims, axis_points);
  std::vector<LatticePage> pages;
  for (int i = 0; i < axes[0].count; ++i) {
    for (int j = 0; j < axes[1].count; ++j) {
      for (int k = 0; k < axes[2].count; ++k) pages.push_back(page_at(lattice, axes, {i, j, k}));
    }
  }
  return pages;
}

PagedVertices by_page(const std::vector<VertexBeat>& vertices, const std::array<int, 3>& dims,
                      int axis_points) {
  const auto axes = axes_of(dims, axis_points);
  PagedVertices paged;
  paged.of_page.resize(static_cast<std::size_t>(axes[0].count) * axes[1].count * axes[2].count);
  std::vector<std::vector<std::size_t>> from(paged.of_page.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    VertexBeat vertex = vertices[v];
    std::size_t at = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int page = axes[axis].page_of(vertex.cell[axis]);
      at = at * axes[axis].count + page;
      if (page > 0) vertex.cell[axis] -= page * axes[axis].step;
      vertex.cell[axis] = std::min(vertex.cell[axis], nameable_cells(axis_points) - 1);
    }
    paged.of_page[at].push_back(vertex);
    from[at].push_back(v);
  }
  for (std::size_t p = 0; p < from.size(); ++p) {
    if (!from[p].empty()) paged.sent.push_back(p);
    paged.from.insert(paged.from.end(), from[p].begin(), from[p].end());
  }
  return paged;
}

std::vector<Beat> page_packets(const std::vector<LatticePage>& pages, const PagedVertices& vertices,
                               OutsideMode mode, Results results) {
  std::vector<Beat> beats;
  for (std::size_t p = 0; p < pages.size(); ++p) {
    const std::vector<VertexBeat>& all = vertices.of_page.at(p);
    if (all.empty()) continue;
    append(beats, lattice_packet(pages[p].lattice));
    for (const auto& some : in_packets(all)) append(beats, vertices_packet(some, mode, results));
  }
  return beats;
}

std::vector<std::vector<VertexBeat>> in_packets(const std::vector<VertexBeat>& vertices) {
  std::vector<std::vector<VertexBeat>> packets;
  for (auto first = vertices.begin(); first != vertices.end();) {
    const auto left = static_cast<std::size_t>(vertices.end() - first);
    const auto last = first + static_cast<std::ptrdiff_t>(std::min(kPacketVertices, left));
    packets.emplace_back(first, last);
    first = last;
  }
  return packets;
}

std::vector<Beat> in_order(const std::vector<Beat>& sorted, const PagedVertices& vertices,
                           Results results) {
  const auto each = static_cast<std::size_t>(results_of(results));
  if (sorted.size() != each * vertices.from.size()) {
    throw std::invalid_argument("there are as many results as were asked for");
  }
  std::vector<Beat> beats(sorted.size());
  for (std::size_t v = 0; v < vertices.from.size(); ++v) {
    for (std::size_t r = 0; r < each; ++r) {
      Beat& beat = beats[each * vertices.from[v] + r];
      beat = sorted[each * v + r];
      beat.last = false;
    }
  }
  if (!beats.empty()) beats.back().last = true;
  return beats;
}

}  // namespace hwffd
