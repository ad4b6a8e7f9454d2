// Eq. (1) by vectors of the processor: beside the oracle, and the same bits whatever the order, the
// width and the way. On each kind of processor that this one can stand for.
#include "hwffd/lattice/lattice_evaluator.hpp"

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace hwffd {
namespace {

using Blending = std::array<Oracle::Coefficients, 3>;

const Blending kMixed{Oracle::uniform_bspline(), Oracle::bernstein(), Oracle::catmull_rom()};
// A sum of 64 products in three steps: some thirty roundings of numbers below 4.
template <class Real>
constexpr double kBound = 64 * std::numeric_limits<Real>::epsilon();

class Random {
 public:
  double unit() { return std::uniform_real_distribution<double>(0, 1)(engine_); }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }
  std::mt19937& engine() { return engine_; }

 private:
  std::mt19937 engine_{1};
};

Lattice random_lattice(const Index3& dims, Random& random) {
  Points points(dims[0] * dims[1] * dims[2], 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = 2 * random.unit() - 1;
  return {dims, points};
}

/// Vertices in random cells: some alone, some in runs of up to 40, so that vectors are filled in
/// every measure.
std::vector<Embedded> random_vertices(const Lattice& lattice, std::size_t count, Random& random) {
  std::vector<Embedded> vertices;
  while (vertices.size() < count) {
    Embedded vertex;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      vertex.cell[axis] = random.below(lattice.cells()[axis]);
    }
    for (int run = random.below(2) == 0 ? 1 : random.below(40); run >= 0; --run) {
      vertex.local = {random.unit(), random.unit(), random.unit()};
      vertices.push_back(vertex);
    }
  }
  vertices.resize(count);
  return vertices;
}

template <class Real>
VertexArrays<Real> arrays(const LatticeEvaluator<Real>& evaluator,
                          const std::vector<Embedded>& vertices) {
  VertexArrays<Real> result;
  for (const Embedded& vertex : vertices) {
    result.origins.push_back(evaluator.origin(vertex.cell));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.local[axis].push_back(
          static_cast<Real>(vertex.local[static_cast<Eigen::Index>(axis)]));
      result.position[axis].push_back(-1);
    }
  }
  return result;
}

bool has_fused_multiply_add(std::int64_t target) {
  return target != HWY_SSSE3 && target != HWY_SSE4 && target != HWY_SCALAR && target != HWY_EMU128;
}

/// Each kind of processor for which the code was made and that this one can stand for.
class Targets : public testing::TestWithParam<std::int64_t> {
 protected:
  void SetUp() override { hwy::SetSupportedTargetsForTest(GetParam()); }
  void TearDown() override { hwy::SetSupportedTargetsForTest(0); }
};

INSTANTIATE_TEST_SUITE_P(LatticeEvaluator, Targets,
                         testing::ValuesIn(hwy::SupportedAndGeneratedTargets()),
                         [](const auto& info) { return hwy::TargetName(info.param); });

template <class Real>
void expect_oracle() {
  Random random;
  const Oracle oracle(kMixed[0], kMixed[1], kMixed[2]);
  double largest = 0;
  for (const Index3& dims : {Index3{4, 4, 4}, Index3{5, 7, 4}, Index3{9, 6, 16}}) {
    const Lattice lattice = random_lattice(dims, random);
    const LatticeEvaluator<Real> evaluator(lattice, kMixed);
    const std::vector<Embedded> vertices = random_vertices(lattice, 3000, random);
    VertexArrays<Real> evaluated = arrays(evaluator, vertices);
    evaluator.evaluate(evaluated);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const Point local(evaluated.local[0][v], evaluated.local[1][v], evaluated.local[2][v]);
      const Point wanted =
          oracle.evaluate(lattice.support(vertices[v].cell), local[0], local[1], local[2]);
      const Point position(evaluated.position[0][v], evaluated.position[1][v],
                           evaluated.position[2][v]);
      largest = std::max(largest, (position - wanted).cwiseAbs().maxCoeff());
    }
  }
  EXPECT_LE(largest, kBound<Real>);
  EXPECT_GT(largest, 0);
}

TEST_P(Targets, IsTheOracleButForRounding) {
  expect_oracle<float>();
  expect_oracle<double>();
}

