#pragma once

#include <string>
#include <vector>

#include "study.hpp"

namespace hwffd::words {

constexpr int kPictureWidth = 4096;  ///< pixels that the points' range, [-1, 1), is drawn on
constexpr double kHalfPixel = 1.0 / kPictureWidth;

/// A line for each row, below a line of headings.
std::string table(const std::vector<Result>& results);

/// Which word length does what binary32 does, and which suffices for a picture; a form each.
std::string answer(const std::vector<Result>& results);

/// build/reports/words.json.
std::string json_report(const std::vector<Result>& results);

/// A line for each row whose error exceeds the bound that is proved of it, or is no number; empty
/// if none does.
std::string faults(const std::vector<Result>& results);

}  // namespace hwffd::words
