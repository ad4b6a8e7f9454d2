#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "built_core.hpp"
#include "hwffd/model/scatter_stream.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/stream_bench.hpp"

namespace hwffd::test {

/// A core whose events are written down, each with its place.
class EventLog final : public cores::StreamCore {
 public:
  explicit EventLog(std::unique_ptr<cores::StreamCore> core) : core_(std::move(core)) {}

  void drive_reset(bool asserted) override;
  void drive_input(bool valid, const Beat& beat) override { core_->drive_input(valid, beat); }
  void drive_output_ready(bool ready) override { core_->drive_output_ready(ready); }
  void settle() override { core_->settle(); }
  void clock() override;
  bool input_ready() const override { return core_->input_ready(); }
  bool output_valid() const override { return core_->output_valid(); }
  Beat output() const override { return core_->output(); }
  std::uint32_t events() const override { return core_->events(); }
  std::uint32_t second() const override { return core_->second(); }
  cores::EventPlace event_place() const override { return core_->event_place(); }
  std::uint32_t waits() const override { return core_->waits(); }
  bool upset() const override { return core_->upset(); }
  bool idle() const override { return core_->idle(); }

  /// Pulses since reset, in the order of clocks.
  const std::vector<model::ScatterEvent>& log() const { return log_; }

 private:
  std::unique_ptr<cores::StreamCore> core_;
  bool in_reset_ = true;
  std::vector<model::ScatterEvent> log_;
};

/// Whether the place of an event of gradients and collects says where its packet is: not of those
/// that tell of a vertex that has added or of a word.
bool has_place(const model::ScatterEvent& event);

/// Events whose places are compared, and how often each of the others came.
struct EventTally {
  std::vector<model::ScatterEvent> placed;
  model::StreamEvents others{};
};

template <class Placed>
EventTally tally(const std::vector<model::ScatterEvent>& events, Placed placed) {
  EventTally result;
  for (const model::ScatterEvent& event : events) {
    if (placed(event)) {
      result.placed.push_back(event);
    } else {
      ++result.others.at(event.event);
    }
  }
  return result;
}

/// Whether these are the same events at the same places, in any order; else both are printed.
::testing::AssertionResult same_events(const std::vector<model::ScatterEvent>& got,
                                       const std::vector<model::ScatterEvent>& expected);

/// Whether each event came as often as expected. Of event 9 `shared` tell of vertices that have
/// added and of words: two of those in one clock are one pulse.
::testing::AssertionResult as_often(const model::StreamEvents& got,
                                    const model::StreamEvents& expected, std::uint64_t shared);

/// A core, its model and the bench between them.
template <class Model>
class EventRun {
 public:
  /// @param format  of words
  /// @param model   what the model is constructed of
  template <class... Args>
  EventRun(const BuiltCore& core, const std::string& format, std::uint64_t seed,
           const std::string& source, const std::string& sink, Args&&... model)
      : codec_(format), core_(core.make(seed)), model_(std::forward<Args>(model)...) {
    tb::StreamBenchOptions options;
    options.test = {core.name, seed, "SEED=" + std::to_string(seed)};
    options.source_throttle = source;
    options.sink_throttle = sink;
    options.probe_edges = true;
    bench_ = std::make_unique<tb::StreamBench>(core_, options);
    bench_->reset(3);
  }

  /// Appends whole packets to the command stream, and what the model makes of them to the
  /// expectations.
  void send(const std::vector<Beat>& packets) {
    bench_->send(packets);
    bench_->expect(model_.run(packets));
    sent_ += packets.size();
  }
  /// Functions of a family, with derivatives, on all axes.
  void send_functions(const std::string& family = "bspline") {
    send(coefficients_packet(hwffd::family(family, codec_), codec_, Functions::kDerivativesToo));
  }
  /// One that ends anything under way, in core, bench and model.
  void reset(std::uint64_t cycles = 1) {
    bench_->reset(cycles);
    model_.reset();
    sent_ = 0;
  }

  const WordCodec& codec() const { return codec_; }
  tb::StreamBench& bench() { return *bench_; }
  bool idle() const { return core_.idle(); }
  /// Beats sent since reset.
  std::size_t sent() const { return sent_; }
  /// All pulses of the core.
  const std::vector<model::ScatterEvent>& events() const { return core_.log(); }
  /// Those of the core that have a place.
  std::vector<model::ScatterEvent> placed_events() const {
    return tally(events(), has_place).placed;
  }
  /// Pulses of one event, of the core.
  std::uint64_t pulses(event::Code code) const {
    return static_cast<std::uint64_t>(
        std::count_if(events().begin(), events().end(),
                      [code](const auto& event) { return event.event == stream_event(code); }));
  }
  /// Words x, y, z of the results from `first` on.
  std::vector<std::array<std::uint32_t, 3>> words(std::size_t first, std::size_t count) const {
    std::vector<std::array<std::uint32_t, 3>> result;
    for (std::size_t r = first; r < first + count; ++r) {
      const Beat& beat = bench_->results().at(r);
      result.push_back({beat.words[0], beat.words[1], beat.words[2]});
    }
    return result;
  }

 protected:
  Model& model() { return model_; }
  const Model& model() const { return model_; }
  /// To the end: every bit of every result.
  ::testing::AssertionResult finish() {
    bench_->run();
    if (!bench_->finish()) return ::testing::AssertionFailure() << bench_->report();
    return ::testing::AssertionSuccess();
  }

 private:
  WordCodec codec_;
  EventLog core_;
  Model model_;
  std::unique_ptr<tb::StreamBench> bench_;
  std::size_t sent_ = 0;
};

}  // namespace hwffd::test
