// What a translation loses is found by reading what was written.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "errors.hpp"
#include "mesh_files.hpp"

namespace hwffd {
namespace {

using MeshLosses = MeshFiles;
using Texts = std::vector<std::string>;

bool has(const Texts& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

const char* const kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";

/// Statements that no other format has, and those that one has and another has not.
TEST_F(MeshLosses, StatementsOfMaterials) {
  folder.write("a.mtl",
               "newmtl wood\nKd 0.8 0.7 0.6\nKs 0.5 0.5 0.5\nNs 250\nd 0.75\nillum 4\naniso 0.5\n"
               "map_Kd -s 2 2 1 -o 0.1 0 0 wood.png\nmap_Bump -bm 0.5 bump.png\n");
  const Mesh mesh = load(std::string("mtllib a.mtl\nusemtl wood\n") + kTriangle);
  for (const std::string text : {"aniso", "-s of map_Kd", "-o of map_Kd", "-bm of map_Bump"}) {
    EXPECT_TRUE(has(mesh.dropped(), "statement " + text + " of materials")) << text;
  }
  const Texts losses = mesh.save(folder / "b.glb");
  EXPECT_FALSE(has(losses, "statement kd of materials"));
  EXPECT_TRUE(has(losses, "statement bump of materials"));
  EXPECT_EQ(mesh.save(folder / "b.obj"), Texts());
  EXPECT_EQ(mesh.save(folder / "b.ply"), Texts{"materials"});
}

TEST_F(MeshLosses, WhatIsMeasured) {
  const Mesh mesh = load(
      "o a\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 1 0 0\nv 5 5 5 1 0 0\nvn 0 0 1\n"
      "vn 1 0 0\nf 1//1 2//2 3//1 4//1\nl 1 3\np 2\n");
  EXPECT_EQ(mesh.save(folder / "b.off"), (Texts{"smooth normals", "colours", "part names"}));
  EXPECT_EQ(mesh.save(folder / "b.stl"),
            (Texts{"order of vertices", "smooth normals", "colours", "part names",
                   "polygons (cut into triangles)", "lines", "points", "unused vertices"}));
  EXPECT_FALSE(has(mesh.save(folder / "b.glb"), "colours"));
}

/// An obj file has three numbers a colour.
TEST_F(MeshLosses, AlphaOfColours) {
  const auto triangle = [&](int alpha) {
    return load(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
        "property uchar alpha\nelement face 1\nproperty list uchar int vertex_indices\n"
        "end_header\n0 0 0 9 9 9 255\n1 0 0 9 9 9 255\n0 1 0 9 9 9 " +
            std::to_string(alpha) + "\n3 0 1 2\n",
        "a.ply");
  };
  EXPECT_EQ(triangle(128).save(folder / "b.obj"), Texts{"alpha of colours"});
  EXPECT_EQ(triangle(128).save(folder / "b.glb"), Texts());
  EXPECT_EQ(triangle(255).save(folder / "b.obj"), Texts());
}

/// Far from the origin binary32 has too few; elsewhere what it rounds is not seen.
TEST_F(MeshLosses, DigitsOfCoordinates) {
  const Mesh far = load("v 4000000.125 0 0\nv 4000001.25 0 0\nv 4000000 1 0\nf 1 2 3\n");
  for (const char* name : {"b.stl", "b.glb"}) {
    EXPECT_TRUE(has(far.save(folder / name), "digits of coordinates")) << name;
  }
  for (const char* name : {"b.obj", "b.off"}) EXPECT_EQ(far.save(folder / name), Texts()) << name;
  const Mesh near = load("v 0.123456789012 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_FALSE(has(near.save(folder / "b.stl"), "digits of coordinates"));
}

/// A device cannot be read again.
TEST_F(MeshLosses, ADevice) {
  std::filesystem::create_symlink("/dev/null", folder / "null.ply");
  EXPECT_EQ(load(kTriangle).save(folder / "null.ply"), Texts());
}

}  // namespace
}  // namespace hwffd
