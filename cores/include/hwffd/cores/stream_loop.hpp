#pragma once

#include <cstdint>
#include <functional>

#include "hwffd/cores/stream_core.hpp"
#include "hwffd/stream/beat.hpp"

namespace hwffd::cores {

/// The pins of a core in one cycle, sampled just before the rising edge.
struct StreamPins {
  bool in_reset = false;
  bool input_valid = false;
  bool input_ready = false;
  bool output_valid = false;
  bool output_ready = false;
  Beat output;  ///< Read only where output_valid is set.
};

/// How a run of cycles ended.
enum class StreamEnd { kDone, kStopped, kStalled, kLate };

/// What `StreamLoop::run` asks whoever drives the streams.
class StreamParty {
 public:
  virtual ~StreamParty() = default;

  /// One cycle of the loop: `drive`, look at the pins, `clock`. Whether a beat moved.
  virtual bool one_cycle() = 0;
  /// Beats that have to move yet; 0: the run is done.
  virtual std::uint64_t left() const = 0;
  /// Whether to give up.
  virtual bool stopped() const { return false; }
};

/// When a run is given up.
struct StreamLimits {
  std::uint64_t stall;                           ///< cycles in which no beat moves
  std::uint64_t cycles = ~std::uint64_t{0} / 2;  ///< cycles of the whole run
};

/// The one place where the pins of a `StreamCore` are driven, sampled and clocked.
class StreamLoop {
 public:
  using Progress = std::function<void(double)>;

  /// The core must outlive the loop.
  explicit StreamLoop(StreamCore& core) : core_(core) {}

  void reset(bool asserted);

  /// Drives the inputs and samples the outputs that follow; may be repeated within a cycle.
  const StreamPins& drive(bool input_valid, const Beat& input, bool output_ready);
  const StreamPins& pins() const { return pins_; }
  /// The rising edge, which ends the cycle.
  void clock();
  std::uint64_t clocks() const { return clocks_; }

  /// Cycles until nothing is left, a limit is reached or the party stops. `progress`, which may be
  /// empty, is told the fraction that moved, in steps of at least 1 %, the last one 1.
  StreamEnd run(StreamParty& party, const StreamLimits& limits, const Progress& progress);

 private:
  StreamCore& core_;
  StreamPins pins_;
  std::uint64_t clocks_ = 0;
};

}  // namespace hwffd::cores
