// The stream model of scatter: what each packet adds and tells, row by row of the tables of
// docs/interface.md section 2. Events and places are made by hand.
#include "hwffd/model/scatter_stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/events.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::model {
namespace {

using Places = std::vector<std::tuple<unsigned, std::uint32_t, std::uint32_t>>;
using Packet = std::vector<Beat>;

const char* const kRow = "affine-fx17-overlapped";
constexpr std::array<int, 3> kDims = {5, 4, 6};
constexpr unsigned kRefusedGrid = stream_event(event::kGridCount);
constexpr unsigned kOtherPoints = stream_event(event::kPagePoints);
constexpr unsigned kFunctions = stream_event(event::kFunctionsSum);
constexpr unsigned kOverflow = stream_event(event::kPageOverflowed);

Configuration row_of(const char* format) {
  Configuration row = find_configuration(kRow);
  row.format = format;
  return row;
}

Packet functions(const std::string& name, Functions which = Functions::kDerivativesToo) {
  const WordCodec codec("fx17");
  return coefficients_packet(family(name, codec), codec, which);
}

std::uint32_t random_gradient_word(tb::Random& random) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(random.word()) >> random.below(12));
}

std::vector<GradientBeats> random_vertices(tb::Random& random, std::size_t count,
                                           const std::array<int, 3>& dims = kDims) {
  std::vector<GradientBeats> vertices(count);
  for (GradientBeats& vertex : vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      vertex.local[axis] = static_cast<std::uint32_t>(random.below(0x80000001));
      vertex.cell[axis] =
          static_cast<int>(random.below(static_cast<std::uint64_t>(dims[axis]) - 3));
      vertex.gradient[axis] = random_gradient_word(random);
    }
    vertex.tag = static_cast<std::uint16_t>(random.word());
  }
  return vertices;
}

Gradients to(const std::array<int, 3>& dims = kDims) {
  Gradients how;
  how.dims = dims;
  return how;
}

Packet sized(Packet packet, std::size_t beats) {
  packet.back().last = false;
  packet.resize(beats);
  packet.back().last = true;
  return packet;
}

Packet with_word(Packet packet, int word, std::uint32_t bits) {
  packet[0].words[word] ^= bits;
  return packet;
}

Places places(const std::vector<ScatterEvent>& events) {
  Places result;
  for (const ScatterEvent& event : events) {
    result.emplace_back(event.event, event.packet, event.beat);
  }
  return result;
}

/// What the words of beats say, without tags and status.
std::vector<std::array<std::uint32_t, 3>> words(const std::vector<Beat>& results) {
  std::vector<std::array<std::uint32_t, 3>> all;
  for (const Beat& beat : results) all.push_back({beat.words[0], beat.words[1], beat.words[2]});
  return all;
}

class ScatterStream : public ::testing::Test {
 protected:
  std::vector<Beat> send(const Packet& packet) { return model_.run(packet); }
  void send_functions() { send(functions("bspline")); }
  Packet some(std::size_t count, const Gradients& how = to(), int page = 0) {
    return gradients_packet(page, random_vertices(random_, count, how.dims), how);
  }
  Grid grid() const { return grid_between({0.25, 0.5, 2.5}, {1.75, 0.25, 0}, {2, 3, 2}); }
  Packet grid_packet_of(const Grid& grid, const Gradients& how = to(), int page = 0) {
    std::vector<std::array<std::uint32_t, 3>> gradients(vertex_count(grid));
    for (auto& gradient : gradients) {
      for (std::uint32_t& word : gradient) word = random_gradient_word(random_);
    }
    return gradients_packet(page, grid, gradients, how);
  }

  tb::Random random_{1};
  ScatterStreamModel model_{find_configuration(kRow)};
};

// Vertices of two pages in turn, positions and derivatives: the words are those of the datapath.
TEST_F(ScatterStream, CollectsWhatVerticesAdd) {
  const Configuration row = find_configuration(kRow);
  const WordCodec codec(row.format);
  const auto scatter = make_scatter_model(row);
  for (int axis = 0; axis < 3; ++axis) scatter->load(axis, encode(family("bspline", codec), codec));
  const std::array<std::array<int, 3>, 2> dims = {kDims, {4, 16, 7}};
  std::vector<ScatterPage> sums = {{17, dims[0]}, {17, dims[1]}};
  send_functions();
  for (int packet = 0; packet < 24; ++packet) {
    const std::size_t page = random_.below(2);
    const auto vertices = random_vertices(random_, random_.between(1, 9), dims[page]);
    Gradients how = to(dims[page]);
    how.along = static_cast<int>(random_.below(4));
    EXPECT_TRUE(send(gradients_packet(static_cast<int>(page), vertices, how)).empty());
    for (const GradientBeats& vertex : vertices) {
      const GradientWords read = {vertex.local, vertex.cell, vertex.gradient, how.along - 1};
      sums[page].add(vertex.cell, scatter->parts(read));
    }
  }
  for (int page = 0; page < 2; ++page) {
    Collect how;
    how.shift = page;
    how.tag = 0xFFF0;
    const auto results = send(collect_packet(page, how));
    const auto expected = sums[static_cast<std::size_t>(page)].collect(page);
    ASSERT_EQ(results.size(), expected.size());
    for (std::size_t p = 0; p < results.size(); ++p) {
      for (int c = 0; c < 3; ++c) EXPECT_EQ(results[p].words[c], expected[p].words[c]) << p;
      EXPECT_EQ(results[p].words[3], (0xFFF0 + p) & 0xFFFF);
      EXPECT_EQ(results[p].last, p + 1 == results.size());
      EXPECT_FALSE(results[p].user);
    }
  }
  EXPECT_TRUE(model_.events().empty());
}

