#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "hwffd/model/stream_model.hpp"

namespace hwffd::test {

/// Which core a board has.
enum class BoardCore { kStream, kSmall };

/// `StreamModel`, and where a board has `ffd_board_core` what that does otherwise.
class BoardModel {
 public:
  BoardModel(const Configuration& row, BoardCore core)
      : stream_(row), small_(core == BoardCore::kSmall) {}

  std::vector<Beat> run(const std::vector<Beat>& beats) {
    std::vector<Beat> results;
    for (const Beat& beat : beats) {
      for (const Beat& result : accept(beat)) results.push_back(result);
    }
    return results;
  }

 private:
  static constexpr int kSmallAxis = 4;

  std::vector<Beat> accept(Beat beat) {
    if (!small_) return stream_.run({beat});
    if (header_) {
      start(beat);
    } else if (functions_left_ > 0) {
      --functions_left_;
      mixed_ = functions_left_ > 0;
    }
    header_ = beat.last;
    std::vector<Beat> results = stream_.run({beat});
    if (mixed_) std::for_each(results.begin(), results.end(), blank);
    return results;
  }

  /// Reads a header; one that the core refuses loses its opcode.
  void start(Beat& header) {
    const auto opcode = static_cast<Opcode>(header.words[0] & 0xff);
    const std::uint32_t word = header.words[2];
    bool refused = opcode == Opcode::kInterleaved;
    if (opcode == Opcode::kVertices) refused = (word >> 8 & 3) != 0;
    if (opcode == Opcode::kLattice) {
      for (int shift : {0, 8, 16}) refused = refused || (word >> shift & 0xff) > kSmallAxis;
    }
    if (refused) header.words[0] &= ~0xffU;
    functions_left_ = 0;
    if (opcode == Opcode::kCoefficients) {
      functions_left_ =
          (word & kDerivativesFollow) != 0 ? 2 * kCoefficientBeats : kCoefficientBeats;
    }
  }

  static void blank(Beat& result) {
    result.words[0] = result.words[1] = result.words[2] = 0;
    result.words[3] = (result.words[3] & ~kStatusSaturated) | kStatusUnloaded;
  }

  model::StreamModel stream_;
  bool small_;
  bool header_ = true;
  bool mixed_ = false;  // coefficients that were cut short came last
  int functions_left_ = 0;
};

}  // namespace hwffd::test
