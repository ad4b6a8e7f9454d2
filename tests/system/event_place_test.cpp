// Where an event is told to be, and which one it is where two would fit: docs/interface.md section
// 5, sentence by sentence. Events and places are made by hand, not by the model.
#include <gtest/gtest.h>

#include "expand_run.hpp"
#include "named.hpp"

namespace hwffd::test {
namespace {

using event::Code;

constexpr std::uint32_t kEmptyHalf = 0xFFFFFFFF;

class EventPlaces : public ::testing::TestWithParam<PageBuild> {
 protected:
  void SetUp() override {
    lattice_ = run_.random_lattice(random_, dims_);
    run_.send_functions();
    run_.send_lattice(lattice_);
    if (!run_.has(model::kPagesFeature)) return;
    run_.send(lattice_packet(lattice_));
    packets_ = 3;
  }

  std::vector<VertexBeat> vertices(std::size_t count) {
    return random_vertices(run_.codec(), random_, dims_, count);
  }
  std::uint32_t outside() const { return run_.codec().coordinate(1.25); }
  Grid grid() const { return grid_between({0.25, 0.5, 2.5}, {1.75, 0.25, 0}, {2, 3, 2}, 7); }
  std::vector<Beat> packed(std::size_t count) {
    const auto some = random_packed(random_, dims_, count);
    return run_.has(model::kPagesFeature) ? page_packed_packet(run_.page(), some)
                                          : packed_packet(some);
  }
  /// A packet of so many beats: cut, or with beats that belong to nothing behind it.
  static std::vector<Beat> sized(std::vector<Beat> packet, std::size_t beats) {
    packet.back().last = false;
    packet.resize(beats);
    packet.back().last = true;
    return packet;
  }

  /// Sends it, and expects so many of one event and of no other, the last one at that beat; and
  /// that the packet behind is exact.
  void expect_event(Code code, std::uint64_t count, std::uint32_t beat, std::vector<Beat> packet) {
    const auto before = run_.bench().events();
    run_.send(packet);
    const std::uint32_t number = packets_++;
    run_.send_vertices(vertices(1));
    ++packets_;
    ASSERT_TRUE(run_.run());
    for (unsigned e = 0; e < kStreamEvents; ++e) {
      const bool expected = count != 0 && e == stream_event(code);
      EXPECT_EQ(run_.bench().events()[e] - before[e], expected ? count : 0U) << "event " << e;
    }
    if (count == 0) return;
    const cores::EventPlace place = run_.bench().event_place(stream_event(code));
    EXPECT_EQ(place.packet, number);
    EXPECT_EQ(place.beat, beat);
  }
  void expect_none(const std::vector<Beat>& packet) {
    expect_event(event::kUnknownOpcode, 0, 0, packet);
  }
  std::size_t results() { return run_.bench().results().size(); }

