#include <algorithm>

#include "hwffd/error.hpp"
#include "hwffd/registers.h"
#include "hwffd/tb/axi_system.hpp"
#include "hwffd/tb/packet_ring.hpp"
#include "scenario.hpp"

namespace hwffd::upsets {
namespace {

constexpr DescriptorRing kRing{0x100200, 4};
constexpr AddressWindow kBuffers{0x200F70, 0x20FFFF};
constexpr AddressWindow kReadWindow{kRing.base, kBuffers.limit};
constexpr AddressWindow kWriteWindow{0x100001230, 0x100005FFF};
constexpr std::uint64_t kBeat = cores::kAxiBeatBytes;
constexpr std::uint64_t kAfter = 100;    // clocks, after which nothing comes
constexpr std::uint64_t kPoll = 12;      // clocks of a read of STATUS
constexpr std::uint64_t kAccess = 2000;  // clocks, after which an access has no answer

bool outside(const std::vector<tb::AxiMemory::Burst>& bursts, const AddressWindow& window) {
  return std::any_of(bursts.begin(), bursts.end(), [&](const tb::AxiMemory::Burst& burst) {
    return burst.address < window.base || burst.address > window.limit ||
           burst.beats * kBeat > window.limit - burst.address + 1;
  });
}

class AxiBench {
 public:
  AxiBench(cores::AxiCore& core, const Plan& plan)
      : plan_(plan),
        system_(core, plan.seed),
        driver_(system_),
        ring_(system_.memory, driver_, kRing, kBuffers) {
    system_.memory.set_latency({1, 20});
    system_.set_throttles("gaps");
    system_.access_limit = kAccess;
  }

  /// As whoever starts the core does it.
  void set_up() {
    attempt([&] {
      driver_.probe();
      driver_.set_windows(kReadWindow, kWriteWindow);
      driver_.lock_windows();
      system_.allow(kReadWindow, kWriteWindow);
    });
  }
  void open() {
    attempt([&] {
      driver_.enable_interrupts(HWFFD_IRQ_ENABLE_DONE_MASK | HWFFD_IRQ_ENABLE_ERROR_MASK |
                                HWFFD_IRQ_ENABLE_REFUSED_MASK);
      ring_.open();
    });
  }

  void pass(const Traffic& traffic) {
    attempt([&] {
      ring_.set_next_buffer(kBuffers.base);
      ring_.put(traffic.beats);
      const std::uint64_t bytes = traffic.results.size() * kBeat;
      area_ = next_area_;
      next_area_ += bytes;
      changed_ = changed();
      driver_.set_results({area_, static_cast<std::uint32_t>(bytes)});
      driver_.clear_counters();
      driver_.start();
      hung_ = !driver_.wait_done(plan_.limit / kPoll);
      if (!hung_) compare(traffic);
    });
  }

  /// What was seen is forgotten; then as a driver does after an error.
  void soft_reset() {
    forget();
    attempt([&] {
      hung_ = !driver_.soft_reset(plan_.limit / kPoll);
      driver_.take_errors();
      driver_.take_interrupts();
      upset_reported();
    });
    open();
  }
  void hard_reset() {
    forget();
    system_.allow({}, {});
    system_.forget_bus();
    system_.reset();
    set_up();
    open();
  }

  bool right() const { return !hung_ && !wrong_ && !flagged_; }
  bool hung() const { return hung_; }
  bool wrong() const { return wrong_; }
  bool flagged() const { return flagged_; }
  bool broken() const {
    return system_.bus_checker.violations() + system_.register_checker.violations() != 0;
  }
  bool wrote_outside() const { return outside(system_.memory.writes(), kWriteWindow); }
  bool read_outside() const { return outside(system_.memory.reads(), kReadWindow); }
  std::uint64_t compared() const { return compared_; }

 private:
  /// Does nothing once something went wrong. An error response, or a core that says of itself what
  /// cannot be, tells of it; no response at all is a hang.
  template <class Steps>
  void attempt(const Steps& steps) {
    if (hung_ || flagged_) return;
    try {
      steps();
    } catch (const DriverError&) {
      flagged_ = true;
    } catch (const std::runtime_error&) {
      hung_ = true;
    }
  }

