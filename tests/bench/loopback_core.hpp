#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hwffd/cores/stream_core.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/stream_bench.hpp"

namespace hwffd::tb {

/// What is wrong with a loop-back core. Flaws that strike one beat strike number `kFlawedBeat`.
enum class Flaw {
  kNone,
  kPayloadChanges,  // one bit flips while the beat waits
  kValidDrops,      // valid falls for a cycle while the beat waits
  kValidInReset,
  kReadyInReset,
  kValidAfterReset,  // valid in the first cycle after reset
  kLosesBeat,
  kDuplicatesBeat,
  kSwapsBeats,
  kFlipsBit,
  kFlipsLast,
  kSamplesLate,  // takes data and last one cycle after the handshake
  kStopsOutput,
  kStopsInput,
  kValidWaitsForReady,
  kExtraBeat,  // one more beat when all is done
  kKeepsBeatsOverReset,
  kLosesFirstAfterReset,  // ready in the first cycle after reset, but not listening
  kHalfRate,
  kReadyFollowsValid,  // a combinational path from input valid to input ready
  kDataFollowsReady,   // a combinational path from output ready to output data
  kValidFollowsReady,  // a combinational path from output ready to output valid
  kIdleTooSoon,        // says so with a beat inside
};

/// A first-in, first-out loop-back with registered outputs: a beat accepted at clock c can be
/// offered at clock c + latency at the soonest. Holds up to `kDepth` beats.
class LoopbackCore : public cores::StreamCore {
 public:
  static constexpr std::size_t kDepth = 64;
  static constexpr std::uint64_t kFlawedBeat = 10;

  explicit LoopbackCore(unsigned latency, Flaw flaw = Flaw::kNone);

  void drive_reset(bool asserted) override { reset_ = asserted; }
  void drive_input(bool valid, const Beat& beat) override;
  void drive_output_ready(bool ready) override { out_ready_ = ready; }
  void settle() override;
  void clock() override;
  /// Clocks in which a beat that was offered and not taken was gone, or another one; and those in
  /// which, with none on offer, the pins were as in the clock before.
  std::uint64_t withdrawn() const { return withdrawn_; }
  std::uint64_t idle_again() const { return idle_again_; }
  /// Clocks with none on offer whose `last` was so.
  std::uint64_t idle_with(bool last) const { return idle_with_last_[last]; }
  bool input_ready() const override;
  bool output_valid() const override;
  Beat output() const override;
  bool idle() const override {
    return !valid_q_ && written_ - read_ <= (flaw_ == Flaw::kIdleTooSoon ? 1U : 0U);
  }

 private:
  struct Entry {
    Beat beat;
    std::uint64_t due = 0;
  };

  void watch(bool taken);
  void clock_in_reset();
  void take(Beat beat);
  void push(const Beat& beat);
  void offer(bool transferred);

  std::uint64_t latency_;
  Flaw flaw_;
  bool reset_ = false;
  bool in_valid_ = false;
  bool out_ready_ = false;
  Beat in_beat_;
  bool waits_ = false;  // a beat was offered and not taken
  Beat before_;
  std::uint64_t withdrawn_ = 0;
  std::uint64_t idle_again_ = 0;
  std::array<std::uint64_t, 2> idle_with_last_{};
  bool settled_in_valid_ = false;  // as the combinational paths see them
  bool settled_out_ready_ = false;

  std::array<Entry, 2 * kDepth> ring_;
  std::uint64_t written_ = 0;
  std::uint64_t read_ = 0;
  std::uint64_t clock_ = 0;
  std::uint64_t accepted_ = 0;
  std::uint64_t delivered_ = 0;
  std::uint64_t idle_ = 0;
  Beat held_back_;
  bool ready_q_ = true;  // as from a random start: nothing is promised before the first reset
  bool valid_q_ = true;
  bool was_reset_ = false;
  bool struck_ = false;
  bool sample_pending_ = false;
};

/// `count` random beats, each with its number as tag.
std::vector<Beat> random_beats(std::size_t count, std::uint64_t seed);

/// Options of a bench with these throttles.
inline StreamBenchOptions throttled(const std::string& source, const std::string& sink,
                                    std::uint64_t seed = 1) {
  StreamBenchOptions options;
  options.test = {"Loopback", seed, {}};
  options.source_throttle = source;
  options.sink_throttle = sink;
  return options;
}

/// Sends the beats and expects the same, after `reset` cycles of reset.
inline void loop_back(StreamBench& bench, const std::vector<Beat>& beats) {
  bench.send(beats);
  bench.expect(beats);
}
inline void loop_back(StreamBench& bench, unsigned reset, const std::vector<Beat>& beats) {
  bench.reset(reset);
  loop_back(bench, beats);
}

}  // namespace hwffd::tb
