#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <string>

#include "hwffd/numerics/fixed.hpp"

namespace hwffd::test {

/// A word of up to 128 bits, as it is printed where a comparison fails.
inline std::string hex(Int128 value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%llx_%016llx", static_cast<unsigned long long>(value >> 64),
                static_cast<unsigned long long>(value));
  return buffer;
}

/// Units side by side in RTL, which take operands in every clock: what each gives, as many clocks
/// later as its latency, is compared with exact arithmetic. `text` prints operands on failure.
template <std::size_t kUnits>
class UnitPipelines {
 public:
  using Results = std::array<Int128, kUnits>;

  explicit UnitPipelines(const std::array<int, kUnits>& latencies) : latencies_(latencies) {}
  ~UnitPipelines() { EXPECT_GT(compared_, 0U); }

  /// Keeps what the operands of this clock must give. The model gives it at once.
  template <class Text>
  void expect(const Results& exact, const Results& model, const Text& text) {
    for (std::size_t unit = 0; unit < kUnits; ++unit) {
      ASSERT_TRUE(exact[unit] == model[unit])
          << "model, unit " << unit << ": got " << hex(model[unit]) << ", expected "
          << hex(exact[unit]) << text();
      expected_[unit].push_back(exact[unit]);
    }
  }

  /// Compares what comes out in this clock.
  template <class Text>
  void compare(const Results& got, const Text& text) {
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

  std::uint64_t compared() const { return compared_; }

 private:
  std::array<int, kUnits> latencies_;
  std::array<std::deque<Int128>, kUnits> expected_;
  std::uint64_t compared_ = 0;
};

}  // namespace hwffd::test
