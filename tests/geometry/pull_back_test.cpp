// Gradients pulled back in double: the transpose of evaluation, in any order with the same bits.
#include "hwffd/lattice/pull_back.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cube.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/lattice_evaluator.hpp"
#include "hwffd/on_threads.hpp"
#include "same_bits.hpp"
#include "sample_lattices.hpp"

namespace hwffd {
namespace {

using Blending = std::array<Oracle::Coefficients, 3>;

const Blending kBspline = {Oracle::uniform_bspline(), Oracle::uniform_bspline(),
                           Oracle::uniform_bspline()};

/// Gradients from large to tiny.
Points gradients(Eigen::Index count, std::mt19937_64& random) {
  Points result = Points::Random(count, 3);
  for (Eigen::Index row = 0; row < count; ++row) {
    result.row(row) *= std::ldexp(1, -static_cast<int>(random() % 60));
  }
  return result;
}

TEST(PullBack, IsTheTransposeOfEvaluation) {
  std::mt19937_64 random(1);
  const Lattice lattice =
      Deformation::parse("random:1").apply(lattice_around("box", cube(), {6, 5, 8}));
  const std::vector<Embedded> places = test::known_places(lattice, 3000, 1);
  const Points gradient = gradients(3000, random);
  for (const Blending& blending :
       {kBspline, Blending{Oracle::hermite(), Oracle::catmull_rom(), Oracle::bernstein()}}) {
    const Points pulled = pull_back_in(lattice.dims(), places, gradient, blending);
    const double forward = evaluate_in(lattice, places, blending).cwiseProduct(gradient).sum();
    EXPECT_NEAR(lattice.points().cwiseProduct(pulled).sum(), forward, 1e-11);
  }
}

// Against sums in extended precision: what a sum is off by is little more than its own rounding.
TEST(PullBack, SumsAreRoundedOnce) {
  std::mt19937_64 random(2);
  const Index3 dims = {5, 4, 6};
  const Lattice lattice = lattice_around("box", cube(), dims);
  const std::vector<Embedded> places = test::known_places(lattice, 20000, 2);
  const Points gradient = gradients(20000, random);
  std::vector<std::array<long double, 3>> exact(5 * 4 * 6);
  const Oracle oracle;
  for (std::size_t v = 0; v < places.size(); ++v) {
    const Index3& cell = places[v].cell;
    const Support parts =
        oracle.pull_back(gradient.row(static_cast<Eigen::Index>(v)), places[v].local);
    for (int p = 0; p < 64; ++p) {
      auto& sum = exact[static_cast<std::size_t>(
          lattice.index(cell[0] + p / 16, cell[1] + p / 4 % 4, cell[2] + p % 4))];
      for (int c = 0; c < 3; ++c) sum[c] += parts(p, c);
    }
  }
  const Points pulled = pull_back_in(dims, places, gradient, kBspline);
  for (std::size_t point = 0; point < exact.size(); ++point) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(pulled(static_cast<Eigen::Index>(point), c), static_cast<double>(exact[point][c]),
                  1e-13);
    }
  }
}

class PullBackBits : public ::testing::Test {
 protected:
  ~PullBackBits() override { set_thread_count(0); }
};

TEST_F(PullBackBits, DoNotDependOnThreadsOrOrder) {
  constexpr Eigen::Index kCount = 30000;
  std::mt19937_64 random(3);
  const Lattice lattice = lattice_around("sphere", cube(), {5, 6, 9});
  std::vector<Embedded> places = test::known_places(lattice, kCount, 3);
  Points gradient = gradients(kCount, random);
  set_thread_count(1);
  const Points expected = pull_back_in(lattice.dims(), places, gradient, kBspline);
  EXPECT_GT(expected.cwiseAbs().maxCoeff(), 1);
  for (const std::size_t threads : {1, 2, 3, 4, 7}) {
    set_thread_count(threads);
    for (Eigen::Index i = kCount - 1; i > 0; --i) {
      const auto other = static_cast<Eigen::Index>(random() % static_cast<std::uint64_t>(i + 1));
      std::swap(places[static_cast<std::size_t>(i)], places[static_cast<std::size_t>(other)]);
      gradient.row(i).swap(gradient.row(other));
    }
    EXPECT_TRUE(same_bits(expected, pull_back_in(lattice.dims(), places, gradient, kBspline)))
        << threads;
  }
}

TEST(PullBack, OfNothingIsZeroAndOfAnySizeItScales) {
  const Lattice lattice = lattice_around("box", cube(), {4, 4, 5});
  EXPECT_EQ(pull_back_in(lattice.dims(), {}, Points(0, 3), kBspline), Points::Zero(80, 3));
  const std::vector<Embedded> places = test::known_places(lattice, 40, 4);
  EXPECT_EQ(pull_back_in(lattice.dims(), places, Points::Zero(40, 3), kBspline),
            Points::Zero(80, 3));
  const Points gradient = Points::Random(40, 3);
  const Points pulled = pull_back_in(lattice.dims(), places, gradient, kBspline);
  for (const double scale : {0x1p-900, 0x1p900}) {
    EXPECT_EQ(pull_back_in(lattice.dims(), places, scale * gradient, kBspline), scale * pulled);
  }
}

// The lattice that a device evaluates in place of a family's has other points.
TEST(PullBack, FamiliesArePulledBackThroughWhatDevicesEvaluate) {
  for (const std::string& name : Family::names()) {
    const Family family = Family::parse(name);
    const Index3 dims = {7, 4, 10};
    const Lattice lattice(dims, Points::Random(7 * 4 * 10, 3));
    const Family::Evaluable evaluable = family.evaluable(lattice);
    const Points gradient = Points::Random(evaluable.lattice.points().rows(), 3);
    const Points pulled = family.pull_back(dims, gradient);
    ASSERT_EQ(pulled.rows(), 280) << name;
    EXPECT_NEAR(pulled.cwiseProduct(lattice.points()).sum(),
                gradient.cwiseProduct(evaluable.lattice.points()).sum(), 1e-10)
        << name;
  }
}

}  // namespace
}  // namespace hwffd
