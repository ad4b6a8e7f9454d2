// Cores that give the results of two vertices in a beat (FEATURES bit 12).
#include "hwffd/stream/halves.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "named.hpp"
#include "page_run.hpp"

namespace hwffd::test {
namespace {

class Halves : public ::testing::TestWithParam<PageBuild> {
 protected:
  bool has(std::uint32_t feature) const { return (GetParam().core.features & feature) != 0; }
  std::vector<Results> kinds() const {
    if (!has(model::kDeterminantFeature)) return {Results::kPosition};
    return {Results::kPosition, Results::kDeterminant};
  }
  Functions functions() const {
    return has(model::kDerivativesFeature) ? Functions::kDerivativesToo : Functions::kBlending;
  }
};

/// What a result beat becomes in half a beat, in numbers, which the model's code has no part in.
void expect_half(const HalfResult& half, const Beat& whole, std::uint32_t determinant) {
  const std::uint32_t status = whole.words[3];
  EXPECT_EQ(half.blank, (status & (kStatusTruncated | kStatusUnloaded)) != 0 ||
                            ((status & kStatusOutside) != 0 && (status & kStatusClamped) == 0 &&
                             (whole.words[0] | whole.words[1] | whole.words[2]) == 0));
  EXPECT_EQ(half.outside, (status & kStatusOutside) != 0);
  EXPECT_EQ(half.folded, (determinant & kStatusFolded) != 0);
  bool saturated = (status & kStatusSaturated) != 0;
  for (int c = 0; c < 3; ++c) {
    const double exact = std::ldexp(static_cast<std::int32_t>(whole.words[c]), -31);
    const double rounded = std::floor(std::ldexp(exact, 19) + 0.5);
    saturated |= rounded > 524287;
    EXPECT_EQ(half.words[c], std::min(rounded, 524287.0));
  }
  EXPECT_EQ(half.saturated, saturated);
}

// Beside the results of the same vertices a beat each.
TEST_P(Halves, AreTheRoundedResults) {
  std::size_t compared = 0, saturated = 0, folded = 0, outside = 0, blank = 0;
  for (const char* sink : {"always", "bernoulli", "sparse"}) {
    PageRun run(GetParam(), 7, "bernoulli", sink);
    tb::Random random(7);
    LatticeWords lattice = random_lattice(run.codec(), random, {5, 4, 6});
    // What is near 1 saturates: half of the points along s.
    for (std::size_t p = 0; p < lattice.points.size() / 2; ++p) lattice.points[p][1] = 0x7FFFFFFF;
    run.send_bspline(functions());
    run.send(page_packet(1, lattice));
    struct Pair {
      std::size_t count;
      Results results;
    };
    std::vector<Pair> pairs;
    for (const Results results : kinds()) {
      for (const bool every : {false, true}) {
        for (const auto mode : {OutsideMode::kClamp, OutsideMode::kBlank}) {
          for (const std::size_t count : {1, 2, 3, 8, 9}) {
            const auto vertices = random_vertices(run.codec(), random, lattice.dims, count, true);
            PageVertices how;
            how.mode = mode;
            how.results = results;
            how.every = every;
            run.send(page_vertices_packet(1, vertices, how));
            how.half = true;
            run.send(page_vertices_packet(1, vertices, how));
            pairs.push_back({count, results});
          }
        }
      }
    }
    ASSERT_TRUE(run.run());
    const std::vector<Beat>& results = run.bench().results();
    std::size_t at = 0;
    for (const Pair& pair : pairs) {
      const std::size_t each = results_of(pair.results), beats = (pair.count + 1) / 2;
      const std::size_t packed = at + each * pair.count;
      ASSERT_LE(packed + beats, results.size());
      const std::vector<Beat> own(results.begin() + static_cast<std::ptrdiff_t>(packed),
                                  results.begin() + static_cast<std::ptrdiff_t>(packed + beats));
      const std::vector<HalfResult> halves = halves_of(own);
      ASSERT_EQ(halves.size(), pair.count);
      for (std::size_t v = 0; v < pair.count; ++v) {
        const Beat& whole = results[at + each * v];
        expect_half(halves[v], whole, each == 1 ? 0 : results[at + each * v + 1].words[3]);
        ++compared;
        saturated += halves[v].saturated ? 1 : 0;
        folded += halves[v].folded ? 1 : 0;
        outside += halves[v].outside ? 1 : 0;
        blank += halves[v].blank ? 1 : 0;
      }
      for (std::size_t b = 0; b < beats; ++b) EXPECT_EQ(own[b].last, b + 1 == beats);
      at = packed + beats;
    }
    EXPECT_EQ(at, results.size());
  }
  std::printf("%zu vertices: %zu saturated, %zu folded, %zu outside, %zu blank\n", compared,
              saturated, folded, outside, blank);
  EXPECT_GT(saturated, 0U);
  EXPECT_LT(saturated, compared);
  EXPECT_GT(outside, blank);
  EXPECT_GT(blank, 0U);
  EXPECT_EQ(folded > 0, has(model::kDeterminantFeature));
}

// A word just below 1, which is none of 20 bits: 1 - 25 2^-30, from functions that sum to
// 1 + 10 2^-16.
TEST_P(Halves, RoundingSaturates) {
  PageRun run(GetParam(), 9, "gaps", "gaps");
  if (run.codec().weight_fraction() != 16) GTEST_SKIP() << "the numbers are those of fx18";
  tb::Random random(9);
  LatticeWords lattice = random_lattice(run.codec(), random, {4, 5, 4});
  for (auto& point : lattice.points) point = {0x80000000U - (20U << 14), 1U << 30, 0};
  const Blending one = family("constant", run.codec());
  const Blending more = user_blending({{{1 + 10.0 / 65536, 0, 0, 0}, {}, {}, {}}});
  run.send(coefficients_packet({more, one, one}, run.codec()));
  run.send(page_packet(1, lattice));
  PageVertices how;
  const auto vertices = random_vertices(run.codec(), random, lattice.dims, 6);
  run.send(page_vertices_packet(1, vertices, how));
  how.half = true;
  run.send(page_vertices_packet(1, vertices, how));
  ASSERT_TRUE(run.run());
  const std::vector<Beat>& results = run.bench().results();
  ASSERT_EQ(results.size(), 6U + 3U);
  EXPECT_EQ(results[0].words[0], 0x80000000U - 50U);
  EXPECT_EQ(results[0].words[3] & kStatusSaturated, 0U);
  for (const HalfResult& half : halves_of({results.begin() + 6, results.end()})) {
    EXPECT_EQ(half.words[0], 0x7FFFF);
    EXPECT_TRUE(half.saturated);
  }
  EXPECT_EQ(run.pulses(event::kSaturated), vertices.size());
}

// Half as many beats: a packet of many is as soon done as without H, and R counts beats.
TEST_P(Halves, TakeNoMoreClocks) {
  std::array<std::uint64_t, 2> clocks{};
  for (const bool half : {false, true}) {
    PageRun run(GetParam(), 3);
    tb::Random random(3);
    const LatticeWords lattice = random_lattice(run.codec(), random, {5, 4, 6});
    PageVertices how;
    how.half = half;
    how.count = has(model::kMarksFeature);
    run.send_bspline(functions());
    run.send(page_packet(1, lattice));
    run.send(page_vertices_packet(1, random_vertices(run.codec(), random, lattice.dims, 65), how));
    ASSERT_TRUE(run.run());
    const std::vector<Beat>& results = run.bench().results();
    ASSERT_EQ(results.size(), (half ? 33U : 65U) + (how.count ? 1U : 0U));
    if (how.count) {
      EXPECT_EQ(results.back().words[0], half ? 33U : 65U);
    }
    clocks[half ? 1 : 0] = run.bench().cycle();
  }
  EXPECT_EQ(clocks[0], clocks[1]);
}

// What cannot be halved is an unknown packet, and the one behind it is exact.
TEST_P(Halves, OfOtherResultsAreRefused) {
  PageRun run(GetParam(), 5, "gaps", "bernoulli");
  tb::Random random(5);
  const LatticeWords lattice = random_lattice(run.codec(), random, {5, 4, 6});
  const auto vertices = random_vertices(run.codec(), random, lattice.dims, 5);
  run.send_bspline(functions());
  run.send(page_packet(1, lattice));
  PageVertices how;
  how.half = true;
  std::uint64_t refused = 0;
  for (const Results results : {Results::kDerivatives, Results::kDeterminantAlone}) {
    how.results = results;
    run.send(page_vertices_packet(1, vertices, how));
    ++refused;
  }
  how.results = Results::kPosition;
  how.fourth = true;
  run.send(page_vertices_packet(1, vertices, how));
  ++refused;
  how.fourth = false;
  run.send(page_vertices_packet(1, vertices, how));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.pulses(event::kUnknownOpcode), refused);
  EXPECT_EQ(run.bench().results().size(), 3U);
}

INSTANTIATE_TEST_SUITE_P(, Halves, ::testing::ValuesIn(page_builds([](const PageBuild& build) {
                           return (build.core.features & model::kHalvesFeature) != 0;
                         })),
                         by_name);

}  // namespace
}  // namespace hwffd::test
