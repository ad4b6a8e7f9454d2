#include "hwffd/tb/axi_checker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace hwffd::tb {
namespace {

bool same(const cores::AxiAddressChannel& a, const cores::AxiAddressChannel& b) {
  return a.address == b.address && a.len == b.len && a.size == b.size && a.burst == b.burst &&
         a.cache == b.cache && a.prot == b.prot && a.id == b.id;
}
bool same(const cores::AxiReadChannel& a, const cores::AxiReadChannel& b) {
  return a.data == b.data && a.response == b.response && a.last == b.last;
}
bool same(const cores::AxiWriteChannel& a, const cores::AxiWriteChannel& b) {
  return a.data == b.data && a.strobe == b.strobe && a.last == b.last;
}
bool same(const cores::AxiResponseChannel& a, const cores::AxiResponseChannel& b) {
  return a.response == b.response;
}

/// Whether a channel broke its promise to hold what waited.
template <class Channel>
bool moved(const Channel& before, const Channel& now) {
  return before.valid && !before.ready && !(now.valid && same(before, now));
}

/// A bus of single beats of four bytes.
cores::AxiPins as_axi(const cores::AxiLitePins& lite) {
  const cores::AxiLiteMasterPins& m = lite.master;
  const cores::AxiLiteSlavePins& s = lite.slave;
  cores::AxiPins pins;
  pins.ar = {m.arvalid, s.arready, m.araddr};
  pins.ar.prot = m.arprot;
  pins.r = {s.rvalid, m.rready, {s.rdata}, s.rresp, true};
  pins.aw = {m.awvalid, s.awready, m.awaddr};
  pins.aw.prot = m.awprot;
  pins.w = {m.wvalid, s.wready, {m.wdata}, m.wstrb, true};
  pins.b = {s.bvalid, m.bready, s.bresp};
  return pins;
}

/// Whether an address is new in this cycle.
bool raised(const cores::AxiAddressChannel& before, const cores::AxiAddressChannel& now) {
  return now.valid && (!before.valid || before.ready);
}

}  // namespace

const char* axi_rule_name(AxiRule rule) {
  static constexpr const char* kNames[] = {"stable",   "reset",      "shape",       "aligned",
                                           "boundary", "length",     "write last",  "read last",
                                           "unasked",  "unanswered", "outstanding", "window",
                                           "stall",    "ready fell", "after error"};
  return kNames[static_cast<std::size_t>(rule)];
}

std::uint64_t AxiChecker::violations() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

void AxiChecker::report(AxiRule rule, std::uint64_t cycle, const std::string& what) {
  ++counts_[static_cast<std::size_t>(rule)];
  if (reports_.size() < kMaxReports) {
    reports_.push_back(fmt::format("cycle {}: {}: {}", cycle, axi_rule_name(rule), what));
  }
}

void AxiChecker::check_reset(const cores::AxiPins& pins, std::uint64_t cycle, bool in_reset) {
  if (lite_) return check_lite_reset(pins, cycle, in_reset);
  // The first edge in reset clears; what is there before is no fault.
  if (edges_in_reset_ < limits_.reset_edges) return;
  if (pins.ar.valid || pins.aw.valid || pins.w.valid) {
    report(AxiRule::kReset, cycle, "ARVALID, AWVALID or WVALID");
  }
  if (in_reset && (pins.r.ready || pins.b.ready)) {
    report(AxiRule::kReset, cycle, "RREADY or BREADY");
  }
}

/// The slave may take and offer nothing in the first cycle after reset either.
void AxiChecker::check_lite_reset(const cores::AxiPins& pins, std::uint64_t cycle, bool in_reset) {
  const auto low = [&](const char* name, bool level) {
    if (level) report(AxiRule::kReset, cycle, name);
  };
  if (in_reset) {
    low("AWVALID", pins.aw.valid);
    low("WVALID", pins.w.valid);
    low("ARVALID", pins.ar.valid);
  }
  if (edges_in_reset_ < limits_.reset_edges) return;
  low("BVALID", pins.b.valid);
  low("RVALID", pins.r.valid);
  low("AWREADY", pins.aw.ready);
  low("WREADY", pins.w.ready);
  low("ARREADY", pins.ar.ready);
}

