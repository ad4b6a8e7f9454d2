// The number layer in fixed point, RTL and model, against exact arithmetic.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "../unit_pipelines.hpp"
#include "Vnumber_units_18.h"
#include "Vnumber_units_32.h"
#include "Vnumber_units_8.h"
#include "exact_fixed.hpp"

namespace hwffd::test {
namespace {

/// Two's complement of `width` bits below a flag.
Int128 packed(Int128 value, bool flag, int width) {
  const Int128 mask = (Int128{1} << width) - 1;
  return (value & mask) | Int128{flag ? 1 : 0} << width;
}
Int128 packed(Rounded rounded, bool flag, int width) {
  return packed(rounded.value, rounded.saturated || flag, width);
}

struct Operands {
  std::uint32_t word = 0;
  Int128 a = 0, b = 0, c = 0, sum_a = 0, sum_b = 0;
  bool flag_a = false, flag_b = false, flag_c = false;
  int shift = 0;
  int rescale = 0;
  int widen = 0;
};

constexpr std::size_t kUnitCount = 13;
using Results = std::array<Int128, kUnitCount>;

template <int W>
Results exact_results(const Operands& o) {
  constexpr int kF = W - 2;
  const bool below = o.word >= 0xC0000000U;  // a coordinate below 0
  const bool outside = o.word > 0x80000000U;
  const Exact coordinate{below ? 0 : outside ? Int128{0x80000000U} : Int128{o.word}, 31};
  const Int128 word = static_cast<std::int32_t>(o.word);
  const Int128 product = o.a * o.b;
  const Int128 one = Int128{1} << kF;
  const bool flag_ab = o.flag_a || o.flag_b;
  const Int128 out = packed(nearest({o.sum_a, 2 * W - 3}, 31, 32), o.flag_a, 32);
  return {packed(nearest(coordinate, kF, W), outside, W),
          packed(nearest({word, 30}, kF, W), false, W),
          packed(nearest({word, 31}, W - 1, W), false, W),
          packed(nearest({product, 2 * kF}, kF, W), flag_ab, W),
          packed(product, flag_ab, 2 * W + 6),
          packed(nearest({o.c * one + product, 2 * kF}, kF, W), flag_ab || o.flag_c, W),
          packed(nearest({o.a * (1 << o.shift), kF}, kF, W), o.flag_a, W),
          packed(o.sum_a + o.sum_b, flag_ab, 2 * W + 6),
          packed(nearest({o.sum_a, 2 * W - 3}, W - 1, W), o.flag_a, W),
          packed(nearest({o.sum_a * (1 << (o.rescale + 1)), 2 * W - 2}, W - 1, W), o.flag_a, W),
          packed(2 * nearest(coordinate, kF, W).value - one, outside, W),
          packed(o.b * one * (1 << o.widen), o.flag_b, 2 * W + 6),
          out};
}

template <int W>
Results model_results(const Operands& o) {
  using F = Fixed<W>;
  using Number = typename F::Number;
  const Number a{static_cast<std::int64_t>(o.a), o.flag_a};
  const Number b{static_cast<std::int64_t>(o.b), o.flag_b};
  const Number c{static_cast<std::int64_t>(o.c), o.flag_c};
  typename F::Sum sum_a;
  sum_a.value = static_cast<decltype(sum_a.value)>(o.sum_a);
  sum_a.saturated = o.flag_a;
  typename F::Sum sum_b;
  sum_b.value = static_cast<decltype(sum_b.value)>(o.sum_b);
  sum_b.saturated = o.flag_b;
  const auto number = [](Number n) { return packed(n.value, n.saturated, W); };
  const auto sum = [](typename F::Sum s) { return packed(s.value, s.saturated, 2 * W + 6); };
  const OutWord out = F::out(sum_a);
  return {number(F::coordinate(o.word)),
          number(F::coefficient(o.word)),
          number(F::point(o.word)),
          number(F::mul(a, b)),
          sum(F::term(a, b)),
          number(F::step(c, a, b)),
          number(F::scale(a, o.shift)),
          sum(F::add(sum_a, sum_b)),
          number(F::narrow(sum_a)),
          number(F::rescale(sum_a, o.rescale)),
          number(F::centre(F::coordinate(o.word))),
          sum(F::widen(b, o.widen)),
          packed(Int128{out.word}, out.saturated, 32)};
}

/// All units of one width: operands go in every clock, results are compared as they come out.
template <int W, class Dut, int kMul, int kAdd, int kEnd>
class Units : public UnitPipelines<Dut, kUnitCount> {
 public:
  Units()
      : UnitPipelines<Dut, kUnitCount>(
            {0, 0, 0, kMul, kMul, kMul + kAdd, kEnd, kAdd, kEnd, kEnd, kAdd, 0, kEnd}) {}

