// Block floating point: its error in the model against the bounds proved of it, the exponent of a
// set of points, and how packets carry it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "bfp/study.hpp"
#include "hwffd/lattice/interleave.hpp"

namespace hwffd {
namespace {

TEST(BlockError, WithinItsBoundsAndWhatIsAskedOfIt) {
  constexpr std::int64_t kVertices = 100000;
  const std::vector<bfp::Result> results = bfp::study(kVertices, 1, [](double) {});
  ASSERT_EQ(results.size(), 6U) << "three distributions, two forms";
  for (const bfp::Result& r : results) {
    std::printf("%s, %s: %.4f ulp, bound %.4f\n", r.points.c_str(), r.form.c_str(), r.of_lattice,
                r.bound);
    EXPECT_EQ(r.vertices, kVertices);
    const bool all_large = r.points == "uniform in one binade";
    const double factored = all_large ? 0.53 : 0.52;
    EXPECT_LE(r.of_lattice, r.form == "factored" ? factored : 0.60) << r.points;
    EXPECT_LE(r.of_lattice, r.bound) << r.points;
    EXPECT_LT(r.bound, 1) << "no better than two roundings";
    EXPECT_GE(r.of_support, r.of_lattice) << r.points;
  }
  EXPECT_GT(results[0].of_lattice, 0.5) << "a rounding has half an ulp";
}

int exponent_of(double coordinate) {
  Points points = Points::Zero(3, 3);
  points(1, 2) = coordinate;
  return block_exponent(points);
}

TEST(BlockExponent, IsThatOfTheLargestWord) {
  EXPECT_EQ(exponent_of(0), 0);
  EXPECT_EQ(exponent_of(0.5), 0);
  EXPECT_EQ(exponent_of(-0.75), 0);
  EXPECT_EQ(exponent_of(1), 1);
  EXPECT_EQ(exponent_of(1 - 0x1p-24), 0);
  EXPECT_EQ(exponent_of(1 - 0x1p-30), 1) << "its word is 1";
  EXPECT_EQ(exponent_of(std::numeric_limits<float>::max()), 128);
  EXPECT_EQ(exponent_of(0x1p-149), -148);
  EXPECT_EQ(exponent_of(-HUGE_VAL), 0) << "an infinity fits any block";
  EXPECT_EQ(exponent_of(std::nan("")), 0);
}

TEST(BlockExponent, OnlyBlocksHaveOne) {
  const Points points = Points::Constant(64, 3, 100);
  EXPECT_EQ(Normalization::of(points, WordCodec("bfp32")).exponent(), 7);
  EXPECT_EQ(Normalization::of(points, WordCodec("bfp32")).to_stream({1, 2, 3}), Point(1, 2, 3));
  EXPECT_EQ(Normalization::of(points, WordCodec("fp32")).exponent(), 0);
  EXPECT_EQ(Normalization::of(points, WordCodec("fx18")).exponent(), 0);
}

TEST(BlockPackets, CarryTheExponentInWord3) {
  LatticeWords lattice{{4, 4, 4}, std::vector<std::array<std::uint32_t, 3>>(64), -5};
  EXPECT_EQ(lattice_packet(lattice)[0].words[3], 0x3FBU);
  std::vector<InterleavedVertex> vertices(2);
  vertices[0].exponent = vertices[1].exponent = 100;
  EXPECT_EQ(interleaved_packet(vertices)[0].words[3], 100U);
  vertices[1].exponent = 99;
  EXPECT_THROW(interleaved_packet(vertices), std::invalid_argument);
}

}  // namespace
}  // namespace hwffd
