// Bad input, a test an event (docs/interface.md section 5): the event and the status it raises, no
// other, no hang, and the next packet exact.
#include <gtest/gtest.h>

#include "system_run.hpp"

namespace hwffd::test {
namespace {

using namespace event;  // NOLINT: events are the words of these tests

class BadInput : public PerConfiguration {
 protected:
  BadInput() : random_(1), lattice_(random_lattice(WordCodec(GetParam().format), random_, 6)) {}

  std::vector<VertexBeat> vertices(std::size_t count) {
    return random_vertices(WordCodec(GetParam().format), random_, lattice_.dims, count);
  }

  /// Sends the packet after good ones and before good ones, and expects exactly `count` of one
  /// event.
  void expect_event(Code code, std::uint64_t count, const std::vector<Beat>& packet,
                    bool loaded = true) {
    SystemRun run(GetParam(), 1, "bernoulli", "bursts");
    if (loaded) {
      run.send_bspline();
      run.send(lattice_packet(lattice_));
      run.send(vertices_packet(vertices(2)));
    }
    run.send(packet);
    run.send_bspline();
    run.send(lattice_packet(lattice_));
    run.send(vertices_packet(vertices(3)));
    ASSERT_TRUE(run.run());
    for (int e = 0; e < kStreamEvents; ++e) {
      EXPECT_EQ(run.bench().events()[e], e == static_cast<int>(code) ? count : 0) << "event " << e;
    }
    results_ = run.bench().results();
    const std::size_t clean = results_.size() - 3;
    for (std::size_t v = clean; v < results_.size(); ++v) {
      EXPECT_EQ(results_[v].words[3] >> 16, 0U) << "the packet after";
    }
  }