TEST_F(ScatterStream, ACollectMayBeCountedAndInterrupt) {
  send_functions();
  send(some(3));
  Collect how;
  how.count = how.interrupt = true;
  const auto results = send(collect_packet(0, how));
  ASSERT_EQ(results.size(), 121U);
  EXPECT_EQ(results.back().words, (std::array<std::uint32_t, 4>{120, 0, 0, 0xFFFFFFFF}));
  for (std::size_t r = 0; r < 121; ++r) {
    EXPECT_EQ(results[r].last, r == 120);
    EXPECT_EQ(results[r].user, r == 120);
  }
}

// A collect leaves a page without points an axis, so others may follow, and a second collect may
// not.
TEST_F(ScatterStream, ACollectLeavesZeros) {
  send_functions();
  send(some(5));
  const auto first = some(4);
  EXPECT_EQ(send(collect_packet(0)).size(), 120U);
  EXPECT_TRUE(send(collect_packet(0)).empty());
  send(some(1, to({4, 4, 7})));
  EXPECT_EQ(send(collect_packet(0)).size(), 112U);
  send(first);
  const auto again = send(collect_packet(0));
  ScatterStreamModel fresh(find_configuration(kRow));
  fresh.run(functions("bspline"));
  fresh.run(first);
  EXPECT_EQ(again, fresh.run(collect_packet(0)));
  EXPECT_EQ(places(model_.events()), (Places{{event::kNoLattice, 3, 0}}));
}

TEST_F(ScatterStream, ABeginLeavesZerosToo) {
  Gradients how = to();
  how.begin = true;
  const Packet packet = some(4, how);
  Gradients other = to({6, 4, 4});
  other.begin = true;
  send_functions();
  send(packet);
  const auto once = send(collect_packet(0));
  send(some(7));
  send(some(2, other));
  send(packet);
  EXPECT_EQ(send(collect_packet(0)), once);
  EXPECT_TRUE(model_.events().empty());
}

// In packets of their own, or of a grid, which has its coordinates cut to 24 bits.
TEST_F(ScatterStream, AGridIsItsVertices) {
  send_functions();
  for (int along = 0; along < 4; ++along) {
    Gradients how = to();
    how.along = along;
    const Packet of_grid = grid_packet_of(grid(), how);
    send(of_grid);
    const auto results = send(collect_packet(0));
    std::vector<GradientBeats> vertices;
    for (const VertexBeat& vertex : grid_vertices(grid(), kDims, WordCodec("fx17"))) {
      const auto& gradient = of_grid[4 + vertices.size()].words;
      vertices.push_back({vertex, {gradient[0], gradient[1], gradient[2]}});
    }
    std::reverse(vertices.begin(), vertices.end());
    send(gradients_packet(0, vertices, how));
    EXPECT_EQ(send(collect_packet(0)), results);
  }
  EXPECT_TRUE(model_.events().empty());
}

/// A packet with something wrong, told at these beats, which adds as much as good ones do.
struct Wrong {
  std::string name;
  Packet packet;
  std::vector<std::pair<unsigned, std::uint32_t>> events;
  std::vector<Packet> instead;
};

class ScatterEvents : public ScatterStream {
 protected:
  /// Sends it behind a good packet of the same page, and a good one behind it.
  void expect(const Wrong& wrong) {
    SCOPED_TRACE(wrong.name);
    const Packet before = some(3), behind = some(2);
    ScatterStreamModel model(find_configuration(kRow)), good(find_configuration(kRow));
    for (ScatterStreamModel* each : {&model, &good}) {
      EXPECT_TRUE(each->run(functions("bspline")).empty());
      EXPECT_TRUE(each->run(before).empty());
    }
    EXPECT_EQ(model.run(wrong.packet), std::vector<Beat>());
    for (const Packet& packet : wrong.instead) good.run(packet);
    Places expected;
    for (const auto& [code, beat] : wrong.events) expected.emplace_back(code, 2, beat);
    EXPECT_EQ(places(model.events()), expected);
    EXPECT_TRUE(good.events().empty());
    for (ScatterStreamModel* each : {&model, &good}) each->run(behind);
    EXPECT_EQ(model.vertices(), good.vertices());
    const auto collected = model.run(collect_packet(0));
    EXPECT_EQ(collected.size(), 120U);
    EXPECT_EQ(collected, good.run(collect_packet(0)));
    EXPECT_EQ(places(model.events()), expected);
  }
  void expect_refused(const std::string& name, const Packet& packet, unsigned code) {
    expect({name, packet, {{code, 0}}, {}});
    expect({name + ", longer", sized(packet, packet.size() + 3), {{code, 0}}, {}});
    expect({name + ", a header", sized(packet, 1), {{code, 0}}, {}});
  }
};

