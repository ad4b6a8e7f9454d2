#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "hwffd/tb/sim.hpp"

namespace hwffd::test {

/// The other end of a board's serial line, bit by bit, with the board between its pins.
template <class VDut>
class SerialHost {
 public:
  SerialHost(std::uint64_t seed, int clocks_per_bit) : sim_(seed), clocks_(clocks_per_bit) {
    level(true, 40 * clocks_);  // past the reset after configuration
    bytes_.clear();
  }

  /// A character; without its stop bit if `whole` is false, and then the line is high again.
  void send(std::uint8_t value, bool whole = true) {
    level(false, clocks_);
    for (int bit = 0; bit < 8; ++bit) level((value >> bit & 1) != 0, clocks_);
    level(whole, clocks_);
    if (!whole) level(true, clocks_);
  }

  /// So many clocks of a level.
  void level(bool high, int clocks) {
    for (int clock = 0; clock < clocks; ++clock) {
      sim_->uart_rx_i = high;
      sim_.tick();
      receive(sim_->uart_tx_o);
    }
  }

  /// Waits for so many bytes, at most `clocks` for each.
  void wait(std::size_t bytes, int clocks) {
    for (std::uint64_t left = (bytes + 1) * clocks; left > 0 && bytes_.size() < bytes; --left) {
      level(true, 1);
    }
  }

  std::vector<std::uint8_t> take_bytes() { return std::exchange(bytes_, {}); }
  /// Characters that came without a stop bit.
  int framing_errors() const { return framing_errors_; }
  std::uint64_t cycle() const { return sim_.cycle(); }

 private:
  void receive(bool high) {
    if (bit_ == 0) {  // idle
      if (high) return;
      bit_ = 1;
      wait_ = clocks_ + clocks_ / 2 - 1;
      return;
    }
    if (wait_-- > 0) return;
    wait_ = clocks_ - 1;
    if (bit_++ <= 8) {
      shift_ = static_cast<std::uint8_t>(shift_ >> 1 | (high ? 0x80 : 0));
      return;
    }
    bit_ = 0;
    bytes_.push_back(shift_);
    framing_errors_ += high ? 0 : 1;
  }

  tb::Sim<VDut> sim_;
  int clocks_;
  int bit_ = 0;
  int wait_ = 0;
  std::uint8_t shift_ = 0;
  int framing_errors_ = 0;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace hwffd::test
