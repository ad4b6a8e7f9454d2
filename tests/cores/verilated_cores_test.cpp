// What Verilated cores show of themselves, and their clock.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "Vbasic_fx18_overlapped.h"
#include "Vbasic_fx18_overlapped_evaluator.h"
#include "hwffd/cores/verilated_evaluator_core.hpp"
#include "hwffd/cores/verilated_stream_core.hpp"

namespace hwffd::cores {
namespace {

using Evaluator = VerilatedEvaluatorCore<Vbasic_fx18_overlapped_evaluator>;
using Stream = VerilatedStreamCore<Vbasic_fx18_overlapped>;

/// Whether that is the valid of the sequencer's steps.
bool is_step_valid(const std::string& instance, const std::string& name) {
  return instance.substr(instance.rfind('.') + 1) == "u_sequencer" && name == "step_valid_o";
}

TEST(VerilatedCores, AnEvaluatorShowsItsProbes) {
  Evaluator core(1);
  core.drive_reset(true);
  for (int clocks = 0; clocks < 3; ++clocks) core.clock();  // settles by itself
  const std::vector<Probe> probes = core.probes();
  const auto steps = std::find_if(probes.begin(), probes.end(), [](const Probe& probe) {
    return is_step_valid(probe.instance, probe.signal);
  });
  ASSERT_NE(steps, probes.end());
  EXPECT_EQ(*steps->value, 0);
}

TEST(VerilatedCores, AStreamShowsItsSignals) {
  Stream core(1);
  core.drive_reset(true);
  for (int clocks = 0; clocks < 3; ++clocks) core.clock();
  const std::vector<Signal> signals = core.signals();
  const auto steps = std::find_if(signals.begin(), signals.end(), [](const Signal& signal) {
    return is_step_valid(signal.instance, signal.name);
  });
  ASSERT_NE(steps, signals.end());
  EXPECT_EQ(steps->width, 1);
  EXPECT_EQ(steps->bytes, 1);
  EXPECT_EQ(steps->value(), 0u);
}

TEST(VerilatedCores, WordsAreKeptInBytes) {
  const std::pair<int, int> expected[] = {{1, 1},  {8, 1},  {9, 2},   {16, 2},  {17, 4}, {32, 4},
                                          {33, 8}, {64, 8}, {65, 12}, {96, 12}, {97, 16}};
  for (const auto& [width, bytes] : expected) EXPECT_EQ(storage_of(width), bytes) << width;
}

/// Registers begin at random values, the same for one seed.
TEST(VerilatedCores, BeginAsTheirSeedSays) {
  const auto bytes = [](std::uint64_t seed) {
    std::vector<std::uint8_t> values;
    Evaluator core(seed);
    core.settle();
    for (const Probe& probe : core.probes()) values.push_back(*probe.value);
    return values;
  };
  EXPECT_FALSE(bytes(1).empty());
  EXPECT_EQ(bytes(1), bytes(1));
  bool differs = false;
  for (std::uint64_t seed = 2; seed < 10; ++seed) differs = differs || bytes(seed) != bytes(1);
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace hwffd::cores
