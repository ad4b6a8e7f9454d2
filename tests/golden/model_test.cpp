// The bit-true models against the oracle, and the properties that their weights must have.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "hwffd/model/organizations.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/numerics/fixed.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/stream/blending.hpp"
#include "named.hpp"
#include "random_vertex.hpp"

namespace hwffd {
namespace {

// docs/numerics.md section 6: the largest error over uniform points in [-1, 1).

class ModelAgainstOracle : public ::testing::TestWithParam<Bound> {};

TEST_P(ModelAgainstOracle, ErrorIsWithinTheStatedBound) {
  constexpr int kVertices = 100000;
  const Configuration& row = find_configuration(GetParam().row);
  const WordCodec codec(row.format);
  const auto model = model::make_evaluator_model(row);
  load(*model, encode(family(GetParam().family, codec), codec));
  const Oracle oracle(Oracle::family(GetParam().family));
  const double largest = largest_error(*model, codec, oracle, 1, kVertices);
  std::printf("%d vertices, largest error %.3g, bound %.3g\n", kVertices, largest,
              GetParam().error);
  EXPECT_LE(largest, GetParam().error);
  EXPECT_GE(8 * largest, GetParam().error) << "the bound says nothing";
}

INSTANTIATE_TEST_SUITE_P(
    , ModelAgainstOracle,
    ::testing::Values(Bound{"basic-fp32-overlapped", "bspline", 5e-7},
                      Bound{"basic-fx18-overlapped", "bspline", 1.3e-4},
                      Bound{"basic-fx32-overlapped", "bspline", 8e-9},
                      Bound{"factored-fp32-overlapped", "bspline", 3e-7},
                      Bound{"factored-fx18-overlapped", "bspline", 5e-5},
                      Bound{"factored-fx32-overlapped", "bspline", 3.5e-9},
                      Bound{"affine-fx17-overlapped", "bspline", 1e-4},
                      Bound{"affine-fx32-overlapped", "bspline", 3.5e-9},
                      Bound{"factored-fx18-overlapped-powers", "bspline", 4e-5},
                      Bound{"affine-fx17-overlapped-powers", "bspline", 8e-5},
                      Bound{"affine3-fx32-overlapped-powers", "bspline", 3e-9}),
    test::by_name);

class Determinism : public ::testing::TestWithParam<const char*> {};

/// What rounds alike: the product form in any order, `factored` however often it is folded.
bool in_product_form(const Configuration& row) {
  return organization_of(row).form == Form::kProduct;
}

// In fixed point sums are exact, so every organization in product form gives the same bits; in
// block floating point too, infinities and NaN among its points.
TEST_P(Determinism, OrganizationsAgreeInFixedPoint) {
  constexpr int kVertices = 100000;
  const WordCodec codec(GetParam());
  const AxisWords axis = encode(watertight_bspline(codec), codec);
  std::vector<std::unique_ptr<model::EvaluatorModel>> models;
  std::vector<std::string> names;
  for (const Configuration& row : configurations()) {
    if (row.format != std::string(GetParam()) || overlaps(row) != codec.is_block()) continue;
    if (!in_product_form(row)) continue;
    models.push_back(model::make_evaluator_model(row));
    names.emplace_back(row.name);
    load(*models.back(), axis);
  }
  if (codec.is_block()) {
    ASSERT_EQ(models.size(), 9U) << "basic, two cg, five trees, parallel";
  } else {
    ASSERT_EQ(models.size(), 10U) << "basic, two cg, six trees, parallel";
  }
  std::mt19937_64 engine(2);
  model::VertexWords words;
  for (int v = 0; v < kVertices; ++v) {
    for (int a = 0; a < 3; ++a) {
      words.local[a] = codec.coordinate(unit(engine));
      words.cell[a] = static_cast<int>(engine() & 15);
    }
    for (std::uint32_t& word : words.points) word = static_cast<std::uint32_t>(engine() >> 32);
    words.exponent = static_cast<int>(engine() % 256) - 127;  // of a random word
    const model::ResultWords first = models[0]->evaluate(0, words);
    for (std::size_t m = 1; m < models.size(); ++m) {
      const model::ResultWords other = models[m]->evaluate(0, words);
      ASSERT_EQ(other.words, first.words) << names[m] << ", vertex " << v;
      ASSERT_EQ(other.saturated, first.saturated) << names[m] << ", vertex " << v;
      ASSERT_EQ(other.nan, first.nan) << names[m] << ", vertex " << v;
    }
  }
  std::printf("%zu organizations, %d vertices\n", models.size(), kVertices);
}

INSTANTIATE_TEST_SUITE_P(, Determinism, ::testing::Values("fx18", "fx32", "bfp32"), test::by_name);

/// All weights of the watertight B-spline in `fxW` at a coordinate.
template <int W>
std::array<std::int64_t, 4> weights_at(const model::CoefficientBank<Fixed<W>>& bank,
                                       std::int64_t coordinate) {
  std::array<std::int64_t, 4> weights{};
  for (int l = 0; l < 4; ++l) {
    weights[l] = model::polynomial<Fixed<W>>(bank, 0, l, {coordinate, false}).value;
  }
  return weights;
}

// Every coordinate of fx18: weights one unit below 0 at most, their sum within 2 units of 1.
TEST(FixedWeights, PartitionOfUnityOverEveryCoordinateOfFx18) {
  const WordCodec codec("fx18");
  const AxisWords axis = encode(watertight_bspline(codec), codec);
  model::CoefficientBank<Fixed<18>> bank;
  for (int l = 0; l < 4; ++l) bank.load(0, l, axis.degree, axis.shift, axis.word[l]);
  constexpr std::int64_t kOne = 1 << 16;
  std::int64_t lowest = 0;
  std::int64_t off = 0;
  for (std::int64_t s = 0; s <= kOne; ++s) {
    const auto w = weights_at<18>(bank, s);
    lowest = std::min(lowest, *std::min_element(w.begin(), w.end()));
    off = std::max(off, std::abs(w[0] + w[1] + w[2] + w[3] - kOne));
  }
  EXPECT_GE(lowest, -1);
  EXPECT_LE(off, 2);
  // Exactly 1 at both ends, with the same three weights on either side of a face.
  const auto first = weights_at<18>(bank, 0);
  const auto last = weights_at<18>(bank, kOne);
  EXPECT_EQ(last[0], 0);
  EXPECT_EQ(first[3], 0);
  for (int l = 0; l < 3; ++l) EXPECT_EQ(first[l], last[l + 1]);
  EXPECT_EQ(first[0] + first[1] + first[2], kOne);
}

}  // namespace
}  // namespace hwffd
