#pragma once

#include <array>
#include <cstdint>

namespace hwffd::model {

/// Whether the functions of an axis, as their words say, sum to 1, and derivatives to 0: some
/// organizations take that for granted. Words are rounded, so that sums may be off by a few units.
/// Mirrors ffd_stream_sums.
class FunctionSums {
 public:
  /// Takes function 0 to 3 of an axis, and says whether it was the last and they do not sum up.
  bool fault(int function, int degree, int shift, bool derivative,
             const std::array<std::uint32_t, 4>& words) {
    if (function == 0) sums_ = {};
    for (int power = 0; power <= degree; ++power) {
      sums_[power] += static_cast<std::int32_t>(words[power]);
    }
    if (function < 3) return false;
    if (!derivative) sums_[0] -= kOne >> shift;
    for (const std::int64_t sum : sums_) {
      if (sum < -kSlack || sum >= kSlack) return true;
    }
    return false;
  }

 private:
  static constexpr std::int64_t kOne = std::int64_t{1} << 30;
  static constexpr std::int64_t kSlack = 4;
  std::array<std::int64_t, 4> sums_{};
};

}  // namespace hwffd::model
