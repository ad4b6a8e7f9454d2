#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "hwffd/cores/verilated_stream_core.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/stream_bench.hpp"
#include "page_stimulus.hpp"

namespace hwffd::test {

template <class Dut>
std::unique_ptr<cores::StreamCore> make_page_core(std::uint64_t seed) {
  return std::make_unique<cores::VerilatedStreamCore<Dut>>(seed);
}

/// A core of cores.csv.
struct PageBuild {
  std::string name;
  const char* row;
  PageCore core;
  std::unique_ptr<cores::StreamCore> (*make)(std::uint64_t seed);
};

inline void PrintTo(const PageBuild& build, std::ostream* out) { *out << build.name; }

/// Those of the program, which CMake makes of the table, or some of them.
std::vector<PageBuild> page_builds(bool (*wanted)(const PageBuild&) = [](const PageBuild&) {
  return true;
});

/// Such a core, its model and the bench between them.
class PageRun {
 public:
  PageRun(const PageBuild& build, std::uint64_t seed, const std::string& source = "always",
          const std::string& sink = "always")
      : build_(build),
        row_(find_configuration(build.row)),
        codec_(row_.format),
        core_(build.make(seed)),
        model_(row_, build.core.features, build.core.axis, build.core.pages, build.core.spans,
               build.core.grid_limit) {
    tb::StreamBenchOptions options;
    options.test = {build.name, seed, "SEED=" + std::to_string(seed)};
    options.source_throttle = source;
    options.sink_throttle = sink;
    options.probe_edges = true;
    bench_ = std::make_unique<tb::StreamBench>(*core_, options);
    bench_->reset(3);
  }

  void send(const std::vector<Beat>& beats) {
    bench_->send(beats);
    bench_->expect(model_.run(beats));
    sent_ += beats.size();
  }
  void send_bspline(Functions functions = Functions::kBlending) {
    send(coefficients_packet(watertight_bspline(codec_), codec_, functions));
  }
  /// To the end: every bit of every result, and every event.
  ::testing::AssertionResult run() {
    bench_->run();
    if (!bench_->finish()) return ::testing::AssertionFailure() << bench_->report();
    if (bench_->events() != model_.events()) {
      return ::testing::AssertionFailure() << "other events than the model's";
    }
    return ::testing::AssertionSuccess();
  }

  /// What the model makes of beats that no core was sent.
  std::vector<Beat> model_of(const std::vector<Beat>& beats) { return model_.run(beats); }
  /// What is loaded and what came of a packet is forgotten.
  void reset() {
    bench_->reset(1);
    model_.reset();
  }

  const WordCodec& codec() const { return codec_; }
  tb::StreamBench& bench() { return *bench_; }
  const Configuration& row() const { return row_; }
  std::size_t sent() const { return sent_; }
  std::uint64_t events(event::Code code) const { return bench_->events()[stream_event(code)]; }
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
  PageBuild build_;

 private:
  const Configuration& row_;
  WordCodec codec_;
  std::unique_ptr<cores::StreamCore> core_;
  model::StreamModel model_;
  std::unique_ptr<tb::StreamBench> bench_;
  std::size_t sent_ = 0;
};

}  // namespace hwffd::test
