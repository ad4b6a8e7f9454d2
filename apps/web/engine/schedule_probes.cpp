#include "schedule_probes.hpp"

#include <algorithm>

#include "hwffd/error.hpp"
#include "hwffd/model/organizations.hpp"
#include "hwffd/model/schedule.hpp"

namespace hwffd::web {
namespace {

/// Vertices that take turns in a barrel (docs/architecture.md section 4).
std::uint64_t contexts_of(const Configuration& row) {
  if (organization_of(row).form != Form::kProduct) return 1;
  const int sum = std::max(row.fma_latency, row.add_latency);
  return static_cast<std::uint64_t>(std::max(sum, 1));
}

/// Whether an instance belongs to the organization, and of several lanes to the first.
bool is_shown(const std::string& instance) {
  if (instance.find(".u_org.") == std::string::npos) return false;
  const std::string lane = "gen_lane[";
  const std::size_t position = instance.find(lane);
  return position == std::string::npos || instance.compare(position + lane.size(), 2, "0]") == 0;
}

/// The first signal of one of those names.
cores::Signal probe(const SignalTable& signals, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    for (const cores::Signal& signal : signals.all()) {
      if (signal.name == name && is_shown(signal.instance)) return signal;
    }
  }
  throw Error("core: built without the probe " + names.front() +
              "; build it with cores/rtl/ffd_bench.vlt");
}

template <class Queue, class ClockOf>
void forget(Queue& queue, std::uint64_t begin, ClockOf clock_of) {
  while (!queue.empty() && clock_of(queue.front()) < begin) queue.pop_front();
}

template <class Queue>
auto listed(const Queue& queue) {
  return std::vector<typename Queue::value_type>(queue.begin(), queue.end());
}

}  // namespace

ScheduleProbes::ScheduleProbes(const SignalTable& signals, const Configuration& row)
    : step_(probe(signals, {"step_valid_i", "read_o"})), sum_(probe(signals, {"sum_valid"})) {
  std::vector<std::string> instances;
  for (const cores::Signal& signal : signals.all()) {
    const bool counts = signal.name == "step_valid_o" && is_shown(signal.instance);
    if (counts) instances.push_back(signal.instance);
  }
  // A combination generator has a second one, for its polynomials, which fills sets of weights.
  std::stable_partition(instances.begin(), instances.end(), [](const std::string& instance) {
    return instance.find("u_fill") != std::string::npos;
  });
  for (const std::string& instance : instances) {
    sequencers_.push_back(
        {signals.only(instance + ":step_valid_o"), signals.only(instance + ":step_first_o")});
  }
  if (sequencers_.empty()) throw Error("core: built without probes; use cores/rtl/ffd_bench.vlt");
  if (walks(row)) {
    walk_ = Walk{probe(signals, {"go"}), probe(signals, {"count_q"}), probe(signals, {"take"}),
                 probe(signals, {"result_valid_o"})};
  }
  sequencers_.back().contexts = contexts_of(row);
  for (Sequencer& sequencer : sequencers_) sequencer.turns.resize(sequencer.contexts);
}

void ScheduleProbes::look(Sequencer& sequencer, std::uint64_t clock) {
  if (sequencer.valid.value() == 0) return;
  std::size_t& vertex = sequencer.turns[clock % sequencer.contexts];
  if (sequencer.first.value() != 0) {
    vertex = sequencer.entered++;
    if (walk_ && !walk_->wanted.empty()) {  // what it counts are planes
      vertex = walk_->wanted.front();
      walk_->wanted.pop_front();
    }
  }
  sequencer.starts.push_back({clock, vertex});
}

void ScheduleProbes::look_at_walk(std::uint64_t clock) {
  if (walk_->takes.value() != 0) walk_->takings.push_back({clock, walk_->taken++});
  if (walk_->result.value() != 0 && !walk_->latency)
    walk_->latency = clock - walk_->takings.front().clock;
  if (walk_->goes.value() == 0) return;
  walk_->wanted.insert(walk_->wanted.end(), walk_->planes.value(), walk_->entered++);
}

void ScheduleProbes::sample(std::uint64_t clock) {
  if (walk_) look_at_walk(clock);
  for (Sequencer& sequencer : sequencers_) look(sequencer, clock);
  const Entries& last = sequencers_.back().starts;
  if (!last.empty() && last.back().clock == clock) on_the_way_.push_back(last.back().vertex);
  if (step_.value() != 0 && !on_the_way_.empty()) {
    steps_.push_back({clock, on_the_way_.front()});
    on_the_way_.pop_front();
  }
  if (sum_.value() != 0) sums_.push_back(clock);
  if (end_ == 0) begin_ = clock;
  end_ = clock + 1;
  begin_ = std::max(begin_, end_ > kWindow ? end_ - kWindow : 0);
  const auto of_entry = [](const cores::Entry& entry) { return entry.clock; };
  for (Sequencer& sequencer : sequencers_) forget(sequencer.starts, begin_, of_entry);
  forget(steps_, begin_, of_entry);
  forget(sums_, begin_, [](std::uint64_t at) { return at; });
  if (walk_) forget(walk_->takings, begin_, of_entry);
}

cores::Schedule ScheduleProbes::schedule() const {
  cores::Schedule schedule;
  schedule.polynomials = listed(sequencers_.front().starts);
  if (sequencers_.size() > 1) schedule.combinations = listed(sequencers_.back().starts);
  schedule.steps = listed(steps_);
  schedule.sums = listed(sums_);
  if (walk_ && walk_->latency) {
    for (const cores::Entry& taken : walk_->takings)
      schedule.results.push_back({taken.clock + *walk_->latency, taken.vertex});
  }
  schedule.begin = begin_;
  schedule.end = end_;
  return schedule;
}

}  // namespace hwffd::web
