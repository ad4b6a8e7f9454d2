#include "hwffd/lattice/refine.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "errors.hpp"

namespace hwffd {
namespace {

/// Numbers of very different sizes, so that sums round.
Lattice random_lattice(const Index3& dims, std::uint64_t seed) {
  std::mt19937_64 source(seed);
  Points points(dims[0] * dims[1] * dims[2], 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const double fraction = static_cast<double>(source() >> 11) * 0x1p-53;
    points.data()[i] = std::ldexp(fraction - 0.5, static_cast<int>(source() % 20));
  }
  return {dims, points};
}

std::array<mpq_class, 4> bspline(const mpq_class& x) {
  const mpq_class y = 1 - x;
  return {y * y * y / 6, (3 * x * x * x - 6 * x * x + 4) / 6,
          (-3 * x * x * x + 3 * x * x + 3 * x + 1) / 6, x * x * x / 6};
}

struct Exact {
  std::array<mpq_class, 3> value;
  double largest = 0.0;  ///< of the control points' coordinates
};

/// At a place in cells from the first face on.
Exact exact_at(const Lattice& lattice, const std::array<mpq_class, 3>& place) {
  Index3 cell{};
  std::array<std::array<mpq_class, 4>, 3> weights;
  for (std::size_t a = 0; a < 3; ++a) {
    cell[a] = std::min(static_cast<int>(place[a].get_d()), lattice.cells()[a] - 1);
    weights[a] = bspline(place[a] - cell[a]);
  }
  const Support support = lattice.support(cell);
  Exact result;
  for (int row = 0; row < 64; ++row) {
    const auto at = [&](std::size_t a, int l) { return weights[a][static_cast<std::size_t>(l)]; };
    const mpq_class weight = at(0, row / 16) * at(1, row / 4 % 4) * at(2, row % 4);
    for (std::size_t c = 0; c < 3; ++c) {
      const double p = support(row, static_cast<int>(c));
      result.value[c] += weight * mpq_class(p);
      result.largest = std::max(result.largest, std::abs(p));
    }
  }
  return result;
}

/// In exact arithmetic: the maps differ by less than an ulp of the largest control point.
TEST(Refine, MapsAsBefore) {
  int compared = 0;
  int rounded = 0;
  std::mt19937_64 source(9);
  for (const Index3& dims : {Index3{4, 4, 4}, Index3{5, 4, 7}, Index3{8, 6, 5}}) {
    for (const std::array<bool, 3>& axes :
         {std::array<bool, 3>{true, true, true}, {true, false, false}, {false, true, true}}) {
      const Lattice lattice = random_lattice(dims, source());
      const Lattice fine = refined(lattice, axes);
      ASSERT_EQ(fine.dims(), refined_dims(dims, axes));
      for (int n = 0; n < 40; ++n) {
        std::array<mpq_class, 3> place;
        std::array<mpq_class, 3> in_fine;
        for (std::size_t a = 0; a < 3; ++a) {
          const int cells = lattice.cells()[a];
          place[a] = mpq_class(
              static_cast<unsigned long>(source() % (1009UL * static_cast<unsigned>(cells) + 1)),
              1009UL);
          place[a].canonicalize();
          in_fine[a] = axes[a] ? mpq_class(2 * place[a]) : place[a];
        }
        const Exact before = exact_at(lattice, place);
        const Exact after = exact_at(fine, in_fine);
        const double ulp = std::nextafter(before.largest, 1e300) - before.largest;
        for (std::size_t c = 0; c < 3; ++c) {
          const mpq_class off = abs(mpq_class(after.value[c] - before.value[c]));
          ASSERT_LE(off.get_d(), ulp);
          rounded += off == 0 ? 0 : 1;
          ++compared;
        }
      }
    }
  }
  EXPECT_EQ(compared, 3 * 3 * 40 * 3);
  EXPECT_GT(rounded, 1000);
}

/// Each coordinate is the nearest double to what exact knot insertion gives.
TEST(Refine, RoundsOnce) {
  const Lattice lattice = random_lattice({6, 5, 4}, 3);
  const Lattice fine = refined(lattice);
  const Index3 dims = fine.dims();
  for (const Index3& at : places(dims)) {
    std::array<mpq_class, 3> sum;
    for (const Index3& step : places({3, 3, 3})) {
      mpq_class weight = 1;
      Index3 from{};
      bool used = true;
      for (std::size_t a = 0; a < 3; ++a) {
        const int odd[3] = {1, 6, 1};
        const int even[3] = {4, 4, 0};
        weight *= mpq_class(at[a] % 2 == 0 ? even[step[a]] : odd[step[a]], 8);
        from[a] = at[a] / 2 + step[a];
        used = used && from[a] < lattice.dims()[a];
      }
      if (!used) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        sum[c] += weight * mpq_class(lattice.point(from)[static_cast<int>(c)]);
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const double got = fine.point(at)[static_cast<int>(c)];
      const mpq_class off = abs(mpq_class(sum[c] - mpq_class(got)));
      for (const double other : {std::nextafter(got, 1e300), std::nextafter(got, -1e300)}) {
        ASSERT_LE(off, abs(mpq_class(sum[c] - mpq_class(other))));
      }
    }
  }
}

TEST(Refine, RefusesTooManyPointsAndOtherFamilies) {
  EXPECT_EQ(refined_dims({4, 33, 7}), (Index3{5, 63, 11}));
  EXPECT_EQ(refined(random_lattice({4, 33, 4}, 1)).dims(), (Index3{5, 63, 5}));
  EXPECT_ERROR(
      refined(random_lattice({4, 34, 4}, 1)),
      "refine: 34 points along t would be 65; give at most 33, or leave that axis as it is");
  EXPECT_EQ(refined(random_lattice({4, 34, 4}, 1), {true, false, true}).dims(), (Index3{5, 34, 5}));
  EXPECT_ERROR(
      refined(random_lattice({4, 4, 4}, 1), {true, true, true}, Family(Family::Kind::kClamped)),
      "refine: knots are inserted into uniform B-splines, not into 'clamped'; give a lattice of "
      "the "
      "family bspline");
}

}  // namespace
}  // namespace hwffd
