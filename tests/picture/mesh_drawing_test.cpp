#include "picture/mesh_drawing.hpp"

#include <gtest/gtest.h>

#include "colours.hpp"
#include "picture/renderer.hpp"
#include "temp_folder.hpp"

namespace hwffd::picture {
namespace {

Image picture_of(const Mesh& mesh) {
  const Renderer renderer(60, 60);
  const Camera camera = Camera::around(mesh.positions(), Point(0, 0, 1), renderer.aspect());
  return renderer.render(camera, [&] { draw_mesh(mesh); });
}

/// Two squares side by side, red and blue, the left one as a polygon, the right one as triangles.
constexpr const char* kSquares =
    "mtllib two.mtl\n"
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
    "usemtl red\nf 1 2 3 4\nusemtl blue\nf 2 5 6\nf 2 6 3\n";
constexpr const char* kMaterials = "newmtl red\nKd 0.9 0 0\nnewmtl blue\nKd 0 0 0.9\n";

TEST(DrawMesh, PartsHaveTheColoursOfTheirMaterials) {
  const TempFolder folder;
  folder.write("two.mtl", kMaterials);
  const Image image = picture_of(Mesh::load(folder.write("two.obj", kSquares)));
  EXPECT_TRUE(is_red(image.at(15, 30)));
  EXPECT_TRUE(is_blue(image.at(45, 30)));
  const int reds = count(image, is_red);
  EXPECT_NEAR(reds, 28 * 28, 60);
  EXPECT_NEAR(count(image, is_blue), reds, 60);
}

TEST(DrawMesh, WithoutNormalsTheyAreSmooth) {
  const TempFolder folder;
  // A roof of two squares; its ridge has the mean of their normals, its eaves have their own.
  const Mesh roof = Mesh::load(folder.write("roof.obj",
                                            "v -1 0 0\nv 0 0 1\nv 0 1 1\nv -1 1 0\nv 1 0 0\n"
                                            "v 1 1 0\nf 1 2 3 4\nf 2 5 6 3\n"));
  ASSERT_FALSE(is_background(picture_of(roof).at(30, 30)));
  const Image image = picture_of(roof);
  const int left = brightness(image.at(6, 30));
  const int ridge = brightness(image.at(30, 30));
  const int right = brightness(image.at(53, 30));
  EXPECT_GT(left, right + 20) << "the light is to the left";
  EXPECT_LE(std::abs(brightness(image.at(28, 30)) - brightness(image.at(31, 30))), 20)
      << "no edge at the ridge";
  EXPECT_GT(ridge, right);
}

TEST(DrawMesh, TheProceduralMeshIsSeenFromOutside) {
  const Image image = picture_of(Mesh::procedural());
  const int seen = 3600 - count(image, is_background);
  EXPECT_GT(seen, 1000);
  EXPECT_LT(seen, 3000);
}

}  // namespace
}  // namespace hwffd::picture
