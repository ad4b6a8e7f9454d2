#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hwffd/cores/evaluator_core.hpp"

namespace hwffd::tb {

/// When an evaluator's schedule did what, in clocks, as its probes showed it; where it has several
/// lanes, the first of them.
class ScheduleRecorder {
 public:
  /// Starts of one sequencer: a polynomial of each of its evaluators, or a combination.
  struct Sequencer {
    std::string name;
    std::vector<std::uint64_t> starts;
  };

  /// Throws std::invalid_argument where the core lacks a probe that every organization has.
  explicit ScheduleRecorder(const cores::EvaluatorCore& core);

  /// Looks at the probes; once a clock, when the core has settled.
  void sample(std::uint64_t clock);

  /// The sequencer that started first.
  const Sequencer& polynomials() const;
  /// The one behind it, of a combination generator; null if there is none.
  const Sequencer* combinations() const;
  /// Weights of a step arrive at the multiplier; where axes are contracted, its points are asked
  /// for.
  const std::vector<std::uint64_t>& steps() const { return steps_; }
  /// The support that each step reads; where steps read none, a number of its vertex.
  const std::vector<std::uint8_t>& sources() const { return sources_; }
  /// The sum of a step arrives at the accumulator, or is complete.
  const std::vector<std::uint64_t>& sums() const { return sums_; }
  /// The sum of a vertex is complete.
  const std::vector<std::uint64_t>& results() const { return results_; }

 private:
  bool first_leads() const;

  std::vector<Sequencer> sequencers_;  // one or two
  std::vector<const std::uint8_t*> sequencer_values_;
  const std::uint8_t* step_ = nullptr;
  const std::uint8_t* source_ = nullptr;
  const std::uint8_t* first_ = nullptr;  // of the sequencer's steps
  std::uint8_t vertex_ = 0;
  const std::uint8_t* sum_ = nullptr;
  const std::uint8_t* result_ = nullptr;
  std::vector<std::uint64_t> steps_;
  std::vector<std::uint8_t> sources_;
  std::vector<std::uint64_t> sums_;
  std::vector<std::uint64_t> results_;
};

}  // namespace hwffd::tb
