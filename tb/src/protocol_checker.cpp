#include "hwffd/tb/protocol_checker.hpp"

#include <fmt/format.h>

#include "hwffd/tb/beat_text.hpp"

namespace hwffd::tb {

void ProtocolChecker::report(std::uint64_t cycle, const std::string& what) {
  if (++violations_ <= kMaxReports) reports_.push_back(fmt::format("cycle {}: {}", cycle, what));
}

void ProtocolChecker::observe_reset(const StreamPins& pins, std::uint64_t cycle, bool cleared) {
  if (pins.in_reset) {
    if (cleared && pins.output_valid) report(cycle, "output valid is high in reset");
    if (cleared && pins.input_ready) report(cycle, "input ready is high in reset");
    if (!cleared) ++edges_seen_;
    waiting_ = false;
    return;
  }
  if (cleared && pins.output_valid) {
    report(cycle, "output valid is high in the first cycle after reset");
  }
  edges_seen_ = 0;
  waiting_ = pins.output_valid && !pins.output_ready;
  if (waiting_) held_ = pins.output;
}

void ProtocolChecker::report_change(const StreamPins& pins, std::uint64_t cycle) {
  if (!pins.output_valid) {
    report(cycle, "output valid fell before the beat was accepted: " + beat_text(held_));
    return;
  }
  report(cycle, fmt::format("output changed while it waited, from {} to {}", beat_text(held_),
                            beat_text(pins.output)));
}

}  // namespace hwffd::tb
