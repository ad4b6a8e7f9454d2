// Packed vertices: two in a beat, with the bits of the same vertices sent one by one; and grids and
// packed vertices among packets of every kind.
#include <gtest/gtest.h>

#include <utility>

#include "bad_packets.hpp"
#include "expand_run.hpp"
#include "hwffd/model/schedule.hpp"
#include "named.hpp"

namespace hwffd::test {
namespace {

class Packed : public ::testing::TestWithParam<PageBuild> {
 protected:
  /// What a driver would send one by one.
  static std::vector<VertexBeat> single(const std::vector<PackedVertex>& vertices,
                                        const WordCodec& codec) {
    std::vector<VertexBeat> all;
    for (const PackedVertex& vertex : vertices) {
      all.push_back(unpacked(vertex, all.size(), codec));
    }
    return all;
  }
};

TEST_P(Packed, AreTheVerticesSentOneByOne) {
  for (std::uint64_t seed = tb::seed_from_environment(1), last = seed + 3; seed <= last; ++seed) {
    ExpandRun run(GetParam(), seed, seed % 2 == 0 ? "always" : "bursts",
                  seed % 3 == 0 ? "always" : "bernoulli");
    tb::Random random(seed);
    run.send_functions();
    const LatticeWords lattice = run.random_lattice(random, 8);
    run.send_lattice(lattice);
    std::vector<std::size_t> counts;
    for (std::size_t some = 1; some <= 12; ++some) {
      PageVertices how = run.random_flags(random, lattice);
      how.large = false;
      how.every = run.has(model::kPagesFeature) && random.chance(0.5);
      how.mode = static_cast<OutsideMode>(random.below(3));
      const auto vertices = random_packed(random, lattice.dims, some, true);
      run.send_packed(vertices, how);
      run.send_vertices(single(vertices, run.codec()), how);
      counts.push_back(run.results(some, how));
    }
    ASSERT_TRUE(run.run());
    ASSERT_TRUE(run.twice(counts));
    EXPECT_EQ(run.pulses(kGridCount), 0U);
  }
}

// Their words by hand: 0, a half, 1 and what lies beyond, along each axis, in each mode.
TEST_P(Packed, EndsOfACoordinate) {
  ExpandRun run(GetParam(), 1);
  tb::Random random(2);
  run.send_bspline();
  run.send_lattice(run.random_lattice(random, 5));
  struct Place {
    std::uint32_t packed;
    double value;
    bool outside;
  };
  const Place places[] = {{0, 0, false},           {1, 0x1p-16, false},
                          {0x8000, 0.5, false},    {0xFFFF, 1 - 0x1p-16, false},
                          {0x10000, 1, false},     {0x10001, 1 + 0x1p-16, true},
                          {0x17FFF, 1.4999, true}, {0x18000, 1.49999, true},
                          {0x1FFFF, 1.49999, true}};
  std::size_t outside = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Place& place : places) {
      PackedVertex vertex;
      vertex.local = {0x4000, 0x2000, 0xC000};
      vertex.local[axis] = place.packed;
      VertexBeat same;
      for (int a = 0; a < 3; ++a) {
        same.local[a] = run.codec().coordinate(a == axis ? place.value : vertex.local[a] / 65536.0);
      }
      run.send_packed({vertex});
      run.send_vertices({same});
      outside += place.outside ? 2 : 0;
    }
  }
  ASSERT_TRUE(run.run());
  for (std::size_t v = 0; v < run.bench().results().size(); v += 2) {
    EXPECT_TRUE(run.same(v, v + 1, 1));
  }
  EXPECT_EQ(run.pulses(kCoordinateOutside), outside);
}

