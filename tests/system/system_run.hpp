#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/stream_bench.hpp"
#include "named.hpp"
#include "share.hpp"
#include "stimulus.hpp"

namespace hwffd::test {

/// The rows of the table that this build has Verilated.
std::vector<Configuration> built_configurations();

/// Those of one number format.
std::vector<Configuration> built_configurations(const std::string& format);

/// A core of one configuration, its model and the bench between them.
class SystemRun {
 public:
  SystemRun(const Configuration& row, std::uint64_t seed, const std::string& source = "always",
            const std::string& sink = "always");

  /// Appends packets to the command stream, and what the model makes of them to the expectations.
  void send(const std::vector<Beat>& beats);
  /// Coefficients of the uniform B-spline and of its derivative.
  void send_bspline();
  /// Runs to the end; the failure is the bench's report.
  ::testing::AssertionResult run();
  /// Resets core, model and bench.
  void reset(std::uint64_t cycles);

  const Configuration& row() const { return row_; }
  const WordCodec& codec() const { return codec_; }
  tb::StreamBench& bench() { return *bench_; }
  const cores::StreamCore& core() const { return *core_; }
  /// What the model says of the events so far.
  std::array<std::uint64_t, kStreamEvents> events() const { return model_.events(); }

 private:
  Configuration row_;
  WordCodec codec_;
  std::unique_ptr<cores::StreamCore> core_;
  model::StreamModel model_;
  std::unique_ptr<tb::StreamBench> bench_;
};

/// For tests over configurations.
class PerConfiguration : public ::testing::TestWithParam<Configuration> {};

}  // namespace hwffd::test

// Instantiates a suite for every built configuration, or for those of the format given.
#define HWFFD_FOR_EACH_CONFIGURATION(suite, ...)                                                  \
  INSTANTIATE_TEST_SUITE_P(, suite,                                                               \
                           ::testing::ValuesIn(::hwffd::test::built_configurations(__VA_ARGS__)), \
                           ::hwffd::test::by_name)
