// A core with pages of four components and with spans, behind its buses: opcodes 5, 6, 7 and 9 from
// memory, in any order with all others.
#include <gtest/gtest.h>

#include <numeric>

#include "Vaxi_pages.h"
#include "axi_run.hpp"
#include "bad_pages.hpp"
#include "errors.hpp"
#include "hwffd/cores/verilated_axi_core.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/spans.hpp"
#include "span_stimulus.hpp"

namespace hwffd::test {
namespace {

/// tests/bus/axi/CMakeLists.txt.
const PageCore kCore{
    model::kAllFeatures | model::kPagesFeature | model::kFourthFeature | model::kSpansFeature,
    kAxisPoints, 4, 16};

AxiRun make_run(std::uint64_t seed, const std::string& throttles) {
  return {find_configuration("cg1-fx18-overlapped"),
          std::make_unique<cores::VerilatedAxiCore<Vaxi_pages>>(seed), seed, throttles, kCore};
}

class AxiPages : public ::testing::Test {
 protected:
  LatticeWords lattice() { return random_lattice(run_.codec(), run_.random(), {5, 4, 6}); }
  std::vector<VertexBeat> vertices(std::size_t count) {
    return random_vertices(run_.codec(), run_.random(), {5, 4, 6}, count);
  }
  /// Words of so many results of the last run.
  std::vector<std::array<std::uint32_t, 3>> words(std::uint64_t first, std::uint64_t count) const {
    std::vector<std::array<std::uint32_t, 3>> result;
    for (std::uint64_t r = first; r < first + count; ++r) {
      result.push_back({run_.result_word(r, 0), run_.result_word(r, 1), run_.result_word(r, 2)});
    }
    return result;
  }
  /// Every event of the model, and no other, in ERROR_STATUS and ERROR_COUNT.
  void expect_events_of_the_model() {
    const CoreErrors errors = run_.driver().take_errors();
    const auto& events = run_.model().events();
    EXPECT_EQ(errors.status, run_.model().error_status());
    EXPECT_EQ(errors.count, std::accumulate(events.begin(), events.end(), std::uint64_t{0}));
  }

