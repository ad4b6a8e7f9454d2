// Where an event is told to be behind more packets, and in a longer one, than other tests have time
// for: bits of both numbers that they leave 0.
#include <gtest/gtest.h>

#include "system_run.hpp"

namespace hwffd::test {
namespace {

class LargestPacket : public ::testing::Test {
 protected:
  /// Vertices, of which the last one is outside.
  void send_vertices(std::uint32_t count) {
    auto vertices = random_vertices(run_.codec(), random_, lattice_.dims, count);
    vertices.back().local[0] = run_.codec().coordinate(1.25);
    run_.send(vertices_packet(vertices));
  }
  void expect_last(event::Code code, std::uint32_t packet, std::uint32_t beat) {
    ASSERT_TRUE(run_.run());
    EXPECT_EQ(run_.bench().events(), run_.events());
    const cores::EventPlace place = run_.bench().event_place(stream_event(code));
    EXPECT_EQ(place.packet, packet);
    EXPECT_EQ(place.beat, beat);
  }

  void SetUp() override {
    run_.send_bspline();
    run_.send(lattice_packet(lattice_));
  }

  SystemRun run_{find_configuration("basic-fx18-overlapped"), 1};  // quickly simulated
  tb::Random random_{1};
  LatticeWords lattice_ = random_lattice(run_.codec(), random_, 6);
};

TEST_F(LargestPacket, NumberOfAPacket) {
  constexpr std::uint32_t kPackets = (1U << 20) + 3;
  send_vertices(1);
  run_.send(std::vector<Beat>(kPackets, Beat{{0x77, 0, 0, 0}, true}));
  expect_last(event::kUnknownOpcode, 2 + kPackets, 0);
}

TEST_F(LargestPacket, PlaceOfABeat) {
  constexpr std::uint32_t kVertices = (1U << 18) + 1;
  send_vertices(kVertices);
  expect_last(event::kCoordinateOutside, 2, kVertices);
}

}  // namespace
}  // namespace hwffd::test
