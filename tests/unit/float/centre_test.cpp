// ffd_num_centre in binary32: 2 x - 1 rounded once, of every kind of number, after exactly LATENCY
// clocks.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <deque>

#include "Vcentre_l1.h"
#include "Vcentre_l4.h"
#include "hwffd/numerics/binary32.hpp"
#include "hwffd/numerics/bits.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {
namespace {

constexpr int kCases = 1'000'000;

/// In double, which is wide enough for the second rounding to change nothing.
std::uint32_t exact(std::uint32_t word) {
  const auto centred = static_cast<float>(2 * static_cast<double>(float_of_bits(word)) - 1);
  return std::isnan(centred) ? 0x7FC00000U : centred == 0 ? 0U : bits_of_float(centred);
}

/// A coordinate in [0, 1], any word, or one next to an end of an exponent.
std::uint32_t draw(tb::Random& random) {
  if (random.chance(0.5)) return bits_of_float(static_cast<float>(random.unit()));
  if (random.chance(0.5)) return random.word();
  const std::uint32_t exponent = random.pick({0U, 1U, 125U, 126U, 127U, 128U, 253U, 254U, 255U})
                                 << 23;
  return exponent + random.pick({0U, 1U, 0x3FFFFFU, 0x400000U, 0x7FFFFFU});
}

template <class VDut>
void expect_centred(std::size_t latency) {
  tb::Random random(tb::seed_from_environment(1));
  tb::Sim<VDut> sim(1);
  std::deque<std::uint32_t> expected;
  int checked = 0;
  int rtl = 0;
  int model = 0;
  for (int i = 0; i < kCases; ++i) {
    const std::uint32_t word = draw(random);
    sim->coordinate_i = word;
    expected.push_back(exact(word));
    const float centred = Binary32::centre(float_of_bits(word));
    model += bits_of_float(centred) != expected.back() ? 1 : 0;
    sim.tick();
    if (expected.size() < latency) continue;
    ++checked;
    rtl += sim->centred_o != expected.front() ? 1 : 0;
    expected.pop_front();
  }
  EXPECT_EQ(checked, kCases - static_cast<int>(latency) + 1);
  EXPECT_EQ(rtl, 0);
  EXPECT_EQ(model, 0);
}

TEST(Centre, OneClock) { expect_centred<Vcentre_l1>(1); }
TEST(Centre, FourClocks) { expect_centred<Vcentre_l4>(4); }

}  // namespace
}  // namespace hwffd::test
