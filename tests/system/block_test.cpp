// What only block floating point has: an exponent for all points of a lattice, infinities and NaN
// beside fixed-point numbers. Every bit against the model, and values against what they must be.
#include <gtest/gtest.h>

#include <cmath>

#include "hwffd/numerics/bits.hpp"
#include "system_run.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint32_t kPlus = 0x7F800000U;
constexpr std::uint32_t kMinus = 0xFF800000U;
constexpr std::uint32_t kNan = 0x7FC00000U;

class Block : public PerConfiguration {
 protected:
  /// The results of a packet behind coefficients of all axes.
  std::vector<Beat> results(const Blending& blending, const std::vector<Beat>& packets) {
    SystemRun run(GetParam(), tb::seed_from_environment(1));
    run.send(coefficients_packet(blending, codec_));
    run.send(packets);
    EXPECT_TRUE(run.run());
    return run.bench().results();
  }
  std::vector<Beat> bspline_results(const std::vector<InterleavedVertex>& vertices) {
    return results(watertight_bspline(codec_), interleaved_packet(vertices));
  }
  InterleavedVertex inside(double s) {
    InterleavedVertex vertex = random_vertex(codec_, random_);
    for (std::uint32_t& word : vertex.local) word = codec_.coordinate(s);
    return vertex;
  }

  WordCodec codec_{GetParam().format};
  tb::Random random_{tb::seed_from_environment(1)};
};

/// Points that are no numbers, by place in the support, and what x of the result is for it.
struct Special {
  const char* what;
  double coordinate;  ///< s, t and u
  std::vector<std::pair<int, std::uint32_t>> points;
  std::uint32_t x;
};

TEST_P(Block, InfinitiesAndNansByClass) {
  const std::vector<Special> cases{
      {"infinity", 0.5, {{21, kPlus}}, kPlus},
      {"infinity below 0", 0.5, {{0, kMinus}}, kMinus},
      {"NaN", 0.5, {{63, 0x7F800001U}}, kNan},
      {"NaN with a sign and a payload", 0.5, {{1, 0xFFFFFFFFU}}, kNan},
      {"two infinities of a sign", 0.5, {{3, kMinus}, {60, kMinus}}, kMinus},
      {"of both signs", 0.5, {{3, kMinus}, {60, kPlus}}, kNan},
      {"infinity and NaN", 0.5, {{62, kPlus}, {63, kNan}}, kNan},
      {"infinity times 0", 0, {{63, kPlus}}, kNan},
      {"infinity times 0, the other end", 1, {{0, kMinus}}, kNan},
      {"infinity at an end where its weight is not 0", 0, {{0, kPlus}}, kPlus},
  };
  std::vector<InterleavedVertex> vertices;
  for (const Special& c : cases) {
    InterleavedVertex vertex = inside(c.coordinate);
    for (const auto& [place, word] : c.points) vertex.points[3 * place] = word;
    vertices.push_back(vertex);
    vertices.push_back(inside(0.25));
  }
  const std::vector<Beat> got = bspline_results(vertices);
  ASSERT_EQ(got.size(), 2 * cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Beat& result = got[2 * i];
    EXPECT_EQ(result.words[0], cases[i].x) << cases[i].what;
    EXPECT_EQ(result.words[3] >> 16, cases[i].x == kNan ? kStatusNan >> 16 : 0U) << cases[i].what;
    for (int c = 1; c < 3; ++c) EXPECT_LT(std::abs(float_of_bits(result.words[c])), 1.0F);
    for (int c = 0; c < 3; ++c) EXPECT_LT(std::abs(float_of_bits(got[2 * i + 1].words[c])), 1.0F);
  }
}

// Catmull-Rom's outer weights are below 0 inside: of one of them an infinity changes its sign, of
// two (place 0 is outer on all axes: three) it is the product's sign that counts.
TEST_P(Block, TheSignOfTheWeightCounts) {
  std::vector<InterleavedVertex> vertices(3, inside(0.5));
  vertices[0].points[3 * (0 * 16 + 1 * 4 + 1)] = kPlus;
  vertices[1].points[3 * (0 * 16 + 0 * 4 + 1)] = kPlus;
  vertices[2].points[3 * 0] = kPlus;
  const auto got = results(family("catmull-rom", codec_), interleaved_packet(vertices));
  ASSERT_EQ(got.size(), 3U);
  EXPECT_EQ(got[0].words[0], kMinus);
  EXPECT_EQ(got[1].words[0], kPlus);
  EXPECT_EQ(got[2].words[0], kMinus);
}

