// ffd_num_powers against its model: weights and derivatives at every coordinate of a format, one a
// clock, flags in random places.
#include <gtest/gtest.h>

#include <deque>

#include "Vnum_powers_12.h"
#include "Vnum_powers_17.h"
#include "Vnum_powers_18.h"
#include "Vnum_powers_8.h"
#include "Vnum_powers_9.h"
#include "hwffd/model/org_powers.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::test {
namespace {

bool bit_of(std::uint64_t word, int bit) { return (word >> bit & 1) != 0; }

template <std::size_t Words>
bool bit_of(const VlWide<Words>& wide, int bit) {
  return (wide.at(bit / 32) >> bit % 32 & 1) != 0;
}

/// Weight l of the port: its sign is bit W - 1, its flag bit W.
template <int W, class Port>
typename Fixed<W>::Weight weight_of(const Port& port, int l) {
  typename Fixed<W>::Weight weight;
  for (int bit = 0; bit < W; ++bit) {
    const std::int64_t value = std::int64_t{bit_of(port, (W + 1) * l + bit)} << bit;
    weight.value += bit == W - 1 ? -value : value;
  }
  weight.saturated = bit_of(port, (W + 1) * l + W);
  return weight;
}

template <int W, class Dut>
void expect_model(int latency) {
  using Powers = model::PowersBspline<Fixed<W>>;
  constexpr std::int64_t kOne = std::int64_t{1} << (W - 2);
  Dut dut;
  tb::Random random(W);
  std::deque<typename Powers::Weights> due;
  std::int64_t checked = 0;
  for (std::int64_t clock = 0; clock <= 2 * kOne + 1 + latency; ++clock) {
    const std::int64_t units = std::min(clock / 2, kOne);
    const bool derivative = clock % 2 == 1;
    const typename Fixed<W>::Weight coordinate{units, random.chance(0.1)};
    dut.coordinate_i = static_cast<std::uint32_t>(units | std::int64_t{coordinate.saturated} << W);
    dut.derivative_i = derivative;
    due.push_back(derivative ? Powers::slopes(coordinate) : Powers::weights(coordinate));
    dut.clk = 0;
    dut.eval();
    dut.clk = 1;
    dut.eval();
    if (clock + 1 < latency) continue;
    for (int l = 0; l < 4; ++l) {
      const auto got = weight_of<W>(dut.weights_o, l);
      ASSERT_EQ(got.value, due.front()[l].value) << "clock " << clock << ", weight " << l;
      ASSERT_EQ(got.saturated, due.front()[l].saturated) << "clock " << clock << ", weight " << l;
    }
    due.pop_front();
    ++checked;
  }
  EXPECT_GE(checked, 2 * kOne + 2);
}

TEST(Powers, Of8Bits) { expect_model<8, Vnum_powers_8>(3 * (1 + 1)); }

TEST(Powers, Of9Bits) { expect_model<9, Vnum_powers_9>(3 * (2 + 1)); }

TEST(Powers, Of12Bits) { expect_model<12, Vnum_powers_12>(3 * (3 + 2)); }

TEST(Powers, Of17Bits) { expect_model<17, Vnum_powers_17>(3 * (4 + 1)); }

TEST(Powers, Of18Bits) { expect_model<18, Vnum_powers_18>(3 * (2 + 1)); }

}  // namespace
}  // namespace hwffd::test