  void compare(const Traffic& traffic) {
    system_.run(kAfter);
    const std::uint64_t count = traffic.results.size();
    for (std::uint64_t i = 0; i < count; ++i) {
      wrong_ = wrong_ || system_.memory.beat(area_ + i * kBeat) != traffic.results[i].words;
    }
    wrong_ = wrong_ || driver_.result_count() != count || changed() != changed_ ||
             !system_.interrupt() || driver_.take_interrupts() != HWFFD_IRQ_STATE_DONE_MASK;
    const CoreErrors errors = driver_.take_errors();
    flagged_ = errors.status != 0 || errors.count != 0 || driver_.stopped() || upset_reported();
    compared_ += count;
  }

  /// Whether a hardened core tells of a flip. One that three copies have mended is none.
  bool upset_reported() {
    const std::uint32_t limits = system_.read32(HWFFD_LIMITS2_OFFSET);
    if ((limits & HWFFD_LIMITS2_HARDENED_MASK) == 0) return false;
    const std::uint32_t upset_status = system_.read32(HWFFD_UPSET_STATUS_OFFSET);
    system_.write32(HWFFD_UPSET_STATUS_OFFSET, upset_status);
    return (upset_status & ~HWFFD_UPSET_STATUS_COPY_MASK) != 0 || (wrong_ && upset_status != 0);
  }

  /// Bytes that were written where no result of this or an earlier area belongs. What a run with a
  /// fault has left behind is not that of the next one.
  std::uint64_t changed() const {
    return system_.memory.changed_outside(
        {ring_.ring_range(), {kBuffers.base, kBuffers.limit}, {kWriteWindow.base, next_area_ - 1}});
  }

  void forget() { hung_ = wrong_ = flagged_ = false; }

  const Plan& plan_;
  tb::AxiSystem system_;
  Driver driver_;
  tb::PacketRing ring_;
  std::uint64_t area_ = kWriteWindow.base;
  std::uint64_t next_area_ = kWriteWindow.base;
  std::uint64_t changed_ = 0;  // before the pass
  std::uint64_t compared_ = 0;
  bool hung_ = false;
  bool wrong_ = false;
  bool flagged_ = false;
};

class AxiScenario final : public Scenario {
 public:
  AxiScenario(cores::AxiCore& core, const Plan& plan) : bench_(core, plan), plan_(plan) {}

  void run(Trigger& trigger) override;
  Verdict judge() override;
  std::uint64_t compared() const override { return bench_.compared(); }

 private:
  AxiBench bench_;
  const Plan& plan_;
};

void AxiScenario::run(Trigger& trigger) {
  bench_.set_up();
  bench_.open();
  trigger.open();
  bench_.pass(plan_.first);
  trigger.close();
  bench_.pass(plan_.second);
}

Verdict AxiScenario::judge() {
  Verdict verdict;
  const bool outside_write = bench_.wrote_outside();
  verdict.outside_read = bench_.read_outside();
  if (bench_.right() && !bench_.broken() && !outside_write) return verdict;
  const bool hung = bench_.hung(), flagged = bench_.flagged(), wrong = bench_.wrong();
  bench_.soft_reset();
  bench_.pass(plan_.second);
  verdict.recovered = verdict.restarted = bench_.right();
  if (!verdict.recovered) {
    bench_.hard_reset();
    bench_.pass(plan_.second);
    verdict.restarted = bench_.right();
  }
  verdict.outcome = outside_write ? Outcome::kOutsideWindow
                    : hung        ? verdict.recovered ? Outcome::kHangCleared : Outcome::kHangStuck
                    : flagged     ? Outcome::kFlagged
                    : wrong       ? Outcome::kSilent
                                  : Outcome::kOther;
  return verdict;
}

}  // namespace

std::unique_ptr<Scenario> make_scenario(cores::AxiCore& core, const Plan& plan) {
  return std::make_unique<AxiScenario>(core, plan);
}

}  // namespace hwffd::upsets
