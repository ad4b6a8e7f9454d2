// Clocks per vertex: equal to the formulas, not merely printed.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "system_run.hpp"

namespace hwffd::test {
namespace {

// A barrel of 2, 4 or 6 contexts spreads its starts within its round; over whole rounds the
// interval is exact.
constexpr std::size_t kVertices = 1 + 144;

/// Clocks between vertices: the paper's 640, 64 combinations one a clock, or one every 6 clocks.
double formula(const Configuration& row) {
  if (std::string(row.schedule) == "paper") return 640;
  return std::string(row.evaluator) == "iterative" ? 384 : 64;
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
// than a vertex takes at the paper's schedule or with the iterative evaluator.
TEST_P(Throughput, LoadsTheNextVertexDuringThePresentOne) {
  SystemRun run(GetParam(), 1, "sparse");
  run.send_bspline();
  run.send(interleaved_packet(make_stimulus("random", run.codec(), 1 + 48, 2)));
  ASSERT_TRUE(run.run());
  const double expected = std::max(4.0 * kVertexBeats, formula(GetParam()));
  // The first beat is offered out of the throttle's step; two results later that has passed.
  EXPECT_EQ(run.bench().clocks_per_result(2, 48), expected);
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
  const bool overlapped = std::string(row.schedule) == "overlapped";
  const double contexts = overlapped && std::string(row.evaluator) != "iterative" ? row.add_latency
                          : overlapped ? (row.add_latency + 5) / 6
                                       : 1;
  const double steps = contexts * formula(row);
  const int pipeline = 6 * row.mul_latency + 4 * row.add_latency + 2 * row.convert_latency;
  std::printf("latency %llu clocks\n", static_cast<unsigned long long>(latency));
  EXPECT_LE(static_cast<double>(latency), steps + pipeline + 24);
  EXPECT_GE(static_cast<double>(latency), steps - contexts);
}

HWFFD_FOR_EACH_CONFIGURATION(Throughput);

}  // namespace
}  // namespace hwffd::test
