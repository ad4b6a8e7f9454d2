// ffd_num_in and the model's coordinate, coefficient, point and range against exact arithmetic:
// converters with different numbers of registers take a word in every clock, in any role, and each
// answers as many clocks later.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <string>

#include "../fixed/exact_units.hpp"
#include "Ventry_units_0.h"
#include "Ventry_units_18.h"
#include "Ventry_units_31.h"
#include "Ventry_units_32.h"
#include "Ventry_units_72.h"
#include "Ventry_units_8.h"
#include "Ventry_units_96.h"
#include "Ventry_units_99.h"
#include "hwffd/numerics/binary32.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {
namespace {

enum Role { kCoordinate, kCoefficient, kPoint };

struct Entry {
  int role = kCoordinate;
  bool clear = false, clamp = false, one = false;
  std::uint32_t word = 0;
  int exponent = 0;
};

template <class F>
inline constexpr bool kBinary32 = false;
template <>
inline constexpr bool kBinary32<Binary32> = true;

/// {outside, NaN, number} as entry_units has it.
std::uint64_t answer(Int128 number, bool nan, bool outside) {
  return static_cast<std::uint64_t>(number) | std::uint64_t{nan} << 62 |
         std::uint64_t{outside} << 63;
}

// ---- exact: where a word lies, and its number as integers

struct Place {
  bool nan = false, outside = false, above = false;
};

template <class F>
Place place_of(std::uint32_t word) {
  if constexpr (kBinary32<F> || kBlock<F>) {
    const FloatFields fields = float_fields(word);
    if (fields.kind != Class::kFinite) return {true, false, !fields.negative};
    const bool below = fields.negative && fields.significand != 0;
    const bool above = !fields.negative && aligned(fields, 32, 70).value > Int128{1} << 32;
    return {false, below || above, above};
  } else {
    const bool below = word >= 0xC0000000U;
    return {false, word > 0x80000000U, !below};
  }
}

template <class F>
Int128 exact_number(const Entry& e) {
  if (e.clear) return 0;
  const Place place = place_of<F>(e.word);
  const bool off = place.nan || place.outside;
  const bool end = e.role == kCoordinate && e.clamp && (e.one || off);
  if constexpr (kBinary32<F>) {
    if (end) return e.one || place.above ? 0x3F800000 : 0;
    return e.word;
  } else {
    constexpr int W = kWidth<F>;
    if (end) return e.one || place.above ? Int128{1} << (W - 2) : 0;
    if (e.role == kCoordinate) return packed(exact_coordinate<F>(e.word), W);
    if (e.role == kCoefficient) {
      return packed(nearest({static_cast<std::int32_t>(e.word), 30}, W - 2, W), false, W);
    }
    Operands o;
    o.word = e.word;
    o.exponent = e.exponent;
    return exact_point<F>(o);
  }
}

// ---- model: the stream clamps the word, then it is converted

Int128 bits_of(float number, int /*width*/) { return bits_of_float(number); }
template <class Number>
auto bits_of(const Number& number, int width) -> decltype(Int128{number.value}) {
  return packed({number.value, number.saturated}, width);
}
template <class Number>
auto bits_of(const Number& number, int width) -> decltype(bits_of(number.number, width)) {
  const double special = number.special;
  const Class kind = std::isnan(special) ? Class::kNan
                     : special > 0       ? Class::kPlus
                     : special < 0       ? Class::kMinus
                                         : Class::kFinite;
  return packed({number.number.value, number.number.saturated, kind}, width);
}

template <class F>
std::uint64_t model_answer(const Entry& e) {
  int width = 32;
  if constexpr (!kBinary32<F>) width = kWidth<F>;
  const CoordinateRange range = F::range(e.word);
  std::uint32_t word = e.word;
  // Of a NaN the model clamps nothing: its vertex is blank.
  if (e.role == kCoordinate && e.clamp) {
    const std::uint32_t end = (e.word >> 31) != 0 ? 0 : F::kOneWord;
    word = e.one ? F::kOneWord : range.nan ? end : range.clamped;
  }
  const Int128 number = e.clear                  ? 0
                        : e.role == kCoordinate  ? bits_of(F::coordinate(word), width)
                        : e.role == kCoefficient ? bits_of(F::coefficient(word), width)
                                                 : bits_of(F::point(word, e.exponent), width);
  return answer(number, range.nan, range.outside);
}

// ---- RTL

template <class Format, class Dut>
class Converters {
 public:
  using F = Format;