  ExpandRun run_{GetParam(), 1, "bernoulli", "bursts"};
  tb::Random random_{7};
  const std::array<int, 3> dims_ = {5, 4, 6};
  LatticeWords lattice_;
  std::uint32_t packets_ = 2;  ///< sent so far
};

// Its last beat, 49 for each of the vertices up to it.
TEST_P(EventPlaces, OfAnInterleavedVertexIsItsLastBeat) {
  if (!run_.has(model::kInterleavedFeature)) GTEST_SKIP() << "no interleaved vertices";
  constexpr std::uint32_t kBeats = kVertexBeats;
  for (std::uint32_t stray = 1; stray <= 3; ++stray) {
    std::vector<Beat> packet = interleaved_packet(make_stimulus("random", run_.codec(), 3, 1));
    packet[1 + kBeats * (stray - 1)].words[1] = outside();
    expect_event(event::kCoordinateOutside, 1, kBeats * stray, packet);
  }
  const std::vector<Beat> whole = interleaved_packet(make_stimulus("random", run_.codec(), 3, 2));
  for (const std::size_t last : {1U, kBeats - 1, kBeats, kBeats + 1, 2 * kBeats + 17}) {
    expect_event(event::kPacketShort, 1, static_cast<std::uint32_t>(last), sized(whole, last + 1));
  }
  expect_event(event::kPacketLong, 1, 3 * kBeats + 1, sized(whole, whole.size() + 2));
}

// One that gives no result has the place behind its header, however much of it came, and one event,
// whatever is behind it.
TEST_P(EventPlaces, OfARefusedGridIsBeatOne) {
  Grid beyond = grid(), none = grid();
  beyond.start[2] = std::uint64_t{4} << kGridFraction;
  none.count[1] = 0;
  for (const Grid& bad : {beyond, none}) {
    for (const std::size_t beats : {4, 5, 9}) {
      expect_event(event::kGridCount, 1, 1, sized(grid_packet(bad, run_.page()), beats));
    }
  }
  for (const std::size_t beats : {2, 3}) {
    expect_event(event::kPacketShort, 1, 1, sized(grid_packet(grid(), run_.page()), beats));
  }
  expect_event(event::kPacketShort, 1, 0, sized(grid_packet(grid(), run_.page()), 1));
}

TEST_P(EventPlaces, OfAGridThatIsTooLongIsItsLastVertex) {
  const auto count = static_cast<std::uint32_t>(vertex_count(grid()));
  for (const std::size_t beats : {5, 8}) {
    expect_event(event::kPacketLong, 1, count, sized(grid_packet(grid(), run_.page()), beats));
  }
}

// A position that is cut to 24 bits is compared then: what is cut off may lie behind the last face,
// and in front of the first one it does not.
TEST_P(EventPlaces, AGridIsCutBeforeItIsCompared) {
  constexpr std::uint64_t kUnit = std::uint64_t{1} << (kGridFraction - kGridCoordinate);
  for (int axis = 0; axis < 3; ++axis) {
    Grid single = grid();
    single.count = {1, 1, 1};
    single.start[axis] = static_cast<std::uint64_t>(dims_[axis] - 3) << kGridFraction;
    expect_none(grid_packet(single, run_.page()));
    const std::vector<Beat> face = {run_.bench().results().at(results() - 2)};
    single.start[axis] += kUnit - 1;
    expect_none(grid_packet(single, run_.page()));
    EXPECT_EQ(run_.bench().results().at(results() - 2), face[0]);
    single.start[axis] += 1;
    expect_event(event::kGridCount, 1, 1, grid_packet(single, run_.page()));
    Grid back = grid();
    back.count = {1, 1, 1};
    back.count[axis] = 2;
    back.start[axis] = kUnit;
    back.step[axis] = -static_cast<std::int64_t>(kUnit);
    expect_none(grid_packet(back, run_.page()));
    back.start[axis] -= 1;
    expect_event(event::kGridCount, 1, 1, grid_packet(back, run_.page()));
  }
}

// A beat a vertex, and one for the half that an odd count leaves unread.
TEST_P(EventPlaces, OfPackedVertices) {
  for (std::uint32_t stray = 1; stray <= 5; ++stray) {
    std::vector<Beat> packet = packed(5);
    const std::size_t half = (stray - 1) % 2;
    packet[1 + (stray - 1) / 2].words[2 * half] |= 0x1FFFF;  // s is all ones
    expect_event(event::kCoordinateOutside, 1, stray, packet);
  }
  for (const std::uint32_t count : {1U, 3U, 5U}) {
    std::vector<Beat> packet = packed(count + 3);
    packet[0].words[1] = count;
    expect_event(event::kPacketLong, 1, count + 2, packet);
  }
  for (const std::uint32_t count : {2U, 4U}) {
    std::vector<Beat> packet = packed(count + 2);
    packet[0].words[1] = count;
    expect_event(event::kPacketLong, 1, count + 1, packet);
  }
}

// 64 ones in the last half are no vertex, also where the count wants one: the packet is too short
// then.
TEST_P(EventPlaces, AnEmptyHalfIsNoVertex) {
  for (const std::uint32_t count : {2U, 4U, 6U}) {
    std::vector<Beat> packet = packed(4);
    packet[0].words[1] = count;
    packet[2].words[2] = packet[2].words[3] = kEmptyHalf;
    const std::size_t before = results();
    if (count == 2) {
      expect_event(event::kPacketLong, 1, 3, packet);
      EXPECT_EQ(results() - before, 2U + 1);
      continue;
    }
    expect_event(event::kPacketShort, 1, 3, packet);
    ASSERT_EQ(results() - before, 3U + 1);
    EXPECT_TRUE(run_.bench().results()[before + 2].last);
  }
  std::vector<Beat> three = packed(3);
  three[2].words[2] = three[2].words[3] = kEmptyHalf;
  expect_none(three);
}

TEST_P(EventPlaces, OnesInAnyOtherHalfAreARefusedVertex) {
  std::vector<Beat> packet = packed(4);
  packet[1].words[2] = packet[1].words[3] = kEmptyHalf;
  run_.send(packet);
  ASSERT_TRUE(run_.run());
  ASSERT_EQ(results(), 4U);
  EXPECT_EQ(run_.bench().results()[1].words[3] >> 16,
            (kStatusUnloaded | kStatusClamped | kStatusOutside) >> 16);
  for (unsigned e = 0; e < kStreamEvents; ++e) {
    const bool expected = e == stream_event(event::kGridCount) || e == event::kCellOutside ||
                          e == event::kCoordinateOutside;
    EXPECT_EQ(run_.bench().events()[e], expected ? 1U : 0U) << "event " << e;
    if (expected) {
      EXPECT_EQ(run_.bench().event_place(static_cast<int>(e)).beat, 2U) << "event " << e;
    }
  }
}

// Beats behind the header are not looked at: too short, and not too long as well.
TEST_P(EventPlaces, ACountOfZeroIsOneEvent) {
  std::vector<std::vector<Beat>> packets = {vertices_packet(vertices(3)), packed(4)};
  if (run_.has(model::kInterleavedFeature)) {
    packets.push_back(interleaved_packet(make_stimulus("random", run_.codec(), 1, 1)));
  }
  if (run_.has(model::kPagesFeature)) {
    packets.push_back(page_vertices_packet(run_.page(), vertices(3)));
    packets.push_back(points_packet(run_.page(), lattice_, 0, 3));
  }
  for (std::vector<Beat>& packet : packets) {
    SCOPED_TRACE(packet[0].words[0] & 0xFF);
    packet[0].words[1] = 0;
    const std::size_t before = results();
    expect_event(event::kPacketShort, 1, 0, packet);
    EXPECT_EQ(results() - before, 1U);
  }
}

// All bits of a header that have no meaning, one by one: in opcodes 1 to 4 they are not looked at,
// in those behind them they make the packet unknown.
TEST_P(EventPlaces, FlagsThatAnOpcodeDoesNotHave) {
  const std::uint32_t packed_flag = run_.has(model::kPackedFeature) ? kPackedFlag : 0;
  std::vector<Beat> loads = coefficients_packet(watertight_bspline(run_.codec()), run_.codec());
  for (int bit = 8; bit < 32; ++bit) {
    const std::uint32_t flag = 1U << bit;
    SCOPED_TRACE(bit);
    std::vector<std::vector<Beat>> older = {loads, lattice_packet(lattice_)};
    if ((flag & packed_flag) == 0) older.push_back(vertices_packet(vertices(2)));
    if (run_.has(model::kInterleavedFeature)) {
      older.push_back(interleaved_packet(make_stimulus("random", run_.codec(), 1, 1)));
    }
    for (std::vector<Beat>& packet : older) {
      const std::size_t before = results(), expected = packet[0].words[1];
      packet[0].words[0] |= flag;
      packet[0].words[3] |= flag & ~0x3FFU;
      expect_none(packet);
      const bool gives = (packet[0].words[0] & 0xFF) > 2;
      EXPECT_EQ(results() - before, (gives ? expected : 0) + 1);
    }
    if (bit < 22) continue;
    const bool known = flag == kHalfFlag && run_.has(model::kHalvesFeature);
    std::vector<std::vector<Beat>> newer;
    if (!known) newer.push_back(grid_packet(grid(), run_.page()));
    if (run_.has(model::kPagesFeature)) {
      newer.push_back(page_packet(run_.page(), lattice_));
      newer.push_back(points_packet(run_.page(), lattice_, 0, 3));
      if (!known) newer.push_back(page_vertices_packet(run_.page(), vertices(3)));
    }
    for (std::vector<Beat>& packet : newer) {
      packet[0].words[0] |= flag;
      expect_event(event::kUnknownOpcode, 1, 0, packet);
    }
  }
}

// Clamped by its mode a vertex is C and O, and not S: what is saturated is what came in without it.
TEST_P(EventPlaces, ModesAndTheStatusOfACoordinateOutside) {
  struct Mode {
    OutsideMode mode;
    std::uint32_t fixed, binary32;
  };
  for (const Mode& mode :
       {Mode{OutsideMode::kClamp, kStatusClamped | kStatusOutside, kStatusClamped | kStatusOutside},
        {OutsideMode::kPass, kStatusSaturated | kStatusOutside, kStatusOutside},
        {OutsideMode::kBlank, kStatusOutside, kStatusOutside}}) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<VertexBeat> stray = vertices(1);
      stray[0].local[axis] = outside();
      const std::size_t before = results();
      run_.send(vertices_packet(stray, mode.mode));
      ASSERT_TRUE(run_.run());
      const bool binary32 = run_.codec().is_float() && !run_.codec().is_block();
      EXPECT_EQ(run_.bench().results().at(before).words[3] >> 16,
                (binary32 ? mode.binary32 : mode.fixed) >> 16)
          << "mode " << static_cast<int>(mode.mode) << ", axis " << axis;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, EventPlaces, ::testing::ValuesIn(page_builds()), by_name);

}  // namespace
}  // namespace hwffd::test