TEST_F(ScatterEvents, Unknown) {
  for (unsigned opcode = 0; opcode < 256; ++opcode) {
    if (opcode == 1 || opcode == 10 || opcode == 11) continue;
    Packet packet = some(2);
    packet[0].words[0] = opcode;
    expect_refused("opcode " + std::to_string(opcode), packet, event::kUnknownOpcode);
  }
  for (unsigned bit = 16; bit < 32; ++bit) {
    if (bit == 22 || bit == 23) continue;
    for (const Packet& packet : {some(2), grid_packet_of(grid())}) {
      expect_refused("flag", with_word(packet, 0, 1U << bit), event::kUnknownOpcode);
    }
    if (bit == 20 || bit == 21) continue;
    expect_refused("flag", with_word(collect_packet(0), 0, 1U << bit), event::kUnknownOpcode);
  }
  for (unsigned bit = 22; bit < 24; ++bit) {
    expect_refused("flag", with_word(collect_packet(0), 0, 1U << bit), event::kUnknownOpcode);
  }
  for (unsigned bit = 28; bit < 32; ++bit) {
    expect_refused("word 2", with_word(some(2), 2, 1U << bit), event::kUnknownOpcode);
  }
  for (const std::uint32_t mode : {1U, 3U}) {
    expect_refused("mode", with_word(some(2), 2, mode << 24), event::kUnknownOpcode);
  }
  for (unsigned bit = 0; bit < 32; ++bit) {
    expect_refused("word 3", with_word(some(2), 3, 1U << bit), event::kUnknownOpcode);
    expect_refused("word 1", with_word(collect_packet(0), 1, 1U << bit), event::kUnknownOpcode);
    if (bit > 1) {
      expect_refused("word 2", with_word(collect_packet(0), 2, 1U << bit), event::kUnknownOpcode);
    }
    if (bit < 16) continue;
    expect_refused("word 3", with_word(grid_packet_of(grid()), 3, 1U << bit),
                   event::kUnknownOpcode);
    expect_refused("word 3", with_word(collect_packet(0), 3, 1U << bit), event::kUnknownOpcode);
  }
}

TEST_F(ScatterEvents, PagesAndPoints) {
  for (const int page : {2, 3, 255}) {
    expect_refused("page", some(2, to(), page), event::kNoLattice);
    expect_refused("page", grid_packet_of(grid(), to(), page), event::kNoLattice);
    expect_refused("page", collect_packet(page), event::kNoLattice);
  }
  expect_refused("a page that is zero", collect_packet(1), event::kNoLattice);
  for (int axis = 0; axis < 3; ++axis) {
    for (const int points : {0, 3, 17, 255}) {
      Packet packet = some(2);
      packet[0].words[2] &= ~(0xFFU << (8 * axis));
      packet[0].words[2] |= static_cast<std::uint32_t>(points) << (8 * axis);
      expect_refused("points", packet, event::kLatticeSize);
      expect_refused("points", with_word(packet, 0, kBeginFlag), event::kLatticeSize);
    }
    std::array<int, 3> other = kDims;
    other[axis] += 1;
    expect_refused("other points", some(2, to(other)), kOtherPoints);
    expect_refused("other points", grid_packet_of(grid(), to(other)), kOtherPoints);
  }
}

// One event, the first of 0, 4, 5, 10 and 13.
TEST_F(ScatterEvents, AreTheFirstOfSeveral) {
  Packet packet = grid_packet_of(grid());
  packet[0].words[1] = 0;
  expect({"13", packet, {{kRefusedGrid, 3}}, {}});
  packet[0].words[2] += 1;
  expect_refused("10", packet, kOtherPoints);
  packet[0].words[2] = 0x7F0404;
  expect_refused("5", packet, event::kLatticeSize);
  packet[0].words[0] |= 0xFF00;
  expect_refused("4", packet, event::kNoLattice);
  packet[0].words[0] |= kEveryFlag;
  expect_refused("0", packet, event::kUnknownOpcode);
}

