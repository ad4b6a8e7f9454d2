#include "hwffd/tb/schedule_recorder.hpp"

#include <stdexcept>

namespace hwffd::tb {
namespace {

/// Whether a probe is in a lane behind the first.
bool in_another_lane(const std::string& instance) {
  const std::string lane = "gen_lane[";
  const auto position = instance.find(lane);
  return position != std::string::npos && instance.at(position + lane.size()) != '0';
}

}  // namespace

ScheduleRecorder::ScheduleRecorder(const cores::EvaluatorCore& core) {
  for (const cores::Probe& probe : core.probes()) {
    if (in_another_lane(probe.instance)) continue;
    if (probe.signal == "step_valid_o") {
      sequencers_.push_back({probe.instance, {}});
      sequencer_values_.push_back(probe.value);
    } else if (probe.signal == "step_first_o") {
      first_ = probe.value;
    } else if (probe.signal == "step_valid_i" || probe.signal == "read_o") {
      step_ = probe.value;
    } else if (probe.signal == "step_source_i" || probe.signal == "read_source_o") {
      source_ = probe.value;
    } else if (probe.signal == "sum_valid") {
      sum_ = probe.value;
    } else if (probe.signal == "result_valid_o") {
      result_ = probe.value;
    }
  }
  if (sequencers_.empty() || sequencers_.size() > 2 || step_ == nullptr || first_ == nullptr ||
      sum_ == nullptr || result_ == nullptr) {
    throw std::invalid_argument("an evaluator without the probes of cores/rtl/ffd_bench.vlt");
  }
}

void ScheduleRecorder::sample(std::uint64_t clock) {
  for (std::size_t i = 0; i < sequencers_.size(); ++i) {
    if (*sequencer_values_[i] != 0) sequencers_[i].starts.push_back(clock);
  }
  if (*step_ != 0) {
    steps_.push_back(clock);
    if (*first_ != 0) ++vertex_;
    sources_.push_back(source_ != nullptr ? *source_ : vertex_);
  }
  if (*sum_ != 0) sums_.push_back(clock);
  if (*result_ != 0) results_.push_back(clock);
}

bool ScheduleRecorder::first_leads() const {
  if (sequencers_.size() == 1) return true;
  return sequencers_[0].starts.at(0) < sequencers_[1].starts.at(0);
}

const ScheduleRecorder::Sequencer& ScheduleRecorder::polynomials() const {
  return sequencers_[first_leads() ? 0 : 1];
}

const ScheduleRecorder::Sequencer* ScheduleRecorder::combinations() const {
  if (sequencers_.size() == 1) return nullptr;
  return &sequencers_[first_leads() ? 1 : 0];
}

}  // namespace hwffd::tb
