// The packets of grids and of packed vertices, and the vertices that are made of them, against
// plain arithmetic.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "hwffd/stream/formats.hpp"
#include "hwffd/stream/grid.hpp"
#include "hwffd/stream/packed.hpp"

namespace hwffd {
namespace {

constexpr std::uint64_t kCell = std::uint64_t{1} << kGridFraction;
constexpr std::uint64_t kUnit = kCell >> kGridCoordinate;

/// Where a vertex is along an axis.
double place(const VertexBeat& vertex, int axis, const WordCodec& codec) {
  return vertex.cell[axis] + codec.decode_coordinate(vertex.local[axis]);
}

// The last vertex is exactly where it was asked for, whatever the count, and none is further from
// its place than half a unit and what the step's own rounding adds.
TEST(Grid, IsBetweenItsEnds) {
  const std::array<int, 3> dims{16, 16, 16};
  std::mt19937_64 random(1);
  for (const char* format : {"fp32", "fx32", "bfp32"}) {
    const WordCodec codec(format);
    for (const int count : {2, 3, 7, 100, 4096, 65535}) {
      const double first = std::ldexp(static_cast<double>(random() % (13 << 20)), -20);
      const double last = std::ldexp(static_cast<double>(random() % (13 << 20)), -20);
      const Grid grid = grid_between({first, 0, 13}, {last, 13, 0}, {count, 2, 3});
      ASSERT_TRUE(grid_fits(grid, dims));
      for (int n = 0; n < count; n += 1 + count / 50) {
        const VertexBeat vertex =
            grid_vertex(grid, dims, codec, {static_cast<std::uint32_t>(n), 0, 0});
        const double wanted = first + (last - first) * n / (count - 1);
        EXPECT_NEAR(place(vertex, 0, codec), wanted, 0x1p-25 + 0x1p-41 * n + 0x1p-40) << n;
      }
      const auto top = static_cast<std::uint32_t>(count - 1);
      const VertexBeat end = grid_vertex(grid, dims, codec, {top, 1, 2});
      EXPECT_EQ(place(end, 0, codec), last) << count;
      EXPECT_EQ(end.cell[1], 12);
      EXPECT_EQ(end.local[1], codec.coordinate(1));
      EXPECT_EQ(end.cell[2], 0);
      EXPECT_EQ(end.local[2], codec.coordinate(0));
    }
  }
}

TEST(Grid, CountsItsVerticesSFastest) {
  const WordCodec codec("fx18");
  const Grid grid = grid_between({0, 0, 0}, {1, 1, 1}, {3, 2, 4}, 0xFFFD);
  const auto vertices = grid_vertices(grid, {4, 4, 4}, codec);
  ASSERT_EQ(vertices.size(), 24U);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    EXPECT_EQ(vertices[v].tag, (0xFFFD + v) & 0xFFFF);
    EXPECT_EQ(vertices[v].local[0], codec.coordinate(static_cast<double>(v % 3) / 2));
    EXPECT_EQ(vertices[v].local[1], codec.coordinate(static_cast<double>(v / 3 % 2)));
  }
}

TEST(Grid, FitsOrNot) {
  const std::array<int, 3> dims{5, 4, 40};
  Grid grid;
  grid.count = {1, 1, 1};
  EXPECT_TRUE(grid_fits(grid, dims));
  grid.start = {2 * kCell + kUnit - 1, 0, 31 * kCell};
  EXPECT_TRUE(grid_fits(grid, dims, 32)) << "cut to the face; the 32nd cell has a name";
  grid.start[2] = 32 * kCell;
  EXPECT_FALSE(grid_fits(grid, dims, 32));
  EXPECT_TRUE(grid_fits(grid, {5, 4, 35}, 32)) << "the face that ends the 32nd";
  EXPECT_TRUE(grid_fits(grid, dims));
  grid.start[0] = 2 * kCell + kUnit;
  EXPECT_FALSE(grid_fits(grid, dims));
  grid.start[0] = 0;
  grid.step[0] = -1;
  EXPECT_TRUE(grid_fits(grid, dims)) << "a step that is not taken";
  grid.count[0] = 2;
  EXPECT_FALSE(grid_fits(grid, dims)) << "below 0 by the last bit";
  grid.step[0] = std::int64_t{1} << 62;
  grid.count[0] = 5;
  EXPECT_FALSE(grid_fits(grid, dims)) << "no wrap";
  EXPECT_THROW(grid_vertices(grid, dims, WordCodec("fp32")), std::invalid_argument);
  grid.count[0] = 0;
  EXPECT_FALSE(grid_fits(grid, dims));
}

TEST(Grid, PacketAndBack) {
  Grid grid;
  grid.start = {1, kCell + 2, ~std::uint64_t{0}};
  grid.step = {-1, std::int64_t{3} << 40, 5};
  grid.count = {0xFFFF, 2, 3};
  grid.tag = 0x1234;
  PageVertices how;
  how.results = Results::kDerivatives;
  how.fourth = how.large = how.count = how.interrupt = true;
  const auto packet = grid_packet(grid, 200, how);
  ASSERT_EQ(packet.size(), 4U);
  EXPECT_EQ(packet[0].words,
            (std::array<std::uint32_t, 4>{0x003AC808, 0x0002FFFF, 0x100, 0x12340003}));
  EXPECT_EQ(packet[1].words, (std::array<std::uint32_t, 4>{1, 0, 0xFFFFFFFF, 0xFFFFFFFF}));
  const Grid back = grid_of({packet[0], packet[1], packet[2], packet[3]});
  EXPECT_EQ(back.start, grid.start);
  EXPECT_EQ(back.step, grid.step);
  EXPECT_EQ(back.count, grid.count);
  EXPECT_EQ(back.tag, grid.tag);
  for (int b = 0; b < 4; ++b) EXPECT_EQ(packet[b].last, b == 3);
}

TEST(Grid, RefusesWhatItCannotSay) {
  EXPECT_THROW(grid_between({0, 0, 0}, {1, 1, 1}, {0, 1, 1}), std::invalid_argument);
  EXPECT_THROW(grid_between({0, 0, 0}, {1, 1, 1}, {1, 65536, 1}), std::invalid_argument);
  EXPECT_THROW(grid_between({0, -0.1, 0}, {1, 1, 1}, {1, 1, 1}), std::invalid_argument);
  EXPECT_THROW(grid_between({0, 0, 0}, {1, 1, NAN}, {1, 1, 1}), std::invalid_argument);
  PageVertices every;
  every.every = true;
  PageVertices passed;
  passed.mode = OutsideMode::kPass;
  EXPECT_THROW(grid_packet({}, 0, every), std::invalid_argument);
  EXPECT_THROW(grid_packet({}, 0, passed), std::invalid_argument);
  EXPECT_THROW(grid_packet({}, 256), std::invalid_argument);
}

TEST(PackedVertices, AreTheNearest) {
  for (const char* format : {"fp32", "fx18", "bfp32"}) {
    const WordCodec codec(format);
    VertexBeat vertex;
    vertex.local = {codec.coordinate(0.3), codec.coordinate(1), codec.coordinate(1.25)};
    vertex.cell = {15, 0, 7};
    const PackedVertex small = packed(vertex, codec);
    EXPECT_EQ(small.local, (std::array<std::uint32_t, 3>{19661, 0x10000, 0x10000}));
    EXPECT_EQ(packed_bits(small), 0x3878000200004CCDU | std::uint64_t{0x10000} << 34);
    const VertexBeat back = unpacked(vertex_of_bits(packed_bits(small)), 0x10005, codec);
    EXPECT_EQ(back.cell, vertex.cell);
    EXPECT_EQ(back.tag, 5);
    EXPECT_EQ(codec.decode_coordinate(back.local[0]), 19661 / 65536.0);
    vertex.cell[1] = 16;
    EXPECT_THROW(packed(vertex, codec), std::invalid_argument);
  }
}

TEST(PackedVertices, LieTwoInABeat) {
  const std::vector<PackedVertex> three(3);
  const auto packet = packed_packet(three, OutsideMode::kBlank, Results::kDeterminant);
  ASSERT_EQ(packet.size(), 3U);
  EXPECT_EQ(packet[0].words, (std::array<std::uint32_t, 4>{0x40003, 3, 0x202, 0}));
  EXPECT_EQ(packet[2].words, (std::array<std::uint32_t, 4>{0, 0, 0xFFFFFFFF, 0xFFFFFFFF}));
  for (int b = 0; b < 3; ++b) EXPECT_EQ(packet[b].last, b == 2);
  EXPECT_TRUE(packed_packet({})[0].last);
  PageVertices how;
  how.every = true;
  EXPECT_EQ(page_packed_packet(9, three, how)[0].words,
            (std::array<std::uint32_t, 4>{0x50907, 0, 0, 0}));
  how.large = true;
  EXPECT_THROW(page_packed_packet(9, three, how), std::invalid_argument);
}

}  // namespace
}  // namespace hwffd
