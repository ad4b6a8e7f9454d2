// What the driver refuses to send to a core that was built without it, by the packet's header.
#include <gtest/gtest.h>

#include <string>

#include "hwffd/driver.hpp"
#include "hwffd/registers.h"
#include "hwffd/stream/opcodes.hpp"

namespace hwffd::test {
namespace {

/// With which parameter a core has each feature, by its bit.
constexpr const char* kParameters[] = {
    "PAGED = 1",       "AXIS above 32",   "FOURTH = 1", "SPANS above 1", "GRIDS = 1",
    "PACKED = 1",      "MARKS = 1",       "",           "RESIDENT = 1",  "INTERLEAVED = 1",
    "DERIVATIVES = 1", "DETERMINANT = 1", "HALVES = 1"};
constexpr std::uint32_t kToday = 0xF00;  // resident, interleaved, derivatives, determinant
constexpr std::uint32_t kEvery = 1U << 16, kFourth = 1U << 17, kPacked = 1U << 18,
                        kLarge = 1U << 19, kResult = 1U << 20, kInterrupt = 1U << 21,
                        kHalf = 1U << 22;
constexpr std::uint32_t kAll = 0x1FFF;
constexpr std::uint32_t kDerivativesFollow = 1U << 31;

CoreIdentity core_with(std::uint32_t features) {
  CoreIdentity core{};
  core.features = features;
  const unsigned most = (features & HWFFD_FEATURES_LARGE_MASK) != 0 ? 64 : 16;
  core.points_axis = (features & HWFFD_FEATURES_RESIDENT_MASK) != 0 ? most : 0;
  core.pages = 4;
  core.spans = 9;
  core.grid_limit = (features & HWFFD_FEATURES_GRIDS_MASK) != 0 ? 48 : 0;
  return core;
}

/// What is said of a packet; empty: it may be sent.
std::string complaint(const CoreIdentity& core, const PacketHeader& header) {
  try {
    check_packet(core, header);
  } catch (const DriverError& error) {
    return error.what();
  }
  return "";
}

/// A packet, and the features that it wants.
struct Wanted {
  PacketHeader header;
  std::uint32_t features;
};

constexpr std::uint32_t kPoints = 0x040506;
const Wanted kPackets[] = {
    {{1, 0, 0x3F, 0}, 0},
    {{1, 0, kDerivativesFollow, 0}, 0x400},
    {{2, 0, kPoints, 0}, 0x100},
    {{3, 5, 2, 0}, 0x100},
    {{3, 5, 0x100, 0}, 0x500},
    {{3, 5, 0x200, 0}, 0xD00},
    {{4, 5, 0, 0}, 0x200},
    {{4, 5, 0x101, 0}, 0x600},
    {{4, 5, 0x200, 0}, 0xE00},
    {{5 | 0x300, 0, kPoints, 0}, 0x101},
    {{5 | kLarge, 0, 0x404040, 0}, 0x103},
    {{5 | kFourth, 0, kPoints, 0}, 0x105},
    {{6, 2, 17, 0}, 0x101},
    {{7 | kEvery, 0, 0, 0}, 0x101},
    {{7 | kPacked, 2, 0x200, 0}, 0xD21},
    {{7 | kResult, 2, 0, 0}, 0x141},
    {{7 | kInterrupt, 2, 0, 0}, 0x141},
    {{7 | kHalf, 2, 0, 0}, 0x1101},
    {{8 | kHalf | 0x300, 0x10008, 0x200, 1}, 0x1D11},
    {{3 | kPacked, 5, 2, 0}, 0x120},
    {{8, 0x10008, 0x100, 1}, 0x510},
    {{8 | 0x300, 0x10008, 0, 1}, 0x111},
    {{9 | kEvery, 9, 0, 0}, 8},
    {{9, 4, kDerivativesFollow | 5 << 8, 0}, 0x408},
};

TEST(PacketCheck, AsksForNoMoreThanAPacketWants) {
  for (const Wanted& packet : kPackets) {
    // Lattices and vertices have somewhere to be, whatever else is not there.
    EXPECT_EQ(complaint(core_with(packet.features), packet.header), "") << packet.header[0];
    EXPECT_EQ(complaint(core_with(kAll), packet.header), "") << packet.header[0];
  }
}

TEST(PacketCheck, NamesEachFeatureThatIsMissing) {
  unsigned refused = 0;
  for (const Wanted& packet : kPackets) {
    for (unsigned bit = 0; bit < 13; ++bit) {
      const std::uint32_t feature = 1U << bit;
      const bool wanted = (packet.features & feature) != 0;
      // Opcodes 5 to 8 say pages or grids; the lattice behind them is the core's affair.
      if (!wanted || (bit == 8 && (packet.header[0] & 0xFF) > 4)) continue;
      const std::string said = complaint(core_with(kAll & ~feature), packet.header);
      const std::string cure = std::string("or build it with ") + kParameters[bit];
      EXPECT_NE(said.find("this core has no "), std::string::npos) << said;
      EXPECT_NE(said.find(cure), std::string::npos) << said << " / " << cure;
      ++refused;
    }
  }
  EXPECT_EQ(refused, 45U);
}

TEST(PacketCheck, SaysItInOneLine) {
  EXPECT_EQ(complaint(core_with(0x300), {3, 5, 0x100, 0}),
            "this core has no derivatives: ask for positions, or build it with DERIVATIVES = 1");
  EXPECT_EQ(complaint(core_with(0x100), {4, 5, 0, 0}),
            "this core has no interleaved vertices: send a lattice and its vertices, or build it "
            "with INTERLEAVED = 1");
  EXPECT_EQ(complaint(core_with(kToday), {2, 0, 0x111010, 0}),
            "17 points along axis u: this core takes 4 to 16; make the lattice smaller, or build "
            "with AXIS");
  EXPECT_EQ(complaint(core_with(kAll), {5, 0, 0x042804, 0}),
            "40 points along axis t: this core takes 4 to 32 without flag L of opcode 5");
  EXPECT_EQ(complaint(core_with(kAll), {5 | kLarge, 0, 0x044104, 0}),
            "65 points along axis t: this core takes 4 to 64; make the lattice smaller, or build "
            "with AXIS");
}

TEST(PacketCheck, KnowsTheLimits) {
  const CoreIdentity core = core_with(kAll & ~HWFFD_FEATURES_LARGE_MASK);
  for (const std::uint32_t points : {0x040403U, 0x040304U, 0x030404U, 0x040411U, 0x110404U}) {
    EXPECT_NE(complaint(core, {2, 0, points, 0}), "") << points;
    EXPECT_NE(complaint(core, {5, 0, points, 0}), "") << points;
  }
  for (const std::uint32_t opcode : {5U, 6U, 7U, 8U}) {
    const std::uint32_t counts = opcode == 8 ? 0x10001 : 1;
    EXPECT_EQ(complaint(core, {opcode | 0x300, counts, kPoints & 0x0F0F0F, 1}), "") << opcode;
    EXPECT_NE(complaint(core, {opcode | 0x400, counts, kPoints & 0x0F0F0F, 1}), "") << opcode;
  }
  for (const PacketHeader& header :
       {PacketHeader{8, 0x10000, 0, 1}, PacketHeader{8, 1, 0, 1}, PacketHeader{8, 0x10001, 0, 0}}) {
    EXPECT_NE(complaint(core, header), "") << "no vertex";
  }
  EXPECT_NE(complaint(core_with(kAll), {7 | kPacked | kLarge, 2, 0, 0}), "") << "P and L";
  EXPECT_NE(complaint(core_with(kAll), {7 | kHalf, 2, 0x100, 0}), "") << "H of derivatives";
  EXPECT_NE(complaint(core_with(kAll), {7 | kHalf, 2, 0x300, 0}), "") << "H of det J alone";
  EXPECT_NE(complaint(core_with(kAll), {7 | kHalf | kFourth, 2, 0, 0}), "") << "H and Q";
  EXPECT_EQ(complaint(core, {9, 4, 5 << 8, 0}), "");
  EXPECT_NE(complaint(core, {9, 5, 5 << 8, 0}), "");
  EXPECT_NE(complaint(core, {9, 0xFFFFFFFF, 1 << 8, 0}), "") << "no wrap";
  EXPECT_EQ(complaint(core, {3, 1, 0x300, 0}), "");
  EXPECT_NE(complaint(core, {0, 0, 0, 0}), "");
  EXPECT_NE(complaint(core, {kOpcodes + 1, 0, 0, 0}), "");
}

// Counts whose product is the limit, and one more of each; then limits that only the most reaches.
TEST(PacketCheck, RefusesGridsBeyondTheLimit) {
  constexpr std::uint32_t kMost = 0xFFFF;
  const auto grid = [](std::uint32_t s, std::uint32_t t, std::uint32_t u) {
    return PacketHeader{8, t << 16 | s, 0, u};
  };
  CoreIdentity core = core_with(kAll);
  EXPECT_EQ(complaint(core, grid(kMost, kMost, kMost)), "");
  const auto refused = [&](const PacketHeader& header) {
    return complaint(core, header).find("build with GRID_LIMIT") != std::string::npos;
  };
  for (core.grid_limit = 0; core.grid_limit <= 45; ++core.grid_limit) {
    const unsigned limit = core.grid_limit;
    const std::uint32_t s = 1U << (limit + 2) / 3, t = 1U << (limit + 1) / 3, u = 1U << limit / 3;
    EXPECT_EQ(complaint(core, grid(s, t, u)), "") << limit;
    for (const PacketHeader& more : {grid(s + 1, t, u), grid(s, t + 1, u), grid(s, t, u + 1)})
      EXPECT_TRUE(refused(more)) << limit;
  }
  for (core.grid_limit = 46; core.grid_limit < 48; ++core.grid_limit) {
    EXPECT_EQ(complaint(core, grid(kMost, kMost, 0x4000)), "");
    EXPECT_TRUE(refused(grid(kMost, kMost, kMost)));
  }
  core.grid_limit = 10;
  EXPECT_EQ(complaint(core, grid(25, 41, 1)),
            "a grid of 1025 vertices: this core takes 2^10; send it in parts, or build with "
            "GRID_LIMIT");
}

TEST(PacketCheck, KnowsTheFlagsOfEachOpcode) {
  const std::uint32_t flags[] = {0x0A, 0x02, 0x7F, 0x7A, 0x01};  // of opcodes 5 to 9
  for (std::uint32_t opcode = 1; opcode <= 9; ++opcode) {
    const std::uint32_t word = opcode <= 2 || opcode == 5 ? kPoints : 0;
    for (unsigned flag = 0; flag < 16; ++flag) {
      const bool known = opcode < 5 || (flags[opcode - 5] >> flag & 1) != 0;
      const PacketHeader header{opcode | 0x10000U << flag, 0x10001 & (opcode == 8 ? ~0U : 1U), word,
                                opcode == 8 ? 1U : 0U};
      EXPECT_EQ(complaint(core_with(kAll), header).empty(), known) << opcode << " " << flag;
    }
  }
}

}  // namespace
}  // namespace hwffd::test
