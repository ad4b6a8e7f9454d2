// The whole core behind its buses, worked by the driver class: results in memory are those of the
// model bit for bit, whatever comes and however the buses wait; counters, interrupts, identity.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <string>

#include "axi_run.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/stream/blending.hpp"

namespace hwffd::test {
namespace {

class Axi : public PerAxiConfiguration {};

TEST_P(Axi, SaysWhatItIs) {
  AxiRun run(GetParam(), 1);
  const CoreIdentity identity = run.driver().probe();
  const std::string format = GetParam().format;
  const std::map<std::string, unsigned long> words{{"fp32", 0}, {"bfp32", 99}};
  const auto it = words.find(format);
  EXPECT_EQ(identity.n, static_cast<unsigned>(GetParam().n));
  EXPECT_EQ(identity.format, it != words.end() ? it->second : std::stoul(format.substr(2)));
  EXPECT_EQ(identity.schedule, 0U);
  EXPECT_EQ(identity.evaluator, 0U);
  EXPECT_EQ(identity.points_axis, static_cast<unsigned>(kAxisPoints));
  EXPECT_EQ(identity.in_flight, overlapped_interval(GetParam()) >= 16 ? 16U : 128U);
  EXPECT_EQ(identity.features, std::uint32_t{model::kAllFeatures});
  EXPECT_EQ(identity.pages, 2U);
  EXPECT_EQ(identity.spans, 1U);
}

/// Packets of every kind, good and bad, in several runs that go on from each other.
TEST_P(Axi, AnyPacketsGiveTheModelsBits) {
  std::uint64_t results = 0, events = 0;
  const std::vector<std::string> throttles = {"always", "mixed",  "bernoulli",
                                              "mixed",  "bursts", "sparse"};
  for (std::uint64_t seed = 1; seed <= throttles.size(); ++seed) {
    AxiRun run(GetParam(), seed, throttles[seed - 1]);
    run.send_bspline();
    for (int repeat = 0; repeat < 3; ++repeat) {
      run.send(random_packets(run.codec(), run.random(), 20));
      ASSERT_TRUE(run.go()) << "seed " << seed << ", run " << repeat;
    }
    const auto counts = run.model().events();
    const CoreErrors errors = run.driver().take_errors();
    const auto total = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    EXPECT_EQ(errors.status, run.model().error_status()) << "seed " << seed;
    EXPECT_EQ(errors.count, total) << "seed " << seed;
    EXPECT_EQ(run.driver().counters().vertices, run.model().vertices()) << "seed " << seed;
    EXPECT_TRUE(run.clean()) << "seed " << seed;
    results += run.checked();
    events += total;
  }
  fmt::print("{} results, {} events\n", results, events);
}

/// Descriptors that come while the core is busy are taken in the same run, or in the next.
TEST_P(Axi, PacketsAreAddedWhileItRuns) {
  AxiRun run(GetParam(), 3, "mixed");
  run.send_scene(100, 6);
  run.start(1000);
  for (int packet = 0; packet < 5; ++packet) run.send_vertices(20);
  ASSERT_TRUE(run.finish());
  EXPECT_EQ(run.driver().pending(), 0U);
  EXPECT_EQ(run.checked(), 200U);
  EXPECT_TRUE(run.clean());
}

/// Ring, buffers and results lie anywhere in 64 bits of addresses.
TEST_P(Axi, AnywhereInMemory) {
  AxiRun run(GetParam(), 6);
  for (int place = 0; place < 8; ++place) {
    run.move_to(Places::anywhere(run.random()));
    ASSERT_TRUE(run.good_run()) << place;
  }
  EXPECT_TRUE(run.clean());
}

/// More packets than the ring has entries: it goes around.
TEST_P(Axi, TheRingGoesAround) {
  AxiRun run(GetParam(), 4, "gaps");
  run.send_bspline();
  for (int repeat = 0; repeat < 4; ++repeat) {
    run.send_lattice(5);
    for (int packet = 0; packet < 20; ++packet) run.send_vertices(2);
    ASSERT_TRUE(run.go()) << repeat;
  }
  EXPECT_EQ(run.checked(), 160U);
  EXPECT_TRUE(run.clean());
}

/// The largest ring: every bit of its indices is 1 once, and 0 again behind a reset.
TEST(AxiRing, HasThirtyTwoThousandEntries) {
  constexpr unsigned kLog2Size = 15, kRound = 1024;
  AxiRun run(find_configuration("basic-fx18-overlapped"), 11);
  const AddressWindow buffers{0x200F70, 0x3FFFFF};
  run.move_to({{0x80000, kLog2Size}, buffers, {0x80000, buffers.limit}, kWriteWindow});
  for (unsigned round = 0; round < (1U << kLog2Size) / kRound; ++round) {
    for (unsigned packet = 0; packet < kRound; ++packet) run.send_bspline();
    ASSERT_TRUE(run.go()) << round;
    const std::uint32_t tail = (round + 1) * kRound % (1U << kLog2Size);
    ASSERT_EQ(run.system().read32(HWFFD_RING_TAIL_OFFSET), tail);
  }
  EXPECT_TRUE(run.ends_well());
  ASSERT_TRUE(run.soft_reset());
  EXPECT_EQ(run.system().read32(HWFFD_RING_TAIL_OFFSET), 0U);
  EXPECT_TRUE(run.ends_well());
}

TEST_P(Axi, RegistersAreWordsOfBytes) {
  AxiRun run(GetParam(), 12, "mixed");
  expect_words_and_bytes(run.system());
  EXPECT_TRUE(run.ends_well());
}

TEST_P(Axi, CountersCount) {
  AxiRun run(GetParam(), 5);
  ASSERT_TRUE(run.good_run());
  CoreCounters counters = run.driver().counters();
  EXPECT_EQ(counters.vertices, run.checked());
  EXPECT_GT(counters.busy, run.checked());
  EXPECT_LT(counters.busy, run.system().cycle());
  EXPECT_EQ(counters.stalls, 0U);

  run.driver().clear_counters();
  counters = run.driver().counters();
  EXPECT_EQ(counters.vertices + counters.stalls + counters.busy, 0U);
  const std::uint64_t before = run.checked();
  ASSERT_TRUE(run.good_run());
  EXPECT_EQ(run.driver().counters().vertices, run.checked() - before);
  EXPECT_TRUE(run.clean());
}

/// A vertex is one, however many results it has; results that share a packet with none too.
TEST_P(Axi, VerticesAreCountedNotResults) {
  AxiRun run(GetParam(), 10);
  run.send(coefficients_packet(watertight_bspline(run.codec()), run.codec(),
                               Functions::kDerivativesToo));
  run.send_lattice(5);
  std::uint64_t vertices = 0;
  for (const Results results : {Results::kPosition, Results::kDerivatives, Results::kDeterminant,
                                Results::kDeterminantAlone}) {
    for (const OutsideMode mode : {OutsideMode::kClamp, OutsideMode::kBlank}) {
      run.send(vertices_packet(run.vertices(7), mode, results));
      vertices += 7;
    }
  }
  ASSERT_TRUE(run.go());
  EXPECT_EQ(run.checked(), 2 * 7 * (1 + 4 + 2 + 1));
  EXPECT_EQ(run.driver().counters().vertices, vertices);
  EXPECT_TRUE(run.clean());
}

/// A result that cannot leave because the memory takes no data waits, and is counted as a stall.
TEST_P(Axi, StallsAreCounted) {
  AxiRun run(GetParam(), 6);
  run.send_scene(800);
  run.start_with_memory_shut(80'000);
  EXPECT_GT(run.driver().counters().stalls, 1000U);
  run.system().memory.set_throttles({});
  ASSERT_TRUE(run.finish());
  EXPECT_EQ(run.driver().counters().vertices, run.checked()) << "once each, however long they wait";
  EXPECT_TRUE(run.clean());
}

TEST_P(Axi, Interrupts) {
  AxiRun run(GetParam(), 7, "bernoulli");
  Driver& driver = run.driver();
  EXPECT_FALSE(run.system().interrupt());
  run.send_bspline();
  run.start();
  for (int i = 0; i < 20'000 && !run.system().interrupt(); ++i) run.system().run(1);
  EXPECT_TRUE(run.system().interrupt()) << "done";
  EXPECT_TRUE(run.wait());
  EXPECT_EQ(driver.take_interrupts(), HWFFD_IRQ_STATE_DONE_MASK);
  EXPECT_FALSE(run.system().interrupt());

  driver.enable_interrupts(HWFFD_IRQ_ENABLE_ERROR_MASK);
  run.send({{{0x77, 0, 0, 0}, true}});  // of an unknown opcode
  ASSERT_TRUE(run.go());
  EXPECT_TRUE(run.system().interrupt()) << "error";
  EXPECT_EQ(driver.take_interrupts(), HWFFD_IRQ_STATE_DONE_MASK | HWFFD_IRQ_STATE_ERROR_MASK);
  EXPECT_FALSE(run.system().interrupt());
  driver.take_errors();

  driver.enable_interrupts(0);
  ASSERT_TRUE(run.good_run());
  EXPECT_FALSE(run.system().interrupt()) << "not enabled";
  EXPECT_EQ(driver.take_interrupts(), HWFFD_IRQ_STATE_DONE_MASK);
  EXPECT_TRUE(run.clean());
}

/// What these tests compare, they see: a flipped bit of a result, a result that is
/// missing, a guard byte, an address outside its window.
TEST_P(Axi, PlantedFaultsAreFound) {
  AxiRun run(GetParam(), 9);
  tb::AxiMemory& memory = run.system().memory;
  const auto flip = [&](std::uint64_t address) {
    memory.set_byte(address, memory.byte(address) ^ 1);
  };
  run.send_bspline();
  run.send(interleaved_packet(make_stimulus("random", run.codec(), 3, 1)));
  run.start();
  ASSERT_TRUE(run.wait());
  const std::uint64_t last_byte = run.area() + 3 * cores::kAxiBeatBytes - 1;
  flip(last_byte);
  EXPECT_FALSE(run.finish()) << "a flipped bit";
  flip(last_byte);
  EXPECT_TRUE(run.finish());
  run.system().run(300);
  flip(last_byte + 1);
  EXPECT_FALSE(run.clean()) << "a guard byte";
  flip(last_byte + 1);
  EXPECT_TRUE(run.clean());

  run.send(interleaved_packet(make_stimulus("random", run.codec(), 3, 1)));
  run.start(2);
  EXPECT_FALSE(run.finish()) << "a result is missing";
  run.forget_expected();
  run.system().allow(kReadWindow, {kWriteWindow.base, run.area() + cores::kAxiBeatBytes});
  run.send(interleaved_packet(make_stimulus("random", run.codec(), 3, 1)));
  ASSERT_TRUE(run.go());
  EXPECT_FALSE(run.clean()) << "an address outside the window";
}

/// One vertex a clock, from random cells of the largest lattice, keeps both directions of the bus
/// busy: at least 95 % of each, loading the lattice included.
TEST_P(Axi, TheBusIsUsedWhereTheEvaluatorKeepsUp) {
  if (overlapped_interval(GetParam()) > 1) GTEST_SKIP() << "its evaluator is slower than the bus";
  constexpr int kPackets = 25;
  constexpr int kVertices = 4000;  // a packet
  AxiRun run(GetParam(), 8);
  run.system().memory.set_latency({30, 30});
  run.send_bspline();
  run.send_lattice(std::array<int, 3>{16, 16, 16});
  for (int packet = 0; packet < kPackets; ++packet) run.send_vertices(kVertices);
  ASSERT_TRUE(run.go());
  const tb::BusUtilisation bus = run.system().utilisation();
  fmt::print("R {:.2f} %, W {:.2f} %\n", 100 * bus.read(), 100 * bus.write());
  EXPECT_GE(bus.read(), 0.95);
  EXPECT_GE(bus.write(), 0.95);
  EXPECT_GE(bus.write_beats, std::uint64_t{kPackets * kVertices});
  EXPECT_TRUE(run.clean());
}

HWFFD_FOR_EACH_AXI_CONFIGURATION(Axi);

}  // namespace
}  // namespace hwffd::test