  AxiRun run_ = make_run(1, "mixed");
};

TEST_F(AxiPages, AreWhatTheRegistersSay) {
  const CoreIdentity core = run_.driver().probe();
  EXPECT_EQ(core.features, kCore.features);
  EXPECT_EQ(core.points_axis, static_cast<unsigned>(kCore.axis));
  EXPECT_EQ(core.pages, static_cast<unsigned>(kCore.pages));
  EXPECT_EQ(core.spans, static_cast<unsigned>(kCore.spans));
}

TEST(AxiPagesSoak, AnyPacketsInAnyOrder) {
  constexpr int kRounds = 30;
  std::array<std::uint64_t, kStreamEvents> events{};
  for (std::uint64_t seed = tb::seed_from_environment(1), last = seed + 3; seed <= last; ++seed) {
    AxiRun run = make_run(seed, seed % 2 == 0 ? "mixed" : "always");
    tb::Random& random = run.random();
    PagePackets packets(run.codec(), random, kCore);
    run.send(
        coefficients_packet(random_coefficients(run.codec(), random), Functions::kDerivativesToo));
    for (int round = 0; round < kRounds; ++round) {
      run.system().memory.set_latency({1, 1 + random.below(60)});
      run.send(packets.any(5));
      run.send(random_span_packets(run.codec(), random, kCore));
      run.send(packets.any(5));
      run.send(random_span_packets(run.codec(), random, kCore));
      ASSERT_TRUE(run.go()) << "seed " << seed << " round " << round;
    }
    EXPECT_GT(run.checked(), 20U * kRounds);
    const CoreErrors errors = run.driver().take_errors();
    const auto& counts = run.model().events();
    EXPECT_EQ(errors.status, run.model().error_status());
    EXPECT_EQ(errors.count, std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
    for (int e = 0; e < kStreamEvents; ++e) events[e] += counts[e];
    EXPECT_TRUE(run.clean());
  }
  for (const Code code : {kUnknownOpcode, kPacketShort, kPacketLong, kNoLattice, kPagePoints,
                          kNoFourth, kSpanBeyond}) {
    EXPECT_GT(events[stream_event(code)], 0U) << "event " << code;
  }
}

// Vertices before a change see what was there, those after it what is new, in one run of the ring.
TEST_F(AxiPages, ChangesKeepTheirOrder) {
  constexpr std::uint64_t kCount = 40;
  const LatticeWords old = lattice(), moved = lattice();
  const auto some = vertices(kCount);
  const auto functions = random_spans(run_.codec(), run_.random(), 1);
  const auto use = [&](int page) { run_.send(run_.driver().page_vertices(page, some)); };
  for (const char* throttles : {"always", "mixed"}) {
    run_.system().set_throttles(throttles);
    run_.send_bspline();
    run_.send(run_.driver().page(2, old));
    run_.send(run_.driver().page(3, moved));
    use(2);  // what is expected: of lattices that nobody changes
    use(3);
    run_.send(run_.driver().page(0, old));
    use(0);
    run_.send(run_.driver().points(0, moved, 0, moved.points.size()));
    use(0);
    run_.send(run_.driver().page(0, old));
    use(0);
    run_.send(spans_packets(1, 0, functions));
    use(0);
    ASSERT_TRUE(run_.go());
    EXPECT_NE(words(0, kCount), words(kCount, kCount));
    EXPECT_EQ(words(2 * kCount, kCount), words(0, kCount));
    EXPECT_EQ(words(3 * kCount, kCount), words(kCount, kCount));
    EXPECT_EQ(words(4 * kCount, kCount), words(0, kCount));
    EXPECT_NE(words(5 * kCount, kCount), words(0, kCount));
  }
  run_.driver().take_errors();
  EXPECT_TRUE(run_.clean());
}

// Each bad packet raises its event at its place; the lattice and the results behind it are as
// before.
TEST_F(AxiPages, BadPackets) {
  const LatticeWords good = lattice();
  const auto some = vertices(3);
  for (const BadPage& bad : bad_pages(run_.codec(), good, some, kCore)) {
    SCOPED_TRACE(bad.name);
    ASSERT_TRUE(run_.soft_reset());  // packets count from 0
    run_.driver().take_errors();
    run_.driver().clear_counters();
    run_.send_bspline();
    run_.send(page_packet(1, good));
    run_.send(page_vertices_packet(1, some));
    run_.send(bad.packet);
    run_.send(page_vertices_packet(1, some));
    ASSERT_TRUE(run_.go());
    EXPECT_EQ(words(0, 3), words(bad.count == 3 ? 6 : 3, 3));
    const CoreErrors errors = run_.driver().take_errors();
    EXPECT_EQ(errors.status, 1U << bad.code);
    EXPECT_EQ(errors.count, bad.count);
    ASSERT_TRUE(errors.first.has_value());
    EXPECT_EQ(errors.first->code, unsigned{bad.code});
    EXPECT_EQ(errors.first->packet, 3U);
  }
  EXPECT_TRUE(run_.ends_well());
}

TEST_F(AxiPages, ASpanBeyondTheTable) {
  run_.send_scene(3, 6);
  auto beyond = spans_packets(0, 15, random_spans(run_.codec(), run_.random(), 1));
  beyond[0].words[1] = 2;
  EXPECT_EQ(message_of<DriverError>([&] { run_.driver().check(beyond[0].words); }),
            "functions of 17 spans: this core has 16; send fewer, or build with SPANS");
  run_.send(beyond);
  run_.send_vertices(3);
  ASSERT_TRUE(run_.go());
  EXPECT_TRUE(run_.only_error({kSpanBeyond, 3, 0, 0}));
  EXPECT_TRUE(run_.ends_well());
}

// A lattice that is larger than the core keeps, by what its registers say; the same bits as from a
// core that has it as one page. The second batch finds four of its nine pages there.
TEST_F(AxiPages, ALargeLatticeGoesByPages) {
  const PointStore store = run_.driver().store();
  EXPECT_EQ(store.axis_points, kCore.axis);
  EXPECT_EQ(store.pages, kCore.pages);
  EXPECT_TRUE(store.spans);
  const LatticeWords large = random_lattice(run_.codec(), run_.random(), {30, 9, 40});
  const auto some = random_vertices(run_.codec(), run_.random(), large.dims, 400);
  const auto functions = coefficients_packet(watertight_bspline(run_.codec()), run_.codec());
  model::StreamModel whole(find_configuration("cg1-fx18-overlapped"),
                           model::kAllFeatures | model::kPagesFeature | model::kLargeFeature, 64,
                           1);
  PageVertices how;
  how.large = true;
  whole.run(functions);
  whole.run(page_packet(0, large));
  const auto expected = whole.run(page_vertices_packet(0, some, how));
  ResidentPages resident(store);
  run_.send(functions);
  for (const std::size_t loads : {9U, 14U}) {
    PagedVertices paged = by_page(some, large.dims, store.axis_points);
    run_.send(resident.packets(pages_of(large, store.axis_points), paged));
    EXPECT_EQ(resident.loads(), loads);
    ASSERT_TRUE(run_.go());
    for (std::size_t v = 0; v < some.size(); ++v) {
      const std::size_t was = paged.from[v];
      for (unsigned c = 0; c < 3; ++c) {
        ASSERT_EQ(run_.result_word(v, c), expected[was].words[c]) << was;
      }
      ASSERT_EQ(run_.result_word(v, 3) & kTagMask, some[was].tag);
    }
  }
  run_.driver().take_errors();
  EXPECT_TRUE(run_.clean());
}

// A soft reset forgets all pages, functions and origins.
TEST_F(AxiPages, ASoftResetForgetsThem) {
  const LatticeWords some = lattice();
  run_.send_bspline();
  for (int page = 0; page < kCore.pages; ++page) run_.send(page_packet(page, some, {4, 0, 8}));
  ASSERT_TRUE(run_.go());
  ASSERT_TRUE(run_.soft_reset());
  run_.send_bspline();
  for (int page = 0; page < kCore.pages; ++page) run_.send(page_vertices_packet(page, vertices(2)));
  ASSERT_TRUE(run_.go());
  for (std::uint64_t r = 0; r < 8; ++r) {
    EXPECT_EQ(run_.result_word(r, 3) >> 16, kStatusUnloaded >> 16) << r;
  }
  EXPECT_TRUE(run_.only_error({kNoLattice, 1, 1, 0}, 8));
  EXPECT_TRUE(run_.ends_well());
}

// The driver makes packets for the core that it found, and says in a line what would not do.
TEST_F(AxiPages, TheDriverMakesWhatTheCoreTakes) {
  Driver& driver = run_.driver();
  const LatticeWords plain = lattice();
  const LatticeWords four = with_fourth(plain, run_.codec(), run_.random());
  const auto some = vertices(4);
  PageVertices fourth;
  fourth.fourth = true;
  run_.send_bspline();
  run_.send(driver.page(3, four, {1, 2, 3}));
  run_.send(driver.points(3, four, 7, 5));
  run_.send(driver.page_vertices(3, some, fourth));
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.checked(), 8U);
  expect_events_of_the_model();
  EXPECT_EQ(message_of<DriverError>([&] { driver.page(4, plain); }),
            "page 4: this core has 4, from 0 on; use one of them, or build with PAGES");
  EXPECT_EQ(message_of<DriverError>([&] { driver.points(9, plain, 0, 1); }),
            "page 9: this core has 4, from 0 on; use one of them, or build with PAGES");
  const LatticeWords longer = random_lattice(run_.codec(), run_.random(), {4, 17, 4});
  EXPECT_EQ(message_of<DriverError>([&] { driver.page(0, longer); }),
            "17 points along axis t: this core takes 4 to 16; make the lattice smaller, or build "
            "with AXIS");
  PageVertices large;
  large.large = true;
  EXPECT_EQ(message_of<DriverError>([&] { driver.page_vertices(0, some, large); }),
            "this core has no large lattices: cut the lattice into pages, or build it with "
            "AXIS above 32");
  auto far = some;
  far[2].cell[1] = 16;
  EXPECT_EQ(message_of<DriverError>([&] { driver.page_vertices(0, far); }),
            "vertex 2: cell 16 along axis t: 0 to 15 can be said to this core; cut the lattice "
            "into pages, or build with AXIS");
  EXPECT_TRUE(run_.clean());
}

}  // namespace
}  // namespace hwffd::test
