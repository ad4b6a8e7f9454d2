// What a stream can do to the core besides vertices at full speed: resets, reloads, bad packets,
// numbers that are none; and the proof that the bench can fail.
#include <gtest/gtest.h>

#include <cstdio>
#include <numeric>

#include "system_run.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kSeeds = 8;

/// Eight seeds, from SEED on; fewer where cores are slow.
std::vector<std::uint64_t> seeds() {
  std::vector<std::uint64_t> list(share_of(kSeeds));
  std::iota(list.begin(), list.end(), tb::seed_from_environment(1));
  return list;
}

class Stream : public PerConfiguration {};
class FloatStream : public PerConfiguration {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(
    FloatStream);  // most programs of netlists are of fixed point only

TEST_P(Stream, ResetAtAnyMomentLeavesNothingBehind) {
  std::uint64_t resets = 0;
  for (const std::uint64_t seed : seeds()) {
    SystemRun run(GetParam(), seed, "always", "bursts");
    tb::Random random(seed);
    for (int again = 0; again < 5; ++again, ++resets) {
      run.send_bspline();
      run.send(interleaved_packet(make_stimulus("random", run.codec(), 6, seed + 100)));
      run.bench().run_for(random.below(900));
      run.reset(1 + random.below(3));
    }
    run.send({Beat{{0x77, 0, 0, 0}, false}, Beat{{}, true}});  // an event, in the first packet
    run.send_bspline();
    run.send(interleaved_packet(make_stimulus("random", run.codec(), 3, seed)));
    ASSERT_TRUE(run.run());
    EXPECT_EQ(run.bench().events()[stream_event(event::kUnknownOpcode)], 1U);
    const cores::EventPlace place = run.bench().event_place(stream_event(event::kUnknownOpcode));
    EXPECT_EQ(place.packet, 0U);
    EXPECT_EQ(place.beat, 0U);
  }
  EXPECT_EQ(resets, 5 * share_of(kSeeds));
}

TEST_P(Stream, CoefficientsChangeBetweenVertices) {
  for (const std::uint64_t seed : seeds()) {
    SystemRun run(GetParam(), seed, "bernoulli", "bernoulli");
    tb::Random random(seed);
    for (int bank = 0; bank < 6; ++bank) {
      run.send(coefficients_packet(random_coefficients(run.codec(), random)));
      const std::size_t vertices = random.below(4);
      run.send(interleaved_packet(make_stimulus("random", run.codec(), vertices, seed + bank)));
    }
    run.send(interleaved_packet(make_stimulus("corner", run.codec(), 2, seed)));
    ASSERT_TRUE(run.run());
  }
}

// Whatever comes, the model knows what follows: results, and events by kind.
TEST_P(Stream, AnyPacketsInAnyOrder) {
  std::uint64_t events = 0;
  for (const std::uint64_t seed : seeds()) {
    SystemRun run(GetParam(), seed, "bursts", "bernoulli");
    tb::Random random(seed);
    run.send(random_packets(run.codec(), random, 40));
    run.send_bspline();
    run.send(interleaved_packet(make_stimulus("random", run.codec(), 2, seed)));
    ASSERT_TRUE(run.run());
    EXPECT_EQ(run.bench().events(), run.events());
    for (const std::uint64_t count : run.events()) events += count;
  }
  std::printf("%llu packets, %llu events\n", 40 * static_cast<unsigned long long>(seeds().size()),
              static_cast<unsigned long long>(events));
}

TEST_P(Stream, IdleWhenNothingIsInside) {
  SystemRun run(GetParam(), 1);
  EXPECT_TRUE(run.core().idle());
  run.send_bspline();
  run.send(interleaved_packet(make_stimulus("random", run.codec(), 2, 1)));
  run.bench().run_for(100);
  EXPECT_FALSE(run.core().idle());
  ASSERT_TRUE(run.run());
  EXPECT_TRUE(run.core().idle());
}

TEST_P(FloatStream, NotANumberStaysInItsVertex) {
  SystemRun run(GetParam(), 1);
  tb::Random random(1);
  std::vector<InterleavedVertex> vertices;
  for (const std::uint32_t word : {0x7FC00001U, 0xFFFFFFFFU, 0x7F800000U, 0xFF800000U}) {
    for (int place = 0; place < 4; ++place) {
      InterleavedVertex vertex = random_vertex(run.codec(), random);
      (place < 3 ? vertex.local[place] : vertex.points[93]) = word;
      vertices.push_back(vertex);
      vertices.push_back(random_vertex(run.codec(), random));
    }
  }
  run.send_bspline();
  run.send(interleaved_packet(vertices));
  ASSERT_TRUE(run.run());
  const std::vector<Beat>& results = run.bench().results();
  ASSERT_EQ(results.size(), 32U);
  for (std::size_t v = 0; v < results.size(); v += 2) {
    const bool infinite_point = v % 8 == 6 && v >= 16;
    const bool nan = (results[v].words[3] & kStatusNan) != 0;
    EXPECT_EQ(nan, !infinite_point) << "vertex " << v;
    for (int c = 0; c < 3 && v % 8 != 6; ++c) {
      EXPECT_EQ(results[v].words[c], 0x7FC00000U) << "vertex " << v;
    }
    EXPECT_EQ(results[v + 1].words[3] >> 16, 0U) << "vertex " << v + 1;
  }
}

TEST_P(Stream, ValidDoesNotWaitForReady) {
  SystemRun run(GetParam(), 1);
  run.send_bspline();
  run.send(interleaved_packet(make_stimulus("random", run.codec(), 30, 1)));
  EXPECT_TRUE(run.bench().raises_valid_without_ready(3000, 3000));
  EXPECT_TRUE(run.run());
}

TEST_P(Stream, ThePlantedFaultIsFound) {
  using Kind = tb::Fault::Kind;
  for (const tb::Fault fault :
       {tb::Fault{Kind::kFlip, 1, 0}, tb::Fault{Kind::kFlip, 2, 95}, tb::Fault{Kind::kFlip, 0, 128},
        tb::Fault{Kind::kDrop, 1, 0}, tb::Fault{Kind::kDuplicate, 1, 0}}) {
    SystemRun run(GetParam(), 1);
    run.send_bspline();
    run.send(interleaved_packet(make_stimulus("random", run.codec(), 4, 1)));
    run.bench().plant(fault);
    EXPECT_FALSE(run.run());
    EXPECT_TRUE(run.bench().fault_struck());
  }
}

HWFFD_FOR_EACH_CONFIGURATION(Stream);
HWFFD_FOR_EACH_CONFIGURATION(FloatStream, "fp32");

}  // namespace
}  // namespace hwffd::test
