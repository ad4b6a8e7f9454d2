#pragma once

#include <cstdint>

namespace hwffd {

/// A sum as the stream returns it: the word and what is to be said of it.
struct OutWord {
  std::uint32_t word = 0;
  bool saturated = false;
  bool nan = false;
};

}  // namespace hwffd
