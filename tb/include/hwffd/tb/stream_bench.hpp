#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "hwffd/cores/stream_core.hpp"
#include "hwffd/cores/stream_loop.hpp"
#include "hwffd/stream/beat.hpp"
#include "hwffd/tb/fault.hpp"
#include "hwffd/tb/protocol_checker.hpp"
#include "hwffd/tb/scoreboard.hpp"
#include "hwffd/tb/stream_driver.hpp"
#include "hwffd/tb/stream_monitor.hpp"
#include "hwffd/tb/test_identity.hpp"
#include "hwffd/tb/throttle.hpp"

namespace hwffd::tb {

/// How a bench drives and judges its core. Cycles are clocks of the core.
struct StreamBenchOptions {
  TestIdentity test;                       ///< its seed also feeds throttles and idle data
  std::string source_throttle = "always";  ///< a name of `throttle_names`
  std::string sink_throttle = "always";
  std::uint64_t stall_limit = 20'000;         ///< watchdog: cycles without any beat in or out
  std::uint64_t cycle_limit = 1'000'000'000;  ///< watchdog: cycles of one `run`
  std::uint64_t quiet_cycles = 256;           ///< after a run, in which no result may appear
  bool offer_at_once = true;  ///< offer the first beat in the first cycle after reset, always
  bool probe_edges = false;   ///< check that no output depends on an input of the same cycle: in
                              ///< the first 4,096 cycles, then in every 17th
  bool record = true;         ///< keep results and clocks; a soak does without
  unsigned reset_edges = 1;   ///< edges in reset after which valid and ready must be low
};

/// A core between a driver and a monitor, with throttles on both sides, the protocol's rules and
/// a scoreboard.
///
/// A cycle is: drive the inputs, settle, sample ready and valid, clock. Nothing throws because the
/// core is wrong: failures are collected, `finish` tells the verdict and `report` the reasons. A
/// missing `reset`, or an unknown throttle, is the caller's fault and throws.
class StreamBench : private cores::StreamParty {
 public:
  /// The core must outlive the bench. Throws std::invalid_argument for an unknown throttle.
  StreamBench(cores::StreamCore& core, StreamBenchOptions options);

  /// Holds reset for that many cycles, at least 1, with random data on the idle input. What was
  /// sent or expected and has not come is dropped, and so are the recorded results and clocks:
  /// called in mid-stream it is a restart, after which the core must be as new. The next cycle of
  /// the bench is the first one out of reset.
  void reset(std::uint64_t cycles);

  /// Queues input beats and expected results.
  void send(std::vector<Beat> beats);
  void expect(std::vector<Beat> beats);

  /// Runs until all sent beats are accepted and all expected ones have come, then through the
  /// quiet period. Ends early when a watchdog runs out or 20 failures are reported. True when
  /// nothing has failed so far; after a watchdog it stays false until the next reset.
  bool run();
  /// Runs that many cycles and stops wherever the streams are, for a reset in mid-stream.
  void run_for(std::uint64_t cycles);
  /// Holds the sink's ready low until the core raises valid, and for `hold` cycles more: valid must
  /// never wait for ready. A failure when valid does not rise within `limit` cycles. Send and
  /// expect beats before, `run` after.
  bool raises_valid_without_ready(std::uint64_t limit, std::uint64_t hold = 64);

  /// Ends the test: everything sent, everything expected checked, no rule broken. True when all
  /// is well.
  bool finish();
  /// Nothing has failed so far. (Only `finish` notices that nothing was checked.)
  bool ok() const;
  /// Counts, every failure, and the command that repeats the run.
  std::string report() const;

  /// The clock of each result, and of each accepted input beat, since the last reset.
  const std::vector<std::uint64_t>& result_clocks() const { return monitor_.clocks(); }
  const std::vector<std::uint64_t>& accept_clocks() const { return driver_.clocks(); }
  /// The results since the last reset.
  const std::vector<Beat>& results() const { return monitor_.beats(); }
  /// Pulses of each event since the last reset.
  const std::array<std::uint64_t, kStreamEvents>& events() const { return events_; }
  /// Second vertices that left with another one, since the last reset.
  std::uint64_t seconds() const { return seconds_; }
  /// Where the last of an event came from.
  cores::EventPlace event_place(int event) const { return event_places_.at(event); }
  /// Clocks since the last reset in which that bit of wait_o was 1.
  std::uint64_t waits(unsigned bit) const { return waits_.at(bit); }
  /// Clocks between results `first` and `last`, divided by their distance. Throws
  /// std::out_of_range when they are not two recorded results in order.
  double clocks_per_result(std::size_t first, std::size_t last) const;
  /// The same over all results since the last reset.
  double clocks_per_result() const;
  /// Clocks since construction, those in reset included.
  std::uint64_t cycle() const { return loop_.clocks(); }

  /// Called by `run` with the fraction done, in steps of at least 1 %, the last one 1.
  void on_progress(std::function<void(double)> callback) { progress_ = std::move(callback); }
  /// Another throttle than that of the options.
  void throttle_source(const Throttle& throttle) { source_ = throttle; }
  /// Spoils one result on its way to the scoreboard, which must notice.
  void plant(const Fault& fault) { fault_ = FaultInjector(fault); }
  bool fault_struck() const { return fault_.struck(); }

  const Scoreboard& scoreboard() const { return scoreboard_; }
  const ProtocolChecker& checker() const { return checker_; }
  const StreamDriver& driver() const { return driver_; }
  const StreamMonitor& monitor() const { return monitor_; }

 private:
  enum class SinkMode { kThrottled, kReady, kStalled };

  bool one_cycle() override { return step(SinkMode::kThrottled); }
  std::uint64_t left() const override { return driver_.waiting() + scoreboard_.outstanding(); }
  bool stopped() const override;

  bool step(SinkMode mode);
  void count_events();
  void count_waits();
  void compare(const StreamPins& probed, const StreamPins& pins);
  void fail(const std::string& what);
  void fail_hanging(const std::string& what);

  cores::StreamCore& core_;
  cores::StreamLoop loop_;
  StreamBenchOptions options_;
  Throttle source_;
  Throttle sink_;
  StreamDriver driver_;
  StreamMonitor monitor_;
  ProtocolChecker checker_;
  Scoreboard scoreboard_;
  FaultInjector fault_;
  std::function<void(double)> progress_;
  std::array<std::uint64_t, kStreamEvents> events_{};
  std::array<cores::EventPlace, kStreamEvents> event_places_{};
  std::uint64_t seconds_ = 0;
  std::array<std::uint64_t, 3> waits_{};
  bool was_reset_ = false;
  bool first_cycle_ = false;
  bool asleep_ = false;  // the core said so a clock ago, and no beat was offered
  bool hung_ = false;
  std::vector<std::string> failures_;
  std::vector<std::string> end_failures_;
};

}  // namespace hwffd::tb