template <class Real>
void expect_each_by_itself() {
  Random random;
  const Lattice lattice = random_lattice({6, 5, 7}, random);
  const LatticeEvaluator<Real> evaluator(lattice, kMixed);
  std::vector<Embedded> vertices = random_vertices(lattice, 2000, random);
  std::vector<std::array<Real, 3>> alone;
  for (const Embedded& vertex : vertices) {
    VertexArrays<Real> single = arrays(evaluator, {vertex});
    evaluator.evaluate(single);
    alone.push_back({single.position[0][0], single.position[1][0], single.position[2][0]});
  }
  std::vector<std::size_t> order(vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto cell = [&](std::size_t v) { return vertices[v].cell; };
  for (int round = 0; round < 3; ++round) {
    std::vector<Embedded> turn;
    for (const std::size_t v : order) turn.push_back(vertices[v]);
    VertexArrays<Real> evaluated = arrays(evaluator, turn);
    evaluator.evaluate(evaluated);
    std::size_t different = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        different += evaluated.position[c][i] != alone[order[i]][c];
      }
    }
    EXPECT_EQ(different, 0U) << "round " << round;
    if (round == 0) std::shuffle(order.begin(), order.end(), random.engine());
    if (round == 1) {
      std::sort(order.begin(), order.end(),
                [&](std::size_t a, std::size_t b) { return cell(a) < cell(b); });
    }
  }
}

TEST_P(Targets, AVertexIsTheSameAloneInAnyOrderAndSorted) {
  expect_each_by_itself<float>();
  expect_each_by_itself<double>();
}

TEST_P(Targets, EveryLengthOfARunWritesItsOwnVerticesOnly) {
  Random random;
  const Lattice lattice = random_lattice({4, 4, 5}, random);
  const LatticeEvaluator<float> evaluator(lattice, kMixed);
  const std::vector<Embedded> vertices(70, Embedded{{0, 0, 1}, {0.25, 0.5, 0.75}, true});
  VertexArrays<float> single = arrays(evaluator, {vertices[0]});
  evaluator.evaluate(single);
  for (std::size_t length = 0; length <= 64; ++length) {
    VertexArrays<float> evaluated = arrays(evaluator, vertices);
    evaluated.origins.resize(length);
    evaluator.evaluate(evaluated);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      EXPECT_EQ(evaluated.position[2][v], v < length ? single.position[2][0] : -1) << length;
    }
  }
}

TEST(LatticeEvaluator, WidthsWithFusedMultiplyAddAgree) {
  Random random;
  const Lattice lattice = random_lattice({7, 5, 6}, random);
  const std::vector<Embedded> vertices = random_vertices(lattice, 5000, random);
  std::vector<Points> by_target;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (!has_fused_multiply_add(target)) continue;
    hwy::SetSupportedTargetsForTest(target);
    by_target.push_back(evaluate_in(lattice, vertices, kMixed));
  }
  hwy::SetSupportedTargetsForTest(0);
  for (const Points& positions : by_target) EXPECT_EQ(positions, by_target.front());
}

TEST(LatticeEvaluator, VerticesThatBringTheirPointsAreThoseOfTheLattice) {
  Random random;
  const Lattice lattice = random_lattice({6, 6, 6}, random);
  const std::vector<Embedded> vertices = random_vertices(lattice, 2500, random);
  std::vector<SupportedVertex> supported;
  for (const Embedded& vertex : vertices) {
    supported.push_back({vertex.local, lattice.support(vertex.cell)});
  }
  EXPECT_EQ(evaluate_in(supported, kMixed), evaluate_in(lattice, vertices, kMixed));
  EXPECT_EQ(evaluate_in(std::vector<SupportedVertex>{}, kMixed).rows(), 0);
}

TEST(LatticeEvaluator, TheLargestLatticeIsReachedToItsLastPoint) {
  Random random;
  const Lattice lattice = random_lattice({64, 64, 64}, random);
  const Embedded last{{60, 60, 60}, {1, 1, 1}, true};
  const Blending bernstein{Oracle::bernstein(), Oracle::bernstein(), Oracle::bernstein()};
  const Points positions = evaluate_in(lattice, {last}, bernstein);
  EXPECT_LE((positions.row(0) - lattice.point(63, 63, 63).transpose()).cwiseAbs().maxCoeff(),
            kBound<double>);
}

}  // namespace
}  // namespace hwffd
