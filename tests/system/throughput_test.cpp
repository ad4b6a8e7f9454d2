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

/// Clocks from the last control point of a single vertex to its result, by section 4 of
/// docs/datasheet.md: at least so many, and less than a step more. Of `basic` without fused units.
std::uint64_t formula_of_latency(const Configuration& row, std::uint64_t step) {
  const auto mul = static_cast<std::uint64_t>(row.mul_latency);
  const auto add = static_cast<std::uint64_t>(row.add_latency);
  const auto convert = static_cast<std::uint64_t>(row.convert_latency);
  const std::string format = row.format;
  const bool iterative = row.evaluator == std::string("iterative");
  const std::uint64_t loop = mul + add + (iterative && (mul + add) % 3 == 0 ? 1 : 0);
  const std::uint64_t read = !overlaps(row) ? 0 : iterative ? 2 : 1;
  const std::uint64_t contexts = overlaps(row) ? (add + step - 1) / step : 1;
  const std::uint64_t in = format == "fp32" ? 1 : format == "bfp32" ? 4 : 2;
  const std::uint64_t out = format == "bfp32" ? 3 : format == "fp32" || convert == 0 ? 0 : 1;
  return 63 * contexts * step + read + 3 * loop + convert + 3 * mul + add + convert + in + out + 12;
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
  if (row.org == std::string("basic") && row.fma_latency == 0) {
    const auto step = static_cast<std::uint64_t>(interval / 64);
    EXPECT_GE(latency, formula_of_latency(row, step));
    EXPECT_LT(latency, formula_of_latency(row, step) + step);
  }
}

// Each packet of a vertex by itself, in a core that is idle; the bench sees whether it says so too
// soon.
TEST_P(Throughput, SingleVerticesOfALattice) {
  SystemRun run(GetParam(), 1);
  tb::Random random(2);
  const LatticeWords lattice = random_lattice(run.codec(), random, 6);
  run.send_bspline();
  run.send(lattice_packet(lattice));
  for (int v = 0; v < 5; ++v) {
    run.send(vertices_packet(random_vertices(run.codec(), random, lattice.dims, 1)));
    ASSERT_TRUE(run.run());
    EXPECT_TRUE(run.core().idle());
  }
}

// Functions go into a bank as soon as its last vertex has left, whatever is inside of the other
// bank: they cost no more than their beats.
TEST_P(Throughput, FunctionsChangeAmongVertices) {
  constexpr std::size_t kTogether = 12, kChanges = 8;
  SystemRun run(GetParam(), 1);
  for (std::size_t v = 0; v < kChanges; ++v) {
    const Blending functions = family(v % 2 == 0 ? "bspline" : "bernstein", run.codec());
    run.send(coefficients_packet(functions, run.codec()));
    run.send(interleaved_packet(make_stimulus("random", run.codec(), kTogether, v)));
  }
  ASSERT_TRUE(run.run());
  const double beats =
      static_cast<double>(run.bench().accept_clocks().size()) / (kTogether * kChanges);
  const double clocks = run.bench().clocks_per_result(kTogether, (kChanges - 1) * kTogether);
  std::printf("%g clocks, %g beats\n", clocks, beats);
  EXPECT_LE(clocks, std::max(beats, formula(GetParam())) + 0.5);
}

HWFFD_FOR_EACH_CONFIGURATION(Throughput);

}  // namespace
}  // namespace hwffd::test
