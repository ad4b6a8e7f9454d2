#include "hwffd/tb/stream_bench.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "hwffd/tb/random.hpp"

namespace hwffd::tb {
namespace {

// Which generator takes which stream of the test's seed.
enum SeedIndex : std::uint64_t { kSourceSeed, kSinkSeed, kIdleSeed };

constexpr std::uint64_t kAlwaysProbed = 4096;
constexpr std::uint64_t kProbeStep = 17;  // shares no factor with the schedules

Beat inverted(Beat beat) {
  for (auto& word : beat.words) word = ~word;
  beat.last = !beat.last;
  return beat;
}

}  // namespace

StreamBench::StreamBench(cores::StreamCore& core, StreamBenchOptions options)
    : core_(core),
      loop_(core),
      options_(std::move(options)),
      source_(
          make_throttle(options_.source_throttle, derive_seed(options_.test.seed, kSourceSeed))),
      sink_(make_throttle(options_.sink_throttle, derive_seed(options_.test.seed, kSinkSeed))),
      driver_(derive_seed(options_.test.seed, kIdleSeed)),
      checker_(options_.reset_edges),
      scoreboard_(options_.test) {
  driver_.record(options_.record);
  monitor_.record(options_.record);
}

void StreamBench::reset(std::uint64_t cycles) {
  if (cycles == 0) throw std::invalid_argument("StreamBench: a reset takes at least one cycle");
  driver_.clear();
  monitor_.clear();
  scoreboard_.restart();
  loop_.reset(true);
  for (std::uint64_t i = 0; i < cycles; ++i) step(SinkMode::kThrottled);
  loop_.reset(false);
  events_ = {};
  event_places_ = {};
  seconds_ = 0;
  waits_ = {};
  was_reset_ = true;
  first_cycle_ = true;
  hung_ = false;
}

void StreamBench::send(std::vector<Beat> beats) { driver_.push(std::move(beats)); }

void StreamBench::expect(std::vector<Beat> beats) {
  monitor_.reserve(scoreboard_.outstanding() + beats.size());
  scoreboard_.expect(std::move(beats));
}

bool StreamBench::step(SinkMode mode) {
  // The throttles are asked in every cycle, so that one side's pattern does not depend on the
  // other.
  const bool source_willing = source_.willing();
  const bool sink_willing = sink_.willing();
  const bool in_reset = loop_.pins().in_reset;
  const std::uint64_t cycle = loop_.clocks();
  driver_.drive(!in_reset && (source_willing || (first_cycle_ && options_.offer_at_once)));
  first_cycle_ = false;
  const bool ready = mode == SinkMode::kThrottled ? sink_willing : mode == SinkMode::kReady;

  // What depends on an input does so from the start. Later, when a run repeats itself, a look now
  // and then costs less than half of the simulation.
  const bool probing = options_.probe_edges && (cycle < kAlwaysProbed || cycle % kProbeStep == 0);
  StreamPins probed;
  if (probing) probed = loop_.drive(!driver_.valid(), inverted(driver_.beat()), !ready);
  const StreamPins& pins = loop_.drive(driver_.valid(), driver_.beat(), ready);
  if (probing) compare(probed, pins);

  checker_.observe(pins, cycle);
  if (asleep_ && !in_reset &&
      (core_.events() != 0 || pins.output_valid || (!core_.idle() && !driver_.valid()))) {
    checker_.report(cycle, "the core was idle, no beat was offered, and something is inside");
  }
  asleep_ = !in_reset && core_.idle() && !driver_.valid();
  if (asleep_ && core_.events() != 0) {
    checker_.report(cycle, "the core is idle, no beat is offered, and tells an event");
  }
  bool moved = false;
  if (!in_reset) {
    count_events();
    count_waits();
    if (core_.upset()) checker_.report(cycle, "an upset is told, and none happened");
    moved = driver_.accept(pins.input_ready, cycle);
    if (monitor_.observe(pins.output_valid, pins.output_ready, pins.output, cycle)) {
      moved = true;
      Beat got = pins.output;
      for (unsigned copies = fault_.pass(got); copies != 0; --copies) {
        scoreboard_.receive(got, cycle);
      }
    }
  }
  loop_.clock();
  return moved;
}

void StreamBench::count_events() {
  const std::uint32_t second = core_.second();
  seconds_ += second & 1;
  events_[stream_event(event::kSaturated)] += second >> 1 & 1;
  const std::uint32_t pulses = core_.events();
  for (int event = 0; event < kStreamEvents && pulses != 0; ++event) {
    if ((pulses >> event & 1) == 0) continue;
    ++events_[event];
    event_places_[event] = core_.event_place();
  }
}

void StreamBench::count_waits() {
  const std::uint32_t waits = core_.waits();
  for (unsigned bit = 0; bit < waits_.size() && waits != 0; ++bit) waits_[bit] += waits >> bit & 1;
}

void StreamBench::compare(const StreamPins& probed, const StreamPins& pins) {
  const std::uint64_t cycle = loop_.clocks();
  if (probed.input_ready != pins.input_ready) {
    checker_.report(cycle, "input ready depends on an input of the same cycle");
  }
  if (probed.output_valid != pins.output_valid) {
    checker_.report(cycle, "output valid depends on an input of the same cycle");
  } else if (pins.output_valid && probed.output != pins.output) {
    checker_.report(cycle, "output data depends on an input of the same cycle");
  }
}

bool StreamBench::run() {
  if (!was_reset_) throw std::logic_error("StreamBench: run before the first reset");
  if (hung_) return false;
  switch (loop_.run(*this, {options_.stall_limit, options_.cycle_limit}, progress_)) {
    case cores::StreamEnd::kDone:
      // With ready high, a beat that appears is taken, and the scoreboard calls it unexpected.
      for (std::uint64_t i = 0; i < options_.quiet_cycles && !stopped(); ++i) {
        step(SinkMode::kReady);
      }
      return ok();
    case cores::StreamEnd::kStalled:
      fail_hanging(fmt::format("no beat moved for {} cycles", options_.stall_limit));
      break;
    case cores::StreamEnd::kLate:
      fail_hanging(fmt::format("no end after {} cycles", options_.cycle_limit));
      break;
    case cores::StreamEnd::kStopped:
      break;
  }
  return false;
}

void StreamBench::run_for(std::uint64_t cycles) {
  if (!was_reset_) throw std::logic_error("StreamBench: run before the first reset");
  for (std::uint64_t i = 0; i < cycles && !stopped(); ++i) step(SinkMode::kThrottled);
}

bool StreamBench::raises_valid_without_ready(std::uint64_t limit, std::uint64_t hold) {
  if (!was_reset_) throw std::logic_error("StreamBench: run before the first reset");
  for (std::uint64_t i = 0; i < limit; ++i) {
    step(SinkMode::kStalled);
    if (!loop_.pins().output_valid) continue;
    for (std::uint64_t j = 0; j < hold; ++j) step(SinkMode::kStalled);
    return true;
  }
  fail(fmt::format("output valid did not rise in {} cycles with ready held low", limit));
  return false;
}

bool StreamBench::stopped() const {
  return scoreboard_.full() || checker_.violations() >= ProtocolChecker::kMaxReports;
}

void StreamBench::fail(const std::string& what) {
  failures_.push_back(fmt::format("cycle {}: {}", loop_.clocks(), what));
}

void StreamBench::fail_hanging(const std::string& what) {
  const StreamPins& pins = loop_.pins();
  hung_ = true;
  fail(fmt::format(
      "watchdog: {}; input beats accepted {}, waiting {}; results received {}, outstanding {}; "
      "pins: input valid {:d} ready {:d}, output valid {:d} ready {:d}",
      what, driver_.accepted(), driver_.waiting(), monitor_.count(), scoreboard_.outstanding(),
      pins.input_valid, pins.input_ready, pins.output_valid, pins.output_ready));
}

bool StreamBench::finish() {
  end_failures_.clear();
  scoreboard_.finish();
  if (driver_.waiting() != 0) {
    end_failures_.push_back(fmt::format("{} input beats were never accepted", driver_.waiting()));
  }
  return ok();
}

bool StreamBench::ok() const {
  return failures_.empty() && end_failures_.empty() && checker_.violations() == 0 &&
         scoreboard_.ok();
}

std::string StreamBench::report() const {
  const TestIdentity& test = options_.test;
  std::string text = fmt::format(
      "{} seed {} ({} -> {}): {} of {} beats checked, {} wrong, {} extra, {} protocol violations, "
      "{} cycles\n",
      test.name, test.seed, options_.source_throttle, options_.sink_throttle, scoreboard_.checked(),
      scoreboard_.expected(), scoreboard_.mismatches(), scoreboard_.extra(), checker_.violations(),
      loop_.clocks());
  for (const auto* list : {&checker_.reports(), &failures_, &end_failures_}) {
    for (const std::string& line : *list) text += line + "\n";
  }
  for (const std::string& line : scoreboard_.reports()) text += line + "\n";
  return text + "replay: " + replay_command(test) + "\n";
}

double StreamBench::clocks_per_result(std::size_t first, std::size_t last) const {
  const auto& clocks = result_clocks();
  if (first >= last || last >= clocks.size()) {
    throw std::out_of_range(fmt::format("clocks_per_result: {} to {} of {} recorded results", first,
                                        last, clocks.size()));
  }
  return static_cast<double>(clocks[last] - clocks[first]) / static_cast<double>(last - first);
}

double StreamBench::clocks_per_result() const {
  const std::size_t count = result_clocks().size();
  return clocks_per_result(0, count == 0 ? 0 : count - 1);
}

}  // namespace hwffd::tb