void AxiChecker::check_stable(const cores::AxiPins& pins, std::uint64_t cycle) {
  if (moved(before_.ar, pins.ar)) report(AxiRule::kStable, cycle, "AR");
  if (moved(before_.aw, pins.aw)) report(AxiRule::kStable, cycle, "AW");
  if (moved(before_.w, pins.w)) report(AxiRule::kStable, cycle, "W");
  if (moved(before_.r, pins.r)) report(AxiRule::kStable, cycle, "R");
  if (moved(before_.b, pins.b)) report(AxiRule::kStable, cycle, "B");
  if (lite_) return;
  const bool pause = limits_.width == 256 && before_.r.valid;
  const bool fell =
      (before_.r.ready && !pins.r.ready && !pause) || (before_.b.ready && !pins.b.ready);
  if (fell && !ready_may_fall_) report(AxiRule::kReadyFell, cycle, "RREADY or BREADY");
}

void AxiChecker::check_address(const cores::AxiAddressChannel& channel, bool read,
                               std::uint64_t cycle) {
  if (lite_) return;
  const std::uint64_t beat = limits_.width / 8;
  const std::uint64_t last =
      channel.address / beat * beat + ((channel.len + std::uint64_t{1}) * beat - 1);
  const std::uint64_t units = (last - channel.address) / cores::kAxiBeatBytes + 1;
  const std::string what =
      fmt::format("{} {:#x}, {} beats", read ? "read" : "write", channel.address, channel.len + 1);
  if (std::uint64_t{1} << channel.size != beat || channel.burst != 1)
    report(AxiRule::kShape, cycle, what);
  if (channel.address % cores::kAxiBeatBytes != 0) report(AxiRule::kAligned, cycle, what);
  if (channel.address / 4096 != last / 4096) report(AxiRule::kBoundary, cycle, what);
  if (units > limits_.burst) report(AxiRule::kLength, cycle, what);
  const std::uint64_t first_legal = read ? limits_.read_first : limits_.write_first;
  const std::uint64_t last_legal = read ? limits_.read_last : limits_.write_last;
  // At 256 bits the upper half of the last beat may lie behind it, unread or not written.
  const std::uint64_t end = last_legal | (std::max(beat, cores::kAxiBeatBytes) - 1);
  const std::uint64_t allowed = limits_.width == 256 ? end : last_legal;
  if (channel.address < first_legal || last > allowed || last < channel.address) {
    report(AxiRule::kWindow, cycle, what);
  }
}

void AxiChecker::check_errors(const cores::AxiPins& pins, std::uint64_t cycle) {
  if (lite_) return;
  const std::uint64_t late = limits_.width == 256 ? 1 : 0;
  if (error_seen_ && cycle - error_cycle_ > kAxiAddressesAfterError + late) {
    const unsigned allowed = hardened_ ? kAxiAddressesInGuard : 0;
    if (raised(before_.ar, pins.ar) && ++late_reads_ > allowed)
      report(AxiRule::kAfterError, cycle, "AR");
    if (raised(before_.aw, pins.aw) && ++late_writes_ > allowed)
      report(AxiRule::kAfterError, cycle, "AW");
  }
  const bool error = errs(pins);
  if (error && !error_seen_) error_cycle_ = cycle;
  error_seen_ = error_seen_ || error;
}

/// Whether an error response was taken; that of 16 bytes counts when all of them have come.
bool AxiChecker::errs(const cores::AxiPins& pins) {
  const bool write = pins.b.valid && pins.b.ready && pins.b.response != cores::kAxiOkay;
  if (!pins.r.valid || !pins.r.ready) return write;
  const bool failed = pins.r.response != cores::kAxiOkay || half_error_;
  const bool half = limits_.width == 64 && !reads_.empty() && reads_.front() % 2 == 0;
  half_error_ = half && failed;
  return write || (failed && !half);
}

void AxiChecker::observe_reads(const cores::AxiPins& pins, std::uint64_t cycle) {
  if (pins.r.valid && reads_.empty()) {
    report(AxiRule::kUnasked, cycle, "read data");
  } else if (pins.r.valid && pins.r.ready) {
    const bool last = --reads_.front() == 0;
    if (last != pins.r.last) report(AxiRule::kReadLast, cycle, last ? "missing" : "early");
    if (lite_ && pins.r.response == cores::kAxiExOkay) report(AxiRule::kShape, cycle, "R");
    if (last) reads_.pop_front();
  }
  if (pins.ar.valid && pins.ar.ready) {
    check_address(pins.ar, true, cycle);
    reads_.push_back(pins.ar.len + std::uint64_t{1});
  }
  most_reads_ = std::max<std::uint64_t>(most_reads_, reads_.size());
  if (reads_.size() > limits_.reads) report(AxiRule::kOutstanding, cycle, "reads");
}