TEST_F(ScatterEvents, PacketsTooShortAndTooLong) {
  const auto vertices = random_vertices(random_, 4);
  const Packet whole = gradients_packet(0, vertices, to());
  for (std::size_t beats = 1; beats < whole.size(); ++beats) {
    const std::size_t complete = (beats - 1) / 2;
    const std::vector<GradientBeats> first(
        vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(complete));
    std::vector<Packet> instead;
    if (complete != 0) instead.push_back(gradients_packet(0, first, to()));
    expect({"short",
            sized(whole, beats),
            {{event::kPacketShort, static_cast<std::uint32_t>(beats - 1)}},
            instead});
  }
  for (const std::size_t more : {1, 2, 5}) {
    expect({"long", sized(whole, whole.size() + more), {{event::kPacketLong, 9}}, {whole}});
  }
  for (const std::size_t beats : {1U, 2U, 9U}) {
    Packet none = sized(whole, beats);
    none[0].words[1] = 0;
    expect({"none", none, {{event::kPacketShort, 0}}, {}});
  }
  const Packet of_grid = grid_packet_of(grid());
  for (std::size_t beats = 1; beats < of_grid.size(); ++beats) {
    // What a grid with fewer rows adds, or nothing.
    std::vector<Packet> instead;
    std::vector<GradientBeats> first;
    const auto at = grid_vertices(grid(), kDims, WordCodec("fx17"));
    for (std::size_t v = 0; v + 4 < beats; ++v) {
      const auto& gradient = of_grid[4 + v].words;
      first.push_back({at[v], {gradient[0], gradient[1], gradient[2]}});
    }
    if (!first.empty()) instead.push_back(gradients_packet(0, first, to()));
    expect({"grid, short",
            sized(of_grid, beats),
            {{event::kPacketShort, static_cast<std::uint32_t>(beats - 1)}},
            instead});
  }
  expect({"grid, long", sized(of_grid, of_grid.size() + 2), {{event::kPacketLong, 16}}, {of_grid}});
}

// The words come all the same.
TEST_F(ScatterEvents, ACollectThatIsTooLong) {
  send_functions();
  const Packet packet = some(3);
  send(packet);
  const auto expected = send(collect_packet(0));
  send(packet);
  EXPECT_EQ(send(sized(collect_packet(0), 3)), expected);
  EXPECT_EQ(places(model_.events()), (Places{{event::kPacketLong, 4, 1}}));
}

TEST_F(ScatterEvents, GridsThatLeaveTheLattice) {
  constexpr std::uint64_t kCell = std::uint64_t{1} << kGridFraction;
  std::vector<Grid> bad(6, grid());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bad[axis].count[axis] = 0;
    bad[3 + axis].start[axis] = static_cast<std::uint64_t>(kDims[axis] - 3) * kCell + (1U << 16);
  }
  for (const Grid& each : bad) {
    const Packet packet = grid_packet_of(each);
    expect({"grid", sized(packet, 4), {{kRefusedGrid, 3}}, {}});
    expect({"grid", sized(packet, packet.size() + 5), {{kRefusedGrid, 3}}, {}});
    for (const std::size_t beats : {1U, 2U, 3U}) {
      const auto last = static_cast<std::uint32_t>(beats - 1);
      expect({"grid, short", sized(packet, beats), {{event::kPacketShort, last}}, {}});
    }
  }
}

// B and points an axis hold of packets that are cut short, and of grids that are refused; not of
// what is dropped with its header.
TEST_F(ScatterEvents, WhatHoldsOfABeginThatGoesWrong) {
  Gradients how = to({4, 6, 4});
  how.begin = true;
  Grid beyond = grid();
  beyond.count[2] = 0;
  Packet none = some(2, how);
  none[0].words[1] = 0;
  const std::vector<Packet> begun = {sized(some(2, how), 1), none, sized(some(2, how), 2),
                                     sized(grid_packet_of(grid(), how), 3),
                                     grid_packet_of(beyond, how)};
  send_functions();
  for (const Packet& packet : begun) {
    send(some(3));
    send(packet);
    const auto results = send(collect_packet(0));
    ASSERT_EQ(results.size(), 96U);
    for (const Beat& beat : results) EXPECT_EQ(beat.words[0] | beat.words[1] | beat.words[2], 0U);
  }
  EXPECT_EQ(model_.events().size(), begun.size());
  for (const Packet& packet : {with_word(some(2, how), 0, kEveryFlag), some(2, how, 9)}) {
    send(some(3));
    send(packet);
    EXPECT_EQ(send(collect_packet(0)).size(), 120U);
  }
}

// By the mode: on the nearest place, or nothing.
TEST_F(ScatterEvents, VerticesOutside) {
  struct Outside {
    int axis;
    int cell;
    std::uint32_t word, nearest;
    std::vector<unsigned> events;
  };
  for (const Outside& outside :
       {Outside{0, 0, 0x80000001, 0x80000000, {event::kCoordinateOutside}},
        {1, 0, 0xBFFFFFFF, 0x80000000, {event::kCoordinateOutside}},
        {2, 1, 0xC0000000, 0, {event::kCoordinateOutside}},
        {2, 2, 0xFFFFFFFF, 0, {event::kCoordinateOutside}},
        {0, 2, 0x1234567, 0x80000000, {event::kCellOutside}},
        {2, 15, 0, 0x80000000, {event::kCellOutside}},
        {1, 1, 0xFFFFFFFF, 0x80000000, {event::kCellOutside, event::kCoordinateOutside}}}) {
    auto vertices = random_vertices(random_, 3);
    vertices[1].local[outside.axis] = outside.word;
    vertices[1].cell[outside.axis] = outside.cell;
    auto inside = vertices;
    inside[1].local[outside.axis] = outside.nearest;
    inside[1].cell[outside.axis] = std::min(outside.cell, kDims[outside.axis] - 4);
    std::vector<std::pair<unsigned, std::uint32_t>> events;
    for (const unsigned code : outside.events) events.emplace_back(code, 4);
    expect({"clamp",
            gradients_packet(0, vertices, to()),
            events,
            {gradients_packet(0, inside, to())}});
    Gradients blank = to();
    blank.mode = OutsideMode::kBlank;
    const Packet packet = gradients_packet(0, vertices, blank);
    expect({"blank", packet, events, {gradients_packet(0, {inside[0], inside[2]}, to())}});
    // One that is cut tells nothing.
    expect({"cut",
            sized(packet, 4),
            {{event::kPacketShort, 3}},
            {gradients_packet(0, {inside[0]}, to())}});
  }
}

