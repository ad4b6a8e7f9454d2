#include "picture/before_after.hpp"

#include <gtest/gtest.h>

#include "colours.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"

namespace hwffd::picture {
namespace {

/// The procedural mesh, then the same moved by `way`, with the lattice's middle moved likewise.
Image picture_of(const Point& way, const std::string& deformation) {
  Mesh mesh = Mesh::procedural();
  const Lattice before = Box::around(mesh.positions()).lattice({4, 4, 4});
  const Lattice after = Deformation::parse(deformation).apply(before);
  BeforeAfter halves(before, after);
  EXPECT_EQ(halves.missing(), "");
  halves.draw(mesh, before);
  mesh.set_positions(mesh.positions().rowwise() + way.transpose());
  halves.draw(mesh, after);
  return halves.image();
}

/// Pixels that differ between the left and the right half.
int differing(const Image& image) {
  int number = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width / 2; ++x) {
      number += image.at(x, y) != image.at(x + image.width / 2, y) ? 1 : 0;
    }
  }
  return number;
}

TEST(BeforeAfter, HalvesShareACameraAndShowTheirOwnState) {
  const Image same = picture_of(Point::Zero(), "none");
  ASSERT_EQ(same.width, 1400);
  ASSERT_EQ(same.height, 600);
  EXPECT_GT(1400 * 600 - count(same, is_background), 50000);
  EXPECT_EQ(differing(same), 0);
  EXPECT_GT(differing(picture_of(Point(1, 0, 0), "none")), 10000) << "the mesh is drawn as it is";
  EXPECT_GT(differing(picture_of(Point::Zero(), "shear")), 10000) << "the lattice too";
}

}  // namespace
}  // namespace hwffd::picture