void AxiChecker::pair_writes(std::uint64_t cycle) {
  while (!writes_.empty() && !data_.empty()) {
    if (writes_.front() != data_.front()) {
      report(AxiRule::kWriteLast, cycle,
             fmt::format("{} beats, {} wanted", data_.front(), writes_.front()));
    }
    writes_.pop_front();
    data_.pop_front();
    ++unanswered_;
  }
}

void AxiChecker::check_write_data(const cores::AxiPins& pins, std::uint64_t cycle) {
  pause_ = pins.w.valid || data_beats_ == 0 ? 0 : pause_ + 1;
  if (pause_ > (limits_.width == 256 ? 1 : 0)) report(AxiRule::kStall, cycle, "write data");
  if (lite_ || !pins.w.valid || !pins.w.ready) return;
  const std::uint32_t all = static_cast<std::uint32_t>((std::uint64_t{1} << limits_.width / 8) - 1);
  const bool upper = limits_.width == 256 && data_beats_ == 0 && pins.w.strobe == 0xffff0000;
  const bool lower = limits_.width == 256 && pins.w.last && pins.w.strobe == 0xffff;
  const bool none = hardened_ && ready_may_fall_ && pins.w.strobe == 0;
  if (pins.w.strobe != all && !upper && !lower && !none) report(AxiRule::kShape, cycle, "strobes");
}

void AxiChecker::observe_writes(const cores::AxiPins& pins, std::uint64_t cycle) {
  if (pins.b.valid && unanswered_ == 0) {
    report(AxiRule::kUnasked, cycle, "write response");
  } else if (pins.b.valid && pins.b.ready) {
    --unanswered_;
    if (lite_ && pins.b.response == cores::kAxiExOkay) report(AxiRule::kShape, cycle, "B");
  }
  check_write_data(pins, cycle);
  if (pins.aw.valid && pins.aw.ready) {
    check_address(pins.aw, false, cycle);
    writes_.push_back(pins.aw.len + std::uint64_t{1});
  }
  if (pins.w.valid && pins.w.ready) {
    ++data_beats_;
    if (pins.w.last) {
      data_.push_back(data_beats_);
      data_beats_ = 0;
    }
  }
  pair_writes(cycle);
  const std::uint64_t open = writes_.size() + unanswered_;
  most_writes_ = std::max(most_writes_, open);
  if (open > limits_.writes) report(AxiRule::kOutstanding, cycle, "writes");
}

void AxiChecker::observe(const cores::AxiPins& pins, std::uint64_t cycle, bool in_reset) {
  if (in_reset || edges_in_reset_ > 0) check_reset(pins, cycle, in_reset);
  edges_in_reset_ = in_reset ? edges_in_reset_ + 1 : 0;
  reset_seen_ = reset_seen_ || in_reset;
  if (in_reset) {
    reads_.clear();
    writes_.clear();
    data_.clear();
    data_beats_ = unanswered_ = pause_ = 0;
    half_error_ = false;
    before_known_ = false;
    restarted();
    return;
  }
  if (before_known_) {
    check_stable(pins, cycle);
    check_errors(pins, cycle);
  }
  observe_reads(pins, cycle);
  observe_writes(pins, cycle);
  before_ = pins;
  before_known_ = true;
}

void AxiChecker::observe(const cores::AxiLitePins& pins, std::uint64_t cycle) {
  observe(as_axi(pins), cycle, pins.in_reset);
}

void AxiChecker::finish(std::uint64_t cycle) {
  if (lite_ && !reset_seen_) report(AxiRule::kReset, cycle, "no reset was seen");
  const std::size_t open = reads_.size() + writes_.size() + data_.size() + unanswered_;
  if (open != 0 || data_beats_ != 0) {
    report(AxiRule::kUnanswered, cycle, fmt::format("{} bursts", open));
  }
}

}  // namespace hwffd::tb
