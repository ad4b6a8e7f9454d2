#include <algorithm>
#include <memory>

#include "hwffd/cores/stream_loop.hpp"
#include "hwffd/tb/protocol_checker.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/stream_driver.hpp"
#include "scenario.hpp"

namespace hwffd::upsets {
namespace {

constexpr std::uint64_t kQuiet = 64;  // clocks at rest, after which nothing comes
constexpr double kReady = 0.7;        // of the clocks: both sides wait now and then

class StreamBench {
 public:
  StreamBench(cores::StreamCore& core, const Plan& plan)
      : core_(core), plan_(plan), loop_(core), random_(plan.seed), driver_(plan.seed) {}

  void reset() {
    driver_.clear();
    loop_.reset(true);
    for (int edge = 0; edge < 2; ++edge) cycle(false);
    loop_.reset(false);
    hung_ = wrong_ = false;
    events_ = 0;
  }

  /// False once the core does not come to rest.
  bool pass(const Traffic& traffic) {
    if (hung_) return false;
    results_.clear();
    driver_.push(traffic.beats);
    std::uint64_t quiet = 0;
    for (std::uint64_t clock = 0; quiet < kQuiet; ++clock) {
      if (clock == plan_.limit) {
        hung_ = true;
        return false;
      }
      cycle(true);
      quiet = driver_.waiting() == 0 && core_.idle() && !loop_.pins().output_valid ? quiet + 1 : 0;
    }
    wrong_ = wrong_ || results_ != traffic.results;
    compared_ += results_.size();
    return true;
  }

  bool right() const { return !hung_ && !wrong_ && events_ == 0; }
  bool hung() const { return hung_; }
  bool wrong() const { return wrong_; }
  bool flagged() const { return events_ != 0; }
  bool broken() const { return checker_.violations() != 0; }
  std::uint64_t compared() const { return compared_; }

 private:
  void cycle(bool willing) {
    driver_.drive(willing && random_.chance(kReady));
    const auto& pins = loop_.drive(driver_.valid(), driver_.beat(), random_.chance(kReady));
    checker_.observe(pins, loop_.clocks());
    if (!pins.in_reset) {
      driver_.accept(pins.input_ready, loop_.clocks());
      if (pins.output_valid && pins.output_ready) results_.push_back(pins.output);
      events_ |= core_.events();
    }
    loop_.clock();
  }

  cores::StreamCore& core_;
  const Plan& plan_;
  cores::StreamLoop loop_;
  tb::Random random_;
  tb::StreamDriver driver_;
  tb::ProtocolChecker checker_;
  std::vector<Beat> results_;
  std::uint32_t events_ = 0;
  std::uint64_t compared_ = 0;
  bool hung_ = false;
  bool wrong_ = false;
};

class StreamScenario final : public Scenario {
 public:
  StreamScenario(cores::StreamCore& core, const Plan& plan) : bench_(core, plan), plan_(plan) {}

  void run(Trigger& trigger) override;
  Verdict judge() override;
  std::uint64_t compared() const override { return bench_.compared(); }

 private:
  StreamBench bench_;
  const Plan& plan_;
};

void StreamScenario::run(Trigger& trigger) {
  bench_.reset();
  trigger.open();
  bench_.pass(plan_.first);
  trigger.close();
  bench_.pass(plan_.second);
}

Verdict StreamScenario::judge() {
  Verdict verdict;
  if (bench_.right() && !bench_.broken()) return verdict;
  const bool hung = bench_.hung(), flagged = bench_.flagged(), wrong = bench_.wrong();
  bench_.reset();
  bench_.pass(plan_.first);
  verdict.recovered = verdict.restarted = bench_.right();
  verdict.outcome = hung      ? verdict.recovered ? Outcome::kHangCleared : Outcome::kHangStuck
                    : flagged ? Outcome::kFlagged
                    : wrong   ? Outcome::kSilent
                              : Outcome::kOther;
  return verdict;
}

}  // namespace

std::unique_ptr<Scenario> make_scenario(cores::StreamCore& core, const Plan& plan) {
  return std::make_unique<StreamScenario>(core, plan);
}

}  // namespace hwffd::upsets
