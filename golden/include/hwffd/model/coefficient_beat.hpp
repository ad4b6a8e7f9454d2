#pragma once

#include "hwffd/model/span_table.hpp"
#include "hwffd/stream/packets.hpp"

namespace hwffd::model {

/// A function, or the derivative of one, that a beat of opcode 1 brings.
struct CoefficientBeat {
  int axis = 0;
  int function = 0;  ///< 0 to 3
  bool derivative = false;
  FunctionWords words;
};

/// Whether a packet of coefficients brings derivatives, too.
inline bool brings_derivatives(const Beat& header) {
  return (header.words[2] & kDerivativesFollow) != 0;
}

/// Beats behind that header.
inline int coefficient_beats(const Beat& header) {
  return (brings_derivatives(header) ? 2 : 1) * kCoefficientBeats;
}

/// What a beat of the payload brings, the first one being number 0.
inline CoefficientBeat coefficient_of(const Beat& header, int number, const Beat& beat) {
  CoefficientBeat read;
  read.axis = number % kCoefficientBeats / 4;
  read.function = number % 4;
  read.derivative = number >= kCoefficientBeats;
  const auto field = [&](int low) {
    return static_cast<int>(header.words[2] >> (low + 2 * read.axis)) & 3;
  };
  read.words = {field(0), field(read.derivative ? 16 : 8), beat.words};
  return read;
}

}  // namespace hwffd::model
