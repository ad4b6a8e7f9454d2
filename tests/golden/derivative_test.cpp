// The derivatives of the bit-true models: their functions, their values and det J against the
// oracle, finite differences (docs/numerics.md section 9).
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "hwffd/numerics/fixed.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/stream/blending.hpp"
#include "named.hpp"
#include "random_vertex.hpp"

namespace hwffd {
namespace {

/// The model of a row with one family on all axes.
class Device {
 public:
  Device(const std::string& row, const std::string& name)
      : codec_(find_configuration(row).format),
        model_(model::make_evaluator_model(find_configuration(row))),
        axis_(encode(family(name, codec_), codec_)) {
    load(*model_, axis_);
  }

  const WordCodec& codec() const { return codec_; }
  int exponent() const { return axis_.derivative.exponent; }
  /// Fixed point: det J times 2^-determinant_shift() is what comes.
  int determinant_shift() const {
    return codec_.has_fixed_weights() ? model::kDeterminantShift + 3 * exponent() : 0;
  }
  const model::EvaluatorModel& model() const { return *model_; }

  /// dq along an axis times 2^-exponent().
  Eigen::Vector3d derivative(const Vertex& vertex, int axis) const {
    model::VertexWords words = vertex.words;
    words.derivative = axis;
    const model::ResultWords result = model_->evaluate(0, words);
    EXPECT_FALSE(result.saturated || result.nan);
    Eigen::Vector3d value;
    for (int c = 0; c < 3; ++c) value[c] = codec_.decode_point(result.words[c]);
    return value;
  }

