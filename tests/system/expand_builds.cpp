#include "expand_builds.hpp"

#include <iterator>

#include "Vexpand_affine.h"
#include "Vexpand_basic.h"
#include "Vexpand_bfp.h"
#include "Vexpand_cg1.h"
#include "Vexpand_fx32.h"
#include "Vexpand_scan.h"
#include "Vexpand_tree8.h"

namespace hwffd::test {
namespace {

constexpr std::uint32_t kPlain =
    model::kResidentFeature | model::kGridsFeature | model::kPackedFeature;
constexpr std::uint32_t kInPages = model::kPagesFeature | model::kFourthFeature;
const PageBuild kBuilds[] = {
    {"cg1",
     "cg1-fx18-overlapped",
     {model::kAllFeatures | kPlain | kInPages | model::kMarksFeature, 16, 4},
     make_page_core<Vexpand_cg1>},
    {"basic",
     "basic-fp32-overlapped",
     {model::kAllFeatures | kPlain | model::kSpansFeature, 32, 2, 16},
     make_page_core<Vexpand_basic>},
    {"bfp",
     "basic-bfp32-overlapped",
     {kPlain | model::kInterleavedFeature | model::kPagesFeature, 20, 2},
     make_page_core<Vexpand_bfp>},
    {"fx32", "cg1-fx32-overlapped", {kPlain, 8, 2}, make_page_core<Vexpand_fx32>},
    {"tree8",
     "tree8-fx18-overlapped",
     {kPlain | model::kInterleavedFeature | kInPages | model::kLargeFeature | model::kMarksFeature,
      64, 3},
     make_page_core<Vexpand_tree8>},
    {"affine", "affine-fx17-overlapped", {kPlain, 16, 2}, make_page_core<Vexpand_affine>},
    {"scan", "scan4-fx17-overlapped", {kPlain, 16, 2}, make_page_core<Vexpand_scan>},
};

}  // namespace

std::vector<PageBuild> expand_builds() { return {std::begin(kBuilds), std::end(kBuilds)}; }

void ExpandRun::send_lattice(const LatticeWords& lattice) {
  send(has(model::kPagesFeature) ? page_packet(page(), lattice) : lattice_packet(lattice));
}

void ExpandRun::send_grid(const Grid& grid, const PageVertices& how) {
  send(grid_packet(grid, page(), how));
}

void ExpandRun::send_vertices(const std::vector<VertexBeat>& vertices, const PageVertices& how) {
  send(has(model::kPagesFeature) ? page_vertices_packet(page(), vertices, how)
                                 : vertices_packet(vertices, how.mode, how.results));
}

void ExpandRun::send_packed(const std::vector<PackedVertex>& vertices, const PageVertices& how) {
  send(has(model::kPagesFeature) ? page_packed_packet(page(), vertices, how)
                                 : packed_packet(vertices, how.mode, how.results));
}

PageVertices ExpandRun::random_flags(tb::Random& random, const LatticeWords& lattice) const {
  PageVertices how;
  if (has(model::kDerivativesFeature)) how.results = static_cast<Results>(random.below(3));
  how.large = is_large(lattice) || (has(model::kLargeFeature) && random.chance(0.5));
  how.count = has(model::kMarksFeature) && random.chance(0.5);
  how.interrupt = has(model::kMarksFeature) && random.chance(0.5);
  how.fourth = !lattice.fourth.empty() && random.chance(0.5);
  if (how.fourth && how.results == Results::kDeterminant) how.results = Results::kPosition;
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
  return vertices * static_cast<std::size_t>(results_of(how.results)) * (how.fourth ? 2 : 1) +
         (how.count ? 1 : 0);
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