// A half with bit 63 is no vertex: blank and flagged, one event each, its neighbours exact.
TEST_P(Packed, SpareBitsRefuseAVertex) {
  tb::Random random(3);
  for (std::size_t wrong = 0; wrong < 5; ++wrong) {
    ExpandRun run(GetParam(), 1, "bernoulli", "bursts");
    const LatticeWords lattice = run.random_lattice(random, 6);
    const auto vertices = random_packed(random, lattice.dims, 5);
    std::vector<Beat> packet = run.has(model::kPagesFeature)
                                   ? page_packed_packet(run.page(), vertices)
                                   : packed_packet(vertices);
    packet[1 + wrong / 2].words[1 + 2 * (wrong % 2)] |= 1U << 31;
    run.send_bspline();
    run.send_lattice(lattice);
    run.send(packet);
    run.send_packed(vertices);
    ASSERT_TRUE(run.run());
    for (unsigned e = 0; e < kStreamEvents; ++e) {
      EXPECT_EQ(run.bench().events()[e], e == stream_event(kGridCount) ? 1U : 0U) << "event " << e;
    }
    for (std::size_t v = 0; v < 5; ++v) {
      if (v != wrong) {
        EXPECT_TRUE(run.same(v, 5 + v, 1));
      }
    }
    EXPECT_EQ(run.bench().results()[wrong].words[3], wrong | kStatusUnloaded);
    EXPECT_EQ(run.bench().results()[wrong].words[0], run.codec().is_float() ? 0x7FC00000U : 0U);
  }
}

// Counts and ends: an odd one leaves a half that is not read, whatever it holds; a packet that ends
// early gives what came, one that ends late no more.
TEST_P(Packed, CountsAndEnds) {
  struct Ends {
    std::uint32_t count;
    std::size_t vertices;  ///< that are in the beats
    std::size_t results;
    Code code;
  };
  const Ends all[] = {
      {3, 3, 3, kUnknownOpcode}, {3, 4, 3, kUnknownOpcode}, {5, 3, 3, kPacketShort},
      {6, 4, 4, kPacketShort},   {3, 6, 3, kPacketLong},    {4, 5, 4, kPacketLong},
      {2, 7, 2, kPacketLong},    {1, 2, 1, kUnknownOpcode}, {0, 2, 0, kPacketShort}};
  tb::Random random(4);
  for (const Ends& ends : all) {
    SCOPED_TRACE(std::to_string(ends.count) + " of " + std::to_string(ends.vertices));
    ExpandRun run(GetParam(), 1, "bernoulli", "bursts");
    const LatticeWords lattice = run.random_lattice(random, 6);
    const auto vertices = random_packed(random, lattice.dims, ends.vertices);
    std::vector<Beat> packet = run.has(model::kPagesFeature)
                                   ? page_packed_packet(run.page(), vertices)
                                   : packed_packet(vertices);
    packet[0].words[1] = ends.count;
    run.send_bspline();
    run.send_lattice(lattice);
    run.send(packet);
    run.send_packed(vertices);
    ASSERT_TRUE(run.run());
    ASSERT_EQ(run.bench().results().size(), ends.results + ends.vertices);
    const bool bad = ends.code != kUnknownOpcode;
    for (unsigned e = 0; e < kStreamEvents; ++e) {
      EXPECT_EQ(run.bench().events()[e], bad && e == ends.code ? 1U : 0U) << "event " << e;
    }
    for (std::size_t v = 0; v < ends.results; ++v) {
      EXPECT_EQ(run.words(v, 1), run.words(ends.results + v, 1));
      EXPECT_EQ(run.bench().results()[v].last, v + 1 == ends.results);
    }
  }
}

TEST_P(Packed, HaveNoFlagL) {
  ExpandRun run(GetParam(), 1);
  if (!run.has(model::kPagesFeature)) GTEST_SKIP() << "no flags";
  tb::Random random(5);
  const LatticeWords lattice = run.random_lattice(random, 6);
  std::vector<Beat> packet = page_packed_packet(run.page(), random_packed(random, lattice.dims, 4));
  packet[0].words[0] |= kLargeFlag;
  run.send_bspline();
  run.send_lattice(lattice);
  run.send(packet);
  run.send_vertices(random_vertices(run.codec(), random, lattice.dims, 1));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.pulses(kUnknownOpcode), 1U);
  EXPECT_EQ(run.bench().results().size(), 1U);
}

// Two vertices a beat: the organization is fed as fast as by single ones.
TEST_P(Packed, ClocksOfAVertex) {
  ExpandRun run(GetParam(), 1);
  tb::Random random(6);
  const LatticeWords lattice = run.random_lattice(random, std::array<int, 3>{8, 8, 8});
  run.send_bspline();
  run.send_lattice(lattice);
  run.send_packed(random_packed(random, lattice.dims, 200));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.bench().clocks_per_result(39, 199), expected_interval(run.row()));
}

