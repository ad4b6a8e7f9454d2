#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "row.hpp"

namespace hwffd::words {

/// What was measured and proved of one row; errors are absolute, of a component.
struct Result {
  std::string form;
  std::string format;
  int word_length = 0;
  bool fixed = false;
  double max_error = 0;
  double rms_error = 0;
  double bound = 0;
  std::int64_t vertices = 0;
};

/// Called with the done part of the work, 0 to 1, by one thread at a time.
using Progress = std::function<void(double)>;

/// Measures all rows over the same vertices, and proves their bounds, on two threads. The results
/// depend on seed and number of vertices only.
std::vector<Result> study(const Rows& rows, std::int64_t vertices, std::uint64_t seed,
                          const Progress& progress);

}  // namespace hwffd::words