  void apply(const Entry& e) {
    const Place place = place_of<F>(e.word);
    const std::uint64_t exact = answer(exact_number<F>(e), place.nan, place.outside);
    ASSERT_EQ(model_answer<F>(e), exact) << "model" << text(e);
    expected_.push_front(exact);
    Dut& dut = sim_.dut();
    dut.role_i = static_cast<CData>(e.role);
    dut.clear_i = e.clear;
    dut.clamp_i = e.clamp;
    dut.one_i = e.one;
    dut.word_i = e.word;
    dut.exponent_i = static_cast<SData>(e.exponent & 0x3FF);
    dut.eval();
    const std::array<std::uint64_t, 6> got{dut.now_o,     dut.after_1_o, dut.after_2_o,
                                           dut.after_3_o, dut.after_4_o, dut.after_9_o};
    for (std::size_t i = 0; i < got.size(); ++i) {
      const std::size_t latency = i == 5 ? 9 : i;
      if (expected_.size() <= latency) continue;
      ASSERT_EQ(got[i], expected_[latency])
          << std::hex << "RTL of latency " << latency << ": got " << got[i] << ", expected "
          << expected_[latency] << " after" << text(e);
      ++compared_;
    }
    if (expected_.size() > 9) expected_.pop_back();
    sim_.tick();
  }
  std::uint64_t compared() const { return compared_; }

 private:
  static std::string text(const Entry& e) {
    return " word " + hex(e.word) + " role " + std::to_string(e.role) + " exponent " +
           std::to_string(e.exponent) + (e.clear ? " clear" : "") + (e.clamp ? " clamp" : "") +
           (e.one ? " one" : "");
  }