  tb::Random random_;
  LatticeWords lattice_;
  std::vector<Beat> results_;
};

TEST_P(BadInput, UnknownOpcode) {
  std::vector<Beat> packet = vertices_packet(vertices(3));
  packet[0].words[0] = 0x77;
  expect_event(kUnknownOpcode, 1, packet);
}

TEST_P(BadInput, TooShort) {
  for (const std::vector<Beat>& whole :
       {lattice_packet(lattice_), vertices_packet(vertices(5)),
        coefficients_packet(watertight_bspline(WordCodec(GetParam().format)),
                            WordCodec(GetParam().format))}) {
    for (const std::size_t beats : {std::size_t{1}, std::size_t{2}, whole.size() - 1}) {
      std::vector<Beat> packet(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(beats));
      packet.back().last = true;
      expect_event(kPacketShort, 1, packet);
    }
  }
}

TEST_P(BadInput, NoVertices) {
  std::vector<Beat> packet = vertices_packet(vertices(1));
  packet[0].words[1] = 0;
  expect_event(kPacketShort, 1, packet);
}

TEST_P(BadInput, TooLong) {
  for (std::vector<Beat> packet : {lattice_packet(lattice_), vertices_packet(vertices(5))}) {
    packet.back().last = false;
    packet.resize(packet.size() + 3);
    packet.back().last = true;
    expect_event(kPacketLong, 1, packet);
  }
}

TEST_P(BadInput, NothingLoaded) {
  const WordCodec codec(GetParam().format);
  expect_event(kNoCoefficients, 2, interleaved_packet(make_stimulus("random", codec, 2, 1)), false);
  for (int v = 0; v < 2; ++v) EXPECT_EQ(results_[v].words[3] >> 16, kStatusUnloaded >> 16);
}

TEST_P(BadInput, NoLattice) {
  const WordCodec codec(GetParam().format);
  std::vector<Beat> packets = coefficients_packet(watertight_bspline(codec), codec);
  const std::vector<Beat> early = vertices_packet(vertices(4));
  packets.insert(packets.end(), early.begin(), early.end());
  expect_event(kNoLattice, 4, packets, false);
  for (int v = 0; v < 4; ++v) EXPECT_EQ(results_[v].words[3] >> 16, kStatusUnloaded >> 16);
}

TEST_P(BadInput, BadDimensions) {
  for (const std::uint32_t word : {0x040403U, 0x040304U, 0x110404U, 0xFF0404U, 0U}) {
    std::vector<Beat> packet = lattice_packet(lattice_);
    packet[0].words[2] = word;
    expect_event(kLatticeSize, 1, packet);
  }
}

TEST_P(BadInput, CellOutsideTheLattice) {
  const WordCodec codec(GetParam().format);
  for (int axis = 0; axis < 3; ++axis) {
    for (const int beyond : {lattice_.dims[axis] - 3, 15}) {
      std::vector<VertexBeat> stray = vertices(3);
      stray[1].cell[axis] = beyond;
      expect_event(kCellOutside, 1, vertices_packet(stray, OutsideMode::kClamp));
      EXPECT_EQ(results_[3].words[3] >> 16, (kStatusClamped | kStatusOutside) >> 16);
      // Clamped is the same as the last cell at 1.
      std::vector<VertexBeat> inside = stray;
      inside[1].cell[axis] = lattice_.dims[axis] - 4;
      inside[1].local[axis] = codec.coordinate(1);
      const Beat clamped = results_[3];
      expect_event(kCellOutside, 0, vertices_packet(inside));
      for (int c = 0; c < 3; ++c) EXPECT_EQ(clamped.words[c], results_[3].words[c]);
      expect_event(kCellOutside, 1, vertices_packet(stray, OutsideMode::kPass));
      EXPECT_EQ(results_[3].words[3] >> 16, kStatusOutside >> 16);
      expect_event(kCellOutside, 1, vertices_packet(stray, OutsideMode::kBlank));
      EXPECT_EQ(results_[3].words[3] >> 16, kStatusOutside >> 16);
      EXPECT_EQ(results_[3].words[0], codec.is_float() ? 0x7FC00000U : 0U);
    }
  }
}

TEST_P(BadInput, CoordinateOutside) {
  const WordCodec codec(GetParam().format);
  const std::vector<std::uint32_t> words =
      codec.is_float() ? std::vector<std::uint32_t>{0x3F800001U, 0xBF800000U, 0x80000001U}
                       : std::vector<std::uint32_t>{0x80000001U, 0xFFFFFFFFU};
  for (const std::uint32_t word : words) {
    std::vector<VertexBeat> stray = vertices(3);
    stray[1].local[2] = word;
    expect_event(kCoordinateOutside, 1, vertices_packet(stray));
    EXPECT_EQ(results_[3].words[3] >> 16, (kStatusClamped | kStatusOutside) >> 16);
    expect_event(kCoordinateOutside, 1, vertices_packet(stray, OutsideMode::kBlank));
    EXPECT_EQ(results_[3].words[3] >> 16, kStatusOutside >> 16);
  }
}

// Nearest is the face on the same side, however little a coordinate is outside.
TEST_P(BadInput, CoordinateOutsideGoesToTheNearestFace) {
  const WordCodec codec(GetParam().format);
  const auto expect_as = [&](double value, double face) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<VertexBeat> stray = vertices(3);
      stray[1].local[axis] = codec.coordinate(value);
      expect_event(kCoordinateOutside, 1, vertices_packet(stray));
      const Beat clamped = results_[3];
      stray[1].local[axis] = codec.coordinate(face);
      expect_event(kCoordinateOutside, 0, vertices_packet(stray));
      for (int c = 0; c < 3; ++c) EXPECT_EQ(clamped.words[c], results_[3].words[c]) << value;
    }
  };
  for (const double value : {-0x1p-31, -0.25, -0.5}) expect_as(value, 0);
  for (const double value : {1 + 0x1p-23, 1.25, 1.49}) expect_as(value, 1);
}

TEST_P(BadInput, CoordinateThatIsNoNumber) {
  const WordCodec codec(GetParam().format);
  if (!codec.is_float()) GTEST_SKIP() << "fixed point has none";
  for (const std::uint32_t word : {0x7FC00000U, 0xFF800001U, 0x7F800000U, 0xFF800000U}) {
    std::vector<VertexBeat> stray = vertices(3);
    stray[1].local[0] = word;
    expect_event(kCoordinateNan, 1, vertices_packet(stray));
    EXPECT_EQ(results_[3].words[3] >> 16, kStatusNan >> 16);
    EXPECT_EQ(results_[3].words[0], 0x7FC00000U);
  }
}

TEST_P(BadInput, LastFaceIsInside) {
  const WordCodec codec(GetParam().format);
  std::vector<VertexBeat> face = vertices(3);
  for (int axis = 0; axis < 3; ++axis) {
    face[1].cell[axis] = lattice_.dims[axis] - 4;
    face[1].local[axis] = codec.coordinate(1);
  }
  expect_event(kCellOutside, 0, vertices_packet(face));
  EXPECT_EQ(results_[3].words[3] >> 16, 0U);
}

HWFFD_FOR_EACH_CONFIGURATION(BadInput);

}  // namespace
}  // namespace hwffd::test
