// Watertight seams: a vertex on a face, edge or corner that cells share gets the same bits from
// each of them (docs/numerics.md section 5), in the model and in the RTL; or, from an organization
// that is not watertight, within a bound.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/model/seam_bound.hpp"
#include "system_run.hpp"

namespace hwffd::test {
namespace {

constexpr std::size_t kValues = 60000;    // compared components, at least
constexpr std::size_t kRtlValues = 6000;  // where every bit is compared with the model's, too

/// A random lattice of 2 x 2 x 2 cells somewhere in a 16^3 lattice: 5^3 points as words.
struct Neighbourhood {
  std::array<int, 3> first_cell{};
  std::vector<std::array<std::uint32_t, 3>> points;

  Neighbourhood(const WordCodec& codec, tb::Random& random) : points(125) {
    for (int& cell : first_cell) cell = static_cast<int>(random.below(15));
    for (auto& point : points) {
      for (std::uint32_t& word : point) word = codec.point(2 * random.unit() - 1);
    }
  }

  /// The vertex at `local` in the cell first_cell + `side` (0 or 1 an axis).
  InterleavedVertex vertex(const std::array<int, 3>& side,
                           const std::array<std::uint32_t, 3>& local) const {
    InterleavedVertex vertex;
    vertex.local = local;
    for (int axis = 0; axis < 3; ++axis) vertex.cell[axis] = first_cell[axis] + side[axis];
    for (int p = 0; p < 64; ++p) {
      const int at = ((p / 16 + side[0]) * 5 + (p / 4 % 4 + side[1])) * 5 + p % 4 + side[2];
      for (int c = 0; c < 3; ++c) vertex.points[3 * p + c] = points[at][c];
    }
    return vertex;
  }
};

/// One vertex on a shared face (1 axis), edge (2) or corner (3), as each of the 2, 4 or 8 cells
/// sees it: coordinate 1 in the lower cell of a shared axis, 0 in the upper one.
std::vector<InterleavedVertex> shared_vertex(const WordCodec& codec, tb::Random& random) {
  const Neighbourhood neighbourhood(codec, random);
  const auto shared = static_cast<unsigned>(1 + random.below(7));  // axes, as bits
  std::array<std::uint32_t, 3> inside{};
  for (std::uint32_t& word : inside) word = codec.coordinate(random.unit());
  std::vector<InterleavedVertex> vertices;
  for (unsigned sides = 0; sides < 8; ++sides) {
    if ((sides & ~shared) != 0) continue;
    std::array<int, 3> side{};
    std::array<std::uint32_t, 3> local = inside;
    for (int axis = 0; axis < 3; ++axis) {
      side[axis] = static_cast<int>(sides >> axis) & 1;
      if ((shared >> axis & 1) != 0) local[axis] = codec.coordinate(side[axis] == 0 ? 1.0 : 0.0);
    }
    vertices.push_back(neighbourhood.vertex(side, local));
  }
  return vertices;
}

/// Vertices in groups that must agree.
struct Seams {
  std::vector<InterleavedVertex> vertices;
  std::vector<std::size_t> group;  // of each vertex

  Seams(const WordCodec& codec, std::size_t values, std::uint64_t seed) {
    tb::Random random(seed);
    for (std::size_t g = 0; 3 * vertices.size() < values; ++g) {
      for (const InterleavedVertex& vertex : shared_vertex(codec, random)) {
        vertices.push_back(vertex);
        group.push_back(g);
      }
    }
  }

