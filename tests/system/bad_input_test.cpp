// Bad input of every event (docs/interface.md section 5): the event and the status it raises, no
// other, no hang, and the next packet exact.
#include <gtest/gtest.h>

#include "bad_packets.hpp"
#include "hwffd/model/organizations.hpp"
#include "hwffd/stream/blending.hpp"
#include "system_run.hpp"

namespace hwffd::test {
namespace {

class BadInput : public PerConfiguration {
 protected:
  std::vector<VertexBeat> vertices(std::size_t count) {
    return random_vertices(codec_, random_, lattice_.dims, count);
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
    for (unsigned e = 0; e < kStreamEvents; ++e) {
      EXPECT_EQ(run.bench().events()[e], e == stream_event(code) ? count : 0) << "event " << e;
    }
    place_ = run.bench().event_place(stream_event(code));
    results_ = run.bench().results();
    for (std::size_t v = 1; v <= 3; ++v) expect_status(results_.size() - v, 0);  // those after
  }

  /// The status of a result, and no other bit.
  void expect_status(std::size_t result, std::uint32_t status) {
    EXPECT_EQ(results_.at(result).words[3] >> 16, status >> 16) << "result " << result;
  }

  std::uint32_t blank() const { return codec_.is_float() ? 0x7FC00000U : 0U; }

  const WordCodec codec_{GetParam().format};
  tb::Random random_{1};
  LatticeWords lattice_ = random_lattice(codec_, random_, 6);
  std::vector<Beat> results_;
  cores::EventPlace place_;  ///< of the last event
};

TEST_P(BadInput, Packets) {
  for (const BadPacket& bad : bad_packets(codec_, random_, lattice_)) {
    SCOPED_TRACE(bad.name);
    expect_event(bad.code, 1, bad.packet);
    EXPECT_EQ(place_.packet, 3U);
    EXPECT_EQ(place_.beat, bad.beat);
    if (bad.status != 0) expect_status(3, bad.status);
    if (bad.code == kCoordinateNan) {
      EXPECT_EQ(results_.at(3).words[0], 0x7FC00000U);
    }
  }
}

// Each number that an axis of a lattice cannot have.
TEST_P(BadInput, NumbersOfPoints) {
  std::vector<Beat> packets;
  std::uint64_t bad = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (std::uint32_t points = 0; points < 256; ++points) {
      if (points >= 4 && points <= kAxisPoints) continue;
      std::vector<Beat> load = lattice_packet(lattice_);
      load.resize(2);
      load.back().last = true;
      const std::uint32_t place = 0xFFU << 8 * axis;
      load.front().words[2] = (load.front().words[2] & ~place) | points << 8 * axis;
      append(packets, load);
      ++bad;
    }
  }
  expect_event(kLatticeSize, bad, packets);
}

// Each bit of the number of vertices that a packet gives, where three come and none is the last.
TEST_P(BadInput, NumbersOfVertices) {
  std::vector<Beat> packets;
  std::uint64_t bad = 0;
  for (int bit = 2; bit < 32; ++bit) {
    for (std::uint32_t more = 0; more < 3; ++more) {
      std::vector<Beat> packet = vertices_packet(vertices(3));
      packet.front().words[1] = (std::uint32_t{1} << bit) + more;
      append(packets, packet);
      ++bad;
    }
  }
  expect_event(kPacketShort, bad, packets);
}

// Each event is told with its packet and its beat: of lattices that end anywhere, and of packets
// that are unknown and end anywhere.
TEST_P(BadInput, PlaceOfEachEvent) {
  const LatticeWords largest =
      random_lattice(codec_, random_, {kAxisPoints, kAxisPoints, kAxisPoints});
  const std::vector<Beat> whole = lattice_packet(largest);
  SystemRun run(GetParam(), 1, "always", "always");
  run.send_bspline();
  run.send(whole);
  std::uint32_t packets = 2;
  for (const std::uint32_t most : {1U, 3U, 20U, 100U, 1000U, 4000U}) {
    for (int i = 0; i < 8; ++i, packets += 2) {
      const bool unknown = random_.chance(0.3);
      std::vector<Beat> packet = whole;
      packet.resize(1 + random_.below(most));
      packet.back().last = true;
      if (unknown) packet.front().words[0] |= 0xFF;
      run.send(packet);
      run.send(vertices_packet(vertices(1)));
      ASSERT_TRUE(run.run());
      const Code code = unknown ? kUnknownOpcode : kPacketShort;
      const cores::EventPlace place = run.bench().event_place(stream_event(code));
      EXPECT_EQ(place.packet, packets);
      EXPECT_EQ(place.beat, unknown ? 0 : packet.size() - 1);
    }
  }
}

// A coordinate outside where it is told and nothing else saturates, of each axis.
TEST_P(BadInput, ACoordinateAloneIsFlagged) {
  for (auto& point : lattice_.points) point.fill(codec_.point(0.125));
  lattice_.exponent = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<VertexBeat> stray = vertices(3);
    stray[1].local[axis] = codec_.is_float() ? 0x3FC00000U : 0xA0000000U;
    SystemRun run(GetParam(), 1, "bernoulli", "bursts");
    run.send_bspline();
    run.send(lattice_packet(lattice_));
    run.send(vertices_packet(stray, OutsideMode::kPass));
    ASSERT_TRUE(run.run());
    EXPECT_EQ(run.bench().events(), run.events());
    EXPECT_EQ(run.bench().events()[stream_event(kCoordinateOutside)], 1U);
    EXPECT_EQ(run.bench().events()[stream_event(kSaturated)], codec_.has_fixed_weights());
    results_ = run.bench().results();
    expect_status(1, kStatusOutside | (codec_.has_fixed_weights() ? kStatusSaturated : 0U));
  }
}

