#pragma once

#include <cstdint>
#include <string>

#include "hwffd/stream/beat.hpp"

namespace hwffd::tb {

/// A beat in hex, word 0 first: `3f800000 40000000 00000000 00000003 last`.
std::string beat_text(const Beat& beat);

/// The tag of a result or a vertex: by convention the low 16 bits of word 3.
inline std::uint16_t beat_tag(const Beat& beat) {
  return static_cast<std::uint16_t>(beat.words[3] & 0xffffu);
}

}  // namespace hwffd::tb