  /// How components differ from those of the group's first vertex, of `each` results a vertex.
  struct Differences {
    std::size_t count = 0;
    double largest = 0;
  };
  Differences differences(const std::vector<Beat>& results, const WordCodec& codec,
                          std::size_t each = 1) const {
    EXPECT_EQ(results.size(), each * vertices.size());
    Differences differ;
    std::size_t first = 0;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (group[v] != group[first]) first = v;
      for (std::size_t r = 0; r < each; ++r) {
        const Beat& own = results[each * v + r];
        const Beat& other = results[each * first + r];
        for (int c = 0; c < 3; ++c) {
          if (own.words[c] == other.words[c]) continue;
          ++differ.count;
          const double apart =
              codec.decode_point(own.words[c]) - codec.decode_point(other.words[c]);
          differ.largest = std::max(differ.largest, std::abs(apart));
        }
      }
    }
    return differ;
  }
};

/// None, or where the organization is not watertight some, within its bound.
void expect_sound(const Configuration& row, const Seams::Differences& differ, std::size_t values) {
  const double units = differ.largest / seam_unit(row);
  std::printf("%zu values, %zu differ, by %.3g units at most\n", values, differ.count, units);
  EXPECT_LE(units, seam_bound(row));
  if (seam_bound(row) == 0) {
    EXPECT_EQ(differ.count, 0U);
  } else {
    EXPECT_GT(differ.count, 0U) << "it has become watertight: say so";
  }
}

Seams::Differences model_differences(const Seams& seams, const Configuration& row,
                                     const Blending& blending) {
  const WordCodec codec(row.format);
  model::StreamModel model(row);
  model.run(coefficients_packet(blending, codec));
  return seams.differences(model.run(interleaved_packet(seams.vertices)), codec);
}

class Seam : public PerConfiguration {};
class FloatSeam : public PerConfiguration {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(FloatSeam);  // gates are of fixed point only

TEST_P(Seam, ModelIsWatertight) {
  const WordCodec codec(GetParam().format);
  const Seams seams(codec, kValues, tb::seed_from_environment(1));
  EXPECT_GE(3 * seams.vertices.size(), kValues);
  expect_sound(GetParam(), model_differences(seams, GetParam(), watertight_bspline(codec)),
               3 * seams.vertices.size());
}

// The test can fail: with each coefficient rounded by itself, binary32 cracks. Not so an evaluator
// that takes no coefficients.
TEST_P(FloatSeam, PlainCoefficientsCrackInBinary32) {
  const Seams seams(WordCodec(GetParam().format), kValues, tb::seed_from_environment(1));
  const std::size_t differ = model_differences(seams, GetParam(), plain_bspline()).count;
  std::printf("%zu values, %zu differ\n", 3 * seams.vertices.size(), differ);
  if (std::string(GetParam().evaluator) == "bspline") {
    EXPECT_EQ(differ, 0U);
  } else {
    EXPECT_GT(differ, kValues / 10);
  }
}

TEST_P(Seam, RtlIsWatertight) {
  SystemRun run(GetParam(), 1);
  const std::size_t values = share_of(kRtlValues);
  const Seams seams(run.codec(), values, tb::seed_from_environment(2));
  run.send_bspline();
  run.send(interleaved_packet(seams.vertices));
  ASSERT_TRUE(run.run());
  EXPECT_GE(3 * seams.vertices.size(), values);
  expect_sound(GetParam(), seams.differences(run.bench().results(), run.codec()),
               3 * seams.vertices.size());
}

// The derivatives of both sides, too: three of four results, each of three components.

TEST_P(Seam, ModelDerivativesAreWatertight) {
  const WordCodec codec(GetParam().format);
  const Seams seams(codec, kValues / 3, tb::seed_from_environment(3));
  model::StreamModel model(GetParam());
  model.run(coefficients_packet(watertight_bspline(codec), codec, Functions::kDerivativesToo));
  const auto results =
      model.run(interleaved_packet(seams.vertices, OutsideMode::kClamp, Results::kDerivatives));
  EXPECT_GE(9 * seams.vertices.size(), kValues);
  expect_sound(GetParam(), seams.differences(results, codec, 4), 9 * seams.vertices.size());
}

TEST_P(Seam, RtlDerivativesAreWatertight) {
  SystemRun run(GetParam(), 1);
  const std::size_t values = share_of(kRtlValues);
  const Seams seams(run.codec(), values / 3, tb::seed_from_environment(4));
  run.send_bspline();
  run.send(interleaved_packet(seams.vertices, OutsideMode::kClamp, Results::kDerivatives));
  ASSERT_TRUE(run.run());
  EXPECT_GE(9 * seams.vertices.size(), values);
  expect_sound(GetParam(), seams.differences(run.bench().results(), run.codec(), 4),
               9 * seams.vertices.size());
}

HWFFD_FOR_EACH_CONFIGURATION(Seam);
HWFFD_FOR_EACH_CONFIGURATION(FloatSeam, "fp32");

}  // namespace
}  // namespace hwffd::test
