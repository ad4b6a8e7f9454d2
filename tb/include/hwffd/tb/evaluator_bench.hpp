#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hwffd/model/evaluator.hpp"
#include "hwffd/stream/packets.hpp"
#include "hwffd/tb/evaluator_core.hpp"
#include "hwffd/tb/throttle.hpp"

namespace hwffd::tb {

/// An evaluator at its read port: vertices offered one a clock, every result compared with the
/// model, the clock of each start and result kept.
class EvaluatorBench {
 public:
  /// Resets the core and loads the same blending functions for all axes into bank 0. Core and model
  /// must outlive the bench.
  EvaluatorBench(EvaluatorCore& core, model::EvaluatorModel& model, const AxisWords& blending);

  /// Runs vertices whose supports are `supports[index of vertex % supports]`; at most 256 of them.
  /// Throws std::runtime_error when nothing comes for 20,000 clocks.
  void run(const std::vector<model::VertexWords>& vertices, std::size_t supports,
           Throttle source = Throttle::always(), Throttle sink = Throttle::always());

  std::uint64_t checked() const { return checked_; }
  std::uint64_t mismatches() const { return mismatches_; }
  const std::string& first_mismatch() const { return first_mismatch_; }
  const std::vector<std::uint64_t>& start_clocks() const { return starts_; }
  const std::vector<std::uint64_t>& result_clocks() const { return results_; }
  /// What came out, in order.
  const std::vector<EvaluatorCore::Result>& results() const { return words_; }
  /// Clocks of the runs so far.
  std::uint64_t clocks() const { return clock_; }

 private:
  void write_supports(const std::vector<model::VertexWords>& vertices, std::size_t supports);
  void compare(const EvaluatorCore::Result& got, const model::VertexWords& vertex,
               std::uint16_t tag);

  EvaluatorCore& core_;
  model::EvaluatorModel& model_;
  std::uint64_t clock_ = 0;
  std::uint64_t checked_ = 0;
  std::uint64_t mismatches_ = 0;
  std::string first_mismatch_;
  std::vector<std::uint64_t> starts_;
  std::vector<std::uint64_t> results_;
  std::vector<EvaluatorCore::Result> words_;
};

/// Clocks between events `first` and the last one, divided by their distance.
double mean_interval(const std::vector<std::uint64_t>& clocks, std::size_t first);

}  // namespace hwffd::tb
