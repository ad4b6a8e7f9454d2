#include "dims.hpp"

#include <cstdio>

#include "hwffd/error.hpp"

namespace hwffd {

Index3 parse_dims(const std::string& text, const std::string& what, int least, int most) {
  Index3 dims{};
  int end = 0;
  const int read = std::sscanf(text.c_str(), "%2dx%2dx%2d%n", &dims[0], &dims[1], &dims[2], &end);
  if (read != 3 || static_cast<std::size_t>(end) != text.size()) {
    throw UsageError(what + ": expected points an axis, as 4x4x4 or 8x5x6");
  }
  for (const int n : dims) {
    if (n < least || n > most) {
      throw UsageError(what + ": " + std::to_string(least) + " to " + std::to_string(most) +
                       " points an axis");
    }
  }
  return dims;
}

}  // namespace hwffd
