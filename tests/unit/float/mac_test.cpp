// ffd_num_mac: sum + weight x point with one rounding, the operands where they belong, a result a
// clock after exactly LATENCY clocks.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <deque>

#include "Vmac_l1.h"
#include "Vmac_l5.h"
#include "hwffd/numerics/binary32.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {
namespace {

constexpr int kCases = 1'000'000;

float float_of(std::uint32_t word) {
  float value;
  std::memcpy(&value, &word, sizeof value);
  return value;
}

std::uint32_t word_of(float value) {
  std::uint32_t word;
  std::memcpy(&word, &value, sizeof word);
  return word;
}

/// Any word, one in four with an exponent near 1, so that sums and products meet.
std::uint32_t draw(tb::Random& random) {
  const std::uint32_t word = random.word();
  if (random.chance(0.25)) return word;
  const auto exponent = static_cast<std::uint32_t>(random.between(115, 138));
  return (word & 0x807fffffU) | exponent << 23;
}

template <class VDut>
void expect_mac(std::size_t latency) {
  tb::Random random(tb::seed_from_environment(1));
  tb::Sim<VDut> sim(1);
  std::deque<std::uint32_t> expected;
  std::array<int, 2> differ{};  // from the host, from the model
  int checked = 0;
  for (int i = 0; i < kCases; ++i) {
    const float weight = float_of(draw(random));
    const float point = float_of(draw(random));
    const float sum = float_of(draw(random));
    sim->weight_i = word_of(weight);
    sim->point_i = word_of(point);
    sim->sum_i = word_of(sum);
    const float fused = std::fma(weight, point, sum);
    expected.push_back(std::isnan(fused) ? 0x7fc00000U : fused == 0 ? 0U : word_of(fused));
    differ[1] += word_of(Binary32Fused::mac(sum, weight, point)) != expected.back() ? 1 : 0;
    sim.tick();
    if (expected.size() < latency) continue;
    ++checked;
    differ[0] += sim->sum_o != expected.front() ? 1 : 0;
    expected.pop_front();
  }
  EXPECT_EQ(checked, kCases - static_cast<int>(latency) + 1);
  EXPECT_EQ(differ[0], 0);
  EXPECT_EQ(differ[1], 0);
}

TEST(Mac, OneClock) { expect_mac<Vmac_l1>(1); }
TEST(Mac, FiveClocks) { expect_mac<Vmac_l5>(5); }

}  // namespace
}  // namespace hwffd::test