 private:
  WordCodec codec_;
  std::unique_ptr<model::EvaluatorModel> model_;
  AxisWords axis_;
};

TEST(DerivativeFunctions, AreExactInEveryFormat) {
  const std::vector<std::pair<std::string, int>> exponents{{"bspline", 1}, {"bernstein", 3},
                                                           {"hermite", 2}, {"catmull-rom", 2},
                                                           {"linear", 1},  {"constant", 0}};
  for (const auto& [name, exponent] : exponents) {
    const Oracle::Coefficients functions = Oracle::family(name);
    for (const std::string format : {"fp32", "fx12", "fx18", "fx27", "fx32"}) {
      const WordCodec codec(format);
      const AxisWords axis = encode(family(name, codec), codec);
      EXPECT_EQ(axis.derivative.exponent, codec.has_fixed_weights() ? exponent : 0)
          << name << format;
      EXPECT_EQ(axis.derivative.shift, 0) << name << format;
      for (int l = 0; l < 4; ++l) {
        for (int power = 0; power < 4; ++power) {
          const double exact = power < 3 ? (power + 1) * functions(l, power + 1) : 0.0;
          // A point's word is Q1.31, a coefficient's Q2.30.
          const double value = codec.decode_point(axis.derivative.word[l][power]) *
                               (codec.has_fixed_weights() ? std::ldexp(2.0, exponent) : 1.0);
          EXPECT_NEAR(value, exact, 1e-15) << name << ' ' << format;
        }
      }
    }
  }
}

// A user's functions: the exponent is the smallest that holds the sum of magnitudes.
TEST(DerivativeFunctions, ExponentOfAUsersFunctions) {
  EXPECT_EQ(derivative_exponent(user_blending({{{1, -1}, {0, 1}, {}, {}}})), 1);
  EXPECT_EQ(derivative_exponent(user_blending({{{0, 0.5}, {0, -0.5}, {}, {}}})), 0);
  EXPECT_EQ(derivative_exponent(user_blending({{{0, 0.51}, {0, -0.5}, {}, {}}})), 1);
  EXPECT_EQ(derivative_exponent(user_blending({{{0, 4, -4}, {}, {}, {}}})), 2);
  EXPECT_EQ(derivative_exponent(user_blending({{{7}, {}, {}, {}}})), 0);
}

// Of dq times 2^-exponent, points in [-1/2, 1/2).
class DerivativeAgainstOracle : public ::testing::TestWithParam<Bound> {};

TEST_P(DerivativeAgainstOracle, ErrorIsWithinTheStatedBound) {
  constexpr int kVertices = 20000;
  const Device device(GetParam().row, GetParam().family);
  const Oracle oracle(Oracle::family(GetParam().family));
  std::mt19937_64 engine(1);
  double largest = 0;
  for (int v = 0; v < kVertices; ++v) {
    const Vertex vertex = random_vertex(device.codec(), 0.5, engine);
    const Eigen::Matrix3d exact =
        std::ldexp(1.0, -device.exponent()) * oracle.jet(vertex.support, vertex.local).jacobian;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d error = device.derivative(vertex, axis) - exact.col(axis);
      largest = std::max(largest, error.cwiseAbs().maxCoeff());
    }
  }
  std::printf("%d vertices, largest error %.3g, bound %.3g\n", kVertices, largest,
              GetParam().error);
  EXPECT_LE(largest, GetParam().error);
  EXPECT_GE(2 * largest, GetParam().error) << "the bound says nothing";
}

INSTANTIATE_TEST_SUITE_P(, DerivativeAgainstOracle,
                         ::testing::Values(Bound{"basic-fp32-overlapped", "bspline", 2.9e-7},
                                           Bound{"basic-fx18-overlapped", "bspline", 7e-5},
                                           Bound{"basic-fx32-overlapped", "bspline", 4.2e-9},
                                           Bound{"factored-fp32-overlapped", "bspline", 1.4e-7},
                                           Bound{"factored-fx18-overlapped", "bspline", 1.9e-5},
                                           Bound{"factored-fx32-overlapped", "bspline", 1.4e-9},
                                           Bound{"basic-fp32-overlapped", "bernstein", 1.4e-6},
                                           Bound{"basic-fx18-overlapped", "bernstein", 7.5e-5},
                                           Bound{"basic-fx32-overlapped", "bernstein", 4.6e-9},
                                           Bound{"basic-fp32-overlapped", "hermite", 1e-6},
                                           Bound{"basic-fx18-overlapped", "hermite", 8e-5},
                                           Bound{"basic-fx32-overlapped", "hermite", 5e-9},
                                           Bound{"basic-fp32-overlapped", "catmull-rom", 1.2e-6},
                                           Bound{"basic-fx18-overlapped", "catmull-rom", 7e-5},
                                           Bound{"basic-fx32-overlapped", "catmull-rom", 5e-9}),
                         test::by_name);

struct RowBounds {
  const char* name;
  double difference;   ///< of dq from central differences
  double determinant;  ///< of the word of det J
};
void PrintTo(const RowBounds& bounds, std::ostream* out) { *out << bounds.name; }

class DerivativeOfRow : public ::testing::TestWithParam<RowBounds> {};

// Central differences of positions in double; their own error is below 1e-8 here.
TEST_P(DerivativeOfRow, IsTheFiniteDifference) {
  constexpr double kStep = 1e-4;
  const Device device(GetParam().name, "bspline");
  const Oracle oracle;
  std::mt19937_64 engine(2);
  for (int v = 0; v < 2000; ++v) {
    const Vertex vertex = random_vertex(device.codec(), 0.5, engine);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
      const Eigen::Vector3d ahead = vertex.local + step;
      const Eigen::Vector3d behind = vertex.local - step;
      const Eigen::Vector3d difference =
          (oracle.evaluate(vertex.support, ahead[0], ahead[1], ahead[2]) -
           oracle.evaluate(vertex.support, behind[0], behind[1], behind[2])) /
          (2 * kStep);
      const Eigen::Vector3d error =
          std::ldexp(1.0, device.exponent()) * device.derivative(vertex, axis) - difference;
      EXPECT_LE(error.cwiseAbs().maxCoeff(), GetParam().difference)
          << "vertex " << v << " axis " << axis;
    }
  }
}

