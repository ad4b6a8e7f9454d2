// Polynomials that share the loop of an iterative evaluator never meet in it: every bit of every
// weight against the model, at each length of the loop side by side.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <string>

#include "Vpolynomial_loops.h"
#include "hwffd/model/coefficients.hpp"
#include "hwffd/model/configuration.hpp"
#include "hwffd/tb/sim.hpp"
#include "wide_words.hpp"

namespace hwffd::test {
namespace {

using F = Fixed<18>;
constexpr int kLeast = 2, kMost = 17;  // clocks of a step, as in polynomial_loops.v
constexpr int kLoops = kMost - kLeast + 1;
constexpr int kNumber = 19;  // bits of a weight with its flag

Int128 packed(F::Weight weight) {
  return (weight.value & 0x3FFFF) | Int128{weight.saturated ? 1 : 0} << 18;
}

/// Bits of a port of many words.
template <class Port>
std::uint32_t bits(const Port& port, int low, int width) {
  std::uint64_t two = port[low / 32];
  if (low % 32 + width > 32) two |= std::uint64_t{port[low / 32 + 1]} << 32;
  return static_cast<std::uint32_t>(two >> (low % 32) & ((std::uint64_t{1} << width) - 1));
}

class Polynomials : public ::testing::Test {
 protected:
  Polynomials() {
    sim_->start_i = 0;
    for (int address = 0; address < 16; ++address) load(address);
    for (int loop = 0; loop < kLoops; ++loop) {
      latency_[loop] = bits(sim_->latency_o, 8 * loop, 8);
    }
  }

  /// Starts polynomials, each as many clocks after the one before as `distance` says.
  void run(int polynomials, const std::function<int()>& distance) {
    for (int i = 0; i < polynomials; ++i) {
      start();
      for (int clocks = distance() - 1; clocks > 0; --clocks) step(false);
    }
    while (std::any_of(expected_.begin(), expected_.end(), [](auto& e) { return !e.empty(); })) {
      step(false);
    }
    for (int loop = 0; loop < kLoops; ++loop) EXPECT_EQ(checked_[loop], polynomials);
  }
  void expect_every_bit() {
    for (int loop = 0; loop < kLoops; ++loop) {
      EXPECT_EQ(wrong_[loop], 0) << "a step of " << kLeast + loop << " clocks";
    }
  }
  int interval() const { return interval_; }

  tb::Random random_{tb::seed_from_environment(1)};
  std::array<int, kLoops> wrong_{};

 private:
  struct Weight {
    std::uint64_t clock;
    Int128 bits;
  };

  /// A function with coefficients of every size, as it was loaded; the four of a bank have one
  /// shift.
  void load(int address) {
    auto& entry = bank_.entry[0][address % 4];
    entry = {};
    Int128 word = 0;
    for (int power = 0; power < 4; ++power) {
      entry.coefficient[power].value = static_cast<std::int64_t>(corner_or_random(random_, 18));
      word |= packed(entry.coefficient[power]) << (kNumber * power);
    }
    if (address % 4 == 0) shift_ = static_cast<int>(random_.below(4));
    entry.shift = shift_;
    functions_[address] = bank_;
    sim_->load_i = 1;
    sim_->load_address_i = static_cast<CData>(address);
    drive(sim_->load_entry_i, word | Int128{entry.shift} << (4 * kNumber));
    sim_.tick();
    sim_->load_i = 0;
  }

  void start() {
    const auto address = static_cast<int>(random_.below(16));
    const F::Weight x{static_cast<std::int64_t>(random_.below((1 << 16) + 1)), false};
    const F::Weight weight = model::polynomial(functions_[address], 0, address % 4, x);
    for (int loop = 0; loop < kLoops; ++loop) {
      expected_[loop].push_back({sim_.cycle() + latency_[loop], packed(weight)});
    }
    sim_->coordinate_i = static_cast<IData>(packed(x));
    sim_->address_i = static_cast<CData>(address);
    step(true);
  }

  /// A clock; what is not a start has garbage at the inputs.
  void step(bool starts) {
    if (!starts) {
      sim_->coordinate_i = static_cast<IData>(random_.below(1 << kNumber));
      sim_->address_i = static_cast<CData>(random_.below(16));
    }
    sim_->start_i = starts;
    sim_.tick();
    for (int loop = 0; loop < kLoops; ++loop) {
      auto& expected = expected_[loop];
      if (expected.empty() || expected.front().clock != sim_.cycle()) continue;
      wrong_[loop] += bits(sim_->weight_o, kNumber * loop, kNumber) != expected.front().bits;
      ++checked_[loop];
      expected.pop_front();
    }
  }

  tb::Sim<Vpolynomial_loops> sim_{tb::seed_from_environment(1), 1'000'000};
  const int interval_ = sim_->interval_o;
  int shift_ = 0;
  model::CoefficientBank<F> bank_;
  std::array<model::CoefficientBank<F>, 16> functions_;
  std::array<std::uint64_t, kLoops> latency_{};
  std::array<std::deque<Weight>, kLoops> expected_;
  std::array<int, kLoops> checked_{};
};

// Three passes a polynomial: no loop could take them sooner.
TEST_F(Polynomials, StartEveryThreeClocks) {
  EXPECT_EQ(interval(), 3);
  run(20'000, [] { return 3; });
  expect_every_bit();
}

// Some turns stay empty, so that what is left in the loop of a polynomial that ended goes round.
TEST_F(Polynomials, StartAnyMultipleOfThreeClocksApart) {
  run(20'000, [&] { return 3 * static_cast<int>(1 + random_.below(20)); });
  expect_every_bit();
}

// The comparison can fail: three passes do not fit into two clocks, whatever the loop.
TEST_F(Polynomials, MeetWhereTheyStartSooner) {
  run(2'000, [] { return 2; });
  for (int loop = 0; loop < kLoops; ++loop) {
    EXPECT_GT(wrong_[loop], 1'000) << "a step of " << kLeast + loop << " clocks";
  }
}

// Every length that the table asks for in this schedule is among those above.
TEST(PolynomialLoops, AreThoseOfTheTable) {
  int rows = 0;
  for (const Configuration& row : configurations()) {
    if (row.evaluator != std::string("iterative") || !overlaps(row)) continue;
    const int step = row.fma_latency > 0 ? row.fma_latency : row.mul_latency + row.add_latency;
    EXPECT_GE(step, kLeast) << row.name;
    EXPECT_LE(step, kMost) << row.name;
    ++rows;
  }
  EXPECT_GT(rows, 0);
}

}  // namespace
}  // namespace hwffd::test