// An infinity in a resident lattice reaches the cells whose support holds it, and no other.
TEST_P(Block, AnInfinityInALatticeStaysInItsCells) {
  LatticeWords lattice;
  lattice.dims = {4, 4, 9};
  lattice.points.resize(4 * 4 * 9);
  for (auto& point : lattice.points) {
    for (std::uint32_t& word : point) word = codec_.point(random_.unit());
  }
  lattice.points[4][1] = kMinus;  // (0, 0, 4): cells 1 to 4 along u
  std::vector<VertexBeat> vertices(6);
  for (int k = 0; k < 6; ++k) {
    vertices[k].cell = {0, 0, k};
    for (std::uint32_t& word : vertices[k].local) word = codec_.coordinate(0.5);
  }
  std::vector<Beat> packets = lattice_packet(lattice);
  const std::vector<Beat> reading = vertices_packet(vertices);
  packets.insert(packets.end(), reading.begin(), reading.end());
  const auto got = results(watertight_bspline(codec_), packets);
  ASSERT_EQ(got.size(), 6U);
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(got[k].words[1] == kMinus, k >= 1 && k <= 4) << "cell " << k;
    EXPECT_TRUE(std::isfinite(float_of_bits(got[k].words[0]))) << "cell " << k;
  }
}

// One point beyond the block saturates, as if it were the largest that fits, and says so.
TEST_P(Block, ATooSmallExponentSaturatesAndIsFlagged) {
  std::vector<InterleavedVertex> vertices(3, inside(0.5));
  for (InterleavedVertex& vertex : vertices) {
    for (std::uint32_t& word : vertex.points) word = codec_.point(random_.unit() / 2);
  }
  vertices[1].points = vertices[0].points;
  vertices[1].points[3 * 21] = codec_.point(3);
  vertices[2].points = vertices[0].points;
  vertices[2].points[3 * 21] = 0x3F7FFFFFU;
  const std::vector<Beat> got = bspline_results(vertices);
  ASSERT_EQ(got.size(), 3U);
  EXPECT_EQ(got[0].words[3] >> 16, 0U);
  EXPECT_EQ(got[1].words[3] >> 16, kStatusSaturated >> 16);
  EXPECT_EQ(got[2].words[3] >> 16, 0U);
  EXPECT_NEAR(float_of_bits(got[1].words[0]), float_of_bits(got[2].words[0]), 0x1p-24);
}

// Points and exponent times a power of two: the same significands come out, whichever the block.
TEST_P(Block, TheExponentOnlyScales) {
  const std::vector<InterleavedVertex> vertices = {inside(0.3), inside(0.7), inside(0)};
  const std::vector<Beat> expected = bspline_results(vertices);
  std::size_t compared = 0;
  for (const int exponent : {-90, -1, 1, 17, 120}) {
    std::vector<InterleavedVertex> scaled = vertices;
    for (InterleavedVertex& vertex : scaled) {
      vertex.exponent = exponent;
      for (std::uint32_t& word : vertex.points) {
        word = codec_.point(std::ldexp(codec_.decode_point(word), exponent));
      }
    }
    const std::vector<Beat> got = bspline_results(scaled);
    ASSERT_EQ(got.size(), expected.size());
    for (std::size_t v = 0; v < got.size(); ++v) {
      for (int c = 0; c < 3; ++c, ++compared) {
        EXPECT_EQ(codec_.decode_point(got[v].words[c]),
                  std::ldexp(codec_.decode_point(expected[v].words[c]), exponent));
      }
    }
  }
  EXPECT_EQ(compared, 45U);
}

// The ends of binary32: subnormal results are rounded once, results beyond it are infinities, which
// are nothing that saturated.
TEST_P(Block, SubnormalAndOverflow) {
  const Blending larger = user_blending({{{1.25, 0, 0, 0}, {}, {}, {}}});
  std::vector<InterleavedVertex> low = {inside(0.5)};
  low[0].exponent = -126;
  for (std::uint32_t& word : low[0].points) word = 5;
  low[0].points[0] = 0x80000001U;
  std::vector<InterleavedVertex> high = {inside(0.5)};
  high[0].exponent = 128;
  for (std::uint32_t& word : high[0].points) word = 0x7F000000U;
  high[0].points[0] = 0xFF000000U;
  std::vector<Beat> packets = interleaved_packet(low);
  const std::vector<Beat> more = interleaved_packet(high);
  packets.insert(packets.end(), more.begin(), more.end());
  const std::vector<Beat> got = results(larger, packets);
  ASSERT_EQ(got.size(), 2U);
  // 1.25^3 = 1.953125, times 5 is 9.77 units of the least subnormal.
  EXPECT_EQ(got[0].words[0], 0x80000002U);
  EXPECT_EQ(got[0].words[1], 10U);
  EXPECT_EQ(got[1].words[1], 0x7F7A0000U) << "1.953125 x 2^127 still fits";
  EXPECT_EQ(got[1].words[3] >> 16, 0U);
  for (std::uint32_t& word : high[0].points) word = 0x7F19999AU;  // 1.2 x 2^127
  high[0].points[0] |= 0x80000000U;
  const std::vector<Beat> beyond = results(larger, interleaved_packet(high));
  ASSERT_EQ(beyond.size(), 1U);
  EXPECT_EQ(beyond[0].words[0], kMinus);
  EXPECT_EQ(beyond[0].words[2], kPlus);
  EXPECT_EQ(beyond[0].words[3] >> 16, 0U);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Block);  // a build of tier sim has no such row
HWFFD_FOR_EACH_CONFIGURATION(Block, "bfp32");

}  // namespace
}  // namespace hwffd::test
