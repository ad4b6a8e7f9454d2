#include "operands.hpp"

#include <algorithm>

namespace hwffd::testfloat {
namespace {

constexpr std::uint32_t kFraction = (1u << 23) - 1;
constexpr int kKinds = 3;

/// Exponent fields: both ends, around 1, and where products and sums reach the ends or part.
std::vector<std::uint32_t> special_exponents() {
  std::vector<std::uint32_t> exponents;
  for (int centre : {0, 2, 24, 63, 103, 127, 151, 190, 253}) {
    for (int step = -1; step <= 2; ++step) {
      const int field = centre + step;
      if (field >= 0 && field <= 255) exponents.push_back(static_cast<std::uint32_t>(field));
    }
  }
  std::sort(exponents.begin(), exponents.end());
  exponents.erase(std::unique(exponents.begin(), exponents.end()), exponents.end());
  return exponents;
}

/// Significands with a one or a zero alone, and with runs of ones from either end.
std::vector<std::uint32_t> special_significands() {
  std::vector<std::uint32_t> significands{0, kFraction};
  for (int place = 0; place < 23; ++place) {
    significands.push_back(1u << place);
    significands.push_back(kFraction ^ (1u << place));
    significands.push_back(kFraction >> place);
    significands.push_back(kFraction << place & kFraction);
  }
  return significands;
}

}  // namespace

Operands::Operands(int count, std::uint64_t seed)
    : count_(count),
      source_(seed),
      exponents_(special_exponents()),
      significands_(special_significands()) {
  for (int i = 0; i < count_; ++i) {
    all_ *= classes();
    all_kinds_ *= kKinds;
  }
}

std::uint32_t Operands::classes() const {
  return 2 * static_cast<std::uint32_t>(exponents_.size());
}

std::array<std::uint32_t, Operands::kMost> Operands::next() {
  std::array<std::uint32_t, kMost> words{};
  std::uint64_t kinds = kinds_;
  std::uint64_t combination = corners_;
  bool all_corners = true;
  for (int i = 0; i < count_; ++i) {
    const std::uint64_t kind = kinds % kKinds;
    kinds /= kKinds;
    all_corners = all_corners && kind == 0;
    if (kind == 0) {
      words[i] = corner(static_cast<std::uint32_t>(combination % classes()));
      combination /= classes();
    } else {
      words[i] = kind == 1 ? mixed() : random();
    }
  }
  if (all_corners) {
    seen_ = std::max(seen_, corners_ + 1);
    corners_ = (corners_ + 1) % all_;
  }
  kinds_ = (kinds_ + 1) % all_kinds_;
  return words;
}

std::uint32_t Operands::below(std::uint32_t limit) {
  return static_cast<std::uint32_t>((source_() >> 32) * limit >> 32);
}

std::uint32_t Operands::corner(std::uint32_t which) {
  const std::uint32_t significand =
      significands_[below(static_cast<std::uint32_t>(significands_.size()))];
  return (which & 1) << 31 | exponents_[which >> 1] << 23 | significand;
}

std::uint32_t Operands::mixed() {
  const std::uint32_t base = corner(below(classes()));
  const std::uint32_t significand =
      significands_[below(static_cast<std::uint32_t>(significands_.size()))];
  return (base & ~kFraction) | ((base + significand) & kFraction);
}

std::uint32_t Operands::random() {
  const auto word = static_cast<std::uint32_t>(source_() >> 32);
  if (below(3) == 0) return word;
  return (word & 0x80000000u) | runs(8) << 23 | runs(23);
}

/// So many bits: random ones between a run of zeros or ones above and one below.
std::uint32_t Operands::runs(std::uint32_t bits) {
  const std::uint32_t all = (1u << bits) - 1;
  const std::uint32_t upper = below(bits + 1);
  const std::uint32_t lower = below(upper + 1);
  const std::uint32_t inside = (all >> (bits - upper)) & ~((1u << lower) - 1);
  const std::uint32_t around = (source_() >> 63) != 0 ? all & ~inside : 0;
  return (static_cast<std::uint32_t>(source_() >> 32) & inside) | around;
}

}  // namespace hwffd::testfloat
