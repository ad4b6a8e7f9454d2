// The number layer in block floating point, RTL and model, against exact arithmetic: what differs
// from fixed point (aligner, normaliser, infinities) and that the rest is as wide as it should be.
#include "hwffd/numerics/block.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "../unit_pipelines.hpp"
#include "Vblock_units_72.h"
#include "Vblock_units_99.h"
#include "exact_block.hpp"

namespace hwffd::test {
namespace {

/// A number with its flags, as the exact arithmetic has it.
struct Value {
  Int128 value = 0;
  bool saturated = false;
  Class kind = Class::kFinite;
};

struct Operands {
  std::uint32_t word = 0;
  int exponent = 0;
  Value a, b, c;  ///< weights
  Value factor;   ///< a point
  Value sum_a, sum_b;
};

constexpr std::size_t kUnitCount = 9;
using Results = std::array<Int128, kUnitCount>;

/// {minus, plus, saturated} above two's complement of `width` bits.
Int128 packed(const Value& v, int width) {
  const bool plus = v.kind == Class::kPlus || v.kind == Class::kNan;
  const bool minus = v.kind == Class::kMinus || v.kind == Class::kNan;
  const int flags = (minus ? 4 : 0) | (plus ? 2 : 0) | (v.saturated ? 1 : 0);
  return (v.value & ((Int128{1} << width) - 1)) | Int128{flags} << width;
}

Value rounded(Rounded r, bool flag, Class kind = Class::kFinite) {
  return {r.value, r.saturated || flag, kind};
}

/// {NaN, saturated, word}
Int128 packed_out(std::uint32_t word, bool saturated, bool nan) {
  return Int128{word} | Int128{saturated ? 1 : 0} << 32 | Int128{nan ? 1 : 0} << 33;
}

template <int W>
Value exact_coordinate(std::uint32_t word) {
  const Parts parts = parts_of(word);
  const Int128 one = Int128{1} << (W - 2);
  const bool beyond = parts.kind != Class::kFinite;
  if (beyond) return {parts.negative ? 0 : one, true};
  if (parts.negative) return {0, parts.significand != 0};
  const Rounded inside = aligned(parts, W - 2, 64);
  const bool above = word > 0x3F800000U;
  return {above ? one : inside.value, above};
}

template <int W>
Results exact_results(const Operands& o) {
  constexpr int kF = W - 2;
  const Parts parts = parts_of(o.word);
  const bool flag_ab = o.a.saturated || o.b.saturated;
  const Int128 product = o.a.value * o.b.value;
  const Value point = parts.kind == Class::kFinite
                          ? rounded(aligned(parts, W - 1 - o.exponent, W), false)
                          : Value{0, false, parts.kind};
  const Value term{o.a.value * o.factor.value, o.a.saturated || o.factor.saturated,
                   product_class(o.a.value, o.factor.kind)};
  const Value sum{o.sum_a.value + o.sum_b.value, o.sum_a.saturated || o.sum_b.saturated,
                  sum_class(o.sum_a.kind, o.sum_b.kind)};
  static constexpr std::array<std::uint32_t, 4> kSpecial{0, 0x7F800000U, 0xFF800000U, 0x7FC00000U};
  const std::uint32_t out = o.sum_a.kind == Class::kFinite
                                ? rounded_binary32(o.sum_a.value, o.exponent - (2 * W - 3))
                                : kSpecial[static_cast<std::size_t>(o.sum_a.kind)];
  return {packed(exact_coordinate<W>(o.word), W),
          packed(rounded(nearest({static_cast<std::int32_t>(o.word), 30}, kF, W), false), W),
          packed(point, W),
          packed(rounded(nearest({product, 2 * kF}, kF, W), flag_ab), W),
          packed(term, 2 * W + 6),
          packed(rounded(nearest({o.c.value * (Int128{1} << kF) + product, 2 * kF}, kF, W),
                         flag_ab || o.c.saturated),
                 W),
          packed(sum, 2 * W + 6),
          packed(rounded(nearest({o.sum_a.value, 2 * W - 3}, W - 1, W), o.sum_a.saturated,
                         o.sum_a.kind),
                 W),
          packed_out(out, o.sum_a.saturated, o.sum_a.kind == Class::kNan)};
}

double special_of(Class kind) {
  switch (kind) {
    case Class::kFinite:
      return 0;
    case Class::kPlus:
      return HUGE_VAL;
    case Class::kMinus:
      return -HUGE_VAL;
    default:
      return std::nan("");
  }
}

Class class_of(double special) {
  if (std::isnan(special)) return Class::kNan;
  if (special == 0) return Class::kFinite;
  return special > 0 ? Class::kPlus : Class::kMinus;
}

template <int W>
Results model_results(const Operands& o) {
  using F = Block<W>;
  const auto weight = [](const Value& v) {
    return typename F::Weight{static_cast<std::int64_t>(v.value), v.saturated};
  };
  const auto sum_of = [](const Value& v) {
    typename F::Sum sum;
    sum.number.value = static_cast<decltype(sum.number.value)>(v.value);
    sum.number.saturated = v.saturated;
    sum.special = special_of(v.kind);
    return sum;
  };
  const auto of_weight = [](typename F::Weight w) {
    return packed({w.value, w.saturated, Class::kFinite}, W);
  };
  const auto of_point = [](const typename F::Point& p) {
    return packed({p.number.value, p.number.saturated, class_of(p.special)}, W);
  };
  const auto of_sum = [](const typename F::Sum& s) {
    return packed({s.number.value, s.number.saturated, class_of(s.special)}, 2 * W + 6);
  };
  const typename F::Point factor{weight(o.factor), special_of(o.factor.kind)};
  const OutWord out = F::out(sum_of(o.sum_a), o.exponent);
  return {of_weight(F::coordinate(o.word)),
          of_weight(F::coefficient(o.word)),
          of_point(F::point(o.word, o.exponent)),
          of_weight(F::mul(weight(o.a), weight(o.b))),
          of_sum(F::term(weight(o.a), factor)),
          of_weight(F::step(weight(o.c), weight(o.a), weight(o.b))),
          of_sum(F::add(sum_of(o.sum_a), sum_of(o.sum_b))),
          of_point(F::narrow(sum_of(o.sum_a))),
          packed_out(out.word, out.saturated, out.nan)};
}

/// All units of one width: operands go in every clock, results are compared as they come out.
template <int W, class Dut, int kMul, int kAdd, int kEnd>
class Units : public UnitPipelines<Dut, kUnitCount> {
 public:
  Units() : UnitPipelines<Dut, kUnitCount>({0, 0, 0, kMul, kMul, kMul + kAdd, kAdd, kEnd, kEnd}) {}

