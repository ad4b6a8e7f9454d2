#include "timeline.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "hwffd/model/schedule.hpp"

namespace hwffd::organizations {
namespace {

using Json = nlohmann::ordered_json;

/// Starts or steps as entries, each of the vertex whose step it belongs to: entries are steps in
/// their order, or whole shares of a vertex.
std::vector<cores::Entry> entries_of(const std::vector<std::uint64_t>& clocks,
                                     const tb::ScheduleRecorder& recorded) {
  std::vector<cores::Entry> entries;
  for (std::size_t i = 0; i < clocks.size(); ++i) {
    const std::size_t step = i * recorded.sources().size() / clocks.size();
    entries.push_back({clocks[i], recorded.sources()[step]});
  }
  return entries;
}

cores::Schedule schedule_of(const tb::ScheduleRecorder& recorded) {
  cores::Schedule schedule;
  schedule.polynomials = entries_of(recorded.polynomials().starts, recorded);
  if (const tb::ScheduleRecorder::Sequencer* generator = recorded.combinations()) {
    schedule.combinations = entries_of(generator->starts, recorded);
  }
  schedule.steps = entries_of(recorded.steps(), recorded);
  schedule.sums = recorded.sums();
  for (std::size_t vertex = 0; vertex < recorded.results().size(); ++vertex)
    schedule.results.push_back({recorded.results()[vertex], vertex});
  schedule.end = std::numeric_limits<std::uint64_t>::max();
  return schedule;
}

struct Window {
  std::uint64_t begin;
  std::uint64_t end;
};

/// The first vertex and a little of what follows.
Window window_of(const Row& row, const std::vector<cores::Lane>& lanes) {
  const std::uint64_t begin = lanes.front().spans.front().begin;
  const std::uint64_t end = row.measured.schedule.results().front();
  return {begin, end + std::max<std::uint64_t>(4, (end - begin) / 8)};
}

/// The format in which an organization is shown.
std::string timed_format(const Comparison& comparison, const std::string& org) {
  std::vector<std::string> formats;
  for (const Row& row : comparison.rows()) {
    if (row.configuration->org == org) formats.emplace_back(row.configuration->format);
  }
  for (const char* format : {"fx18", "fx17"}) {
    if (std::count(formats.begin(), formats.end(), format) > 0) return format;
  }
  return formats.front();
}

/// What of a lane lies in a window, in clocks from its beginning.
Json json_of(const cores::Lane& lane, const Window& window) {
  Json spans = Json::array();
  for (const cores::Lane::Span& span : lane.spans) {
    const std::uint64_t begin = std::max(span.begin, window.begin);
    const std::uint64_t end = std::min(span.end, window.end);
    if (begin >= end) continue;
    spans.push_back({begin - window.begin, end - window.begin, span.vertex});
  }
  return {{"name", lane.name}, {"spans", std::move(spans)}};
}

}  // namespace

std::vector<cores::Lane> lanes_of(const Row& row) {
  const Configuration& c = *row.configuration;
  // Of ffd_bench_evaluator; a clock more where reads of several lanes meet.
  const int read_latency = hwffd::lanes(c) > 1 && folds(c) == 3 ? 3 : 2;
  return lanes_of(c, {row.count.evaluators, read_latency}, schedule_of(row.measured.schedule));
}

std::string timelines(const Comparison& comparison) {
  Json list = Json::array();
  for (const Row& row : comparison.rows()) {
    const Configuration& c = *row.configuration;
    if (c.format != timed_format(comparison, c.org)) continue;
    const std::vector<cores::Lane> lanes = lanes_of(row);
    const Window window = window_of(row, lanes);
    Json drawn = Json::array();
    for (const cores::Lane& lane : lanes) drawn.push_back(json_of(lane, window));
    list.push_back({{"name", c.name},
                    {"org", c.org},
                    {"n", c.n},
                    {"schedule", c.schedule},
                    {"clocks", window.end - window.begin},
                    {"first_done", row.measured.schedule.results().front() - window.begin},
                    {"lanes", std::move(drawn)}});
  }
  return Json{{"rows", std::move(list)}}.dump() + "\n";
}

}  // namespace hwffd::organizations
