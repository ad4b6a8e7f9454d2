#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace hwffd::testfloat {

/// Binary32 operands by TestFloat's scheme, written from its published description: operands are
/// mostly combinations of a special exponent with a special significand, since errors hide where
/// these meet, and the rest are random in ways that leave long runs of zeros or ones.
///
/// Three kinds of words:
///  * corner: sign, one of the special exponents, one significand of one or two special bits;
///  * mixed: a special exponent, and the sum of two such significands;
///  * random: all bits random, or exponent and significand with runs of equal bits.
///
/// Cases take every combination of kinds in turn. Where all operands are corners, every combination
/// of classes (sign and exponent) comes in turn, too, with significands chosen at random.
class Operands {
 public:
  static constexpr int kMost = 3;

  /// @param count  operands a case: 2 or 3
  Operands(int count, std::uint64_t seed);

  /// The next case; those behind `count` are 0.
  std::array<std::uint32_t, kMost> next();

  /// Classes of a corner: a sign with a special exponent.
  std::uint32_t classes() const;
  /// Combinations of classes of corners that have come so far at least once.
  std::uint64_t combinations() const { return seen_; }
  /// All combinations that there are.
  std::uint64_t all_combinations() const { return all_; }

 private:
  std::uint32_t below(std::uint32_t limit);
  std::uint32_t corner(std::uint32_t which);
  std::uint32_t mixed();
  std::uint32_t random();
  std::uint32_t runs(std::uint32_t bits);

  int count_;
  std::mt19937_64 source_;
  std::vector<std::uint32_t> exponents_;
  std::vector<std::uint32_t> significands_;
  std::uint64_t all_kinds_ = 1;
  std::uint64_t kinds_ = 0;    // which combination of kinds comes next
  std::uint64_t corners_ = 0;  // which combination of classes
  std::uint64_t seen_ = 0;
  std::uint64_t all_ = 1;
};

}  // namespace hwffd::testfloat
