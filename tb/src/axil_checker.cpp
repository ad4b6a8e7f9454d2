#include "hwffd/tb/axil_checker.hpp"

#include <fmt/format.h>

namespace hwffd::tb {

void AxiLiteChecker::report(std::uint64_t cycle, const std::string& what) {
  if (++violations_ <= kMaxReports) reports_.push_back(fmt::format("cycle {}: {}", cycle, what));
}

void AxiLiteChecker::observe(const cores::AxiLitePins& pins, std::uint64_t cycle) {
  if (pins.in_reset || in_reset_) observe_reset(pins, cycle);
  in_reset_ = pins.in_reset;
  if (pins.in_reset) {
    cleared_ = true;
    held_ = {};
    open_aw_ = open_w_ = open_ar_ = 0;
    waits_b_ = waits_r_ = false;
    return;
  }
  const cores::AxiLiteMasterPins& m = pins.master;
  const cores::AxiLiteSlavePins& s = pins.slave;
  const Channel channels[] = {
      {"aw", m.awvalid, s.awready, m.awaddr},
      {"w", m.wvalid, s.wready, std::uint64_t{m.wstrb} << 32 | m.wdata},
      {"b", s.bvalid, m.bready, s.bresp},
      {"ar", m.arvalid, s.arready, m.araddr},
      {"r", s.rvalid, m.rready, std::uint64_t{s.rresp} << 32 | s.rdata},
  };
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const Channel& now = channels[i];
    if (held_[i].waiting && !now.valid) {
      report(cycle, fmt::format("{}valid fell before it was accepted", now.name));
    } else if (held_[i].waiting && now.payload != held_[i].payload) {
      report(cycle, fmt::format("{} changed while it waited, from {:x} to {:x}", now.name,
                                held_[i].payload, now.payload));
    }
    held_[i] = {now.valid && !now.ready, now.payload};
  }
  observe_order(pins, cycle);
}

void AxiLiteChecker::observe_reset(const cores::AxiLitePins& pins, std::uint64_t cycle) {
  const cores::AxiLiteMasterPins& m = pins.master;
  const cores::AxiLiteSlavePins& s = pins.slave;
  const char* when = pins.in_reset ? "in reset" : "in the first cycle after reset";
  const auto low = [&](const char* name, bool level) {
    if (level) report(cycle, fmt::format("{} is high {}", name, when));
  };
  if (pins.in_reset) {
    low("awvalid", m.awvalid);
    low("wvalid", m.wvalid);
    low("arvalid", m.arvalid);
    if (!in_reset_) return;  // the slave has seen no edge in this reset yet
  }
  low("bvalid", s.bvalid);
  low("rvalid", s.rvalid);
  low("awready", s.awready);
  low("wready", s.wready);
  low("arready", s.arready);
}

void AxiLiteChecker::observe_order(const cores::AxiLitePins& pins, std::uint64_t cycle) {
  const cores::AxiLiteMasterPins& m = pins.master;
  const cores::AxiLiteSlavePins& s = pins.slave;
  if (s.bvalid && !waits_b_) {
    if (open_aw_ == 0) report(cycle, "bvalid without an accepted address");
    if (open_w_ == 0) report(cycle, "bvalid without accepted data");
    if (s.bresp == cores::kExOkay) report(cycle, "bresp is EXOKAY");
  }
  if (s.rvalid && !waits_r_) {
    if (open_ar_ == 0) report(cycle, "rvalid without an accepted address");
    if (s.rresp == cores::kExOkay) report(cycle, "rresp is EXOKAY");
  }
  waits_b_ = s.bvalid && !m.bready;
  waits_r_ = s.rvalid && !m.rready;
  if (s.bvalid && m.bready) {
    ++writes_;
    open_aw_ -= open_aw_ > 0 ? 1 : 0;
    open_w_ -= open_w_ > 0 ? 1 : 0;
  }
  if (s.rvalid && m.rready) {
    ++reads_;
    open_ar_ -= open_ar_ > 0 ? 1 : 0;
  }
  open_aw_ += m.awvalid && s.awready ? 1 : 0;
  open_w_ += m.wvalid && s.wready ? 1 : 0;
  open_ar_ += m.arvalid && s.arready ? 1 : 0;
}

void AxiLiteChecker::finish(std::uint64_t cycle) {
  if (!cleared_) report(cycle, "no reset was seen");
  if (open_aw_ > 0 || open_w_ > 0) {
    report(cycle,
           fmt::format("writes without a response: {} addresses, {} data", open_aw_, open_w_));
  }
  if (open_ar_ > 0) report(cycle, fmt::format("reads without a response: {}", open_ar_));
}

}  // namespace hwffd::tb
