// The number layer in fixed point and in block floating point, RTL and model, against exact
// arithmetic: units side by side take operands in every clock, and what each gives, as many clocks
// later as its latency, is compared; the model gives it at once.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <string>

#include "Vnumber_units_18.h"
#include "Vnumber_units_32.h"
#include "Vnumber_units_72.h"
#include "Vnumber_units_8.h"
#include "Vnumber_units_99.h"
#include "exact_units.hpp"
#include "hwffd/tb/sim.hpp"
#include "wide_words.hpp"

namespace hwffd::test {
namespace {

// ---- model

double special_of(Class kind) {
  const double specials[] = {0, HUGE_VAL, -HUGE_VAL, std::nan("")};
  return specials[static_cast<std::size_t>(kind)];
}
Class class_of(double special) {
  if (std::isnan(special)) return Class::kNan;
  if (special == 0) return Class::kFinite;
  return special > 0 ? Class::kPlus : Class::kMinus;
}

/// As the model has it: a word and a flag, or that beside an infinity or a NaN.
template <class Number>
auto number_of(const Value& v, Number number = {}) -> decltype(void(number.saturated), Number()) {
  number.value = static_cast<decltype(number.value)>(v.value);
  number.saturated = v.saturated;
  return number;
}
template <class Number>
auto number_of(const Value& v, Number number = {}) -> decltype(void(number.special), Number()) {
  return {number_of<decltype(number.number)>(v), special_of(v.kind)};
}
template <class Number>
auto value_of(const Number& number) -> decltype(void(number.saturated), Value()) {
  return {number.value, number.saturated};
}
template <class Number>
auto value_of(const Number& number) -> decltype(void(number.special), Value()) {
  return {number.number.value, number.number.saturated, class_of(number.special)};
}

template <class F>
Results model_results(const Operands& o) {
  constexpr int W = kWidth<F>;
  const auto a = number_of<typename F::Weight>(o.a), b = number_of<typename F::Weight>(o.b);
  const auto c = number_of<typename F::Weight>(o.c);
  const auto factor = number_of<typename F::Point>(o.factor);
  const auto sum_a = number_of<typename F::Sum>(o.sum_a),
             sum_b = number_of<typename F::Sum>(o.sum_b);
  const auto number = [](const auto& n) { return packed(value_of(n), W); };
  const auto sum = [](const auto& s) { return packed(value_of(s), 2 * W + 6); };
  const OutWord out = F::out(sum_a, o.exponent);
  return {number(F::coordinate(o.word)),
          number(F::coefficient(o.word)),
          number(F::point(o.word, o.exponent)),
          number(F::mul(a, b)),
          sum(F::term(a, factor)),
          number(F::step(c, a, b)),
          number(F::scale(a, o.shift)),
          sum(F::add(sum_a, sum_b)),
          number(F::narrow(sum_a)),
          packed_out(out.word, out.saturated, out.nan)};
}

// ---- RTL

/// All units of one format: operands go in every clock, results are compared as they come out.
template <class Format, class Dut, int kMul, int kAdd, int kEnd>
class Units {
 public:
  using F = Format;
  static constexpr std::size_t kCount = kUnits;

  void apply(const Operands& o) {
    const Results exact = exact_results<F>(o), model = model_results<F>(o);
    for (std::size_t unit = 0; unit < kCount; ++unit) {
      ASSERT_TRUE(exact[unit] == model[unit])
          << "model, unit " << unit << ": got " << hex(model[unit]) << ", expected "
          << hex(exact[unit]) << text(o);
      expected_[unit].push_back(exact[unit]);
    }
    drive(sim_.dut(), o);
    sim_.dut().eval();  // converters of latency 0 answer before the edge
    compare(o);
    sim_.tick();
  }
  std::uint64_t compared() const { return compared_; }

 private:
  static constexpr std::array<int, kCount> kLatencies = {0,           0,    0,    kMul, kMul,
                                                         kMul + kAdd, kEnd, kAdd, kEnd, kEnd};

  static void drive(Dut& dut, const Operands& o) {
    constexpr int W = kWidth<F>;
    dut.word_i = o.word;
    dut.exponent_i = static_cast<SData>(o.exponent & 0x3FF);
    test::drive(dut.a_i, packed(o.a, W));
    test::drive(dut.b_i, packed(o.b, W));
    test::drive(dut.c_i, packed(o.c, W));
    test::drive(dut.factor_i, packed(o.factor, W));
    test::drive(dut.sum_a_i, packed(o.sum_a, 2 * W + 6));
    test::drive(dut.sum_b_i, packed(o.sum_b, 2 * W + 6));
    dut.shift_i = static_cast<CData>(o.shift);
  }
  static Results results(const Dut& dut) {
    return {read(dut.coordinate_o),
            read(dut.coefficient_o),
            read(dut.point_o),
            read(dut.mul_o),
            read(dut.term_o),
            read(dut.step_o),
            read(dut.scale_o),
            read(dut.add_o),
            read(dut.narrow_o),
            packed_out(dut.out_o, dut.out_saturated_o != 0, dut.out_nan_o != 0)};
  }
  void compare(const Operands& o) {
    const Results got = results(sim_.dut());
    for (std::size_t unit = 0; unit < kCount; ++unit) {
      auto& expected = expected_[unit];
      if (expected.size() <= static_cast<std::size_t>(kLatencies[unit])) continue;
      ASSERT_TRUE(got[unit] == expected.front())
          << "RTL, unit " << unit << ": got " << hex(got[unit]) << ", expected "
          << hex(expected.front()) << text(o);
      expected.pop_front();
      ++compared_;
    }
  }
  static std::string text(const Operands& o) {
    std::string all = " after word " + hex(o.word) + " exponent " + std::to_string(o.exponent) +
                      " shift " + std::to_string(o.shift) + " a, b, c, point, sums";
    for (const Value* v : {&o.a, &o.b, &o.c, &o.factor, &o.sum_a, &o.sum_b}) {
      all += " " + hex(packed(*v, 2 * kWidth<F> + 6));
    }
    return all;
  }

