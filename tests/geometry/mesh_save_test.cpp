#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <cstdlib>
#include <set>
#include <sstream>

#include "errors.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "temp_folder.hpp"

namespace hwffd {
namespace {

using Place = std::array<double, 3>;

std::multiset<Place> places(const Mesh& mesh) {
  std::multiset<Place> result;
  for (Eigen::Index i = 0; i < mesh.positions().rows(); ++i) {
    result.insert({mesh.positions()(i, 0), mesh.positions()(i, 1), mesh.positions()(i, 2)});
  }
  return result;
}

/// A mesh whose coordinates need all bits of binary32.
Mesh moved_knot() {
  Mesh mesh = Mesh::procedural();
  mesh.set_positions((mesh.positions() * 0.3).rowwise() + Eigen::RowVector3d(0.1, -5.0, 100.0));
  return mesh;
}

double largest_error(const Mesh& got, const Mesh& expected) {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < got.positions().rows(); ++i) {
    const Eigen::RowVector3d p = got.positions().row(i);
    largest = std::max(
        largest, (expected.positions().rowwise() - p).cwiseAbs().rowwise().maxCoeff().minCoeff());
  }
  return largest;
}

/// Binary formats keep every bit; of the text formats only Assimp's readers round the last one.
TEST(MeshSave, RoundTripOfEveryFormat) {
  const TempFolder folder;
  const Mesh mesh = moved_knot();
  for (const std::string name : {"a.ply", "a.stl", "a.glb", "a.gltf", "a.obj", "a.dae", "a.PLY"}) {
    mesh.save(folder / name);
    const Mesh again = Mesh::load(folder / name);
    EXPECT_EQ(again.vertex_count(), mesh.vertex_count()) << name;
    EXPECT_EQ(again.triangles().size(), mesh.triangles().size()) << name;
    const bool is_text = name == "a.obj" || name == "a.dae";
    if (is_text) {
      EXPECT_LE(largest_error(again, mesh), 0x1p-17) << name;  // one ulp of 100
    } else {
      EXPECT_EQ(places(again), places(mesh)) << name;
    }
  }
}

/// The obj file itself holds the exact numbers: nine digits.
TEST(MeshSave, ObjHoldsExactNumbers) {
  const TempFolder folder;
  const Mesh mesh = moved_knot();
  mesh.save(folder / "a.obj");
  std::multiset<Place> found;
  std::istringstream lines(read_text(folder / "a.obj"));
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("v ", 0) != 0) continue;
    Place place{};
    const char* text = line.c_str() + 1;
    for (double& value : place) {
      char* end = nullptr;
      value = std::strtof(text, &end);
      text = end;
    }
    found.insert(place);
  }
  EXPECT_EQ(found.size(), 3072u);
  EXPECT_EQ(found, places(mesh));
}

/// A model smaller than the distance at which Assimp's own steps join vertices.
TEST(MeshSave, TinyModelKeepsItsVertices) {
  const TempFolder folder;
  Mesh mesh = Mesh::procedural();
  mesh.set_positions(mesh.positions() * 1e-6);
  for (const std::string name : {"a.ply", "a.stl", "a.glb", "a.gltf", "a.obj", "a.dae"}) {
    mesh.save(folder / name);
    EXPECT_EQ(Mesh::load(folder / name).vertex_count(), mesh.vertex_count()) << name;
  }
}

/// The bin file of a gltf does not fit: neither it nor the gltf is touched.
TEST(MeshSave, FailedWriteLeavesOldFiles) {
  const TempFolder folder;
  folder.write("a.gltf", "old");
  folder.write("a.bin", "old");
  const Mesh mesh = Mesh::procedural();
  rlimit old{};
  ::getrlimit(RLIMIT_FSIZE, &old);
  const rlimit small{20000, old.rlim_max};
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::string text = message_of<Error>([&] { mesh.save(folder / "a.gltf"); });
  ::setrlimit(RLIMIT_FSIZE, &old);
  ::signal(SIGXFSZ, handler);
  expect_part(text, "cannot write: File too large");
  EXPECT_EQ(read_text(folder / "a.gltf"), "old");
  EXPECT_EQ(read_text(folder / "a.bin"), "old");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a.bin", "a.gltf"}));
}

TEST(MeshSave, UnknownExtensionListsTheKnownOnes) {
  const TempFolder folder;
  const Mesh mesh = Mesh::procedural();
  const std::string list = "; use the extension obj, ply, off, stl, glb, gltf or dae";
  EXPECT_USAGE_ERROR(mesh.save(folder / "a.xyz"),
                     (folder / "a.xyz").string() + ": cannot write .xyz meshes" + list);
  EXPECT_USAGE_ERROR(mesh.save(folder / "a"),
                     (folder / "a").string() + ": cannot write without an extension" + list);
  EXPECT_USAGE_ERROR(Mesh::check_format("a.xyz"), "a.xyz: cannot write .xyz meshes" + list);
  Mesh::check_format("a.PLY");
  EXPECT_TRUE(Mesh::can_save("a.PLY"));
  EXPECT_FALSE(Mesh::can_save("a.json"));
  EXPECT_TRUE(folder.files().empty());
}

TEST(MeshSave, MissingFolder) {
  const TempFolder folder;
  EXPECT_ERROR_PART(Mesh::procedural().save(folder / "no/a.ply"),
                    "a.ply: cannot write: No such file or directory; check that the folder exists");
}

}  // namespace
}  // namespace hwffd
