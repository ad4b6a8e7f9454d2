// Netlists of the cores that fill a chip, positions of a resident lattice only: every bit of 2,000
// vertices from random cells, at the clocks that the row promises.
#include <gtest/gtest.h>

#include <string>
#include <type_traits>

#include "Vaffine4x3_fx17_overlapped_powers_resident_ecp5_netlist.h"
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

/// A Gowin GW5AST-138C: a vertex a clock.
struct Gw5a {
  using Netlist = Vaffine_fx17_overlapped_resident_gw5a_netlist;
  static constexpr const char* kRow = "affine-fx17-overlapped";
  static constexpr double kClocks = 1;
};

/// A Lattice ECP5-85F: three lanes, each a vertex in four clocks.
struct Ecp5 {
  using Netlist = Vaffine4x3_fx17_overlapped_powers_resident_ecp5_netlist;
  static constexpr const char* kRow = "affine4x3-fx17-overlapped-powers";
  static constexpr double kClocks = 4.0 / 3;
};

template <typename Chip>
class ChipNetlist : public testing::Test {};

struct ChipName {
  template <typename Chip>
  static std::string GetName(int /*index*/) {
    return std::is_same_v<Chip, Gw5a> ? "gw5a" : "ecp5";
  }
};

using Chips = testing::Types<Gw5a, Ecp5>;
TYPED_TEST_SUITE(ChipNetlist, Chips, ChipName);

TYPED_TEST(ChipNetlist, VerticesOfAnyCell) {
  const Configuration& row = find_configuration(TypeParam::kRow);
  const WordCodec codec(row.format);
  cores::VerilatedStreamCore<typename TypeParam::Netlist> core(kSeed);
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
  EXPECT_NEAR(bench.clocks_per_result(40, kVertices - 1), TypeParam::kClocks, 0.001);
}

}  // namespace
}  // namespace hwffd::test
