#include "timeline.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "hwffd/tb/recorded_lanes.hpp"

namespace hwffd::organizations {
namespace {

using Json = nlohmann::ordered_json;

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
  return lanes_of(c, {row.count.evaluators, tb::bench_read_latency(c)},
                  tb::schedule_of(row.measured.schedule));
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