TEST_F(ScatterEvents, VerticesBeforeTheirFunctions) {
  Gradients derivatives = to();
  derivatives.along = 2;
  auto vertices = random_vertices(random_, 2);
  vertices[1].cell[0] = 9;
  send(gradients_packet(0, vertices, to()));
  send(functions("bspline", Functions::kBlending));
  send(gradients_packet(0, vertices, derivatives));
  send(grid_packet_of(grid(), derivatives));
  EXPECT_EQ(model_.vertices(), 0U);
  Places expected = {{event::kNoCoefficients, 0, 2}, {event::kNoCoefficients, 0, 4},
                     {event::kCellOutside, 0, 4},    {event::kNoCoefficients, 2, 2},
                     {event::kNoCoefficients, 2, 4}, {event::kCellOutside, 2, 4}};
  for (std::uint32_t v = 1; v <= 12; ++v) expected.emplace_back(event::kNoCoefficients, 3, 3 + v);
  EXPECT_EQ(places(model_.events()), expected);
  send(some(3));
  send_functions();
  send(some(2, derivatives));
  EXPECT_EQ(model_.vertices(), 5U);
  EXPECT_EQ(model_.events().size(), expected.size());
}

// Those that came too short never come into use, and those that do not sum up do, but are told.
TEST_F(ScatterEvents, Coefficients) {
  const Packet packet = some(4);
  send(functions("bspline"));
  send(packet);
  const auto expected = send(collect_packet(0));
  for (const std::size_t beats : {1U, 2U, 13U, 24U}) {
    send(sized(functions("bernstein"), beats));
    send(packet);
    EXPECT_EQ(send(collect_packet(0)), expected);
    EXPECT_EQ(places(model_.events()).back(),
              (Places::value_type{event::kPacketShort, model_.events().back().packet, beats - 1}));
  }
  EXPECT_EQ(model_.events().size(), 4U);
  Packet sums = functions("bspline");
  sums[5].words[0] ^= 0x1000;
  sums[15].words[1] ^= 0x1000;
  send(sums);
  EXPECT_EQ(Places(1, places(model_.events())[4]), (Places{{kFunctions, 15, 8}}));
  EXPECT_EQ(Places(1, places(model_.events())[5]), (Places{{kFunctions, 15, 16}}));
  send(sized(functions("bspline"), 27));
  EXPECT_EQ(Places(1, places(model_.events())[6]), (Places{{event::kPacketLong, 16, 25}}));
  // The fourth function is never read.
  Packet fourth = functions("bspline");
  fourth[4].words[0] ^= 0x1000;
  send(fourth);
  send(packet);
  EXPECT_EQ(send(collect_packet(0)), expected);
  ScatterStreamModel powers(find_configuration("affine-fx17-overlapped-powers"));
  powers.run(fourth);
  EXPECT_TRUE(powers.events().empty());
}

TEST_F(ScatterEvents, SaturationIsOfAllPoints) {
  send_functions();
  auto vertices = random_vertices(random_, 2);
  vertices[0].gradient = {0x7FFFFFFF, 0x7FFFFFFF, 0x7FFFFFFF};
  send(gradients_packet(0, vertices, to()));
  for (const Beat& beat : send(collect_packet(0))) EXPECT_EQ(beat.words[3] >> 16, 1U);
  send(gradients_packet(0, {vertices[1]}, to()));
  for (const Beat& beat : send(collect_packet(0))) EXPECT_EQ(beat.words[3] >> 16, 0U);
  EXPECT_EQ(places(model_.events()), (Places{{event::kSaturated, 1, 2}}));
}

