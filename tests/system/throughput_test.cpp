// Clocks per vertex: equal to the formulas, not merely printed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "hwffd/model/schedule.hpp"
#include "system_run.hpp"

namespace hwffd::test {
namespace {

// A barrel of 2, 3, 4, 5 or 8 contexts spreads its starts within its round; over whole rounds the
// interval is exact.
constexpr std::size_t kVertices = 1 + 120;

/// Clocks between vertices: the organization's, each having points of its own, or the 49 beats of a
/// vertex where it is faster.
double formula(const Configuration& row) {
  return std::max(static_cast<double>(kVertexBeats), expected_interval(row));
}

class Throughput : public PerConfiguration {};

TEST_P(Throughput, ClocksPerVertexWhileTheSourceKeepsUp) {
  SystemRun run(GetParam(), 1);
  run.send_bspline();
  run.send(interleaved_packet(make_stimulus("random", run.codec(), kVertices, 1)));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.bench().clocks_per_result(), formula(GetParam()));
}

// A vertex and its points take 49 beats: at one beat in four clocks that is 196 clocks, still less
// than a vertex takes at the paper's schedule, and hardly more than with iterative evaluators.
TEST_P(Throughput, LoadsTheNextVertexDuringThePresentOne) {
  SystemRun run(GetParam(), 1, "sparse");
  run.send_bspline();
  run.send(interleaved_packet(make_stimulus("random", run.codec(), 1 + 48, 2)));
  ASSERT_TRUE(run.run());
  const double expected = std::max(4.0 * kVertexBeats, formula(GetParam()));
  // The first beat is offered out of the throttle's step, and a vertex every 196 clocks meets grids
  // of 3, 8 or 9 in rounds of three, two or nine: whole rounds, later on.
  EXPECT_EQ(run.bench().clocks_per_result(12, 48), expected);
}

// From the last control point to the result: the vertex itself, waiting for its turn, the pipeline.
TEST_P(Throughput, LatencyOfASingleVertex) {
  SystemRun run(GetParam(), 1);
  run.send_bspline();
  run.send(interleaved_packet(make_stimulus("random", run.codec(), 1, 3)));
  ASSERT_TRUE(run.run());
  const std::uint64_t latency =
      run.bench().result_clocks().at(0) - run.bench().accept_clocks().back();
  const Configuration& row = GetParam();
  const int deep = std::max(row.add_latency, row.fma_latency);
  const double most_contexts = overlaps(row) ? deep : 1;
  const double interval = expected_interval(row);
  const double least = interval - most_contexts;
  const double most = most_contexts * interval + 6 * row.mul_latency + 10 * deep + 80;
  std::printf("latency %llu clocks\n", static_cast<unsigned long long>(latency));
  EXPECT_LE(static_cast<double>(latency), most);
  EXPECT_GE(static_cast<double>(latency), least);
}

HWFFD_FOR_EACH_CONFIGURATION(Throughput);

}  // namespace
}  // namespace hwffd::test