/// Points of a lattice at rest of any size to 0.6, moved by up to 0.3; a mirror image if wanted.
Vertex volume_vertex(const WordCodec& codec, bool mirrored, std::mt19937_64& engine) {
  Vertex vertex = random_vertex(codec, 0.3, engine);
  const double size = 0.4 * unit(engine);
  for (int p = 0; p < 64; ++p) {
    const Eigen::RowVector3d rest(p / 16 - 1.5, p / 4 % 4 - 1.5, p % 4 - 1.5);
    vertex.support.row(p) += size * rest;
    if (mirrored) vertex.support(p, 0) = -vertex.support(p, 0);
    for (int c = 0; c < 3; ++c) vertex.words.points[3 * p + c] = codec.point(vertex.support(p, c));
  }
  return vertex;
}

// det J against the oracle's, and its sign wherever that is beyond the error.
TEST_P(DerivativeOfRow, DeterminantIsNearTheOracle) {
  const Device device(GetParam().name, "bspline");
  const Oracle oracle;
  const double bound = GetParam().determinant;
  std::mt19937_64 engine(3);
  double largest = 0;
  int folded = 0;
  int upright = 0;
  for (int v = 0; v < 20000; ++v) {
    const Vertex vertex = volume_vertex(device.codec(), v % 2 == 1, engine);
    const model::ResultWords result = device.model().determinant(0, vertex.words);
    EXPECT_FALSE(result.saturated || result.nan);
    EXPECT_EQ(result.words[1] | result.words[2], 0U);
    const double value = device.codec().decode_point(result.words[0]);
    const double exact = std::ldexp(oracle.jet(vertex.support, vertex.local).jacobian.determinant(),
                                    -device.determinant_shift());
    largest = std::max(largest, std::abs(value - exact));
    if (std::abs(exact) <= bound) continue;
    EXPECT_EQ(value <= 0, exact < 0) << "vertex " << v << ", det J " << exact;
    (exact < 0 ? folded : upright)++;
  }
  std::printf("%d upright, %d folded, largest error %.3g, bound %.3g\n", upright, folded, largest,
              bound);
  EXPECT_LE(largest, bound);
  EXPECT_GE(2 * largest, bound) << "the bound says nothing";
  EXPECT_GT(folded, 5000);
  EXPECT_GT(upright, 5000);
}

INSTANTIATE_TEST_SUITE_P(, DerivativeOfRow,
                         ::testing::Values(RowBounds{"basic-fp32-overlapped", 4e-7, 9e-8},
                                           RowBounds{"basic-fx18-overlapped", 1.4e-4, 2e-6},
                                           RowBounds{"basic-fx32-overlapped", 2e-8, 3.8e-10},
                                           RowBounds{"factored-fp32-overlapped", 3e-7, 6.6e-8},
                                           RowBounds{"factored-fx18-overlapped", 4e-5, 1.1e-6},
                                           RowBounds{"factored-fx32-overlapped", 2e-8, 3.4e-10}),
                         test::by_name);

// The ends of the range: columns of components plus or minus 1 - u reach |det J| = 4 nearly, and
// nothing saturates.
TEST(DerivativeDeterminant, HoldsTheLargestThereIs) {
  using F = Fixed<18>;
  const std::int64_t one = 1 << F::kPointFraction;
  const auto sum_of = [&](bool negative) {
    F::Sum sum;
    sum.value =
        (negative ? 1 - one : one - 1) * (std::int64_t{1} << (F::kSumFraction - F::kPointFraction));
    return sum;
  };
  double largest = 0;
  for (unsigned signs = 0; signs < 512; ++signs) {
    std::array<model::VectorSum<F>, 3> columns;
    Eigen::Matrix3d exact;
    for (int i = 0; i < 9; ++i) {
      const bool negative = (signs >> i & 1) != 0;
      columns[i / 3][i % 3] = sum_of(negative);
      exact(i % 3, i / 3) = (negative ? -1 : 1) * (1 - 0x1p-17);
    }
    const OutWord word = model::determinant<F>(columns, 0);
    const double value = std::ldexp(static_cast<std::int32_t>(word.word), -31);
    EXPECT_NEAR(value, exact.determinant() / 4, 1e-4);
    EXPECT_FALSE(word.saturated);
    largest = std::max(largest, std::abs(value));
  }
  EXPECT_GT(largest, 0.9999);
}

}  // namespace
}  // namespace hwffd
