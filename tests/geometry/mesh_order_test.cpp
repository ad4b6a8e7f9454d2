// What goes in comes out: order and number of vertices, those without faces, clouds of points.

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "errors.hpp"
#include "mesh_files.hpp"

namespace hwffd {
namespace {

using Rows = std::vector<std::array<float, 3>>;

/// Places of the vertices, in the order of the file: repeated ones (0 and 3), one that no face uses
/// (2), and corners in another order than the faces take them.
const Rows kRows{{0, 0, 0}, {1, 0, 0}, {9, 8, 7}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}};

Rows halved() {
  Rows rows = kRows;
  for (auto& row : rows) {
    for (float& value : row) value *= 0.5f;
  }
  return rows;
}

std::string lines_of(const std::string& before) {
  std::string text;
  for (const auto& row : kRows) {
    text += before;
    for (const float value : row) text += std::to_string(static_cast<int>(value)) + " ";
    text += "\n";
  }
  return text;
}

std::string obj_text(bool has_faces) {
  return lines_of("v ") + (has_faces ? "f 6 5 2\nf 5 4 2\nf 1 6 2\n" : "");
}

std::string off_text() { return "OFF\n6 3 0\n" + lines_of("") + "3 5 4 1\n3 4 3 1\n3 0 5 1\n"; }

std::string ply_text(bool has_faces) {
  return "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
         "property float z\n" +
         std::string(has_faces ? "element face 3\nproperty list uchar int vertex_indices\n" : "") +
         "end_header\n" + lines_of("") + (has_faces ? "3 5 4 1\n3 4 3 1\n3 0 5 1\n" : "");
}

Rows rows_in_text(const std::string& text, const std::string& keyword) {
  Rows rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(keyword, 0) != 0) continue;
    std::istringstream words(line.substr(keyword.size()));
    std::array<float, 3> row{};
    words >> row[0] >> row[1] >> row[2];
    rows.push_back(row);
  }
  return rows;
}

/// The first `count` vertices of a binary ply file whose vertices are three numbers.
Rows rows_in_ply(const std::string& bytes, std::size_t count) {
  const std::string end = "end_header\n";
  Rows rows(count);
  std::memcpy(rows.data(), bytes.data() + bytes.find(end) + end.size(), count * sizeof(rows[0]));
  return rows;
}

Rows rows_of(const Mesh& mesh) {
  Rows rows;
  each_vertex(mesh, [&](const aiMesh& part, unsigned v) {
    rows.push_back({part.mVertices[v].x, part.mVertices[v].y, part.mVertices[v].z});
  });
  return rows;
}

class MeshOrder : public MeshFiles {
 protected:
  /// The mesh at half its size, saved under each of the names.
  void save(const std::filesystem::path& path, const std::vector<std::string>& names) {
    Mesh mesh = Mesh::load(path);
    EXPECT_EQ(mesh.vertex_count_read(), 6u) << path;
    EXPECT_EQ(mesh.vertex_count(), 5u) << path;
    mesh.set_positions(0.5 * mesh.positions());
    for (const std::string& name : names) {
      const std::vector<std::string> losses = mesh.save(folder / name);
      EXPECT_TRUE(losses.empty()) << path << " to " << name << ": " << losses.front();
    }
  }
};

TEST_F(MeshOrder, VerticesComeOutAsTheyWentIn) {
  const std::vector<std::filesystem::path> sources{folder.write("a.obj", obj_text(true)),
                                                   folder.write("a.off", off_text()),
                                                   folder.write("a.ply", ply_text(true))};
  for (const auto& source : sources) {
    save(source, {"b.obj", "b.off", "b.ply", "b.gltf", "b.glb"});
    EXPECT_EQ(rows_in_text(read_text(folder / "b.obj"), "v "), halved()) << source;
    expect_part(read_text(folder / "b.obj"), "\nf 6 5 2\nf 5 4 2\nf 1 6 2\n");
    if (source.extension() != ".off") {
      expect_part(read_text(folder / "b.off"), "OFF\n6 3 0\n0 0 0\n0.5 0 0\n4.5 4 3.5\n");
    }
    if (source.extension() != ".ply") {
      EXPECT_EQ(rows_in_ply(read_text(folder / "b.ply"), 6), halved()) << source;
    }
    for (const std::string name : {"b.off", "b.ply", "b.gltf", "b.glb"}) {
      EXPECT_EQ(rows_of(Mesh::load(folder / name)), halved()) << source << name;
    }
    save(folder / "b.glb", {"c.obj", "c.ply"});
    expect_part(read_text(folder / "c.obj"), "\nf 6 5 2\nf 5 4 2\nf 1 6 2\n");
  }
}

