// Control points from one family of blending functions to another (paper, section 3.1).
#include "hwffd/lattice/conversion.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "errors.hpp"
#include "hwffd/model/evaluator.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/stream/blending.hpp"
#include "uniform.hpp"

namespace hwffd {
namespace {

const std::array<const char*, 4> kCubics{"bspline", "bernstein", "hermite", "catmull-rom"};

Support random_support(std::mt19937_64& random) {
  Support support;
  for (int i = 0; i < 192; ++i) support(i / 3, i % 3) = 2 * unit(random) - 1;
  return support;
}

TEST(Conversion, BSplineToBezierAsPublished) {
  Eigen::Matrix4d expected;
  expected << 1, 4, 1, 0,  //
      0, 4, 2, 0,          //
      0, 2, 4, 0,          //
      0, 1, 4, 1;
  const auto k = conversion(Oracle::uniform_bspline(), Oracle::bernstein());
  EXPECT_LT((k - expected / 6).cwiseAbs().maxCoeff(), 1e-14);
}

// Every cubic family to every other along each axis, another pair on the next axis.
TEST(Conversion, BothFamiliesEvaluateAlike) {
  std::mt19937_64 random(1);
  int checked = 0;
  double largest = 0;
  for (int pair = 0; pair < 256; ++pair) {
    std::array<Oracle::Coefficients, 3> from;
    std::array<Oracle::Coefficients, 3> to;
    std::array<Eigen::Matrix4d, 3> k;
    for (int axis = 0; axis < 3; ++axis) {
      const int of_axis = pair * (2 * axis + 1) + 5 * axis;
      from[axis] = Oracle::family(kCubics[of_axis % 4]);
      to[axis] = Oracle::family(kCubics[of_axis / 4 % 4]);
      k[axis] = conversion(from[axis], to[axis]);
    }
    const Oracle before(from[0], from[1], from[2]);
    const Oracle after(to[0], to[1], to[2]);
    const Support support = random_support(random);
    const Support converted = convert(support, k);
    for (int v = 0; v < 10; ++v, ++checked) {
      const double s = unit(random);
      const double t = unit(random);
      const double u = unit(random);
      const double off = (before.evaluate(support, s, t, u) - after.evaluate(converted, s, t, u))
                             .cwiseAbs()
                             .maxCoeff();
      largest = std::max(largest, off);
    }
  }
  std::printf("%d vertices, largest difference %.3g\n", checked, largest);
  EXPECT_EQ(checked, 2560);
  EXPECT_LT(largest, 1e-12);
}

// From a family of lower degree there is a way, to one there is none.
TEST(Conversion, OnlyTowardsFamiliesThatSpanTheCubics) {
  const auto raised = conversion(Oracle::linear(), Oracle::bernstein());
  EXPECT_NEAR(raised(1, 1), 2.0 / 3, 1e-14);
  EXPECT_NEAR(raised(1, 2), 1.0 / 3, 1e-14);
  for (const char* name : {"linear", "constant"}) {
    EXPECT_ERROR_PART(conversion(Oracle::bernstein(), Oracle::family(name)),
                      "do not span the cubics");
  }
  Oracle::Coefficients twice = Oracle::bernstein();
  twice.row(2) = twice.row(1);
  EXPECT_THROW(conversion(Oracle::bernstein(), twice), Error);
  twice(2, 2) = std::nan("");
  EXPECT_THROW(conversion(Oracle::bernstein(), twice), Error);
}

struct Bound {
  const char* format;
  double difference;  ///< the limits of both families together
};
void PrintTo(const Bound& bound, std::ostream* out) { *out << bound.format; }

class ConvertedModel : public ::testing::TestWithParam<Bound> {};

// The bit-true model on B-spline points, and on Bezier points that give the same volume.
TEST_P(ConvertedModel, EvaluatesAlikeWithinTheBounds) {
  constexpr int kVertices = 5000;
  const std::string format = GetParam().format;
  const WordCodec codec(format);
  const auto model =
      model::make_evaluator_model(find_configuration("basic-" + format + "-overlapped"));
  const std::array<const char*, 2> names{"bspline", "bernstein"};
  for (int bank = 0; bank < 2; ++bank) {
    const AxisWords axis = encode(family(names[bank], codec), codec);
    for (int a = 0; a < 3; ++a) {
      for (int l = 0; l < 4; ++l) model->load(bank, a, l, axis.degree, axis.shift, axis.word[l]);
    }
  }
  const auto k = conversion(Oracle::uniform_bspline(), Oracle::bernstein());
  std::mt19937_64 random(1);
  double largest = 0;
  int checked = 0;
  for (; checked < kVertices; ++checked) {
    const Support support = random_support(random) / 2;
    const std::array<Support, 2> supports{support, convert(support, {k, k, k})};
    model::VertexWords words;
    for (std::uint32_t& word : words.local) word = codec.coordinate(unit(random));
    std::array<model::ResultWords, 2> results;
    for (int bank = 0; bank < 2; ++bank) {
      for (int i = 0; i < 192; ++i) words.points[i] = codec.point(supports[bank](i / 3, i % 3));
      results[bank] = model->evaluate(bank, words);
      EXPECT_FALSE(results[bank].saturated || results[bank].nan);
    }
    for (int c = 0; c < 3; ++c) {
      largest = std::max(largest, std::abs(codec.decode_point(results[0].words[c]) -
                                           codec.decode_point(results[1].words[c])));
    }
  }
  std::printf("%s: %d vertices, largest difference %.3g\n", format.c_str(), checked, largest);
  EXPECT_EQ(checked, kVertices);
  EXPECT_LE(largest, GetParam().difference);
  EXPECT_GT(largest, 0) << "nothing was rounded: the same points twice?";
}

INSTANTIATE_TEST_SUITE_P(, ConvertedModel,
                         ::testing::Values(Bound{"fp32", 5e-7}, Bound{"fx18", 2e-4},
                                           Bound{"fx32", 1.1e-8}),
                         [](const auto& info) { return info.param.format; });

TEST(Conversion, OperationsThatTheCoefficientFileSaves) {
  const auto count = [](const Eigen::Matrix4d& k) { return conversion_operations({k, k, k}); };
  // Any matrix: 3 axes x 16 rows x 3 components x (16 multiplications, 12 additions).
  const Operations full = count(Eigen::Matrix4d::Constant(0.25));
  EXPECT_EQ(full.multiplications, 2304);
  EXPECT_EQ(full.additions, 1728);
  const Operations bezier = count(conversion(Oracle::uniform_bspline(), Oracle::bernstein()));
  EXPECT_EQ(bezier.multiplications, 1440);
  EXPECT_EQ(bezier.additions, 864);
  const Operations none = count(conversion(Oracle::bernstein(), Oracle::bernstein()));
  EXPECT_EQ(none.multiplications, 0);
  EXPECT_EQ(none.additions, 0);
  for (const char* from : kCubics) {
    for (const char* to : kCubics) {
      const Operations o = count(conversion(Oracle::family(from), Oracle::family(to)));
      std::printf("%s -> %s: %d, %d\n", from, to, o.multiplications, o.additions);
      EXPECT_LE(o.multiplications, full.multiplications);
    }
  }
}

}  // namespace
}  // namespace hwffd
