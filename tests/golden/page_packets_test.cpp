// The packets of pages, word by word as docs/interface.md section 2 draws them.
#include <gtest/gtest.h>

#include <stdexcept>

#include "hwffd/stream/packets.hpp"

namespace hwffd::test {
namespace {

using Words = std::array<std::uint32_t, 4>;

LatticeWords lattice(const std::array<int, 3>& dims) {
  LatticeWords words;
  words.dims = dims;
  for (int p = 0; p < dims[0] * dims[1] * dims[2]; ++p) {
    const auto value = static_cast<std::uint32_t>(16 * p);
    words.points.push_back({value, value + 1, value + 2});
  }
  return words;
}

TEST(PagePackets, Page) {
  LatticeWords words = lattice({4, 5, 6});
  words.exponent = -3;
  const auto plain = page_packet(3, words);
  EXPECT_EQ(plain.front().words, (Words{0x305, 120, 0x060504, 0x3FD}));
  EXPECT_EQ(plain[2].words, (Words{16, 17, 18, 0}));
  ASSERT_EQ(plain.size(), 121U);
  EXPECT_TRUE(plain.back().last && !plain[119].last);
  words.fourth.assign(120, 7);
  EXPECT_EQ(page_packet(255, words).front().words[0], 0x2FF05U);
  EXPECT_EQ(page_packet(255, words)[2].words, (Words{16, 17, 18, 7}));
  EXPECT_EQ(page_packet(0, lattice({4, 33, 4})).front().words[0], 0x80005U);
  EXPECT_EQ(page_packet(0, lattice({4, 32, 4})).front().words[0], 5U);
}

TEST(PagePackets, Points) {
  LatticeWords words = lattice({4, 4, 4});
  words.exponent = 5;
  const auto packet = points_packet(2, words, 63, 1);
  ASSERT_EQ(packet.size(), 2U);
  EXPECT_EQ(packet[0].words, (Words{0x206, 1, 63, 5}));
  EXPECT_EQ(packet[1].words, (Words{1008, 1009, 1010, 0}));
  EXPECT_TRUE(packet[1].last && !packet[0].last);
  words.fourth.assign(64, 9);
  EXPECT_EQ(points_packet(2, words, 10, 3)[0].words, (Words{0x20206, 3, 10, 5}));
  EXPECT_EQ(points_packet(2, words, 10, 3)[3].words, (Words{192, 193, 194, 9}));
  EXPECT_TRUE(points_packet(2, words, 64, 0)[0].last);
}

TEST(PagePackets, Vertices) {
  const std::vector<VertexBeat> vertices = {{{1, 2, 3}, {17, 2, 31}, 0xFEDC}};
  PageVertices how;
  EXPECT_EQ(page_vertices_packet(9, vertices)[0].words, (Words{0x907, 1, 0, 0}));
  EXPECT_EQ(page_vertices_packet(9, vertices)[1].words, (Words{1, 2, 3, 0x5F21FEDC}));
  EXPECT_EQ(vertices_packet(vertices)[1].words[3], 0x5F21FEDCU);
  how.mode = OutsideMode::kBlank;
  how.results = Results::kDerivatives;
  how.every = how.fourth = how.large = true;
  EXPECT_EQ(page_vertices_packet(9, vertices, how)[0].words, (Words{0xB0907, 0, 0x102, 0}));
  const std::uint32_t large = 17U << 14 | 2U << 20 | 31U << 26 | 0x3EDC;
  EXPECT_EQ(page_vertices_packet(9, vertices, how)[1].words, (Words{1, 2, 3, large}));
}

TEST(PagePackets, WhatCannotBeSent) {
  LatticeWords words = lattice({4, 4, 4});
  for (const int page : {-1, 256}) {
    EXPECT_THROW(page_packet(page, words), std::invalid_argument);
    EXPECT_THROW(points_packet(page, words, 0, 1), std::invalid_argument);
    EXPECT_THROW(page_vertices_packet(page, {}), std::invalid_argument);
  }
  EXPECT_THROW(points_packet(0, words, 64, 1), std::invalid_argument);
  EXPECT_THROW(points_packet(0, words, 65, 0), std::invalid_argument);
  EXPECT_THROW(points_packet(0, words, 1, ~std::size_t{0}), std::invalid_argument);
  words.fourth.resize(63);
  EXPECT_THROW(page_packet(0, words), std::invalid_argument);
  EXPECT_THROW(points_packet(0, words, 0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace hwffd::test
