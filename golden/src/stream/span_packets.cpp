// Spans as words and packets.
#include <algorithm>
#include <stdexcept>

#include "hwffd/stream/spans.hpp"

namespace hwffd {
namespace {

constexpr std::size_t kMostSpans = 256;  // `first` has eight bits

using Spans = std::vector<AxisWords>;
using Place = Spans::const_iterator;

bool have_equal_header(const AxisWords& a, const AxisWords& b) {
  return a.degree == b.degree && a.shift == b.shift && a.derivative.shift == b.derivative.shift;
}

bool are_equal(const AxisWords& a, const AxisWords& b) {
  return have_equal_header(a, b) && a.word == b.word && a.derivative.word == b.derivative.word;
}

/// A packet of spans that have the header's fields in common.
std::vector<Beat> packet_of(int axis, std::size_t first, Place begin, Place end,
                            Functions functions, bool ends) {
  const bool derivatives = functions == Functions::kDerivativesToo;
  std::vector<Beat> beats(1);
  beats[0].words = {
      static_cast<std::uint32_t>(Opcode::kSpans) | (ends ? kEndsSet : 0),
      static_cast<std::uint32_t>(end - begin),
      static_cast<std::uint32_t>(begin->degree) | static_cast<std::uint32_t>(begin->shift) << 4 |
          static_cast<std::uint32_t>(first) << 8 | static_cast<std::uint32_t>(axis) << 22,
      0};
  if (derivatives) {
    beats[0].words[2] |= kDerivativesFollow | static_cast<std::uint32_t>(begin->derivative.shift)
                                                  << 18;
  }
  for (Place span = begin; span != end; ++span) {
    for (const auto& words : span->word) beats.push_back({words, false});
    if (!derivatives) continue;
    for (const auto& words : span->derivative.word) beats.push_back({words, false});
  }
  beats.back().last = true;
  return beats;
}

}  // namespace

std::vector<AxisWords> encode(const std::vector<Blending>& spans, const WordCodec& codec) {
  int exponent = 0;
  for (const Blending& span : spans) exponent = std::max(exponent, derivative_exponent(span));
  std::vector<AxisWords> words;
  words.reserve(spans.size());
  for (const Blending& span : spans) words.push_back(encode(span, codec, exponent));
  return words;
}

std::vector<Beat> spans_packets(int axis, int first, const std::vector<AxisWords>& spans,
                                Functions functions, SpanSet set) {
  if (spans.empty() || first < 0 || axis < 0 || axis > 2 || first + spans.size() > kMostSpans) {
    throw std::invalid_argument("spans of an axis, 1 to 256 of them");
  }
  std::vector<Beat> beats;
  for (Place begin = spans.begin(); begin != spans.end();) {
    const Place end = std::find_if(begin, spans.end(), [&](const AxisWords& span) {
      return !have_equal_header(span, *begin);
    });
    const auto at = static_cast<std::size_t>(first + (begin - spans.begin()));
    append(beats,
           packet_of(axis, at, begin, end, functions, set == SpanSet::kEnds && end == spans.end()));
    begin = end;
  }
  return beats;
}

std::vector<Beat> all_spans_packets(const std::array<std::vector<AxisWords>, 3>& axes,
                                    Functions functions) {
  std::array<AxisWords, 3> common;
  struct Run {
    int axis;
    Place begin, end;
  };
  std::vector<Run> runs;
  for (int axis = 0; axis < 3; ++axis) {
    const Spans& spans = axes[axis];
    if (spans.empty()) throw std::invalid_argument("an axis has one span or more");
    common[axis] = spans[spans.size() / 2];
    const auto differs = [&](const AxisWords& span) { return !are_equal(span, common[axis]); };
    for (Place begin = std::find_if(spans.begin(), spans.end(), differs); begin != spans.end();) {
      const Place end = std::find_if_not(begin, spans.end(), differs);
      runs.push_back({axis, begin, end});
      begin = std::find_if(end, spans.end(), differs);
    }
  }
  std::vector<Beat> beats = coefficients_packet(common, functions);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto& [axis, begin, end] = runs[r];
    append(beats,
           spans_packets(axis, static_cast<int>(begin - axes[axis].begin()), Spans(begin, end),
                         functions, r + 1 == runs.size() ? SpanSet::kEnds : SpanSet::kGoesOn));
  }
  return beats;
}

}  // namespace hwffd
