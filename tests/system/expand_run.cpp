#include "expand_run.hpp"

namespace hwffd::test {

std::vector<Beat> ExpandRun::packet_of(const LatticeWords& lattice) const {
  return has(model::kPagesFeature) ? page_packet(page(), lattice) : lattice_packet(lattice);
}

std::vector<Beat> ExpandRun::packet_of(const std::vector<VertexBeat>& vertices,
                                       const PageVertices& how) const {
  return has(model::kPagesFeature) ? page_vertices_packet(page(), vertices, how)
                                   : vertices_packet(vertices, how.mode, how.results);
}

void ExpandRun::send_lattice(const LatticeWords& lattice) { send(packet_of(lattice)); }

void ExpandRun::send_grid(const Grid& grid, const PageVertices& how) {
  send(grid_packet(grid, page(), how));
}

void ExpandRun::send_vertices(const std::vector<VertexBeat>& vertices, const PageVertices& how) {
  send(packet_of(vertices, how));
}

void ExpandRun::send_packed(const std::vector<PackedVertex>& vertices, const PageVertices& how) {
  send(has(model::kPagesFeature) ? page_packed_packet(page(), vertices, how)
                                 : packed_packet(vertices, how.mode, how.results));
}

PageVertices ExpandRun::random_flags(tb::Random& random, const LatticeWords& lattice) const {
  PageVertices how;
  if (has(model::kDerivativesFeature)) how.results = static_cast<Results>(random.below(4));
  how.large = is_large(lattice) || (has(model::kLargeFeature) && random.chance(0.5));
  how.count = has(model::kMarksFeature) && random.chance(0.5);
  how.interrupt = has(model::kMarksFeature) && random.chance(0.5);
  how.fourth = !lattice.fourth.empty() && random.chance(0.5);
  if (how.fourth && has_determinant(how.results)) how.results = Results::kPosition;
  how.half =
      has(model::kHalvesFeature) && !how.fourth && can_be_halved(how.results) && random.chance(0.5);
  return how;
}

LatticeWords ExpandRun::random_lattice(tb::Random& random, int most) const {
  std::array<int, 3> dims;
  for (int& points : dims) points = static_cast<int>(random.between(4, most));
  return random_lattice(random, dims);
}

LatticeWords ExpandRun::random_lattice(tb::Random& random, const std::array<int, 3>& dims) const {
  LatticeWords lattice = test::random_lattice(codec(), random, dims);
  return has(model::kFourthFeature) ? with_fourth(std::move(lattice), codec(), random) : lattice;
}

void ExpandRun::send_functions() {
  send_bspline(has(model::kDerivativesFeature) ? Functions::kDerivativesToo : Functions::kBlending);
}

std::size_t ExpandRun::results(std::size_t vertices, const PageVertices& how) const {
  const std::size_t each = static_cast<std::size_t>(results_of(how.results)) * (how.fourth ? 2 : 1);
  return (how.half ? (vertices + 1) / 2 : vertices * each) + (how.count ? 1 : 0);
}

::testing::AssertionResult ExpandRun::twice(const std::vector<std::size_t>& counts) {
  std::size_t first = 0;
  for (const std::size_t count : counts) {
    const ::testing::AssertionResult equal = same(first, first + count, count);
    if (!equal) return equal;
    first += 2 * count;
  }
  if (bench().results().size() == first) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << bench().results().size() << " results";
}

::testing::AssertionResult ExpandRun::same(std::size_t first, std::size_t again,
                                           std::size_t count) {
  const std::vector<Beat>& all = bench().results();
  if (again + count > all.size()) return ::testing::AssertionFailure() << all.size() << " results";
  for (std::size_t r = 0; r < count; ++r) {
    if (all[first + r] == all[again + r]) continue;
    return ::testing::AssertionFailure() << "result " << first + r << " is not " << again + r;
  }
  return ::testing::AssertionSuccess();
}

}  // namespace hwffd::test