  void apply(const Operands& o) {
    const std::array<Int128, 6> operands{packed(o.a, W),
                                         packed(o.b, W),
                                         packed(o.c, W),
                                         packed(o.factor, W),
                                         packed(o.sum_a, 2 * W + 6),
                                         packed(o.sum_b, 2 * W + 6)};
    const auto set = [&](auto& dut) {
      drive_operands(dut, o.word, operands);
      dut.exponent_i = static_cast<SData>(o.exponent & 0x3FF);
    };
    const auto results = [](auto& dut) {
      return read_results(dut, read(dut.add_o), read(dut.narrow_o),
                          packed_out(dut.out_o, dut.out_saturated_o != 0, dut.out_nan_o != 0));
    };
    const auto text = [&] {
      std::string all = " after word " + hex(o.word) + " exponent " + std::to_string(o.exponent);
      for (std::size_t i = 0; i < operands.size(); ++i) {
        all += std::array{" a ", " b ", " c ", " point ", " sums ", " "}[i] + hex(operands[i]);
      }
      return all;
    };
    this->clock(exact_results<W>(o), model_results<W>(o), set, results, text);
  }
};
using Units8 = Units<8, Vblock_units_72, 1, 1, 0>;
using Units35 = Units<35, Vblock_units_99, 3, 1, 3>;

/// A binary32 word: any field of the exponent, a significand at an end, of one bit, or random.
std::uint32_t random_word(tb::Random& random) {
  const auto field = static_cast<std::uint32_t>(random.below(256));
  const std::uint32_t one_bit = 1U << random.below(23);
  const std::uint32_t fraction =
      random.pick({0U, 1U, 0x7FFFFFU, one_bit, one_bit - 1, random.word() & 0x7FFFFFU,
                   random.word() & 0x7FFFFFU, random.word() & 0x7FFFFFU});
  return (random.chance(0.5) ? 0x80000000U : 0U) | field << 23 | fraction;
}

/// Two in three within reach of the word, so that it neither vanishes nor overflows.
int random_exponent(tb::Random& random, std::uint32_t word) {
  if (random.chance(0.33)) return static_cast<int>(random.below(1024)) - 512;
  return static_cast<int>(word >> 23 & 0xFF) - 126 + static_cast<int>(random.below(44)) - 3;
}

Class random_class(tb::Random& random) {
  return random.chance(0.7) ? Class::kFinite
                            : random.pick({Class::kPlus, Class::kMinus, Class::kNan});
}

template <int W>
Operands random_operands(tb::Random& random) {
  const auto weight = [&] {
    return Value{random.chance(0.1) ? 0 : corner_or_random(random, W), random.chance(0.1)};
  };
  // Sums of a vertex stay within 64 products, half of the word: two of them never overflow. Small
  // ones too, for results that are subnormal or cancel.
  const auto sum = [&] {
    const Int128 value = corner_or_random(random, 2 * W + 5);
    const Int128 small = value >> random.below(2 * W + 5);
    return Value{random.chance(0.5) ? value : small, random.chance(0.1), random_class(random)};
  };
  Operands o;
  o.word = random_word(random);
  o.exponent = random_exponent(random, o.word);
  o.a = weight();
  o.b = weight();
  o.c = weight();
  o.factor = {corner_or_random(random, W), random.chance(0.1), random_class(random)};
  o.sum_a = sum();
  o.sum_b = sum();
  return o;
}

TEST(Block, EveryWeightTimesEveryPointOfEveryClassAt8Bits) {
  tb::Random random(tb::seed_from_environment(8));
  Units8 units;
  std::uint64_t pairs = 0;
  for (int a = -128; a < 128; ++a) {
    for (int b = -128; b < 128 && !HasFatalFailure(); ++b, ++pairs) {
      for (const Class kind : {Class::kFinite, Class::kPlus, Class::kMinus, Class::kNan}) {
        Operands o = random_operands<8>(random);
        o.a.value = a;
        o.b.value = b;
        o.factor.value = b;
        o.factor.kind = kind;
        units.apply(o);
      }
    }
  }
  EXPECT_EQ(pairs, 65536U);
  EXPECT_GE(units.compared(), Units8::kUnits * 4 * (pairs - 1));
}

// The ends of the significand in each field of the exponent, in each block there is; the sum of the
// same number, so that the normaliser meets each exponent too.
TEST(Block, EveryFieldInEveryBlockAt8Bits) {
  tb::Random random(tb::seed_from_environment(1));
  Units8 units;
  std::uint64_t cases = 0;
  for (int exponent = -512; exponent < 512; ++exponent) {
    for (std::uint32_t field = 0; field < 256 && !HasFatalFailure(); ++field) {
      for (const std::uint32_t fraction : {0U, 0x7FFFFFU}) {
        Operands o = random_operands<8>(random);
        o.word = (random.chance(0.5) ? 0x80000000U : 0U) | field << 23 | fraction;
        o.exponent = exponent;
        units.apply(o);
        ++cases;
      }
    }
  }
  EXPECT_EQ(cases, 1024U * 256 * 2);
  EXPECT_GE(units.compared(), Units8::kUnits * (cases - 10));
}

TEST(Block, CornersAndRandomAt35Bits) { run_random<Units35>(35, 1'000'000, random_operands<35>); }

// The reference of the normaliser itself: known words.
TEST(ExactBlock, KnownRoundings) {
  EXPECT_EQ(rounded_binary32(1, 0), 0x3F800000U);
  EXPECT_EQ(rounded_binary32(-3, -1), 0xBFC00000U);
  EXPECT_EQ(rounded_binary32((Int128{1} << 25) + 2, 0), 0x4C000000U) << "a tie to even, down";
  EXPECT_EQ(rounded_binary32((Int128{1} << 25) + 6, 0), 0x4C000002U) << "a tie to even, up";
  EXPECT_EQ(rounded_binary32((Int128{1} << 24) - 1, 104), 0x7F7FFFFFU);
  EXPECT_EQ(rounded_binary32((Int128{1} << 25) - 1, 103), 0x7F800000U);
  EXPECT_EQ(rounded_binary32(1, -149), 1U);
  EXPECT_EQ(rounded_binary32(1, -150), 0U) << "half the least subnormal, a tie to even";
  EXPECT_EQ(rounded_binary32(-3, -151), 0x80000001U);
  EXPECT_EQ(rounded_binary32(0xFFFFFF, -150), 0x00800000U) << "the largest subnormal, and a half";
}

}  // namespace
}  // namespace hwffd::test
