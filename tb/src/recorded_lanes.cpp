#include "hwffd/tb/recorded_lanes.hpp"

#include <limits>

#include "hwffd/model/schedule.hpp"

namespace hwffd::tb {
namespace {

/// Starts or steps as entries, each of the vertex whose step it belongs to: entries are steps in
/// their order, or whole shares of a vertex.
std::vector<cores::Entry> entries_of(const std::vector<std::uint64_t>& clocks,
                                     const std::vector<std::uint8_t>& sources) {
  std::vector<cores::Entry> entries;
  for (std::size_t i = 0; i < clocks.size(); ++i) {
    entries.push_back({clocks[i], sources[i * sources.size() / clocks.size()]});
  }
  return entries;
}

}  // namespace

cores::Schedule schedule_of(const ScheduleRecorder& recorded) {
  cores::Schedule schedule;
  schedule.polynomials = entries_of(recorded.polynomials().starts, recorded.sources());
  if (const ScheduleRecorder::Sequencer* generator = recorded.combinations()) {
    schedule.combinations = entries_of(generator->starts, recorded.sources());
  }
  schedule.steps = entries_of(recorded.steps(), recorded.sources());
  schedule.sums = recorded.sums();
  for (std::size_t vertex = 0; vertex < recorded.results().size(); ++vertex) {
    schedule.results.push_back({recorded.results()[vertex], vertex});
  }
  schedule.end = std::numeric_limits<std::uint64_t>::max();
  return schedule;
}

int bench_read_latency(const Configuration& row) {
  return lanes(row) > 1 && folds(row) == 3 ? 3 : 2;  // a clock more where reads of lanes meet
}

}  // namespace hwffd::tb
