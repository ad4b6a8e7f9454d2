// Cores without some of their features: packets of what is not there are dropped as those of an
// unknown opcode are, and all others have their results to the bit.
#include <gtest/gtest.h>

#include "Vcg1_fx18_overlapped_1792.h"
#include "Vcg1_fx18_overlapped_256.h"
#include "Vcg1_fx18_overlapped_3888.h"
#include "Vcg1_fx18_overlapped_512.h"
#include "Vcg1_fx18_overlapped_768.h"
#include "Vtree8_fx18_overlapped_256.h"
#include "Vtree8_fx18_overlapped_512.h"
#include "hwffd/cores/verilated_stream_core.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/stream_bench.hpp"
#include "named.hpp"
#include "stimulus.hpp"

namespace hwffd::test {
namespace {

using MakeCore = std::unique_ptr<cores::StreamCore> (*)(std::uint64_t seed);

template <class Dut>
std::unique_ptr<cores::StreamCore> make_core(std::uint64_t seed) {
  return std::make_unique<cores::VerilatedStreamCore<Dut>>(seed);
}

/// A core of tests/system/CMakeLists.txt.
struct Build {
  std::string name;
  const char* row;
  std::uint32_t features;
  MakeCore make;
  std::uint64_t refused;  ///< of the packets of `EachPacket`
  std::size_t results;    ///< of the others
};

void PrintTo(const Build& build, std::ostream* out) { *out << build.name; }

/// A core, its model and the bench between them.
class Features : public ::testing::TestWithParam<Build> {
 protected:
  void start(std::uint64_t seed) {
    core_ = GetParam().make(seed);
    tb::StreamBenchOptions options;
    options.test = {GetParam().name, seed, "SEED=" + std::to_string(seed)};
    options.source_throttle = "bursts";
    options.sink_throttle = "bernoulli";
    options.probe_edges = true;
    bench_ = std::make_unique<tb::StreamBench>(*core_, options);
    model_ = std::make_unique<model::StreamModel>(row_, GetParam().features);
    bench_->reset(3);
  }
  void send(const std::vector<Beat>& beats) {
    bench_->send(beats);
    bench_->expect(model_->run(beats));
  }
  /// To the end: every bit of every result, and every event.
  void finish() {
    bench_->run();
    ASSERT_TRUE(bench_->finish()) << bench_->report();
    ASSERT_EQ(bench_->events(), model_->events());
  }
  std::uint64_t refused() const { return bench_->events()[event::kUnknownOpcode]; }

  const Configuration& row_ = find_configuration(GetParam().row);
  const WordCodec codec_{row_.format};
  std::unique_ptr<cores::StreamCore> core_;
  std::unique_ptr<tb::StreamBench> bench_;
  std::unique_ptr<model::StreamModel> model_;
};

// One good packet of each kind, none that the one before could spoil. What is expected here does
// not come from the model.
TEST_P(Features, EachPacket) {
  start(1);
  tb::Random random(1);
  const auto functions = watertight_bspline(codec_);
  const LatticeWords lattice = random_lattice(codec_, random, 6);
  send(coefficients_packet(functions, codec_, Functions::kDerivativesToo));
  if ((GetParam().features & model::kDerivativesFeature) == 0) {
    send(coefficients_packet(functions, codec_));
  }
  send(lattice_packet(lattice));
  for (const Results results : {Results::kPosition, Results::kDerivatives, Results::kDeterminant}) {
    send(vertices_packet(random_vertices(codec_, random, lattice.dims, 3), OutsideMode::kClamp,
                         results));
    send(interleaved_packet(make_stimulus("random", codec_, 3, 1), OutsideMode::kClamp, results));
  }
  ASSERT_NO_FATAL_FAILURE(finish());
  EXPECT_EQ(refused(), GetParam().refused);
  ASSERT_EQ(bench_->results().size(), GetParam().results);
  for (const Beat& result : bench_->results()) {
    EXPECT_EQ(result.words[3] >> 16 & ~(kStatusFolded >> 16), 0U);
  }
}

// Bits of word 0 that are no flags: all, but for P in a core with packed vertices.
TEST_P(Features, VerticesHaveNoOtherFlags) {
  if ((GetParam().features & model::kResidentFeature) == 0) GTEST_SKIP() << "no opcode 3";
  start(1);
  tb::Random random(2);
  const LatticeWords lattice = random_lattice(codec_, random, 6);
  send(coefficients_packet(watertight_bspline(codec_), codec_));
  send(lattice_packet(lattice));
  std::vector<Beat> packet = vertices_packet(random_vertices(codec_, random, lattice.dims, 3));
  send(packet);
  packet[0].words[0] |= 0xFFFFFF00U;
  if ((GetParam().features & model::kPackedFeature) != 0) packet[0].words[0] &= ~kPackedFlag;
  send(packet);
  ASSERT_NO_FATAL_FAILURE(finish());
  EXPECT_EQ(bench_->events(), model::StreamEvents{});
  ASSERT_EQ(bench_->results().size(), 6U);
  for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(bench_->results()[v], bench_->results()[3 + v]);
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
    EXPECT_GT(refused(), GetParam().refused == 0 ? 0 : kRounds);
    EXPECT_GT(bench_->results().size(), 2 * kRounds);
  }
}

constexpr std::uint32_t kNoDerivatives = model::kResidentFeature | model::kInterleavedFeature;
const Build kBuilds[] = {
    {"cg1_256", "cg1-fx18-overlapped", model::kResidentFeature, make_core<Vcg1_fx18_overlapped_256>,
     6, 3},
    {"cg1_512", "cg1-fx18-overlapped", model::kInterleavedFeature,
     make_core<Vcg1_fx18_overlapped_512>, 7, 3},
    {"cg1_768", "cg1-fx18-overlapped", kNoDerivatives, make_core<Vcg1_fx18_overlapped_768>, 5, 6},
    {"cg1_1792", "cg1-fx18-overlapped", kNoDerivatives | model::kDerivativesFeature,
     make_core<Vcg1_fx18_overlapped_1792>, 2, 30},
    {"cg1_3888", "cg1-fx18-overlapped",
     model::kAllFeatures | model::kGridsFeature | model::kPackedFeature,
     make_core<Vcg1_fx18_overlapped_3888>, 0, 42},
    {"tree8_256", "tree8-fx18-overlapped", model::kResidentFeature,
     make_core<Vtree8_fx18_overlapped_256>, 6, 3},
    {"tree8_512", "tree8-fx18-overlapped", model::kInterleavedFeature,
     make_core<Vtree8_fx18_overlapped_512>, 7, 3},
};
INSTANTIATE_TEST_SUITE_P(, Features, ::testing::ValuesIn(kBuilds), by_name);

}  // namespace
}  // namespace hwffd::test
