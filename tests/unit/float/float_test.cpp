// The floating-point units, one body for all: each row of float_rows.inc is a unit in a format at a
// latency. Formats of up to 10 bits are run over all their words against exact integers, binary32
// over corner and random cases against the host. SEED= replays another choice of these.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "exact_reference.hpp"
#include "float_units.inc"
#include "hwffd/numerics/bits.hpp"
#include "hwffd/tb/sim.hpp"

namespace {

namespace exact = hwffd::exact;
using hwffd::float_of_bits;

enum class Unit { Add, Mul, Fma };

struct Case {
  std::uint32_t a, b, c;
};

std::uint64_t seed() {
  const char* text = std::getenv("SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 0) : 1;
}

// ---- all words of a small format
// -----------------------------------------------------------------

/// Counts through all pairs, or all triples, of words.
template <Unit kUnit, int kExponent, int kFraction>
class Exhaustive {
 public:
  static constexpr exact::Format kFormat{kExponent, kFraction + 1};
  static constexpr int kWord = kFormat.word_bits();
  static constexpr std::uint64_t kCases = std::uint64_t{1} << (kUnit == Unit::Fma ? 3 : 2) * kWord;

  Exhaustive() {
    for (std::uint32_t word = 0; word < numbers_.size(); ++word) {
      numbers_[word] = exact::decode(kFormat, word);
    }
  }
  Case operator()(std::uint64_t i) const {
    constexpr std::uint64_t kMask = (1u << kWord) - 1;
    return {static_cast<std::uint32_t>(i & kMask), static_cast<std::uint32_t>(i >> kWord & kMask),
            static_cast<std::uint32_t>(i >> 2 * kWord & kMask)};
  }
  std::uint32_t expected(const Case& in) const {
    const exact::Number &a = numbers_[in.a], &b = numbers_[in.b], &c = numbers_[in.c];
    switch (kUnit) {
      case Unit::Add:
        return exact::add(kFormat, a, b);
      case Unit::Mul:
        return exact::mul(kFormat, a, b);
      case Unit::Fma:
        return exact::fma(kFormat, a, b, c);
    }
  }

 private:
  std::array<exact::Number, std::size_t{1} << kWord> numbers_;
};

// ---- binary32
// ------------------------------------------------------------------------------------

/// The host's result as the units give it: one NaN, one zero.
std::uint32_t canonical(float value) {
  return std::isnan(value) ? 0x7fc00000u : value == 0 ? 0 : hwffd::bits_of_float(value);
}

/// Operands whose parts are special, in the manner of TestFloat, mixed with random ones and with
/// operands that nearly cancel.
template <Unit kUnit>
class Binary32 {
 public:
  static constexpr std::uint64_t kCases = 10'000'000;

  Binary32() : random_(seed()) {
    constexpr int kBias = 127, kMax = 255, kSig = 24;
    exponents_ = {0, 1, 2, 3, kSig - 1, kSig, kSig + 1, 2 * kSig, kMax - 1, kMax};
    // Around 1; where a product of equals under- or overflows; at distances of a significand or
    // two.
    for (int centre : {kBias, kBias / 2, kBias + kBias / 2, kBias - kSig, kBias + kSig,
                       kBias - 2 * kSig, kBias + 2 * kSig, kBias / 2 - kSig / 2, kMax - kSig}) {
      for (int step = -2; step <= 2; ++step) exponents_.push_back(centre + step);
    }
    constexpr std::uint32_t kOnes = 0x7fffff;
    fractions_ = {0, 3, 5, kOnes, kOnes - 2, 0x555555, 0x2aaaaa};
    for (int i = 0; i < 23; ++i) {
      fractions_.push_back(1u << i);
      fractions_.push_back(kOnes ^ 1u << i);
      fractions_.push_back(kOnes >> i);
      fractions_.push_back(kOnes << i & kOnes);
    }
  }

  /// Draws in order: the argument is not needed to find a case again, the seed is.
  Case operator()(std::uint64_t) {
    Case in{word(), word(), word()};
    if ((random_() & 7) == 0) {
      const auto nudge = static_cast<std::uint32_t>(random_() % 7) - 3;
      if (kUnit == Unit::Add) in.b = (in.a ^ 0x80000000u) + nudge;
      if (kUnit == Unit::Fma) in.c = canonical(-float_of_bits(in.a) * float_of_bits(in.b)) + nudge;
    }
    return in;
  }
  std::uint32_t expected(const Case& in) const {
    const float a = float_of_bits(in.a), b = float_of_bits(in.b), c = float_of_bits(in.c);
    switch (kUnit) {
      case Unit::Add:
        return canonical(a + b);
      case Unit::Mul:
        return canonical(a * b);
      case Unit::Fma:
        return canonical(std::fma(a, b, c));
    }
  }

 private:
  /// Sign, exponent and fraction; half of the exponents and half of the fractions are special.
  std::uint32_t word() {
    const std::uint64_t draw = random_();
    auto result = static_cast<std::uint32_t>(draw >> 32);
    const std::uint32_t pick = draw >> 16 & 0xffff;
    if ((draw & 1) != 0) {
      result = (result & 0x807fffffu) | exponents_[pick % exponents_.size()] << 23;
    }
    if ((draw & 2) != 0) {
      result = (result & 0xff800000u) | fractions_[pick / 64 % fractions_.size()];
    }
    return result;
  }

  std::mt19937_64 random_;
  std::vector<std::uint32_t> exponents_;
  std::vector<std::uint32_t> fractions_;
};

// ---- driving a unit
// ------------------------------------------------------------------------------

std::string describe(const Case& in, int digits, bool three) {
  std::ostringstream out;
  out << std::hex << std::setfill('0') << "a " << std::setw(digits) << in.a << "  b "
      << std::setw(digits) << in.b;
  if (three) out << "  c " << std::setw(digits) << in.c;
  return out.str();
}

/// A new case every clock; the result of each is expected exactly kLatency clocks later, and no
/// other one at any time.
template <class VDut, Unit kUnit, int kLatency, class Cases>
class ValueTest : public testing::Test {
 public:
  explicit ValueTest(int word_bits) : digits_((word_bits + 3) / 4) {}

  void TestBody() override {
    constexpr int kMaxFailures = 20;
    hwffd::tb::Sim<VDut> unit(seed());
    Cases cases;
    std::array<Case, kLatency> under_way{};
    std::uint64_t checked = 0;
    int failures = 0;
    for (std::uint64_t i = 0; i < Cases::kCases + kLatency - 1; ++i) {
      const Case in = i < Cases::kCases ? cases(i) : Case{};
      under_way[i % kLatency] = in;
      unit->a_i = in.a;
      unit->b_i = in.b;
      if constexpr (kUnit == Unit::Fma) unit->c_i = in.c;
      unit.tick();
      const std::uint32_t got = unit->result_o;
      if (i + 1 < kLatency) continue;
      const Case& out = under_way[(i + 1) % kLatency];
      const std::uint32_t expected = cases.expected(out);
      ++checked;
      if (got == expected) continue;
      ADD_FAILURE() << describe(out, digits_, kUnit == Unit::Fma) << std::hex << std::setfill('0')
                    << "  got " << std::setw(digits_) << got << "  expected " << std::setw(digits_)
                    << expected << std::dec << "  case " << checked - 1 << "  SEED=" << seed();
      if (++failures == kMaxFailures) FAIL() << "stopped after " << kMaxFailures << " failures";
    }
    std::cout << checked << " cases checked\n";
    RecordProperty("cases", std::to_string(checked));
    EXPECT_EQ(checked, Cases::kCases);
    EXPECT_GT(checked, 0u);
  }

 private:
  int digits_;
};

/// Registers the test of a row.
template <class VDut, Unit kUnit, int kExponent, int kFraction, int kLatency>
void register_row(const std::string& unit, int line) {
  constexpr bool kIsBinary32 = kExponent == 8 && kFraction == 23;
  static_assert(kIsBinary32 || kExponent + kFraction + 1 <= 10, "too many words to try them all");
  const std::string name = unit + "_e" + std::to_string(kExponent) + "f" +
                           std::to_string(kFraction) + "_latency" + std::to_string(kLatency);
  testing::RegisterTest("float", name.c_str(), nullptr, nullptr, __FILE__, line,
                        []() -> testing::Test* {
                          if constexpr (kIsBinary32) {
                            return new ValueTest<VDut, kUnit, kLatency, Binary32<kUnit>>(32);
                          } else {
                            using Cases = Exhaustive<kUnit, kExponent, kFraction>;
                            return new ValueTest<VDut, kUnit, kLatency, Cases>(Cases::kWord);
                          }
                        });
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
#define FLOAT_ROW(unit, exponent, fraction, latency, dut) \
  register_row<dut, Unit::unit, exponent, fraction, latency>(#unit, __LINE__);
#include "float_rows.inc"
#undef FLOAT_ROW
  return RUN_ALL_TESTS();
}
