#include "inside.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/model/schedule.hpp"

namespace hwffd::web {
namespace {

constexpr const char* kLane = "lane:";

/// "lane:(BBB) P lane:of the tree" or "u_encoder:valid_q hwffd_stream:load", one by one.
std::vector<std::string> sources_of(const std::string& busy) {
  if (busy.rfind(kLane, 0) != 0) {
    std::istringstream words(busy);
    return {std::istream_iterator<std::string>(words), {}};
  }
  std::vector<std::string> sources;
  for (std::size_t start = 0; start != std::string::npos;) {
    const std::size_t next = busy.find(std::string(" ") + kLane, start);
    sources.push_back(busy.substr(start, next == std::string::npos ? next : next - start));
    start = next == std::string::npos ? next : next + 1;
  }
  return sources;
}

bool holds(const cores::Lane& lane, std::uint64_t clock) {
  return std::any_of(lane.spans.begin(), lane.spans.end(),
                     [&](const auto& span) { return span.begin <= clock && clock < span.end; });
}

/// What of a lane lies in some clocks, counted from the first of them.
cores::Lane within(const cores::Lane& lane, std::uint64_t begin, std::uint64_t end,
                   std::size_t vertices) {
  cores::Lane cut{lane.name, {}};
  for (const cores::Lane::Span& span : lane.spans) {
    const std::uint64_t from = std::max(span.begin, begin);
    const std::uint64_t to = std::min(span.end, end);
    if (from >= to) continue;
    cut.spans.push_back({from - begin, to - begin, span.vertex % vertices});
  }
  return cut;
}

}  // namespace

Inside::Inside(RunningCore& core, const Configuration& row)
    : core_(core),
      row_(row),
      signals_(core.core().signals()),
      probes_(signals_, row),
      recorder_(signals_) {
  for (const Block& block : design_of(row).blocks) {
    Light light;
    for (const std::string& source : sources_of(block.busy)) {
      if (source.rfind(kLane, 0) == 0) {
        light.lanes.push_back(source.substr(std::string(kLane).size()));
        continue;
      }
      for (const cores::Signal& signal : signals_.find(source)) light.signals.push_back(signal);
    }
    if (light.signals.empty() && light.lanes.empty()) {
      throw Error(fmt::format("block {}: the core shows none of its signals", block.id));
    }
    lights_.push_back(std::move(light));
  }
}

void Inside::begin(Traffic traffic) {
  traffic_ = std::move(traffic);
  probes_ = ScheduleProbes(signals_, row_);
  next_ = 0;
  vertices_ = 0;
  mismatches_ = 0;
}

void Inside::check(const Beat& result) {
  const Beat& expected = traffic_.results[vertices_ % traffic_.results.size()];
  for (std::size_t word = 0; word < result.words.size(); ++word) {
    mismatches_ += result.words[word] != expected.words[word] ? 1 : 0;
  }
  ++vertices_;
}

void Inside::clock() {
  const cores::StreamPins& pins = core_.settle(&traffic_.commands[next_]);
  const std::uint64_t now = core_.clocks();
  probes_.sample(now);
  recorder_.sample(now);
  for (Light& light : lights_) {
    light.on = std::any_of(light.signals.begin(), light.signals.end(),
                           [](const cores::Signal& signal) { return signal.value() != 0; });
  }
  if (pins.output_valid) check(pins.output);
  if (pins.input_ready) next_ = (next_ + 1) % traffic_.commands.size();
  core_.edge();
}

void Inside::run(std::uint64_t clocks) {
  if (traffic_.commands.empty()) throw Error("core: there is no mesh; give one first");
  if (clocks < 1 || clocks > kMostClocks) {
    throw Error(fmt::format("clocks: {} at once; take 1 to {}", clocks, kMostClocks));
  }
  for (std::uint64_t i = 0; i < clocks; ++i) clock();
}

void Inside::run_vertex() {
  constexpr std::uint64_t kPatience = 10'000;  // clocks
  if (traffic_.commands.empty()) throw Error("core: there is no mesh; give one first");
  const std::uint64_t before = vertices_;
  for (std::uint64_t i = 0; i < kPatience; ++i) {
    clock();
    if (vertices_ != before) return;
  }
  throw Error(fmt::format("core: no vertex in {} clocks; open it again", kPatience));
}

Snapshot Inside::snapshot() const {
  Snapshot shown;
  shown.clock = core_.clocks();
  shown.vertices = vertices_;
  shown.mismatches = mismatches_;
  shown.ports = recorder_.values();
  const cores::Units units{design_of(row_).evaluators, read_latency_of(row_)};
  const std::vector<cores::Lane> lanes = cores::lanes_of(row_, units, probes_.schedule());
  const std::uint64_t last = shown.clock == 0 ? 0 : shown.clock - 1;
  for (const Light& light : lights_) {
    bool on = light.on;
    for (const std::string& words : light.lanes) {
      for (const cores::Lane& lane : lanes) {
        on = on || (lane.name.find(words) != std::string::npos && holds(lane, last));
      }
    }
    shown.busy.push_back(on ? 1 : 0);
  }
  shown.first_clock = shown.clock > kTimeline ? shown.clock - kTimeline : 0;
  for (const cores::Lane& lane : lanes) {
    shown.lanes.push_back(within(lane, shown.first_clock, shown.clock, traffic_.results.size()));
  }
  return shown;
}

}  // namespace hwffd::web
