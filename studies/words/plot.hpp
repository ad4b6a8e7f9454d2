#pragma once

#include <string>
#include <vector>

#include "study.hpp"

namespace hwffd::words {

/// build/reports/words.svg: error, on a logarithmic scale, against word length. A form each has its
/// measured maximum, rms and proved bound; horizontal lines for binary32 and for half a pixel.
std::string plot(const std::vector<Result>& results);

}  // namespace hwffd::words