/// Grids, packed vertices and everything else, some of it wrong.
class AnyExpanded {
 public:
  AnyExpanded(ExpandRun& run, tb::Random& random) : run_(run), random_(random) {}

  void send(int packets) {
    for (int p = 0; p < packets; ++p) {
      switch (random_.below(5)) {
        case 0:
          lattice_ = run_.random_lattice(random_, 7);
          run_.send_lattice(lattice_);
          break;
        case 1:
          run_.send(random_packets(run_.codec(), random_, 1));
          break;
        case 2:
          run_.send(packed());
          break;
        default:
          run_.send(grid());
      }
    }
  }

 private:
  /// Most headers have no count that is more than it was: grids stay small.
  std::vector<Beat> grid() {
    std::vector<Beat> packet =
        grid_packet(random_grid(random_, lattice_.dims, 4), run_.page(), flags());
    if (!random_.chance(0.4)) return packet;
    Beat& any = packet[random_.below(packet.size())];
    switch (random_.below(5)) {
      case 0:
        return cut(std::move(packet));
      case 1:
        packet[0].words[random_.chance(0.5) ? 0 : 2] ^= 1U << random_.below(32);
        break;
      case 2:
        packet[0].words[1] &= random_.chance(0.5) ? 0xFFFFU : 0xFFFF0000U;
        break;
      case 3:
        if (&any != packet.data()) any.words[random_.below(4)] ^= 1U << random_.below(32);
        break;
      default:
        packet[0].words[0] ^= static_cast<std::uint32_t>(random_.below(4)) << 8;
    }
    return packet;
  }

  std::vector<Beat> packed() {
    PageVertices how = flags();
    how.large = false;
    how.every = run_.has(model::kPagesFeature) && random_.chance(0.5);
    how.mode = static_cast<OutsideMode>(random_.below(4));
    const auto vertices = random_packed(random_, lattice_.dims, random_.between(1, 9), true);
    std::vector<Beat> packet = run_.has(model::kPagesFeature)
                                   ? page_packed_packet(run_.page(), vertices, how)
                                   : packed_packet(vertices, how.mode, how.results);
    if (random_.chance(0.2)) packet.back().words[1] |= 1U << 31;
    if (random_.chance(0.2)) packet[0].words[1] = static_cast<std::uint32_t>(random_.below(9));
    return random_.chance(0.3) ? cut(std::move(packet)) : packet;
  }

  PageVertices flags() { return run_.random_flags(random_, lattice_); }

  std::vector<Beat> cut(std::vector<Beat> packet) {
    packet.back().last = false;
    packet.resize(1 + random_.below(packet.size() + 3));
    packet.back().last = true;
    return packet;
  }

  ExpandRun& run_;
  tb::Random& random_;
  LatticeWords lattice_ = run_.random_lattice(random_, 7);
};

TEST_P(Packed, AnyPacketsInAnyOrder) {
  std::array<std::uint64_t, kStreamEvents> events{};
  for (std::uint64_t seed = tb::seed_from_environment(1), last = seed + 5; seed <= last; ++seed) {
    ExpandRun run(GetParam(), seed, seed % 2 == 0 ? "always" : "bursts", "bernoulli");
    tb::Random random(seed);
    run.send(coefficients_packet(
        random_coefficients(run.codec(), random),
        run.has(model::kDerivativesFeature) ? Functions::kDerivativesToo : Functions::kBlending));
    AnyExpanded(run, random).send(80);
    ASSERT_TRUE(run.run());
    EXPECT_GT(run.bench().results().size(), 100U);
    for (int e = 0; e < kStreamEvents; ++e) events[e] += run.bench().events()[e];
  }
  for (const Code code : {kUnknownOpcode, kPacketShort, kPacketLong, kGridCount}) {
    EXPECT_GT(events[stream_event(code)], 0U) << "event " << code;
  }
}

INSTANTIATE_TEST_SUITE_P(, Packed, ::testing::ValuesIn(page_builds()), by_name);

}  // namespace
}  // namespace hwffd::test
