// Operations of the number layer in binary32 that round once, of every kind of number, a result a
// clock after exactly LATENCY clocks: ffd_num_mac, sum + weight x point, and ffd_num_centre, 2 x
// - 1.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <deque>

#include "Vcentre_l1.h"
#include "Vcentre_l4.h"
#include "Vmac_l1.h"
#include "Vmac_l5.h"
#include "hwffd/numerics/binary32.hpp"
#include "hwffd/numerics/bits.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {
namespace {

constexpr int kCases = 1'000'000;

/// One NaN, one zero.
std::uint32_t canonical(float value) {
  return std::isnan(value) ? 0x7FC00000U : value == 0 ? 0U : bits_of_float(value);
}

/// What comes of the operands that were put on the pins.
struct Words {
  float exact, model;
};

template <class VDut, class Drive, class Result>
void expect_words(std::size_t latency, Drive drive, Result result) {
  tb::Random random(tb::seed_from_environment(1));
  tb::Sim<VDut> sim(1);
  std::deque<std::uint32_t> expected;
  int checked = 0, rtl = 0, model = 0;
  for (int i = 0; i < kCases; ++i) {
    const Words words = drive(random, sim.dut());
    expected.push_back(canonical(words.exact));
    model += bits_of_float(words.model) != expected.back() ? 1 : 0;
    sim.tick();
    if (expected.size() < latency) continue;
    ++checked;
    rtl += result(sim.dut()) != expected.front() ? 1 : 0;
    expected.pop_front();
  }
  EXPECT_EQ(checked, kCases - static_cast<int>(latency) + 1);
  EXPECT_EQ(rtl, 0);
  EXPECT_EQ(model, 0);
}

/// Any word, three in four with an exponent near 1, so that sums and products meet.
std::uint32_t draw_operand(tb::Random& random) {
  const std::uint32_t word = random.word();
  if (random.chance(0.25)) return word;
  return (word & 0x807FFFFFU) | static_cast<std::uint32_t>(random.between(115, 138)) << 23;
}

template <class VDut>
void expect_mac(std::size_t latency) {
  const auto drive = [](tb::Random& random, VDut& dut) -> Words {
    const float weight = float_of_bits(dut.weight_i = draw_operand(random));
    const float point = float_of_bits(dut.point_i = draw_operand(random));
    const float sum = float_of_bits(dut.sum_i = draw_operand(random));
    return {std::fma(weight, point, sum), Binary32Fused::mac(sum, weight, point)};
  };
  expect_words<VDut>(latency, drive, [](VDut& dut) { return dut.sum_o; });
}

TEST(Mac, OneClock) { expect_mac<Vmac_l1>(1); }
TEST(Mac, FiveClocks) { expect_mac<Vmac_l5>(5); }

/// A coordinate in [0, 1], any word, or one next to an end of an exponent.
std::uint32_t draw_coordinate(tb::Random& random) {
  if (random.chance(0.5)) return bits_of_float(static_cast<float>(random.unit()));
  if (random.chance(0.5)) return random.word();
  return (random.pick({0U, 1U, 125U, 126U, 127U, 128U, 253U, 254U, 255U}) << 23) +
         random.pick({0U, 1U, 0x3FFFFFU, 0x400000U, 0x7FFFFFU});
}

template <class VDut>
void expect_centred(std::size_t latency) {
  // Exact in double, which is wide enough for the second rounding to change nothing.
  const auto drive = [](tb::Random& random, VDut& dut) -> Words {
    const float x = float_of_bits(dut.coordinate_i = draw_coordinate(random));
    return {static_cast<float>(2 * static_cast<double>(x) - 1), Binary32::centre(x)};
  };
  expect_words<VDut>(latency, drive, [](VDut& dut) { return dut.centred_o; });
}

TEST(Centre, OneClock) { expect_centred<Vcentre_l1>(1); }
TEST(Centre, FourClocks) { expect_centred<Vcentre_l4>(4); }

}  // namespace
}  // namespace hwffd::test
