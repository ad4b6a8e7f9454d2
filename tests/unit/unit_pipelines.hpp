#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <string>

#include "fixed/wide_words.hpp"
#include "hwffd/numerics/fixed.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {

/// A word of up to 128 bits, as it is printed where a comparison fails.
inline std::string hex(Int128 value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%llx_%016llx", static_cast<unsigned long long>(value >> 64),
                static_cast<unsigned long long>(value));
  return buffer;
}

/// Units side by side in RTL, which take operands in every clock: what each gives, as many clocks
/// later as its latency, is compared with exact arithmetic. The model gives it at once.
template <class Dut, std::size_t kCount>
class UnitPipelines {
 public:
  static constexpr std::size_t kUnits = kCount;
  using Results = std::array<Int128, kUnits>;

  explicit UnitPipelines(const std::array<int, kUnits>& latencies) : latencies_(latencies) {}
  ~UnitPipelines() { EXPECT_GT(compared_, 0U); }

  /// One clock: `drive` puts operands on the pins, `read` takes what comes out in this clock,
  /// `text` prints the operands on failure.
  template <class Drive, class Read, class Text>
  void clock(const Results& exact, const Results& model, Drive drive, Read read, Text text) {
    for (std::size_t unit = 0; unit < kUnits; ++unit) {
      ASSERT_TRUE(exact[unit] == model[unit])
          << "model, unit " << unit << ": got " << hex(model[unit]) << ", expected "
          << hex(exact[unit]) << text();
      expected_[unit].push_back(exact[unit]);
    }
    drive(sim_.dut());
    sim_.dut().eval();  // converters of latency 0 answer before the edge
    compare(read(sim_.dut()), text);
    sim_.tick();
  }

  std::uint64_t compared() const { return compared_; }

 private:
  template <class Text>
  void compare(const Results& got, Text text) {
    for (std::size_t unit = 0; unit < kUnits; ++unit) {
      auto& expected = expected_[unit];
      if (expected.size() <= static_cast<std::size_t>(latencies_[unit])) continue;
      ASSERT_TRUE(got[unit] == expected.front())
          << "RTL, unit " << unit << ": got " << hex(got[unit]) << ", expected "
          << hex(expected.front()) << text();
      expected.pop_front();
      ++compared_;
    }
  }

  tb::Sim<Dut> sim_{tb::seed_from_environment(1)};
  std::array<int, kUnits> latencies_;
  std::array<std::deque<Int128>, kUnits> expected_;
  std::uint64_t compared_ = 0;
};

/// The operands that every format has, on the pins of `number_units`.
template <class Dut>
void drive_operands(Dut& dut, std::uint32_t word, const std::array<Int128, 6>& operands) {
  dut.word_i = word;
  drive(dut.a_i, operands[0]);
  drive(dut.b_i, operands[1]);
  drive(dut.c_i, operands[2]);
  drive(dut.factor_i, operands[3]);
  drive(dut.sum_a_i, operands[4]);
  drive(dut.sum_b_i, operands[5]);
}

/// The six results that come first in every format, and then the others.
template <class Dut, class... Others>
std::array<Int128, 6 + sizeof...(Others)> read_results(Dut& dut, Others... others) {
  return {read(dut.coordinate_o), read(dut.coefficient_o), read(dut.point_o), read(dut.mul_o),
          read(dut.term_o),       read(dut.step_o),        others...};
}

/// `cases` operands of `draw` through units of a width.
template <class Units, class Draw>
void run_random(std::uint64_t seed, std::uint64_t cases, Draw draw) {
  tb::Random random(tb::seed_from_environment(seed));
  Units units;
  for (std::uint64_t i = 0; i < cases && !::testing::Test::HasFatalFailure(); ++i) {
    units.apply(draw(random));
  }
  EXPECT_GE(units.compared(), Units::kUnits * (cases - 10));
  std::printf("%llu results compared\n", static_cast<unsigned long long>(units.compared()));
}

}  // namespace hwffd::test
