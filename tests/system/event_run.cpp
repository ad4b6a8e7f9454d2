#include "event_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace hwffd::test {
namespace {

/// The same text for the same events, whatever their order.
std::string sorted_text(std::vector<model::ScatterEvent> events) {
  const auto key = [](const model::ScatterEvent& event) {
    return std::make_tuple(event.packet, event.beat, event.event);
  };
  std::sort(events.begin(), events.end(),
            [&](const auto& a, const auto& b) { return key(a) < key(b); });
  std::string text;
  for (const model::ScatterEvent& event : events) {
    text += fmt::format("event {} in packet {}, beat {}\n", event.event, event.packet, event.beat);
  }
  return text;
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
  if (!in_reset_ && (core_->second() & 2) != 0) {
    const cores::EventPlace place = core_->event_place();
    log_.push_back({stream_event(event::kSaturated), place.packet, place.beat});
  }
  core_->clock();
}

bool has_place(const model::ScatterEvent& event) {
  return event.event != event::kSaturated && event.event != stream_event(event::kPageOverflowed);
}

::testing::AssertionResult same_events(const std::vector<model::ScatterEvent>& got,
                                       const std::vector<model::ScatterEvent>& expected) {
  const std::string of_core = sorted_text(got), of_model = sorted_text(expected);
  if (of_core == of_model) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "events of the core:\n"
                                       << of_core << "those expected:\n"
                                       << of_model;
}

::testing::AssertionResult as_often(const model::StreamEvents& got,
                                    const model::StreamEvents& expected, std::uint64_t shared) {
  for (std::size_t code = 0; code < got.size(); ++code) {
    const std::uint64_t most = expected[code];
    const bool shares = code == event::kSaturated && shared != 0;
    const std::uint64_t least = shares ? most - shared + 1 : most;
    if (got[code] >= least && got[code] <= most) continue;
    return ::testing::AssertionFailure()
           << got[code] << " pulses of event " << code << ", " << most << " expected";
  }
  return ::testing::AssertionSuccess();
}

}  // namespace hwffd::test
