// A mesh that comes back in its own format is its file, edited.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <vector>

#include "errors.hpp"
#include "mesh_files.hpp"

namespace hwffd {
namespace {

/// A file, and what it becomes at twice its size and as its mirror image along x.
struct Example {
  const char* name;
  std::string text;
  std::string doubled;
  std::string mirrored;
};

std::vector<Eigen::Matrix3d> everywhere(const Mesh& mesh, const Eigen::Matrix3d& gradient) {
  return std::vector<Eigen::Matrix3d>(mesh.vertex_count(), gradient);
}

class MeshEdit : public MeshFiles {
 protected:
  /// The file that is written of this one when it is moved by a matrix.
  std::string moved(const Example& example, const Eigen::Matrix3d& by) const {
    const std::string name = std::string("in.") + example.name;
    Mesh mesh = load(example.text, name);
    mesh.set_positions(mesh.positions() * by.transpose(), everywhere(mesh, by));
    const std::filesystem::path out = folder / (std::string("out.") + example.name);
    EXPECT_TRUE(mesh.edits(out));
    EXPECT_EQ(mesh.save(out), std::vector<std::string>());
    return read_text(out);
  }

  void check(const std::vector<Example>& examples) const {
    for (const Example& example : examples) {
      SCOPED_TRACE(example.text);
      // Rounding alone moves nothing.
      EXPECT_EQ(moved(example, Eigen::Matrix3d::Identity()), example.text);
      const Eigen::Matrix3d nearly = Eigen::Matrix3d::Identity() * (1 + 1e-15);
      Mesh mesh = load(example.text, std::string("in.") + example.name);
      mesh.set_positions(mesh.positions(), everywhere(mesh, nearly));
      mesh.save(folder / (std::string("same.") + example.name));
      EXPECT_EQ(read_text(folder / (std::string("same.") + example.name)), example.text);
      EXPECT_EQ(moved(example, 2 * Eigen::Matrix3d::Identity()), example.doubled);
      const Eigen::Matrix3d mirror = Eigen::Vector3d(-1, 1, 1).asDiagonal();
      EXPECT_EQ(moved(example, mirror), example.mirrored);
    }
  }
};

TEST_F(MeshEdit, Obj) {
  check({
      // Comments, blank lines, statements that no other format has, corners of every kind.
      {"obj",
       "# a  #b\n\nmtllib  none.mtl\nv 0.50 0 0 # first\n  v 1e0 +0 0\nv\t0 1.0 0\nvt .5 0\nvn 0 0 "
       "2\n"
       "vp 0.1\ns 1\ng a b\nf 1/1/1 2/1/1 3/1/1\nl 1 2 3\np 1 2\nf -3//-1 2//1 3//1 # last",
       "# a  #b\n\nmtllib  none.mtl\nv 1 0 0 # first\n  v 2 +0 0\nv\t0 2 0\nvt .5 0\nvn 0 0 2\n"
       "vp 0.1\ns 1\ng a b\nf 1/1/1 2/1/1 3/1/1\nl 1 2 3\np 1 2\nf -3//-1 2//1 3//1 # last",
       "# a  #b\n\nmtllib  none.mtl\nv -0.5 0 0 # first\n  v -1 +0 0\nv\t0 1.0 0\nvt .5 0\nvn 0 0 "
       "2\n"
       "vp 0.1\ns 1\ng a b\nf 1/1/1 3/1/1 2/1/1\nl 1 2 3\np 1 2\nf -3//-1 3//1 2//1 # last"},
      // A byte order mark, CR, weights, lines that go on, numbers of more digits than binary32 has.
      {"obj", "\xEF\xBB\xBFv 1.00000000001 0 \\\r 0\rv 2 2 0 2\rv 0 1 0 0.1 0.2 0.3\rf 1 \\\r2 3\r",
       "\xEF\xBB\xBFv 2.00000000002 0 \\\r 0\rv 4 4 0 2\rv 0 2 0 0.1 0.2 0.3\rf 1 \\\r2 3\r",
       "\xEF\xBB\xBFv -1.00000000001 0 \\\r 0\rv -2 2 0 2\rv 0 1 0 0.1 0.2 0.3\rf 1 \\\r3 2\r"},
      // A comment that ends in a backslash does not go on.
      {"obj", "# C:\\scenes\\\r\nv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
       "# C:\\scenes\\\r\nv 0 0 0\r\nv 2 0 0\r\nv 0 2 0\r\nf 1 2 3\r\n",
       "# C:\\scenes\\\r\nv 0 0 0\r\nv -1 0 0\r\nv 0 1 0\r\nf 1 3 2\r\n"},
  });
}

/// A normal that several corners share and that they do no more stands once for each direction,
/// behind the one that was read.
TEST_F(MeshEdit, NormalsThatPart) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nvn 0 0 1\nf 1//2 2//2 3//2\nf 1//-2 2//-1 3//1\n";
  Mesh mesh = load(text, "a.obj");
  std::vector<Eigen::Matrix3d> gradients = everywhere(mesh, Eigen::Matrix3d::Identity());
  gradients[2] = Eigen::AngleAxisd(EIGEN_PI / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
  mesh.set_positions(mesh.positions(), gradients);
  mesh.save(folder / "b.obj");
  const std::string written = read_text(folder / "b.obj");
  expect_part(written, "v 0 1 0\nvn 1 0 0\nvn 0 0 1\nvn 0 -1 ");
  expect_part(written, "\nf 1//2 2//2 3//3\nf 1//-3 2//-2 3//1\n");
  const Mesh again = Mesh::load(folder / "b.obj");
  int checked = 0;
  each_vertex(again, [&](const aiMesh& part, unsigned v) {
    if (part.mVertices[v] != aiVector3D(0, 1, 0)) return;
    const aiVector3D n = part.mNormals[v];
    EXPECT_TRUE(n == aiVector3D(1, 0, 0) || (n - aiVector3D(0, -1, 0)).Length() < 1e-6f);
    ++checked;
  });
  EXPECT_EQ(checked, 2);
}

}  // namespace
}  // namespace hwffd
