// What files in the wild look like: each reader takes them, or says why not.

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "errors.hpp"
#include "mesh_files.hpp"

namespace hwffd {
namespace {

using MeshFormats = MeshFiles;

/// A square and what stands around it in the formats.
const char* const kPoints = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

Points square() {
  Points points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  return points;
}

std::string ply(const std::string& vertex, const std::string& face, const std::string& data) {
  return "ply\nformat ascii 1.0\nelement vertex 4\n" + vertex + "element " + face + "end_header\n" +
         data;
}

const char* const kXyz = "property float x\nproperty float y\nproperty float z\n";
const char* const kFace = "face 1\nproperty list uchar int vertex_indices\n";

struct File {
  const char* name;
  std::string text;
};

TEST_F(MeshFormats, SquaresInTheWild) {
  const std::string mark = "\xEF\xBB\xBF";
  const std::vector<File> files{
      {"indented.obj", "  v 0 0 0\n\tv 1 0 0\n v 1 1 0\n v 0 1 0\n  f 1 2 3 4\n"},
      {"cr.obj", "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r"},
      {"mark.obj", mark + "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4"},
      {"comments.obj", "v 0 0 0 # a\nv 1 0 0#b\nv 1 1 0 #\nv 0 1 0\n\n# c\\\nf 1 2 3 4 # d 5\n"},
      {"capitals.obj", "v 0E0 0 0\nv 1E+0 0 0\nv 10E-1 1.0E0 0\nv 0 1 0\nf 1 2 3 4\n"},
      {"comments.ply",
       ply("property float x\ncomment a b\nproperty float y\nobj_info c\nproperty float z\n", kFace,
           std::string(kPoints) + "4 0 1 2 3\n")},
      {"lines.ply", ply(kXyz, kFace, "0\n0\n0\n1 0 0 1\n1 0 0 1 0\n4\n0\n1 2\n3 trailing")},
      {"types.ply", ply("property uchar y\nproperty double w\nproperty short x\nproperty int z\n",
                        "face 1\nproperty list int uchar vertex_index\n",
                        "0 7 0 0\n0 7 1 0\n1 7 1 0\n1 7 0 0\n4 0 1 2 3\n")},
      {"crlf.ply",
       "ply\r\nformat ascii 1.0\r\nelement vertex 4\r\nproperty float x\r\n"
       "property float y\r\nproperty float z\r\nelement face 1\r\n"
       "property list uchar int vertex_indices\r\nend_header\r\n"
       "0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n4 0 1 2 3\r\n"},
      {"strip.ply", ply(kXyz, "tristrips 1\nproperty list int int vertex_indices\n",
                        std::string(kPoints) + "4 0 1 3 2\n")},
      {"strips.ply", ply(kXyz, "tristrips 1\nproperty list int int vertex_indices\n",
                         std::string(kPoints) + "8 0 1 2 -1 0 2 3 -1\n")},
      {"comments.off", std::string("# a\nOFF # b\n4 1 # no edges\n\n") + kPoints +
                           "# faces\n4 0 1 # c\n2 3 255 0 0\n"},
      {"one-line.off", "OFF 4 1 0 0 0 0 1 0 0 1 1 0 0 1 0 4 0 1 2 3"},
      {"no-keyword.off", "4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"},
      {"normals.off",
       "NOFF\n4 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n4 0 1 2 3\n"},
      {"colours.off",
       "COFF\r\n4 1 0\r\n0 0 0 255 0 0 255\r\n1 0 0 255 0 0 255\r\n"
       "1 1 0 255 0 0 255\r\n0 1 0 255 0 0 255\r\n4 0 1 2 3\r\n"},
      {"capitals.stl",
       "SOLID A B\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\n"
       "VERTEX 1 1 0\nENDLOOP\nENDFACET\nFACET NORMAL 0 0 1 OUTER LOOP\n"
       "VERTEX 0 0 0\nVERTEX 1 1 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\nENDSOLID A B\n"},
      {"long.stl",
       "solid " + std::string(5000, 'x') +
           "\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
           "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
           "vertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"}};
  for (const File& file : files) {
    SCOPED_TRACE(file.name);
    const Mesh mesh = load(file.text, file.name);
    EXPECT_EQ(mesh.positions(), square());
    EXPECT_EQ(mesh.triangles().size(), 2u);
    double area = 0;
    for (const Mesh::Triangle& t : mesh.triangles()) {
      const Eigen::RowVector3d a = mesh.positions().row(t[1]) - mesh.positions().row(t[0]);
      const Eigen::RowVector3d b = mesh.positions().row(t[2]) - mesh.positions().row(t[0]);
      area += a.cross(b).z();
    }
    EXPECT_EQ(area, 2);
  }
  EXPECT_EQ(files.size(), 18u);
}

/// Data of a binary file may begin with a byte that ends lines elsewhere, and something may follow.
TEST_F(MeshFormats, BinaryPlyThatBeginsWithALineEnd) {
  const std::vector<float> numbers{0.70339459f, 0.5f, 0.25f, 1, 2, 3};  // first byte 0x0a
  for (const std::string ending : {"\n", "\r", "\r\n"}) {
    std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex 2\n" +
                       std::string(kXyz) + "end_header\n";
    for (std::size_t at = text.find('\n'); at != text.npos;
         at = text.find('\n', at + ending.size())) {
      text.replace(at, 1, ending);
    }
    std::string bytes(sizeof(float) * numbers.size(), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    bytes[0] = '\n';
    float first = 0;
    std::memcpy(&first, bytes.data(), sizeof(first));
    const Mesh mesh = load(text + bytes + "more", "a.ply");
    EXPECT_EQ(mesh.vertex_count(), 2u);
    EXPECT_EQ(mesh.positions()(0, 0), first);
    EXPECT_EQ(mesh.positions()(1, 2), 3);
  }
}

TEST_F(MeshFormats, TextureCoordinatesOfCorners) {
  const Mesh mesh = load(
      ply(kXyz,
          "face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n",
          std::string(kPoints) + "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 .5 0 1 .5 0 1\n"),
      "a.ply");
  mesh.save(folder / "b.obj");
  const std::string text = read_text(folder / "b.obj");
  expect_part(text, "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n");
  expect_part(text, "vt 0.5 0\nvt 1 0.5\nvt 0 1\nf 1/4 3/5 4/6\n");
}

/// Colours of bytes, of wide integers and of numbers up to 255, whatever they are called.
TEST_F(MeshFormats, Colours) {
  const std::string rgb = "property T red\nproperty T green\nproperty T blue\n";
  std::vector<File> files{{"a.obj",
                           "v 0 0 0 255 128 0\nv 1 0 0 255 128 0\nv 1 1 0 255 128 0\n"
                           "v 0 1 0 255 128 0\nf 1 2 3 4\n"},
                          {"a.off",
                           "COFF\n4 1 0\n0 0 0 255 128 0\n1 0 0 255 128 0\n1 1 0 255 128 0\n"
                           "0 1 0 255 128 0\n4 0 1 2 3\n"}};
  for (const std::string type : {"uchar", "float", "int"}) {
    for (const std::string name : {"", "diffuse_"}) {
      const std::string properties = "property " + type + " " + name + "red\nproperty " + type +
                                     " " + name + "green\nproperty " + type + " " + name + "blue\n";
      files.push_back({"a.ply", ply(kXyz + properties, kFace,
                                    "0 0 0 255 128 0\n1 0 0 255 128 0\n1 1 0 255 128 0\n"
                                    "0 1 0 255 128 0\n4 0 1 2 3\n")});
    }
  }
  int checked = 0;
  for (const File& file : files) {
    SCOPED_TRACE(file.text);
    const Mesh mesh = load(file.text, file.name);
    EXPECT_TRUE(mesh.dropped().empty());
    ASSERT_TRUE(mesh.scene().mMeshes[0]->HasVertexColors(0));
    const aiColor4D c = mesh.scene().mMeshes[0]->mColors[0][1];
    EXPECT_EQ(c, aiColor4D(1, 128.0f / 255.0f, 0, 1));
    ++checked;
  }
  EXPECT_EQ(checked, 8);
}

TEST_F(MeshFormats, BrokenFilesAreRefused) {
  const std::string stl = std::string("solid part") + std::string(70, ' ');
  const std::vector<File> files{
      {"face.obj", "v 0 0 0\nf 1 2 3\n"},
      {"zero.obj", "v 0 0 0\nf 0 1 1\n"},
      {"word.obj", "v 0 0 0\nf 1 1 one\n"},
      {"back.obj", "v 0 0 0\nf 1 -2 1\n"},
      {"normal.obj", "v 0 0 0\nf 1//1 1 1\n"},
      {"short.off", "OFF\n3 1 0\n0 0 0\n"},
      {"face.off", "OFF\n1 1 0\n0 0 0\n3 0 0 1\n"},
      {"huge.off", "OFF\n4000000000 1 0\n0 0 0\n"},
      {"4.off", "4OFF\n1 0 0\n0 0 0 1\n"},
      {"short.stl", stl + std::string("\x02\0\0\0", 4) + std::string(60, '\0')},
      {"word.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 zero 0\n"},
      {"xyz.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"}};
  for (const File& file : files) {
    SCOPED_TRACE(file.name);
    const auto path = folder.write(file.name, file.text);
    const std::string message = message_of<Error>([&] { Mesh::load(path); });
    EXPECT_EQ(message.rfind(path.string() + ": ", 0), 0u) << message;
  }
}

/// Doubles stay doubles from file to file, 0.3 m at coordinates of millions.
TEST_F(MeshFormats, DoublesStayDoubles) {
  const std::vector<File> files{
      {"a.obj",
       "v 500000.1 4649776.25 100.125\nv 500000.4 4649776.25 100.125\nv 500000.1 4649776.55 "
       "100.125\nf 1 2 3\n"},
      {"a.off",
       "OFF\n3 1 0\n500000.1 4649776.25 100.125\n500000.4 4649776.25 100.125\n500000.1 "
       "4649776.55 100.125\n3 0 1 2\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
       "property double z\nelement face 1\nproperty list uchar int vertex_indices\n"
       "end_header\n500000.1 4649776.25 100.125\n500000.4 4649776.25 100.125\n"
       "500000.1 4649776.55 100.125\n3 0 1 2\n"}};
  for (const File& file : files) {
    SCOPED_TRACE(file.name);
    const Mesh mesh = load(file.text, file.name);
    EXPECT_FALSE(mesh.is_single());
    for (const std::string name : {"b.obj", "b.off", "b.ply"}) {
      EXPECT_EQ(again(mesh, name).positions(), mesh.positions()) << name;
      EXPECT_EQ(mesh.positions()(1, 0), 500000.4);
    }
  }
}

}  // namespace
}  // namespace hwffd
