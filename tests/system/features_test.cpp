// Cores without some of their features: packets of what is not there are dropped as those of an
// unknown opcode are, and all others have their results to the bit.
#include <gtest/gtest.h>

#include <map>

#include "named.hpp"
#include "page_run.hpp"
#include "stimulus.hpp"

namespace hwffd::test {
namespace {

/// Of the packets of `EachPacket`: how many a core refuses, and the results of the others.
struct Answer {
  std::uint64_t refused;
  std::size_t results;
};
const std::map<std::string, Answer> kAnswers = {
    {"cg1_resident", {8, 3}},     {"cg1_interleaved", {9, 3}}, {"cg1_positions", {7, 6}},
    {"cg1_derivatives", {4, 30}}, {"cg1_expanded", {0, 48}},   {"tree8_resident", {8, 3}},
    {"tree8_interleaved", {9, 3}}};

class Features : public ::testing::TestWithParam<PageBuild> {
 protected:
  void start(std::uint64_t seed) {
    run_ = std::make_unique<PageRun>(GetParam(), seed, "bursts", "bernoulli");
  }
  void send(const std::vector<Beat>& beats) { run_->send(beats); }
  void finish() { ASSERT_TRUE(run_->run()); }
  const std::vector<Beat>& results() const { return run_->bench().results(); }
  std::uint64_t refused() const { return run_->pulses(event::kUnknownOpcode); }
  bool has(std::uint32_t feature) const { return (GetParam().core.features & feature) != 0; }

  const WordCodec codec_{find_configuration(GetParam().row).format};
  const Answer answer_ = kAnswers.at(GetParam().name);
  std::unique_ptr<PageRun> run_;
};

// One good packet of each kind, none that the one before could spoil. What is expected here does
// not come from the model.
TEST_P(Features, EachPacket) {
  start(1);
  tb::Random random(1);
  const auto functions = watertight_bspline(codec_);
  const LatticeWords lattice = random_lattice(codec_, random, 6);
  send(coefficients_packet(functions, codec_, Functions::kDerivativesToo));
  if (!has(model::kDerivativesFeature)) {
    send(coefficients_packet(functions, codec_));
  }
  send(lattice_packet(lattice));
  for (const Results results : {Results::kPosition, Results::kDerivatives, Results::kDeterminant,
                                Results::kDeterminantAlone}) {
    send(vertices_packet(random_vertices(codec_, random, lattice.dims, 3), OutsideMode::kClamp,
                         results));
    send(interleaved_packet(make_stimulus("random", codec_, 3, 1), OutsideMode::kClamp, results));
  }
  ASSERT_NO_FATAL_FAILURE(finish());
  EXPECT_EQ(refused(), answer_.refused);
  ASSERT_EQ(results().size(), answer_.results);
  for (const Beat& result : results()) {
    EXPECT_EQ(result.words[3] >> 16 & ~(kStatusFolded >> 16), 0U);
  }
}

// Bits of word 0 that are no flags: all, but for P in a core with packed vertices.
TEST_P(Features, VerticesHaveNoOtherFlags) {
  if (!has(model::kResidentFeature)) GTEST_SKIP() << "no opcode 3";
  start(1);
  tb::Random random(2);
  const LatticeWords lattice = random_lattice(codec_, random, 6);
  send(coefficients_packet(watertight_bspline(codec_), codec_));
  send(lattice_packet(lattice));
  std::vector<Beat> packet = vertices_packet(random_vertices(codec_, random, lattice.dims, 3));
  send(packet);
  packet[0].words[0] |= 0xFFFFFF00U;
  if (has(model::kPackedFeature)) packet[0].words[0] &= ~kPackedFlag;
  send(packet);
  ASSERT_NO_FATAL_FAILURE(finish());
  EXPECT_EQ(run_->bench().events(), model::StreamEvents{});
  ASSERT_EQ(results().size(), 6U);
  for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(results()[v], results()[3 + v]);
}

TEST_P(Features, AnyPacketsInAnyOrder) {
  constexpr std::uint64_t kRounds = 20;
  for (std::uint64_t seed = tb::seed_from_environment(1), last = seed + 3; seed <= last; ++seed) {
    start(seed);
    tb::Random random(seed);
    for (std::uint64_t round = 0; round < kRounds; ++round) {
      send(coefficients_packet(random_coefficients(codec_, random)));
      send(vertices_packet(random_vertices(codec_, random, {6, 6, 6}, 2, true)));
      send(interleaved_packet(make_stimulus("extreme", codec_, 2, seed + round)));
      send(random_packets(codec_, random, 8));
    }
    ASSERT_NO_FATAL_FAILURE(finish());
    EXPECT_GT(refused(), answer_.refused == 0 ? 0 : kRounds);
    EXPECT_GT(results().size(), 2 * kRounds);
  }
}

INSTANTIATE_TEST_SUITE_P(, Features, ::testing::ValuesIn(page_builds()), by_name);

}  // namespace
}  // namespace hwffd::test
