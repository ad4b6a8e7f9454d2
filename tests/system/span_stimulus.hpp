#pragma once

#include <vector>

#include "page_stimulus.hpp"

namespace hwffd::test {

/// Functions for `count` spans; most have the degree and the shifts of the first.
std::vector<AxisWords> random_spans(const WordCodec& codec, tb::Random& random,
                                    std::uint64_t count);

/// Spans anywhere in the table, some of them the end of a set; some with one thing wrong.
std::vector<Beat> random_span_packets(const WordCodec& codec, tb::Random& random,
                                      const PageCore& core);

}  // namespace hwffd::test
