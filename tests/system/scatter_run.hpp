#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hwffd/model/scatter_stream.hpp"
#include "hwffd/tb/stream_bench.hpp"
#include "scatter_builds.hpp"

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

/// Whether the place of an event says where its packet is.
bool has_place(const model::ScatterEvent& event);
/// The same text for the same events, whatever their order.
std::string sorted_text(std::vector<model::ScatterEvent> events);

/// Such a core, its model and the bench between them.
class ScatterRun {
 public:
  ScatterRun(const ScatterBuild& build, std::uint64_t seed, const std::string& source = "always",
             const std::string& sink = "always");

  /// Appends packets to the command stream, and what the model makes of them to the expectations.
  void send(const std::vector<Beat>& beats);
  /// Functions of a family, with derivatives, on all axes.
  void send_functions(const std::string& family = "bspline");
  /// To the end: every bit of every result, and every event. Places are those of the model but for
  /// events that tell of a vertex that has added or of a word: of those numbers are compared, and
  /// two of event 9 in one clock are one pulse.
  ::testing::AssertionResult run();
  /// One that ends anything under way, in core, bench and model.
  void reset(std::uint64_t cycles = 1);

  const WordCodec& codec() const { return codec_; }
  tb::StreamBench& bench() { return *bench_; }
  bool idle() const { return core_.idle(); }
  /// Beats sent since reset.
  std::size_t sent() const { return sent_; }
  /// Pulses of one event, of the core.
  std::uint64_t pulses(event::Code code) const;
  /// All of the core's.
  const std::vector<model::ScatterEvent>& events() const { return core_.log(); }
  /// Those of the core but for what tells of a vertex that has added or of a word.
  std::vector<model::ScatterEvent> placed_events() const;
  /// Words x, y, z of the results from `first` on.
  std::vector<std::array<std::uint32_t, 3>> words(std::size_t first, std::size_t count) const;

 private:
  WordCodec codec_;
  EventLog core_;
  model::ScatterStreamModel model_;
  std::unique_ptr<tb::StreamBench> bench_;
  std::size_t sent_ = 0;
};

}  // namespace hwffd::test
