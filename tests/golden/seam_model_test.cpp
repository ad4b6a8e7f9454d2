// Positions and derivatives on faces, edges and corners that cells share: the model of every row of
// the table gives the same bits from each cell, whether or not that row is built (docs/numerics.md
// section 5).
#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "random_vertex.hpp"

namespace hwffd {
namespace {

constexpr int kPlaces = 200;
constexpr std::size_t kSize = 5;  // points an axis: 2 x 2 x 2 cells

/// A place that 2, 4 or 8 cells share, as each of them sees it.
std::vector<model::VertexWords> shared_place(const WordCodec& codec, std::mt19937_64& random) {
  std::array<std::array<std::uint32_t, 3>, kSize * kSize * kSize> points{};
  for (auto& point : points) {
    for (std::uint32_t& word : point) word = codec.point(2 * unit(random) - 1);
  }
  std::array<int, 3> first_cell{};
  for (int& cell : first_cell) cell = static_cast<int>(random() % 15);
  std::array<double, 3> inside{};
  for (double& x : inside) x = unit(random);
  const auto shared = static_cast<unsigned>(1 + random() % 7);  // axes, as bits
  std::vector<model::VertexWords> views;
  for (unsigned sides = 0; sides < 8; ++sides) {
    if ((sides & ~shared) != 0) continue;
    model::VertexWords view;
    std::array<std::size_t, 3> side{};
    for (std::size_t a = 0; a < 3; ++a) {
      side[a] = sides >> a & 1;
      const double face = side[a] == 0 ? 1.0 : 0.0;
      view.local[a] = codec.coordinate((shared >> a & 1) != 0 ? face : inside[a]);
      view.cell[a] = first_cell[a] + static_cast<int>(side[a]);
    }
    for (std::size_t p = 0; p < 64; ++p) {
      const std::size_t at =
          ((p / 16 + side[0]) * kSize + p / 4 % 4 + side[1]) * kSize + p % 4 + side[2];
      for (std::size_t c = 0; c < 3; ++c) view.points[3 * p + c] = points[at][c];
    }
    views.push_back(view);
  }
  return views;
}

/// Of components, each with that of the first cell.
struct Seams {
  int compared = 0;
  int differ = 0;
};

/// @param derivative  of each view (VertexWords)
Seams seams_of(const Configuration& row, const Blending& blending,
               int derivative = model::VertexWords::kPosition) {
  const WordCodec codec(row.format);
  const auto model = model::make_evaluator_model(row);
  const AxisWords axis = encode(blending, codec);
  load(*model, axis);
  std::mt19937_64 random(3);
  Seams seams;
  for (int n = 0; n < kPlaces; ++n) {
    std::vector<model::VertexWords> views = shared_place(codec, random);
    for (model::VertexWords& view : views) view.derivative = derivative;
    const model::ResultWords first = model->evaluate(0, views[0]);
    for (std::size_t v = 1; v < views.size(); ++v) {
      const model::ResultWords other = model->evaluate(0, views[v]);
      for (std::size_t c = 0; c < 3; ++c, ++seams.compared) {
        seams.differ += other.words[c] != first.words[c] ? 1 : 0;
      }
    }
  }
  return seams;
}

TEST(SeamModel, EveryRowIsWatertight) {
  int rows = 0;
  for (const Configuration& row : configurations()) {
    for (int derivative = model::VertexWords::kPosition; derivative < 3; ++derivative) {
      const Seams seams = seams_of(row, watertight_bspline(WordCodec(row.format)), derivative);
      EXPECT_GE(seams.compared, 3 * kPlaces) << row.name;
      EXPECT_EQ(seams.differ, 0) << row.name << ", derivative " << derivative;
    }
    ++rows;
  }
  EXPECT_GE(rows, 60) << "ten organizations, three formats, two schedules";
  std::printf("%d rows, %d places each\n", rows, kPlaces);
}

// Nor would the derivatives of functions with one sixth rounded be watertight.
TEST(SeamModel, DerivativesOfRoundedFunctionsCrack) {
  const Configuration& row = find_configuration("basic-fp32-overlapped");
  Blending rounded = watertight_bspline(WordCodec(row.format));
  rounded.derivative = differentiated(rounded.coefficient);
  for (int axis = 0; axis < 3; ++axis) {
    const Seams seams = seams_of(row, rounded, axis);
    EXPECT_GT(seams.differ, seams.compared / 10) << "along " << axis;
  }
}

TEST(SeamModel, PlainCoefficientsCrack) {
  const Seams seams = seams_of(find_configuration("basic-fp32-overlapped"), plain_bspline());
  EXPECT_GT(seams.differ, seams.compared / 10);
}

}  // namespace
}  // namespace hwffd
