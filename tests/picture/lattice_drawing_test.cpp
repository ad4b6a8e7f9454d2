#include "picture/lattice_drawing.hpp"

#include <gtest/gtest.h>

#include "colours.hpp"
#include "hwffd/lattice/box.hpp"
#include "picture/renderer.hpp"

namespace hwffd::picture {
namespace {

/// Seen from a side where no point hides another.
class DrawLattice : public testing::Test {
 protected:
  DrawLattice()
      : renderer_(400, 400),
        camera_(Camera::around(lattice_.points(), Point(0.37, 0.23, 1), renderer_.aspect())),
        image_(renderer_.render(camera_, [&] { draw_lattice(lattice_); })) {}

  Pixel at(const Point& point) const {
    const auto [x, y] = pixel_of(camera_, image_, point);
    return image_.at(x, y);
  }

  Lattice lattice_ = Box(Point(0, 0, 0), Point(1, 1, 1).asDiagonal()).lattice({4, 5, 6});
  Renderer renderer_;
  Camera camera_;
  Image image_;
};

bool is_sphere(const Pixel& pixel) { return pixel[0] > pixel[2] + 20; }

TEST_F(DrawLattice, EveryControlPointIsASphere) {
  int seen = 0;
  for (Eigen::Index p = 0; p < lattice_.points().rows(); ++p) {
    seen += is_sphere(at(lattice_.points().row(p))) ? 1 : 0;
  }
  EXPECT_EQ(seen, 4 * 5 * 6);
}

TEST_F(DrawLattice, NeighboursAreJoinedAndOthersAreNot) {
  int joined = 0;
  for (const auto& [i, j, k] : places({3, 4, 5})) {
    const Point here = lattice_.point(i, j, k);
    for (const Point& next :
         {lattice_.point(i + 1, j, k), lattice_.point(i, j + 1, k), lattice_.point(i, j, k + 1)}) {
      EXPECT_FALSE(is_background(at((here + next) / 2))) << i << j << k;
      ++joined;
    }
  }
  EXPECT_EQ(joined, 180);
  // Far less is covered than diagonals or faces would cover.
  EXPECT_LT(400 * 400 - count(image_, is_background), 400 * 400 / 3);
}

}  // namespace
}  // namespace hwffd::picture