// Words saturate beyond 2^31 with no shift, each point's own; one more vertex than 2^(34-W) is told
// once, and in all points.
TEST_F(ScatterEvents, OverflowIsToldOnce) {
  constexpr std::uint32_t kMost = 65'536;
  ScatterStreamModel model(row_of("fx18"));
  model.run(functions("linear"));
  // The first vertex of the cell: all of its gradient goes to one point.
  GradientBeats vertex;
  vertex.gradient = {0x80000000, 0x10000000, 0};
  std::vector<GradientBeats> vertices(kMost, vertex);
  Gradients how = to({4, 4, 4});
  how.begin = true;
  model.run(gradients_packet(0, vertices, how));
  how.begin = false;
  EXPECT_TRUE(model.events().empty());
  model.run(gradients_packet(0, {vertex}, how));
  model.run(gradients_packet(0, {vertex, vertex}, how));
  EXPECT_EQ(places(model.events()), (Places{{kOverflow, 2, 2}}));
  const auto results = model.run(collect_packet(0));
  ASSERT_EQ(results.size(), 64U);
  std::size_t saturated = 0;
  for (const Beat& beat : results) {
    EXPECT_EQ(beat.words[3] >> 16 & ~1U, kStatusOverflowed >> 16);
    if ((beat.words[3] & kStatusSaturated) == 0) continue;
    ++saturated;
    EXPECT_EQ(beat.words[0], 0x80000000U);
    EXPECT_EQ(beat.words[1], (kMost + 3) << 14);
  }
  EXPECT_EQ(saturated, 1U);
  ASSERT_EQ(model.events().size(), 2U);
  EXPECT_EQ(model.events()[1].event, event::kSaturated);
  model.run(gradients_packet(0, {vertex}, how));
  for (const Beat& beat : model.run(collect_packet(0))) EXPECT_EQ(beat.words[3] >> 16, 0U);
}

TEST_F(ScatterStream, AResetForgetsEverything) {
  send_functions();
  send(some(3));
  const Packet packet = some(2, to({6, 6, 6}));
  send(sized(packet, 3));
  ScatterStreamModel fresh(find_configuration(kRow));
  model_.accept(packet[0]);
  model_.reset();
  for (ScatterStreamModel* each : {&model_, &fresh}) {
    EXPECT_TRUE(each->events().empty());
    each->run(packet);
    each->run(functions("bspline"));
    each->run(packet);
  }
  EXPECT_EQ(places(model_.events()), places(fresh.events()));
  EXPECT_EQ(model_.events().size(), 2U);
  EXPECT_EQ(model_.vertices(), 2U);
  EXPECT_EQ(model_.run(collect_packet(0)), fresh.run(collect_packet(0)));
}

// Permutations of a set of vertices, over packets and over pages that are added, give one result.
TEST_F(ScatterStream, AnyOrderGivesTheSameWords) {
  auto vertices = random_vertices(random_, 30);
  send_functions();
  send(gradients_packet(0, vertices, to()));
  const auto expected = words(send(collect_packet(0)));
  for (int permutation = 0; permutation < 50; ++permutation) {
    for (std::size_t v = vertices.size() - 1; v > 0; --v) {
      std::swap(vertices[v], vertices[random_.below(v + 1)]);
    }
    for (int page = 0; page < 2; ++page) send(sized(some(1, to(), page), 1));
    for (const GradientBeats& vertex : vertices) {
      send(gradients_packet(static_cast<int>(random_.below(2)), {vertex}, to()));
    }
    auto sums = words(send(collect_packet(0)));
    const auto others = words(send(collect_packet(1)));
    for (std::size_t p = 0; p < sums.size(); ++p) {
      for (int c = 0; c < 3; ++c) sums[p][c] += others[p][c];
    }
    ASSERT_EQ(sums, expected);
  }
}

/// A core with rows; `model_` is the one without.
class ScatterRowsStream : public ScatterStream {
 protected:
  /// Rows of up to 30 vertices, which stand still, turn back or leap over cells, now and then.
  Grid long_rows() {
    const auto cells = static_cast<double>(kRowsDims[0] - 3);
    const double first = random_.unit() * cells;
    const double last = random_.chance(0.2) ? first : random_.unit() * cells;
    return grid_between({first, 0.5, 2.5}, {last, 0.25, 0},
                        {static_cast<int>(random_.between(1, 30)), 3, 2});
  }
  /// What the first gradients of a grid add, each row of them ending where they do.
  ScatterPage sums_of(const Packet& packet, const Grid& grid, std::size_t gradients,
                      int along = 0) const {
    const WordCodec codec("fx17");
    const auto scatter = make_scatter_model(find_configuration(kRow));
    for (int axis = 0; axis < 3; ++axis) {
      scatter->load(axis, encode(family("bspline", codec), codec));
    }
    ScatterPage page(17, kRowsDims);
    ScatterRow row(*scatter);
    const auto vertices = grid_vertices(grid, kRowsDims, codec);
    for (std::size_t v = 0; v < gradients; ++v) {
      const auto& gradient = packet[4 + v].words;
      page.count(row.add({vertices[v].local,
                          vertices[v].cell,
                          {gradient[0], gradient[1], gradient[2]},
                          along - 1}));
      if ((v + 1) % grid.count[0] == 0) row.end(page);
    }
    row.end(page);
    return page;
  }
  static std::vector<std::array<std::uint32_t, 3>> words_of(ScatterPage page) {
    std::vector<std::array<std::uint32_t, 3>> all;
    for (const CollectedPoint& point : page.collect(0)) all.push_back(point.words);
    return all;
  }

  static constexpr std::array<int, 3> kRowsDims = {12, 4, 6};
  ScatterStreamModel rows_{find_configuration(kRow), kAxisPoints, kPages, true};
};

