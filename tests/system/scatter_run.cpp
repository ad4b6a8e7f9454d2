#include "scatter_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <tuple>

#include "hwffd/stream/blending.hpp"

namespace hwffd::test {
namespace {

using model::ScatterEvent;

constexpr unsigned kOverflow = stream_event(event::kPageOverflowed);

std::vector<ScatterEvent> with_place(const std::vector<ScatterEvent>& events) {
  std::vector<ScatterEvent> some;
  std::copy_if(events.begin(), events.end(), std::back_inserter(some), has_place);
  return some;
}

std::uint64_t count_of(const std::vector<ScatterEvent>& events, unsigned code) {
  return static_cast<std::uint64_t>(
      std::count_if(events.begin(), events.end(),
                    [code](const ScatterEvent& event) { return event.event == code; }));
}

}  // namespace

void EventLog::drive_reset(bool asserted) {
  in_reset_ = asserted;
  if (asserted) log_.clear();
  core_->drive_reset(asserted);
}

void EventLog::clock() {
  const std::uint32_t pulses = in_reset_ ? 0 : core_->events();
  for (unsigned event = 0; event < 32 && pulses != 0; ++event) {
    if ((pulses >> event & 1) == 0) continue;
    const cores::EventPlace place = core_->event_place();
    log_.push_back({event, place.packet, place.beat});
  }
  core_->clock();
}

bool has_place(const ScatterEvent& event) {
  return event.event != event::kSaturated && event.event != kOverflow;
}

std::string sorted_text(std::vector<ScatterEvent> events) {
  const auto key = [](const ScatterEvent& event) {
    return std::make_tuple(event.packet, event.beat, event.event);
  };
  std::sort(events.begin(), events.end(),
            [&](const ScatterEvent& a, const ScatterEvent& b) { return key(a) < key(b); });
  std::string text;
  for (const ScatterEvent& event : events) {
    text += fmt::format("event {} in packet {}, beat {}\n", event.event, event.packet, event.beat);
  }
  return text;
}

ScatterRun::ScatterRun(const ScatterBuild& build, std::uint64_t seed, const std::string& source,
                       const std::string& sink)
    : codec_(build.row.format),
      core_(build.make(seed)),
      model_(build.row, build.axis, build.pages) {
  tb::StreamBenchOptions options;
  options.test = {build.name, seed, "SEED=" + std::to_string(seed)};
  options.source_throttle = source;
  options.sink_throttle = sink;
  options.probe_edges = true;
  bench_ = std::make_unique<tb::StreamBench>(core_, options);
  bench_->reset(3);
}

void ScatterRun::send(const std::vector<Beat>& beats) {
  bench_->send(beats);
  bench_->expect(model_.run(beats));
  sent_ += beats.size();
}

void ScatterRun::send_functions(const std::string& family) {
  send(coefficients_packet(hwffd::family(family, codec_), codec_, Functions::kDerivativesToo));
}

::testing::AssertionResult ScatterRun::run() {
  bench_->run();
  if (!bench_->finish()) return ::testing::AssertionFailure() << bench_->report();
  const std::string got = sorted_text(placed_events());
  const std::string expected = sorted_text(with_place(model_.events()));
  if (got != expected) {
    return ::testing::AssertionFailure() << "events of the core:\n"
                                         << got << "those of the model:\n"
                                         << expected;
  }
  for (const event::Code code : {event::kSaturated, event::kPageOverflowed}) {
    const std::uint64_t pulses_of_core = pulses(code);
    const std::uint64_t of_model = count_of(model_.events(), stream_event(code));
    const bool shared = code == event::kSaturated && of_model != 0;
    const std::uint64_t least = shared ? 1 : of_model;
    if (pulses_of_core >= least && pulses_of_core <= of_model) continue;
    return ::testing::AssertionFailure() << pulses_of_core << " pulses of event "
                                         << stream_event(code) << ", " << of_model << " expected";
  }
  return ::testing::AssertionSuccess();
}

void ScatterRun::reset(std::uint64_t cycles) {
  bench_->reset(cycles);
  model_.reset();
  sent_ = 0;
}

std::uint64_t ScatterRun::pulses(event::Code code) const {
  return count_of(core_.log(), stream_event(code));
}

std::vector<ScatterEvent> ScatterRun::placed_events() const { return with_place(core_.log()); }

std::vector<std::array<std::uint32_t, 3>> ScatterRun::words(std::size_t first,
                                                            std::size_t count) const {
  std::vector<std::array<std::uint32_t, 3>> result;
  for (std::size_t r = first; r < first + count; ++r) {
    const Beat& beat = bench_->results().at(r);
    result.push_back({beat.words[0], beat.words[1], beat.words[2]});
  }
  return result;
}

}  // namespace hwffd::test
