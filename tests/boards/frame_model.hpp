#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "hwffd/stream/beat.hpp"

namespace hwffd::test {

/// What `ffd_board_bridge` makes of a serial line: bytes, errors and pauses in, beats out.
/// synth/boards/README.md, section Frames.
class FrameModel {
 public:
  /// A whole character.
  void byte(std::uint8_t value) {
    switch (state_) {
      case State::kCountLow:
        count_ = value;
        state_ = State::kCountHigh;
        break;
      case State::kCountHigh:
        count_ |= static_cast<std::uint32_t>(value) << 8;
        state_ = count_ == 0 ? State::kCountLow : State::kBeats;
        break;
      case State::kBeats:
        fill(value, count_ == 1);
        break;
      default:
        break;
    }
  }

  /// A character without a stop bit, or a break.
  void error() {
    if (state_ != State::kBroken) open_ = state_ == State::kBeats;
    state_ = State::kBroken;
  }

  /// A line that is high for long enough.
  void pause() {
    const bool close = state_ == State::kBeats || (state_ == State::kBroken && open_);
    if (close) {
      state_ = State::kBeats;
      while (state_ == State::kBeats) fill(0, true);
    }
    state_ = State::kCountLow;
  }

  /// The beats since the last call.
  std::vector<Beat> take() { return std::exchange(beats_, {}); }

 private:
  enum class State { kCountLow, kCountHigh, kBeats, kBroken };

  void fill(std::uint8_t value, bool last) {
    beat_.words[place_ / 4] |= static_cast<std::uint32_t>(value) << (8 * (place_ % 4));
    if (++place_ < 16) return;
    beat_.last = last;
    beats_.push_back(beat_);
    beat_ = Beat{};
    place_ = 0;
    --count_;
    if (last) state_ = State::kCountLow;
  }

  State state_ = State::kCountLow;
  bool open_ = false;  // the frame that was broken had begun
  std::uint32_t count_ = 0;
  std::size_t place_ = 0;
  Beat beat_;
  std::vector<Beat> beats_;
};

}  // namespace hwffd::test
