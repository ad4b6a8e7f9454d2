#include "hwffd/stream/word_codec.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "hwffd/error.hpp"
#include "hwffd/numerics/bits.hpp"
#include "hwffd/stream/formats.hpp"

namespace hwffd {
namespace {

std::uint32_t rounded(double value, double low, double high) {
  if (std::isnan(value)) throw Error("a number that is none has no word in fixed point");
  return static_cast<std::uint32_t>(
      static_cast<std::int64_t>(std::clamp(std::nearbyint(value), low, high)));
}

}  // namespace

WordCodec::WordCodec(const std::string& format) {
  const auto entry = std::find_if(std::begin(kFormats), std::end(kFormats),
                                  [&](const Format& known) { return format == known.name; });
  if (entry == std::end(kFormats)) {
    throw UsageError("unknown format '" + format + "': " + kFormatNames);
  }
  if (entry->words == Words::kFloat) return;
  width_ = entry->width;
  block_ = entry->words == Words::kBlock;
}

std::uint32_t WordCodec::coordinate(double value) const {
  if (is_float()) return bits_of_float(static_cast<float>(value));
  return rounded(std::ldexp(value, 31), -0x1p30, 0x1.8p31 - 1);
}

std::uint32_t WordCodec::coefficient(double value, int shift) const {
  if (!has_fixed_weights()) return bits_of_float(static_cast<float>(value));
  return rounded(std::ldexp(value, 30 - shift), -0x1p31, 0x1p31 - 1);
}

std::uint32_t WordCodec::point(double value) const {
  if (is_float()) return bits_of_float(static_cast<float>(value));
  return rounded(std::ldexp(value, 31), -0x1p31, 0x1p31 - 1);
}

double WordCodec::decode_coordinate(std::uint32_t word) const {
  if (is_float()) return float_of_bits(word);
  constexpr std::uint32_t kHalf = 0x40000000;  // the middle of [-1/2, 3/2)
  return std::ldexp(static_cast<std::int32_t>(word - kHalf), -31) + 0.5;
}

}  // namespace hwffd
