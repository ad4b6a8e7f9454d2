#include "hwffd/tb/stream_bench.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "hwffd/tb/random.hpp"

namespace hwffd::tb {
namespace {

// Which generator takes which stream of the test's seed.
enum SeedIndex : std::uint64_t { kSourceSeed, kSinkSeed, kIdleSeed };

Beat inverted(Beat beat) {
  for (auto& word : beat.words) word = ~word;
  beat.last = !beat.last;
  return beat;
}

}  // namespace

StreamBench::StreamBench(cores::StreamCore& core, StreamBenchOptions options)
    : core_(core),
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
  pins_.in_reset = true;
  core_.drive_reset(true);
  for (std::uint64_t i = 0; i < cycles; ++i) step(SinkMode::kThrottled);
  pins_.in_reset = false;
  core_.drive_reset(false);
  events_ = {};
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
  driver_.drive(!pins_.in_reset && (source_willing || (first_cycle_ && options_.offer_at_once)));
  first_cycle_ = false;
  pins_.input_valid = driver_.valid();
  pins_.output_ready = mode == SinkMode::kThrottled ? sink_willing : mode == SinkMode::kReady;

  if (options_.probe_edges) probe(pins_.input_valid, pins_.output_ready);
  core_.drive_input(pins_.input_valid, driver_.beat());
  core_.drive_output_ready(pins_.output_ready);
  core_.settle();
  pins_.input_ready = core_.input_ready();
  pins_.output_valid = core_.output_valid();
  if (pins_.output_valid) pins_.output = core_.output();
  if (options_.probe_edges) compare_with_probe();

  checker_.observe(pins_, cycle_);
  bool moved = false;
  if (!pins_.in_reset) {
    count_events();
    moved = driver_.accept(pins_.input_ready, cycle_);
    if (monitor_.observe(pins_.output_valid, pins_.output_ready, pins_.output, cycle_)) {
      moved = true;
      Beat got = pins_.output;
      for (unsigned copies = fault_.pass(got); copies != 0; --copies) {
        scoreboard_.receive(got, cycle_);
      }
    }
  }
  core_.clock();
  ++cycle_;
  return moved;
}

void StreamBench::count_events() {
  const std::uint32_t pulses = core_.events();
  for (int event = 0; event < cores::kStreamEvents && pulses != 0; ++event) {
    events_[event] += pulses >> event & 1;
  }
}

void StreamBench::probe(bool valid, bool ready) {
  core_.drive_input(!valid, inverted(driver_.beat()));
  core_.drive_output_ready(!ready);
  core_.settle();
  probed_.input_ready = core_.input_ready();
  probed_.output_valid = core_.output_valid();
  if (probed_.output_valid) probed_.output = core_.output();
}

void StreamBench::compare_with_probe() {
  if (probed_.input_ready != pins_.input_ready) {
    checker_.report(cycle_, "input ready depends on an input of the same cycle");
  }
  if (probed_.output_valid != pins_.output_valid) {
    checker_.report(cycle_, "output valid depends on an input of the same cycle");
  } else if (pins_.output_valid && probed_.output != pins_.output) {
    checker_.report(cycle_, "output data depends on an input of the same cycle");
  }
}

bool StreamBench::run() {
  if (!was_reset_) throw std::logic_error("StreamBench: run before the first reset");
  if (hung_) return false;
  const std::uint64_t start = cycle_;
  const std::uint64_t total = driver_.waiting() + scoreboard_.outstanding();
  const std::uint64_t progress_step = total / 100 + 1;
  std::uint64_t next_progress = progress_step;
  std::uint64_t last_moved = cycle_;

  for (std::uint64_t left = total; left != 0;) {
    if (full()) return false;
    if (step(SinkMode::kThrottled)) {
      last_moved = cycle_;
      left = driver_.waiting() + scoreboard_.outstanding();
      if (progress_ && (total - left >= next_progress || left == 0)) {
        next_progress = total - left + progress_step;
        progress_(static_cast<double>(total - left) / static_cast<double>(total));
      }
    } else if (cycle_ - last_moved >= options_.stall_limit) {
      fail_hanging(fmt::format("no beat moved for {} cycles", options_.stall_limit));
      return false;
    }
    if (left != 0 && cycle_ - start >= options_.cycle_limit) {
      fail_hanging(fmt::format("no end after {} cycles", options_.cycle_limit));
      return false;
    }
  }
  // With ready high, a beat that appears is taken, and the scoreboard calls it unexpected.
  for (std::uint64_t i = 0; i < options_.quiet_cycles && !full(); ++i) step(SinkMode::kReady);
  return ok();
}

void StreamBench::run_for(std::uint64_t cycles) {
  if (!was_reset_) throw std::logic_error("StreamBench: run before the first reset");
  for (std::uint64_t i = 0; i < cycles && !full(); ++i) step(SinkMode::kThrottled);
}

bool StreamBench::raises_valid_without_ready(std::uint64_t limit, std::uint64_t hold) {
  if (!was_reset_) throw std::logic_error("StreamBench: run before the first reset");
  for (std::uint64_t i = 0; i < limit; ++i) {
    step(SinkMode::kStalled);
    if (!pins_.output_valid) continue;
    for (std::uint64_t j = 0; j < hold; ++j) step(SinkMode::kStalled);
    return true;
  }
  fail(fmt::format("output valid did not rise in {} cycles with ready held low", limit));
  return false;
}

bool StreamBench::full() const {
  return scoreboard_.full() || checker_.violations() >= ProtocolChecker::kMaxReports;
}

void StreamBench::fail(const std::string& what) {
  failures_.push_back(fmt::format("cycle {}: {}", cycle_, what));
}

void StreamBench::fail_hanging(const std::string& what) {
  hung_ = true;
  fail(fmt::format(
      "watchdog: {}; input beats accepted {}, waiting {}; results received {}, outstanding {}; "
      "pins: input valid {:d} ready {:d}, output valid {:d} ready {:d}",
      what, driver_.accepted(), driver_.waiting(), monitor_.count(), scoreboard_.outstanding(),
      pins_.input_valid, pins_.input_ready, pins_.output_valid, pins_.output_ready));
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
      cycle_);
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