TEST_F(ScatterRowsStream, AVertexOfAListIsARow) {
  send_functions();
  rows_.run(functions("bspline"));
  for (int packet = 0; packet < 20; ++packet) {
    Gradients how = to();
    how.along = packet % 4;
    how.mode = packet % 3 == 0 ? OutsideMode::kBlank : OutsideMode::kClamp;
    auto vertices = random_vertices(random_, random_.between(1, 9));
    if (packet % 2 == 0) vertices[0].cell[packet % 3] = 9;
    if (packet % 5 == 0) vertices[0].local[packet % 3] = 0x90000000;
    const Packet list = gradients_packet(0, vertices, how);
    EXPECT_EQ(rows_.run(list), send(list));
    EXPECT_EQ(rows_.run(collect_packet(0)), send(collect_packet(0))) << packet;
  }
  EXPECT_EQ(rows_.vertices(), model_.vertices());
  EXPECT_EQ(places(rows_.events()), places(model_.events()));
  EXPECT_FALSE(model_.events().empty());
}

TEST_F(ScatterRowsStream, AGridGoesByRows) {
  constexpr int kRounds = 60;
  send_functions();
  rows_.run(functions("bspline"));
  int other_words = 0;
  for (int round = 0; round < kRounds; ++round) {
    const Grid grid = long_rows();
    Gradients how = to(kRowsDims);
    how.along = round % 4;
    const Packet packet = grid_packet_of(grid, how);
    rows_.run(packet);
    send(packet);
    const auto by_rows = words(rows_.run(collect_packet(0)));
    const auto by_vertices = words(send(collect_packet(0)));
    ASSERT_EQ(by_rows, words_of(sums_of(packet, grid, vertex_count(grid), how.along))) << round;
    std::array<std::uint32_t, 3> sum{};
    for (std::size_t p = 0; p < by_rows.size(); ++p) {
      for (int c = 0; c < 3; ++c) sum[c] += by_rows[p][c] - by_vertices[p][c];
    }
    EXPECT_EQ(sum, (std::array<std::uint32_t, 3>{}));
    other_words += by_rows != by_vertices ? 1 : 0;
  }
  EXPECT_GT(other_words, kRounds / 2);
  EXPECT_EQ(rows_.vertices(), model_.vertices());
  EXPECT_TRUE(rows_.events().empty());
}

// Each row in a packet of its own, in any order; and halves of rows, which are rows.
TEST_F(ScatterRowsStream, RowsMayComeInPacketsOfTheirOwn) {
  rows_.run(functions("bspline"));
  for (int round = 0; round < 20; ++round) {
    const Grid grid = long_rows();
    const Packet packet = grid_packet_of(grid, to(kRowsDims));
    rows_.run(packet);
    const auto expected = words(rows_.run(collect_packet(0)));
    std::vector<std::uint16_t> order(6);
    std::iota(order.begin(), order.end(), std::uint16_t{0});
    for (std::size_t r = 5; r > 0; --r) std::swap(order[r], order[random_.below(r + 1)]);
    ScatterPage in_halves(17, kRowsDims);
    for (const std::uint16_t r : order) {
      Grid row = grid;
      row.count[1] = row.count[2] = 1;
      row.start[1] += static_cast<std::uint64_t>(grid.step[1] * (r % 3));
      row.start[2] += static_cast<std::uint64_t>(grid.step[2] * (r / 3));
      const auto first = packet.begin() + 4 + r * grid.count[0];
      const std::vector<Beat> beats(first, first + grid.count[0]);
      std::vector<std::array<std::uint32_t, 3>> gradients;
      for (const auto& gradient : words(beats)) gradients.push_back(gradient);
      rows_.run(gradients_packet(0, row, gradients, to(kRowsDims)));
      const std::size_t middle = gradients.size() / 2;
      for (const bool second : {false, true}) {
        Grid half = row;
        half.start[0] +=
            static_cast<std::uint64_t>(second ? grid.step[0] * std::int64_t(middle) : 0);
        half.count[0] = static_cast<std::uint16_t>(second ? gradients.size() - middle : middle);
        if (half.count[0] == 0) continue;
        const auto some = gradients.begin() + static_cast<std::ptrdiff_t>(second ? middle : 0);
        const auto of_half = gradients_packet(1, half, {some, some + half.count[0]}, to(kRowsDims));
        rows_.run(of_half);
        in_halves.join(sums_of(of_half, half, half.count[0]));
      }
    }
    ASSERT_EQ(words(rows_.run(collect_packet(0))), expected) << round;
    ASSERT_EQ(words(rows_.run(collect_packet(1))), words_of(in_halves)) << round;
  }
  EXPECT_TRUE(rows_.events().empty());
}

