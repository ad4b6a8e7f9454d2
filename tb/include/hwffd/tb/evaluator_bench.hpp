#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hwffd/cores/evaluator_core.hpp"
#include "hwffd/model/evaluator.hpp"
#include "hwffd/stream/packets.hpp"
#include "hwffd/tb/evaluator_stimulus.hpp"
#include "hwffd/tb/fault.hpp"
#include "hwffd/tb/schedule_recorder.hpp"
#include "hwffd/tb/throttle.hpp"

namespace hwffd::tb {

/// An evaluator at its read port: vertices offered one a clock, every result compared with the
/// model, the clock of each start and result kept; in each clock the core says whether vertices are
/// inside, which is compared, too.
class EvaluatorBench {
 public:
  /// Functions and derivatives of s, t and u.
  using Bank = std::array<AxisWords, 3>;

  /// Resets the core and loads bank 0. Core and model must outlive the bench.
  EvaluatorBench(cores::EvaluatorCore& core, model::EvaluatorModel& model, const Bank& bank);

  /// Loads a bank, 0 or 1, between runs.
  void load(int number, const Bank& bank);

  /// Spoils one result of the runs to come on its way to the comparison, which must notice: as a
  /// beat it is x, y, z and {NaN, saturated, tag}.
  void plant(const Fault& fault) { fault_ = FaultInjector(fault); }

  /// Writes the supports and runs the vertices; `recorder`, if there is one, looks on.
  /// Throws std::runtime_error when nothing comes for 20,000 clocks.
  void run(const EvaluatorStimulus& stimulus, Throttle source = Throttle::always(),
           Throttle sink = Throttle::always(), ScheduleRecorder* recorder = nullptr);

  /// Results, of which a vertex that wants its Jacobian has four, and one with a second has two.
  std::uint64_t checked() const { return checked_; }
  /// Wrong results, and clocks in which the core was wrong about vertices inside.
  std::uint64_t mismatches() const { return mismatches_; }
  const std::string& first_mismatch() const { return first_mismatch_; }
  /// Of the runs so far, in order.
  const std::vector<std::uint64_t>& start_clocks() const { return starts_; }
  const std::vector<std::uint64_t>& result_clocks() const { return result_clocks_; }
  const std::vector<cores::EvaluatorCore::Result>& results() const { return results_; }
  /// Time in the simulated core, supports and comparison left out.
  double simulation_seconds() const { return seconds_; }

 private:
  void write_supports(const std::vector<SupportWords>& supports);
  void simulate(const EvaluatorStimulus& stimulus, Throttle& source, Throttle& sink,
                ScheduleRecorder* recorder);
  void settle();
  void clock() {
    core_.clock();
    ++clock_;
  }
  void take(const cores::EvaluatorCore::Result& result);
  void compare(const EvaluatorStimulus& stimulus, std::size_t first);
  void compare_result(const EvaluatorStimulus& stimulus, std::size_t index, int derivative,
                      const cores::EvaluatorCore::Derivative& got, bool tag_fits,
                      std::optional<std::uint32_t> second = std::nullopt);

  cores::EvaluatorCore& core_;
  model::EvaluatorModel& model_;
  FaultInjector fault_;
  std::uint64_t clock_ = 0;
  std::uint64_t entered_ = 0;      // vertices
  std::uint64_t left_ = 0;         // results
  std::uint64_t left_before_ = 0;  // the same a clock ago
  std::uint64_t checked_ = 0;
  std::uint64_t mismatches_ = 0;
  double seconds_ = 0;
  std::string first_mismatch_;
  std::vector<std::uint64_t> starts_;
  std::vector<std::uint64_t> result_clocks_;
  std::vector<cores::EvaluatorCore::Result> results_;
};

/// Clocks between events `first` and the last one, divided by their distance. Where `together` of
/// them make a round, over whole rounds.
double mean_interval(const std::vector<std::uint64_t>& clocks, std::size_t first, int together = 1);

}  // namespace hwffd::tb
