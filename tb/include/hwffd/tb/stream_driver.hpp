#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hwffd/stream/beat.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::tb {

/// The source of a stream: a queue of beats, offered in order. A beat once offered stays, with its
/// valid, until it is accepted; between beats data and last are random, so that a core that looks
/// at them without valid is found out.
///
/// Knows no pins: each cycle call `drive`, put `valid` and `beat` on them, then `accept` with the
/// ready that was sampled.
class StreamDriver {
 public:
  explicit StreamDriver(std::uint64_t seed) : random_(seed) {}

  /// Appends beats to the queue.
  void push(std::vector<Beat> beats);
  /// Drops the queue, the offered beat and the record of clocks, as a reset does.
  void clear();

  /// Decides the pins of this cycle: an offered beat stays, a new one is offered when `willing`.
  void drive(bool willing);
  bool valid() const { return valid_; }
  const Beat& beat() const { return valid_ ? queue_[next_] : idle_; }
  /// Ends the cycle. True when the offered beat was accepted.
  bool accept(bool ready, std::uint64_t cycle);

  /// Beats not yet accepted.
  std::size_t waiting() const { return queue_.size() - next_; }
  /// Beats accepted since construction.
  std::uint64_t accepted() const { return accepted_; }
  /// The clock at which each beat was accepted, since the last `clear`.
  const std::vector<std::uint64_t>& clocks() const { return clocks_; }
  /// Whether clocks are recorded (the default); a soak of many runs does without.
  void record(bool on) { record_ = on; }

 private:
  Random random_;
  std::vector<Beat> queue_;
  std::size_t next_ = 0;
  std::vector<std::uint64_t> clocks_;
  std::uint64_t accepted_ = 0;
  Beat idle_;
  bool valid_ = false;
  bool record_ = true;
};

}  // namespace hwffd::tb
