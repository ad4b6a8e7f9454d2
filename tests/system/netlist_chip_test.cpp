// The netlist of the core that fills a Gowin GW5A, positions of a resident lattice only: every bit
// of 2,000 vertices from random cells, one of them in each clock.
#include <gtest/gtest.h>

#include "Vaffine_fx17_overlapped_resident_gw5a_netlist.h"
#include "hwffd/cores/verilated_stream_core.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/stream_bench.hpp"
#include "stimulus.hpp"

namespace hwffd::test {
namespace {

constexpr std::size_t kVertices = 2000;
constexpr std::uint64_t kSeed = 1;

TEST(ChipNetlist, AVertexInEachClockFromAnyCell) {
  const Configuration& row = find_configuration("affine-fx17-overlapped");
  const WordCodec codec(row.format);
  cores::VerilatedStreamCore<Vaffine_fx17_overlapped_resident_gw5a_netlist> core(kSeed);
  model::StreamModel model(row, model::kResidentFeature);
  tb::StreamBenchOptions options;
  options.test = {row.name, kSeed, "SEED=1"};
  tb::StreamBench bench(core, options);
  bench.reset(3);

  const auto send = [&](const std::vector<Beat>& beats) {
    bench.send(beats);
    bench.expect(model.run(beats));
  };
  tb::Random random(kSeed);
  const LatticeWords lattice = random_lattice(codec, random, {16, 16, 16});
  send(coefficients_packet(watertight_bspline(codec), codec));
  send(lattice_packet(lattice));
  send(vertices_packet(random_vertices(codec, random, lattice.dims, kVertices)));
  bench.run();
  ASSERT_TRUE(bench.finish()) << bench.report();
  ASSERT_EQ(bench.results().size(), kVertices);
  EXPECT_EQ(bench.events(), model.events());
  EXPECT_EQ(bench.clocks_per_result(40, kVertices - 1), 1);
}

}  // namespace
}  // namespace hwffd::test