// What came is added, and nothing of it is in the row behind.
TEST_F(ScatterRowsStream, APacketThatEndsWithinARowEndsIt) {
  const Grid grid = grid_between({0.25, 0.5, 2.5}, {7.75, 0.25, 0}, {5, 3, 2});
  const Packet packet = grid_packet_of(grid, to(kRowsDims));
  rows_.run(functions("bspline"));
  Places expected;
  std::uint32_t number = 1;
  for (std::size_t beats = 1; beats <= packet.size() + 2; ++beats) {
    const std::size_t came = std::min(beats < 4 ? 0 : beats - 4, vertex_count(grid));
    const auto last = static_cast<std::uint32_t>(beats - 1);
    rows_.run(sized(packet, beats));
    if (beats < packet.size()) expected.emplace_back(event::kPacketShort, number, last);
    if (beats > packet.size()) {
      expected.emplace_back(event::kPacketLong, number, static_cast<std::uint32_t>(packet.size()));
    }
    const auto cut = words(rows_.run(collect_packet(0)));
    ASSERT_EQ(cut, words_of(sums_of(packet, grid, came))) << beats;
    rows_.run(sized(packet, beats));
    if (beats < packet.size()) expected.emplace_back(event::kPacketShort, number + 2, last);
    if (beats > packet.size()) {
      expected.emplace_back(event::kPacketLong, number + 2,
                            static_cast<std::uint32_t>(packet.size()));
    }
    rows_.run(packet);
    ScatterPage both = sums_of(packet, grid, came);
    both.join(sums_of(packet, grid, vertex_count(grid)));
    ASSERT_EQ(words(rows_.run(collect_packet(0))), words_of(both)) << beats;
    number += 5;
  }
  EXPECT_EQ(places(rows_.events()), expected);
}

// A vertex where something along s saturates, and a layer where something along t or u does.
TEST_F(ScatterRowsStream, VerticesAndLayersThatSaturate) {
  const Grid grid = grid_between({0.25, 0.5, 0.5}, {2.75, 0.5, 0.75}, {3, 1, 2});
  const Packet packet = grid_packet_of(grid, to(kRowsDims));
  for (int axis = 0; axis < 3; ++axis) {
    ScatterStreamModel model(find_configuration(kRow), kAxisPoints, kPages, true);
    Packet steep = functions("bspline");
    // Three of 1.5 are more than a weight, whichever they are.
    const std::ptrdiff_t first = 1 + 4 * axis;
    for (std::ptrdiff_t function = 0; function < 4; ++function) {
      steep.begin()[first + function].words = {0x60000000, 0, 0, 0};
    }
    model.run(steep);
    Places expected = places(model.events());
    ASSERT_EQ(expected.size(), 1U) << "functions that do not sum up";
    model.run(packet);
    // Vertices in cells 0, 1 and 2, six layers a row.
    for (std::uint32_t beat = 4; beat < 10; ++beat) {
      if (axis == 0) expected.emplace_back(event::kSaturated, 1, beat);
      if (axis == 0 || beat % 3 != 0) continue;
      for (int layer = 0; layer < 6; ++layer) {
        expected.emplace_back(event::kSaturated, 1, beat);
      }
    }
    EXPECT_EQ(places(model.events()), expected) << "axis " << axis;
    for (const Beat& beat : model.run(collect_packet(0))) EXPECT_EQ(beat.words[3] >> 16, 1U);
  }
}

// It counts vertices, in the middle of a row as anywhere.
TEST_F(ScatterRowsStream, OverflowIsToldWithinARow) {
  ScatterStreamModel model(row_of("fx18"), kAxisPoints, kPages, true);
  model.run(functions("linear"));
  const Grid grid = grid_between({0, 0, 0}, {1, 0, 0}, {40'000, 2, 1});
  model.run(gradients_packet(0, grid, {80'000, {0x01000000, 0, 0}}, to(kRowsDims)));
  EXPECT_EQ(places(model.events()), (Places{{kOverflow, 1, 3 + 65'537}}));
  for (const Beat& beat : model.run(collect_packet(0))) {
    EXPECT_EQ(beat.words[3] >> 16, kStatusOverflowed >> 16);
  }
}

TEST_F(ScatterRowsStream, AResetEndsARow) {
  const Grid grid = grid_between({0.25, 0.5, 0.5}, {2.75, 0.5, 0.75}, {5, 2, 2});
  const Packet packet = grid_packet_of(grid, to(kRowsDims));
  ScatterStreamModel fresh(find_configuration(kRow), kAxisPoints, kPages, true);
  rows_.run(functions("bspline"));
  for (std::size_t beat = 0; beat < 7; ++beat) rows_.accept(packet[beat]);
  rows_.reset();
  for (ScatterStreamModel* each : {&rows_, &fresh}) {
    each->run(functions("bspline"));
    each->run(packet);
  }
  EXPECT_EQ(rows_.run(collect_packet(0)), fresh.run(collect_packet(0)));
  EXPECT_EQ(rows_.vertices(), 20U);
}

TEST(ScatterStreamModels, OfCoresThatThereAre) {
  EXPECT_THROW(ScatterStreamModel(find_configuration(kRow), 33), std::invalid_argument);
  EXPECT_THROW(ScatterStreamModel(row_of("fx19")), std::invalid_argument);
  EXPECT_NO_THROW(ScatterStreamModel(row_of("fx12"), 32, 5));
}

}  // namespace
}  // namespace hwffd::model