  void apply(const Operands& o) {
    const auto set = [&o](auto& dut) {
      const auto sum = [&](Int128 value, bool flag) { return packed(value, flag, 2 * W + 6); };
      const Int128 b = packed(o.b, o.flag_b, W);
      drive_operands(dut, o.word,
                     {packed(o.a, o.flag_a, W), b, packed(o.c, o.flag_c, W), b,
                      sum(o.sum_a, o.flag_a), sum(o.sum_b, o.flag_b)});
      dut.shift_i = static_cast<CData>(o.shift);
      dut.widen_i = static_cast<CData>(o.widen);
      dut.rescale_i = static_cast<CData>(o.rescale & 7);
    };
    const auto results = [](auto& dut) {
      return read_results(dut, read(dut.scale_o), read(dut.add_o), read(dut.narrow_o),
                          read(dut.rescale_o), read(dut.centre_o), read(dut.widen_o),
                          Int128{dut.out_o} | Int128{dut.out_saturated_o} << 32);
    };
    const auto text = [&o] {
      return " after word " + hex(o.word) + " a " + hex(o.a) + " b " + hex(o.b) + " c " + hex(o.c) +
             " shift " + std::to_string(o.shift) + " sums " + hex(o.sum_a) + " " + hex(o.sum_b);
    };
    this->clock(exact_results<W>(o), model_results<W>(o), set, results, text);
  }
};
using Units8 = Units<8, Vnumber_units_8, 1, 1, 0>;
using Units18 = Units<18, Vnumber_units_18, 4, 1, 3>;
using Units32 = Units<32, Vnumber_units_32, 5, 2, 1>;

template <int W>
Operands random_operands(tb::Random& random) {
  Operands o;
  o.word = static_cast<std::uint32_t>(corner_or_random(random, 32));
  o.a = corner_or_random(random, W);
  o.b = corner_or_random(random, W);
  o.c = corner_or_random(random, W);
  // Sums of a vertex stay within 64 products, half of the word: two of them never overflow.
  o.sum_a = corner_or_random(random, 2 * W + 5);
  o.sum_b = corner_or_random(random, 2 * W + 5);
  o.flag_a = random.chance(0.1);
  o.flag_b = random.chance(0.1);
  o.flag_c = random.chance(0.1);
  o.shift = static_cast<int>(random.below(4));
  o.widen = static_cast<int>(random.below(3));
  o.rescale = static_cast<int>(random.below(5)) - 1;
  return o;
}

TEST(Number, EveryOperandPairAt8Bits) {
  tb::Random random(tb::seed_from_environment(8));
  Units8 units;
  std::uint64_t pairs = 0;
  for (int a = -128; a < 128; ++a) {
    for (int b = -128; b < 128 && !HasFatalFailure(); ++b) {
      for (int c = -128; c < 128; c += 17) {
        Operands o = random_operands<8>(random);
        o.a = a;
        o.b = b;
        o.c = c;
        units.apply(o);
      }
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, 65536U);
  EXPECT_GE(units.compared(), Units8::kUnits * 16 * (pairs - 1));
  std::printf("%llu pairs, %llu results compared\n", static_cast<unsigned long long>(pairs),
              static_cast<unsigned long long>(units.compared()));
}

TEST(Number, CornersAndRandomAt18Bits) { run_random<Units18>(18, 1'000'000, random_operands<18>); }
TEST(Number, CornersAndRandomAt32Bits) { run_random<Units32>(32, 1'000'000, random_operands<32>); }

}  // namespace
}  // namespace hwffd::test
