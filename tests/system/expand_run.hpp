#pragma once

#include <array>
#include <vector>

#include "expand_stimulus.hpp"
#include "page_run.hpp"

namespace hwffd::test {

/// A core with grids and packed vertices, and a lattice in it: in its last page, or resident where
/// there are no pages.
class ExpandRun : public PageRun {
 public:
  using PageRun::PageRun;

  bool has(std::uint32_t feature) const { return (build_.core.features & feature) != 0; }
  int page() const { return has(model::kPagesFeature) ? build_.core.pages - 1 : 0; }
  int axis_points() const { return build_.core.axis; }

  std::vector<Beat> packet_of(const LatticeWords& lattice) const;
  std::vector<Beat> packet_of(const std::vector<VertexBeat>& vertices,
                              const PageVertices& how = {}) const;
  void send_lattice(const LatticeWords& lattice);
  void send_grid(const Grid& grid, const PageVertices& how = {});
  void send_vertices(const std::vector<VertexBeat>& vertices, const PageVertices& how = {});
  void send_packed(const std::vector<PackedVertex>& vertices, const PageVertices& how = {});

  /// Flags that the core has, and the kinds of results that it can make of the lattice.
  PageVertices random_flags(tb::Random& random, const LatticeWords& lattice) const;
  /// A lattice with a fourth component where the core has one, each axis of 4 to `most` points.
  LatticeWords random_lattice(tb::Random& random, int most) const;
  LatticeWords random_lattice(tb::Random& random, const std::array<int, 3>& dims) const;

  /// The functions, and their derivatives where the core has those.
  void send_functions();
  /// How many results so many vertices have.
  std::size_t results(std::size_t vertices, const PageVertices& how) const;
  /// That the results of each two packets in turn are the same, of so many results each, and that
  /// there are no others.
  ::testing::AssertionResult twice(const std::vector<std::size_t>& counts);
  /// That `count` results from `first` on are those from `again` on in every bit.
  ::testing::AssertionResult same(std::size_t first, std::size_t again, std::size_t count);
};

}  // namespace hwffd::test