  tb::Sim<Dut> sim_{tb::seed_from_environment(1)};
  std::array<std::deque<Int128>, kCount> expected_;
  std::uint64_t compared_ = 0;
};
using Fixed8 = Units<Fixed<8>, Vnumber_units_8, 1, 1, 0>;
using Fixed18 = Units<Fixed<18>, Vnumber_units_18, 4, 1, 3>;
using Fixed32 = Units<Fixed<32>, Vnumber_units_32, 5, 2, 1>;
using Block8 = Units<Block<8>, Vnumber_units_72, 1, 1, 0>;
using Block35 = Units<Block<35>, Vnumber_units_99, 3, 1, 3>;

// ---- operands

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

template <class F>
Class random_class(tb::Random& random) {
  if (!kBlock<F> || random.chance(0.7)) return Class::kFinite;
  return random.pick({Class::kPlus, Class::kMinus, Class::kNan});
}

template <class F>
Operands random_operands(tb::Random& random) {
  constexpr int W = kWidth<F>;
  const auto weight = [&] {
    return Value{random.chance(0.1) ? 0 : corner_or_random(random, W), random.chance(0.1)};
  };
  // Sums of a vertex stay within 64 products, half of the word: two of them never overflow. Small
  // ones too, for results that are subnormal or cancel.
  const auto sum = [&] {
    const Int128 value = corner_or_random(random, 2 * W + 5);
    const Int128 small = value >> random.below(2 * W + 5);
    return Value{random.chance(0.5) ? value : small, random.chance(0.1), random_class<F>(random)};
  };
  Operands o;
  o.word =
      kBlock<F> ? random_word(random) : static_cast<std::uint32_t>(corner_or_random(random, 32));
  o.exponent = random_exponent(random, o.word);
  o.a = weight();
  o.b = weight();
  o.c = weight();
  o.factor = {corner_or_random(random, W), random.chance(0.1), random_class<F>(random)};
  o.sum_a = sum();
  o.sum_b = sum();
  o.shift = static_cast<int>(random.below(4));
  return o;
}

/// So many operands, random but for what `set` puts in, which takes their number.
template <class Units, class Set>
void run(std::uint64_t seed, std::uint64_t cases, Set set) {
  tb::Random random(tb::seed_from_environment(seed));
  Units units;
  for (std::uint64_t i = 0; i < cases && !::testing::Test::HasFatalFailure(); ++i) {
    Operands o = random_operands<typename Units::F>(random);
    set(o, i);
    units.apply(o);
  }
  EXPECT_GE(units.compared(), Units::kCount * (cases - 10));
  std::printf("%llu results compared\n", static_cast<unsigned long long>(units.compared()));
}
template <class Units>
void run_random(std::uint64_t seed) {
  run<Units>(seed, 1'000'000, [](Operands&, std::uint64_t) {});
}
/// Eight bits of a number, from `low` on, as a weight or a point.
int operand(std::uint64_t number, unsigned low) {
  return static_cast<int>(number >> low & 0xFF) - 128;
}

TEST(Number, EveryOperandPairAt8Bits) {
  run<Fixed8>(8, 65536 * 16, [](Operands& o, std::uint64_t i) {
    o.a.value = operand(i, 0);
    o.b.value = o.factor.value = operand(i, 8);
    o.c.value = 17 * static_cast<int>(i >> 16) - 128;
  });
}

TEST(Number, CornersAndRandomAt18Bits) { run_random<Fixed18>(18); }
TEST(Number, CornersAndRandomAt32Bits) { run_random<Fixed32>(32); }

TEST(Block, EveryWeightTimesEveryPointOfEveryClassAt8Bits) {
  run<Block8>(8, 65536 * 4, [](Operands& o, std::uint64_t i) {
    o.a.value = operand(i, 0);
    o.b.value = o.factor.value = operand(i, 8);
    o.factor.kind = static_cast<Class>(i >> 16);
  });
}

// The ends of the significand in each field of the exponent, in each block there is; the sum of the
// same number, so that the normaliser meets each exponent too.
TEST(Block, EveryFieldInEveryBlockAt8Bits) {
  run<Block8>(1, 1024 * 256 * 2, [](Operands& o, std::uint64_t i) {
    const auto field = static_cast<std::uint32_t>(i >> 1 & 0xFF);
    o.word = (o.word & 0x80000000U) | field << 23 | (i % 2 != 0 ? 0x7FFFFFU : 0U);
    o.exponent = static_cast<int>(i >> 9) - 512;
  });
}

TEST(Block, CornersAndRandomAt35Bits) { run_random<Block35>(35); }

}  // namespace
}  // namespace hwffd::test