  tb::Sim<Dut> sim_{tb::seed_from_environment(1)};
  std::deque<std::uint64_t> expected_;  ///< of the last clocks, the newest first
  std::uint64_t compared_ = 0;
};
using Float = Converters<Binary32, Ventry_units_0>;
using Fixed8 = Converters<Fixed<8>, Ventry_units_8>;
using Fixed18 = Converters<Fixed<18>, Ventry_units_18>;
using Fixed31 = Converters<Fixed<31>, Ventry_units_31>;
using Fixed32 = Converters<Fixed<32>, Ventry_units_32>;
using Block8 = Converters<Block<8>, Ventry_units_72>;
using Block32Bits = Converters<Block<32>, Ventry_units_96>;
using Block35 = Converters<Block<35>, Ventry_units_99>;

// ---- words

/// Any field of the exponent, with a significand at an end, of one bit, or random; or near 0 and 1.
std::uint32_t float_word(tb::Random& random) {
  const std::uint32_t one_bit = 1U << random.below(23);
  const std::uint32_t fraction =
      random.pick({0U, 1U, 0x7FFFFFU, one_bit, one_bit - 1, random.word() & 0x7FFFFFU,
                   random.word() & 0x7FFFFFU});
  const auto field = static_cast<std::uint32_t>(random.below(256));
  const std::uint32_t near = random.pick({0U, 0x3F800000U, 0x7F800000U}) + 2;
  const std::uint32_t magnitude = random.chance(0.1)
                                      ? near - static_cast<std::uint32_t>(random.below(5))
                                      : field << 23 | fraction;
  return (magnitude & 0x7FFFFFFFU) | (random.chance(0.3) ? 0x80000000U : 0U);
}

/// A power of two, an end, or random, up to two units of the last place or half of one away.
std::uint32_t fixed_word(tb::Random& random, int width) {
  const std::uint32_t unit =
      1U << random.pick({0, std::max(31 - width, 0), 32 - width, std::max(33 - width, 0)});
  const std::uint32_t base = random.pick({0U, 0x80000000U, 0xC0000000U, 1U << random.below(32),
                                          random.word(), random.word() & (0U - unit)});
  return base + unit * (static_cast<std::uint32_t>(random.below(5)) - 2) +
         static_cast<std::uint32_t>(random.below(3)) - 1;
}

template <class F>
Entry random_entry(tb::Random& random) {
  Entry e;
  e.role = static_cast<int>(random.below(3));
  e.clear = random.chance(0.1);
  e.clamp = random.chance(0.5);
  e.one = random.chance(0.1);
  if constexpr (kBinary32<F>) {
    e.word = float_word(random);
  } else {
    const bool is_float = kBlock<F> && e.role != kCoefficient;
    e.word = is_float ? float_word(random) : fixed_word(random, kWidth<F>);
  }
  // Two in three within reach of the word, so that it neither vanishes nor overflows.
  e.exponent = random.chance(0.33) ? static_cast<int>(random.below(1024)) - 512
                                   : static_cast<int>(e.word >> 23 & 0xFF) - 129 +
                                         static_cast<int>(random.below(44));
  return e;
}

/// So many words, random but for what `set` puts in, which takes their number.
template <class Converters, class Set>
void run(std::uint64_t cases, Set set) {
  tb::Random random(tb::seed_from_environment(cases));
  Converters converters;
  for (std::uint64_t i = 0; i < cases && !::testing::Test::HasFatalFailure(); ++i) {
    Entry e = random_entry<typename Converters::F>(random);
    set(e, i);
    converters.apply(e);
  }
  EXPECT_EQ(converters.compared(), 6 * cases - (1 + 2 + 3 + 4 + 9));
  std::printf("%llu numbers compared\n", static_cast<unsigned long long>(converters.compared()));
}
template <class Converters>
void run_random() {
  run<Converters>(1'000'000, [](Entry&, std::uint64_t) {});
}

TEST(Entry, CornersAndRandomInBinary32) { run_random<Float>(); }
TEST(Entry, CornersAndRandomAt8Bits) { run_random<Fixed8>(); }
TEST(Entry, CornersAndRandomAt18Bits) { run_random<Fixed18>(); }
TEST(Entry, CornersAndRandomAt31Bits) { run_random<Fixed31>(); }
TEST(Entry, CornersAndRandomAt32Bits) { run_random<Fixed32>(); }
TEST(Entry, CornersAndRandomInBlocksOf8Bits) { run_random<Block8>(); }
TEST(Entry, CornersAndRandomInBlocksOf32Bits) { run_random<Block32Bits>(); }
TEST(Entry, CornersAndRandomInBlocksOf35Bits) { run_random<Block35>(); }

/// The highest 12 bits of a word, the value and four more, in every role, and below them nothing,
/// a one, or ones.
TEST(Entry, EveryWordAt8Bits) {
  run<Fixed8>(4096 * 3 * 3 * 2, [](Entry& e, std::uint64_t i) {
    static constexpr std::uint32_t kBelow[] = {0, 1, 0xFFFFF};
    e.word = static_cast<std::uint32_t>(i & 0xFFF) << 20 | kBelow[i / 4096 % 3];
    e.role = static_cast<int>(i / (4096 * 3) % 3);
    e.clamp = i / (4096 * 9) != 0;
    e.clear = e.one = false;
  });
}

// The ends of the significand in each field of the exponent, in each block there is.
TEST(Entry, EveryFieldInEveryBlock) {
  const auto set = [](Entry& e, std::uint64_t i) {
    const auto field = static_cast<std::uint32_t>(i >> 1 & 0xFF);
    e.role = kPoint;
    e.clear = false;
    e.word = (e.word & 0x80000000U) | field << 23 | (i % 2 != 0 ? 0x7FFFFFU : 0U);
    e.exponent = static_cast<int>(i >> 9) - 512;
  };
  run<Block8>(1024 * 256 * 2, set);
  run<Block35>(1024 * 256 * 2, set);
}

// Every significand of one bit, and those beside it, at every distance there is, subnormals too.
TEST(Entry, EveryBitAtEveryDistance) {
  const auto set = [](Entry& e, std::uint64_t i) {
    const std::uint32_t bit = 1U << (i % 23);
    const auto distance = static_cast<int>(i / 23 % 128) - 32;
    const bool subnormal = i / (23 * 128) % 2 != 0;
    const auto offset = static_cast<std::uint32_t>(i / (23 * 128 * 2) % 3) - 1;
    const std::uint32_t field = subnormal ? 0 : 1 + (e.word >> 23) % 254;
    e.role = kPoint;
    e.clear = false;
    e.word = (e.word & 0x80000000U) | field << 23 | ((bit + offset) & 0x7FFFFFU);
    e.exponent = static_cast<int>(subnormal ? 1 : field) - 87 - distance;
  };
  run<Block8>(23 * 128 * 2 * 3 * 8, set);
  run<Block35>(23 * 128 * 2 * 3 * 8, set);
}

}  // namespace
}  // namespace hwffd::test