// Told where the organization takes for granted what is not so, once an axis for functions and once
// for derivatives; words may be off by a few units.
TEST_P(BadInput, FunctionsThatDoNotSumToOne) {
  const bool wanted = completes(organization_of(GetParam()).form) && !wired_in(GetParam());
  std::array<AxisWords, 3> axes;
  for (AxisWords& axis : axes) axis = encode(family("catmull-rom", codec_), codec_);
  const auto expect_sum_events = [&](std::uint64_t count,
                                     const std::array<AxisWords, 3>& functions) {
    expect_event(kFunctionsSum, wanted ? count : 0,
                 coefficients_packet(functions, Functions::kDerivativesToo));
  };
  expect_sum_events(0, axes);
  for (const int first : {1, 2}) {
    auto hermite = axes;
    for (int a = first; a < 3; ++a) hermite[a] = encode(family("hermite", codec_), codec_);
    expect_sum_events(2 * (3 - first), hermite);
  }
  if (!wanted) return;
  for (int axis = 0; axis < 3; ++axis) {
    for (int power = 0; power < 4; ++power) {
      for (const bool derivative : {false, true}) {
        for (const int units : {-5, -4, 3, 4}) {
          SCOPED_TRACE(units);
          auto off = axes;
          auto& words = derivative ? off[axis].derivative.word : off[axis].word;
          words[random_.below(4)][power] += static_cast<std::uint32_t>(units);
          expect_sum_events(units < -4 || units > 3 ? 1 : 0, off);
        }
      }
    }
  }
}

// A power above the degree does not count, and neither do functions that came only in part.
TEST_P(BadInput, FunctionsOfALowDegreeSumToOne) {
  std::array<AxisWords, 3> axes;
  for (AxisWords& axis : axes) {
    axis = encode(family("linear", codec_), codec_);
    for (auto* words : {&axis.word, &axis.derivative.word}) {
      for (auto& function : *words)
        function[2] = function[3] = codec_.coefficient(random_.unit(), 0);
    }
  }
  expect_event(kFunctionsSum, 0, coefficients_packet(axes, Functions::kDerivativesToo));
  std::vector<Beat> cut = coefficients_packet(axes, Functions::kDerivativesToo);
  cut[7].words[0] += 99;  // function 2 of axis t, and the packet ends there
  cut.resize(8);
  cut.back().last = true;
  expect_event(kPacketShort, 1, cut);
}

TEST_P(BadInput, NothingLoaded) {
  expect_event(kNoCoefficients, 2, interleaved_packet(make_stimulus("random", codec_, 2, 1)),
               false);
  for (int v = 0; v < 2; ++v) {
    expect_status(v, kStatusUnloaded);
    EXPECT_EQ(results_.at(v).words[0], blank());
  }
}

TEST_P(BadInput, NoLattice) {
  std::vector<Beat> packets = coefficients_packet(watertight_bspline(codec_), codec_);
  append(packets, vertices_packet(vertices(4)));
  expect_event(kNoLattice, 4, packets, false);
  for (int v = 0; v < 4; ++v) expect_status(v, kStatusUnloaded);
}

TEST_P(BadInput, CellOutsideTheLattice) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int beyond : {lattice_.dims[axis] - 3, 15}) {
      std::vector<VertexBeat> stray = vertices(3);
      stray[1].cell[axis] = beyond;
      expect_event(kCellOutside, 1, vertices_packet(stray, OutsideMode::kClamp));
      expect_status(3, kStatusClamped | kStatusOutside);
      // Clamped is the same as the last cell at 1.
      std::vector<VertexBeat> inside = stray;
      inside[1].cell[axis] = lattice_.dims[axis] - 4;
      inside[1].local[axis] = codec_.coordinate(1);
      const Beat clamped = results_.at(3);
      expect_event(kCellOutside, 0, vertices_packet(inside));
      for (int c = 0; c < 3; ++c) EXPECT_EQ(clamped.words[c], results_.at(3).words[c]);
      expect_event(kCellOutside, 1, vertices_packet(stray, OutsideMode::kPass));
      expect_status(3, kStatusOutside);
      expect_event(kCellOutside, 1, vertices_packet(stray, OutsideMode::kBlank));
      expect_status(3, kStatusOutside);
      EXPECT_EQ(results_.at(3).words[0], blank());
    }
  }
}

// Nearest is the face on the same side, however little a coordinate is outside.
TEST_P(BadInput, CoordinateOutsideGoesToTheNearestFace) {
  const auto expect_as = [&](double value, double face) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<VertexBeat> stray = vertices(3);
      stray[1].local[axis] = codec_.coordinate(value);
      expect_event(kCoordinateOutside, 1, vertices_packet(stray));
      const Beat clamped = results_.at(3);
      stray[1].local[axis] = codec_.coordinate(face);
      expect_event(kCoordinateOutside, 0, vertices_packet(stray));
      for (int c = 0; c < 3; ++c) EXPECT_EQ(clamped.words[c], results_.at(3).words[c]) << value;
    }
  };
  for (const double value : {-0x1p-31, -0.25, -0.5}) expect_as(value, 0);
  for (const double value : {1 + 0x1p-23, 1.25, 1.49}) expect_as(value, 1);
}

TEST_P(BadInput, LastFaceIsInside) {
  std::vector<VertexBeat> face = vertices(3);
  for (int axis = 0; axis < 3; ++axis) {
    face[1].cell[axis] = lattice_.dims[axis] - 4;
    face[1].local[axis] = codec_.coordinate(1);
  }
  expect_event(kCellOutside, 0, vertices_packet(face));
  expect_status(3, 0);
}

HWFFD_FOR_EACH_CONFIGURATION(BadInput);

}  // namespace
}  // namespace hwffd::test