TEST_F(MeshOrder, PointsStayPoints) {
  const std::vector<std::filesystem::path> sources{folder.write("a.obj", obj_text(false)),
                                                   folder.write("a.ply", ply_text(false))};
  for (const auto& source : sources) {
    save(source, {"b.obj", "b.ply", "b.off", "b.glb"});
    const std::string obj = read_text(folder / "b.obj");
    EXPECT_EQ(rows_in_text(obj, "v "), halved());
    EXPECT_EQ(obj.find("\nf "), std::string::npos);
    const std::string ply = read_text(folder / "b.ply");
    if (source.extension() != ".ply") {
      EXPECT_EQ(rows_in_ply(ply, 6), halved());
    }
    EXPECT_EQ(ply.find("element face"), std::string::npos);
    for (const std::string name : {"b.obj", "b.ply", "b.glb"}) {
      const Mesh again = Mesh::load(folder / name);
      EXPECT_EQ(rows_of(again), halved()) << name;
      EXPECT_TRUE(again.triangles().empty()) << name;
    }
    for (const std::string name : {"b.stl", "b.dae"}) {
      const Mesh mesh = Mesh::load(source);
      EXPECT_ERROR_PART(mesh.save(folder / name), "the mesh has no faces");
    }
  }
}

/// One point, which is less than Assimp's reader takes, and points beside an object's name.
TEST_F(MeshOrder, SmallClouds) {
  EXPECT_EQ(load("v 1 2 3\n").vertex_count_read(), 1u);
  EXPECT_EQ(load("o dust\nv 1 2 3\nv 1 2 4\nvn 0 0 1\n").vertex_count_read(), 2u);
}

/// What an obj file numbers once stays one vertex where corners differ in texture coordinates.
TEST_F(MeshOrder, SeamsDoNotRepeatVerticesInObj) {
  Mesh mesh = load(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1/3 3/1 4/2\n");
  EXPECT_EQ(mesh.vertex_count_read(), 4u);
  EXPECT_TRUE(mesh.save(folder / "b.obj").empty());
  expect_part(read_text(folder / "b.obj"), "\nf 1/1 2/2 3/3\nf 1/3 3/1 4/2\n");
  EXPECT_EQ(mesh.save(folder / "b.ply"), std::vector<std::string>{"order of vertices"});
}

/// Coordinates of more digits than binary32 has stay double.
TEST_F(MeshOrder, ObjNumbersAreExact) {
  const Mesh mesh = load(
      "v 0.1 +1e-3 16777217\nv 1.00000017881393432617187499 2 4 2\n"
      "v 1 \\\n2 3 0.1 0.2 0.3\nf 1 2 3\n");
  Points expected(3, 3);
  expected << 0.1, 1e-3, 16777217, 0.5 * 1.00000017881393432617187499, 1, 2, 1, 2, 3;
  EXPECT_FALSE(mesh.is_single());
  EXPECT_EQ(mesh.positions(), expected);
  expected << 0.1f, 1e-3f, 1.00000012f, 0, 0, 0, 0, 0, 0;
  const Mesh single = load("v 0.1 +1e-3 1.00000012\nv 0 0 0\nf 1 2 2\n");
  EXPECT_TRUE(single.is_single());
  EXPECT_EQ(single.positions(), expected.topRows(2));
}

/// What a double cannot hold is zero, where it is small.
TEST_F(MeshOrder, ObjNumbersMayBeSmall) {
  const Mesh mesh =
      load("v 1e-50 -1e-400 1E-999\r\nv\t1 \\\r\n2 3\r\nvt 0 0\n# v 7 7 7\nv 1e-40 0 0\n");
  Points expected(3, 3);
  expected << 1e-50, 0, 0, 1, 2, 3, 1e-40, 0, 0;
  EXPECT_EQ(mesh.positions(), expected);
}

/// A face that crosses itself, so that no corner can be cut off, has as many triangles as any
/// other.
TEST_F(MeshOrder, AFaceThatCrossesItself) {
  Mesh mesh =
      load("v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 2 0\nv 1 -1 0\nv -1 1 0\nf 1 2 3 4\nf 1 2 3 4 5 6\n");
  mesh.save(folder / "b.glb");
  EXPECT_EQ(Mesh::load(folder / "b.glb").triangles().size(), 2u + 4u);
}

TEST_F(MeshOrder, ConcaveFacesAreCutInside) {
  // An arrow head: the fan from its first corner would lie outside.
  Mesh mesh = load("v 0 2 0\nv -2 -2 0\nv 0 -1 0\nv 2 -2 0\nf 2 3 4 1\n");
  EXPECT_EQ(mesh.save(folder / "b.glb"), std::vector<std::string>{"polygons (cut into triangles)"});
  const Mesh again = Mesh::load(folder / "b.glb");
  ASSERT_EQ(again.triangles().size(), 2u);
  double area = 0;
  for (const Mesh::Triangle& t : again.triangles()) {
    const Eigen::RowVector3d a = again.positions().row(t[1]) - again.positions().row(t[0]);
    const Eigen::RowVector3d b = again.positions().row(t[2]) - again.positions().row(t[0]);
    const double z = a.x() * b.y() - a.y() * b.x();
    EXPECT_GT(z, 0);
    area += z / 2;
  }
  EXPECT_DOUBLE_EQ(area, 6);
}

TEST_F(MeshOrder, StlSaysWhatIsLost) {
  const Mesh mesh = load("o wedge\n" + obj_text(true));
  EXPECT_EQ(mesh.save(folder / "b.stl"),
            (std::vector<std::string>{"order of vertices", "part names", "unused vertices"}));
}

}  // namespace
}  // namespace hwffd
