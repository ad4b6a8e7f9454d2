#include "span_stimulus.hpp"

#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/spans.hpp"

namespace hwffd::test {

std::vector<AxisWords> random_spans(const WordCodec& codec, tb::Random& random,
                                    std::uint64_t count) {
  std::vector<AxisWords> spans;
  const auto like = random_coefficients(codec, random)[0];
  while (spans.size() < count) {
    spans.push_back(random_coefficients(codec, random)[0]);
    if (random.chance(0.2)) continue;  // else in one packet with the others
    spans.back().degree = like.degree;
    spans.back().shift = like.shift;
    spans.back().derivative.shift = like.derivative.shift;
  }
  return spans;
}

std::vector<Beat> random_span_packets(const WordCodec& codec, tb::Random& random,
                                      const PageCore& core) {
  const bool derivatives = (core.features & model::kDerivativesFeature) != 0;
  const auto first = random.below(core.spans);
  const auto count = 1 + random.below(std::min<std::uint64_t>(5, core.spans - first));
  auto beats = spans_packets(
      static_cast<int>(random.below(3)), static_cast<int>(first),
      random_spans(codec, random, count),
      derivatives && random.chance(0.9) ? Functions::kDerivativesToo : Functions::kBlending,
      random.chance(0.6) ? SpanSet::kEnds : SpanSet::kGoesOn);
  if (random.chance(0.7)) return beats;
  auto& words = beats[0].words;
  switch (random.below(6)) {
    case 0:  // one bit more
      words[random.below(4)] ^= 1U << random.below(32);
      break;
    case 1:
      words[2] = (words[2] & ~0xFF00U) | static_cast<std::uint32_t>(random.below(256)) << 8;
      break;
    case 2:
      words[1] = static_cast<std::uint32_t>(random.below(2 * core.spans));
      break;
    case 3:
      beats.resize(1 + random.below(beats.size()));
      beats.back().last = true;
      break;
    default:
      return spoiled(beats, random);
  }
  return beats;
}

}  // namespace hwffd::test
