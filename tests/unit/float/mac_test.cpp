// ffd_num_mac in binary32, sum + weight x point rounded once, of every kind of number: a result a
// clock after exactly LATENCY clocks.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <deque>

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

/// Any word, three in four with an exponent near 1, so that sums and products meet.
std::uint32_t draw_operand(tb::Random& random) {
  const std::uint32_t word = random.word();
  if (random.chance(0.25)) return word;
  return (word & 0x807FFFFFU) | static_cast<std::uint32_t>(random.between(115, 138)) << 23;
}

template <class VDut>
void expect_mac(std::size_t latency) {
  tb::Random random(tb::seed_from_environment(1));
  tb::Sim<VDut> sim(1);
  std::deque<std::uint32_t> expected;
  int checked = 0, rtl = 0, model = 0;
  for (int i = 0; i < kCases; ++i) {
    const float weight = float_of_bits(sim.dut().weight_i = draw_operand(random));
    const float point = float_of_bits(sim.dut().point_i = draw_operand(random));
    const float sum = float_of_bits(sim.dut().sum_i = draw_operand(random));
    expected.push_back(canonical(std::fma(weight, point, sum)));
    model += bits_of_float(Binary32Fused::mac(sum, weight, point)) != expected.back() ? 1 : 0;
    sim.tick();
    if (expected.size() < latency) continue;
    ++checked;
    rtl += sim.dut().sum_o != expected.front() ? 1 : 0;
    expected.pop_front();
  }
  EXPECT_EQ(checked, kCases - static_cast<int>(latency) + 1);
  EXPECT_EQ(rtl, 0);
  EXPECT_EQ(model, 0);
}

TEST(Mac, OneClock) { expect_mac<Vmac_l1>(1); }
TEST(Mac, FiveClocks) { expect_mac<Vmac_l5>(5); }

}  // namespace
}  // namespace hwffd::test
