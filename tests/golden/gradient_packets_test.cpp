// The packets of gradients and collects, word by word as docs/interface.md section 2 draws them.
#include <gtest/gtest.h>

#include <stdexcept>

#include "hwffd/stream/gradients.hpp"

namespace hwffd {
namespace {

using Words = std::array<std::uint32_t, 4>;

GradientBeats vertex(std::uint32_t first) {
  GradientBeats result;
  result.local = {first, first + 1, first + 2};
  result.cell = {17, 2, 31};
  result.tag = 0xFEDC;
  result.gradient = {first + 3, first + 4, first + 5};
  return result;
}

TEST(GradientPackets, VerticesAreTwoBeatsEach) {
  Gradients how;
  how.dims = {4, 5, 16};
  const auto plain = gradients_packet(3, {vertex(10), vertex(20)}, how);
  ASSERT_EQ(plain.size(), 5U);
  EXPECT_EQ(plain[0].words, (Words{0x30A, 2, 0x100504, 0}));
  EXPECT_EQ(plain[1].words, (Words{10, 11, 12, 0x5F21FEDC}));
  EXPECT_EQ(plain[2].words, (Words{13, 14, 15, 0}));
  EXPECT_EQ(plain[3].words, (Words{20, 21, 22, 0x5F21FEDC}));
  EXPECT_EQ(plain[4].words, (Words{23, 24, 25, 0}));
  for (int beat = 0; beat < 5; ++beat) EXPECT_EQ(plain[beat].last, beat == 4);
  how.along = 3;
  how.mode = OutsideMode::kBlank;
  how.begin = true;
  EXPECT_EQ(gradients_packet(255, {vertex(1)}, how)[0].words, (Words{0x80FF0A, 1, 0xE100504, 0}));
  const auto none = gradients_packet(0, std::vector<GradientBeats>{}, how);
  ASSERT_EQ(none.size(), 1U);
  EXPECT_TRUE(none[0].last);
}

TEST(GradientPackets, AGridHasItsAxesInFront) {
  const Grid grid = grid_between({0, 0.5, 1}, {1, 0.5, 0}, {2, 1, 3}, 0x1234);
  std::vector<std::array<std::uint32_t, 3>> gradients;
  for (std::uint32_t v = 0; v < 6; ++v) gradients.push_back({v, 10 + v, 20 + v});
  Gradients how;
  how.dims = {4, 4, 4};
  how.along = 1;
  how.begin = true;
  const auto packet = gradients_packet(2, grid, gradients, how);
  ASSERT_EQ(packet.size(), 10U);
  EXPECT_EQ(packet[0].words, (Words{0xC0020A, 0x10002, 0x4040404, 3}));
  const auto evaluated = grid_packet(grid, 2);
  for (int beat = 1; beat < 4; ++beat) EXPECT_EQ(packet[beat].words, evaluated[beat].words);
  EXPECT_EQ(packet[9].words, (Words{5, 15, 25, 0}));
  for (int beat = 0; beat < 10; ++beat) EXPECT_EQ(packet[beat].last, beat == 9);
  gradients.pop_back();
  EXPECT_THROW(gradients_packet(2, grid, gradients, how), std::invalid_argument);
}

TEST(GradientPackets, ACollectIsAHeader) {
  Collect how;
  EXPECT_EQ(collect_packet(1).at(0).words, (Words{0x10B, 0, 0, 0}));
  how.shift = 3;
  how.tag = 0xABCD;
  how.count = how.interrupt = true;
  const auto packet = collect_packet(255, how);
  ASSERT_EQ(packet.size(), 1U);
  EXPECT_EQ(packet[0].words, (Words{0x30FF0B, 0, 3, 0xABCD}));
  EXPECT_TRUE(packet[0].last);
}

TEST(GradientPackets, WhatNoHeaderCanName) {
  Gradients how;
  how.dims = {4, 4, 4};
  const auto packet = [&](int page) { return gradients_packet(page, {vertex(0)}, how); };
  EXPECT_NO_THROW(packet(0));
  EXPECT_THROW(packet(256), std::invalid_argument);
  EXPECT_THROW(packet(-1), std::invalid_argument);
  how.along = 4;
  EXPECT_THROW(packet(0), std::invalid_argument);
  how.along = 0;
  how.mode = OutsideMode::kPass;
  EXPECT_THROW(packet(0), std::invalid_argument);
  how.mode = OutsideMode::kClamp;
  how.dims[1] = 256;
  EXPECT_THROW(packet(0), std::invalid_argument);
  Collect collect;
  collect.shift = 4;
  EXPECT_THROW(collect_packet(0, collect), std::invalid_argument);
  EXPECT_THROW(collect_packet(256), std::invalid_argument);
}

}  // namespace
}  // namespace hwffd
