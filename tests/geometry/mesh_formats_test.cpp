// What files in the wild look like: each reader takes them, or says why not.

#include <assimp/material.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
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
      {"tiny.obj", "v 1e-400 -0 +0\nv 1 -1E-999 0\nv +1 1 0\nv 0 1 0\nf 1 2 3 4\n"},
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
      {"blanks.ply", ply("property  float x \nproperty\tfloat y\t\n property float z\n", kFace,
                         std::string(kPoints) + "4 0 1 2 3\n")},
      {"texture.ply", ply("comment TextureFile\ncomment TextureFile \n" + std::string(kXyz), kFace,
                          std::string(kPoints) + "4 0 1 2 3\n")},
      {"more.ply",
       ply(kXyz,
           "vertex 1\nproperty list uchar float x\nelement tristrips 1\nproperty int id\n"
           "property list int int vertex_indices\nelement face 1\n"
           "property list uchar int vertex_indices\n",
           std::string(kPoints) + "2 8 9\n77 4 0 1 3 2\n0\n")},
      {"strip.ply", ply(kXyz, "tristrips 1\nproperty list int int vertex_indices\n",
                        std::string(kPoints) + "4 0 1 3 2\n")},
      {"strips.ply", ply(kXyz, "tristrips 1\nproperty list int int vertex_indices\n",
                         std::string(kPoints) + "8 0 1 2 -1 0 2 3 -1\n")},
      {"comments.off", std::string("# a\nOFF # b\n4 1 # no edges\n\n") + kPoints +
                           "# faces\n4 0 1 # c\n2 3 255 0 0\n"},
      {"loose.off", std::string("OFF +4 +2 0\n") + kPoints + "0\n4 0 1 2 3\n"},
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
           "vertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"},
      {"blank.stl",
       "\n \nsolid\n\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0\nvertex 1 1 0 "
       "endloop "
       "endfacet facet normal 0 0 1 outer loop\nvertex 0 0 0 vertex 1 1 0 vertex 0 1 0 endloop\n"
       "endfacet endsolid\n"}};
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
  EXPECT_EQ(files.size(), 24u);
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
      const std::string properties = fmt::format(
          "property {0} {1}red\nproperty {0} {1}green\nproperty {0} {1}blue\n", type, name);
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

/// Colours by what their types hold, or, of numbers up to 1, as they are.
TEST_F(MeshFormats, ColoursUpToOne) {
  const auto vertices = [](const std::string& colour) {
    return "0 0 0 " + colour + "\n1 0 0 " + colour + "\n1 1 0 " + colour + "\n0 1 0 " + colour +
           "\n4 0 1 2 3\n";
  };
  std::vector<File> files{{"a.off", "COFF\n4 1 0\n" + vertices("1 0.5 0 0.25")}};
  for (const auto& [type, colour] :
       std::vector<std::pair<std::string, std::string>>{{"float", "1 0.5 0 0.25"},
                                                        {"double", "1 0.5 0 0.25"},
                                                        {"char", "127 63.5 0 31.75"},
                                                        {"short", "32767 16383.5 0 8191.75"},
                                                        {"ushort", "65535 32767.5 0 16383.75"}}) {
    std::string properties = kXyz;
    for (const std::string name : {"red", "green", "blue", "alpha"}) {
      properties += fmt::format("property {} {}\n", type, name);
    }
    files.push_back({"a.ply", ply(properties, kFace, vertices(colour))});
  }
  for (const File& file : files) {
    SCOPED_TRACE(file.text);
    const Mesh mesh = load(file.text, file.name);
    ASSERT_TRUE(mesh.scene().mMeshes[0]->HasVertexColors(0));
    EXPECT_EQ(mesh.scene().mMeshes[0]->mColors[0][2], aiColor4D(1, 0.5f, 0, 0.25f));
  }
  EXPECT_EQ(files.size(), 6u);
}

/// Of materials of one name in several libraries the first counts, a library that is named twice is
/// read once, and a material that none has is made; groups without a name are one.
TEST_F(MeshFormats, GroupsAndLibrariesOfObj) {
  folder.write("a.mtl", "newmtl red\nKd 1 0 0\naniso 1\n");
  folder.write("b.mtl", "newmtl red\nKd 0 1 0\n");
  const std::string text =
      "mtllib a.mtl a.mtl\nmtllib b.mtl\nmtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng\ns\n"
      "usemtl none\nf 1 2 3\ng side\ns off\nusemtl red\nf 1 3 4\ng\ns 0\nusemtl none\nf 1 2 4\n";
  const Mesh mesh = load(text);
  std::vector<std::string> parts;
  for (unsigned m = 0; m < mesh.scene().mNumMeshes; ++m) {
    const aiMesh& part = *mesh.scene().mMeshes[m];
    aiString material;
    mesh.scene().mMaterials[part.mMaterialIndex]->Get(AI_MATKEY_NAME, material);
    parts.push_back(std::string(part.mName.C_Str()) + ", " + material.C_Str());
  }
  EXPECT_EQ(parts, (std::vector<std::string>{"default, none", "side, red", "default, none"}));
  EXPECT_EQ(mesh.scene().mMeshes[0]->mMaterialIndex, mesh.scene().mMeshes[2]->mMaterialIndex);
  aiColor3D colour;
  mesh.scene().mMaterials[mesh.scene().mMeshes[1]->mMaterialIndex]->Get(AI_MATKEY_COLOR_DIFFUSE,
                                                                        colour);
  EXPECT_EQ(colour, aiColor3D(1, 0, 0));
  EXPECT_EQ(mesh.dropped(), std::vector<std::string>{"statement aniso of materials"});
  EXPECT_EQ(load("s 1\n" + text).dropped(),
            (std::vector<std::string>{"smoothing groups", "statement aniso of materials"}));
}

/// A facet of a binary stl file: its normal, corners and last two bytes.
struct Facet {
  std::array<float, 12> numbers;
  std::uint16_t attribute;
};

std::string stl_bytes(std::string header, const std::vector<Facet>& facets) {
  header.resize(80, ' ');
  const auto count = static_cast<std::uint32_t>(facets.size());
  std::string bytes = header + std::string(reinterpret_cast<const char*>(&count), sizeof(count));
  for (const Facet& facet : facets) {
    bytes.append(reinterpret_cast<const char*>(facet.numbers.data()), sizeof(facet.numbers));
    bytes.append(reinterpret_cast<const char*>(&facet.attribute), sizeof(facet.attribute));
  }
  return bytes;
}

/// Each solid of a text is a part with its name; a place where two of them meet has a vertex in
/// each.
TEST_F(MeshFormats, SolidsOfStl) {
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
  const Mesh mesh = load("solid left wing\n" + facet +
                             "vertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid left wing\n"
                             "solid\n" +
                             facet + "vertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n",
                         "a.stl");
  ASSERT_EQ(mesh.scene().mNumMeshes, 2u);
  EXPECT_STREQ(mesh.scene().mMeshes[0]->mName.C_Str(), "left wing");
  EXPECT_STREQ(mesh.scene().mMeshes[1]->mName.C_Str(), "");
  for (unsigned m = 0; m < 2; ++m) EXPECT_EQ(mesh.scene().mMeshes[m]->mNumFaces, 1u);
  EXPECT_EQ(mesh.vertex_count_read(), 6u);
  EXPECT_EQ(mesh.positions(), square());
}

/// Two programs keep five bits of red, green and blue in a facet, each in its order; a facet
/// without is white. Corners of two colours are two vertices.
TEST_F(MeshFormats, ColoursOfFacetsOfStl) {
  const std::array<float, 12> first{0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0};
  const std::array<float, 12> second{0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 0};
  constexpr std::uint16_t kHas = 0x8000;
  for (const bool is_red_first : {false, true}) {
    const std::uint16_t colour = is_red_first ? kHas | 31 | 8 << 5 : kHas | 31 << 10 | 8 << 5;
    const std::string header = is_red_first ? "COLOR=abcd" : "";
    for (const bool is_first_white : {false, true}) {
      const Mesh mesh =
          load(stl_bytes(header, {{first, is_first_white ? std::uint16_t{0} : colour},
                                  {second, is_first_white ? colour : std::uint16_t{0}}}),
               "a.stl");
      EXPECT_TRUE(mesh.dropped().empty());
      EXPECT_EQ(mesh.vertex_count_read(), 6u);
      EXPECT_EQ(mesh.vertex_count(), 4u);
      const aiMesh& part = *mesh.scene().mMeshes[0];
      ASSERT_TRUE(part.HasVertexColors(0));
      for (unsigned f = 0; f < 2; ++f) {
        const bool is_white = (f == 0) == is_first_white;
        const aiColor4D expected =
            is_white ? aiColor4D(1, 1, 1, 1) : aiColor4D(1, 8.0f / 31.0f, 0, 1);
        for (unsigned c = 0; c < 3; ++c) {
          EXPECT_EQ(part.mColors[0][part.mFaces[f].mIndices[c]], expected) << f;
        }
      }
    }
  }
  // Other bytes there are no colours; they are named once.
  const Mesh mesh = load(stl_bytes("", {{first, 7}, {second, 9}}), "a.stl");
  EXPECT_FALSE(mesh.scene().mMeshes[0]->HasVertexColors(0));
  EXPECT_EQ(mesh.dropped(), std::vector<std::string>{"attributes of facets"});
}

/// Facets of one place are one vertex, however many meet there and whatever their normals are.
TEST_F(MeshFormats, ManyFacetsOfStlMeet) {
  constexpr int kFacets = 600;
  std::vector<Facet> facets;
  for (int n = 0; n < kFacets; ++n) {
    const auto i = static_cast<float>(n);
    facets.push_back({{i, 1, 0, 0, 0, 0, 1, i, 0, 1, i + 1, 0}, 0});
  }
  facets.push_back({{0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0}, 0});  // two corners in one place
  const Mesh mesh = load(stl_bytes("", facets), "a.stl");
  EXPECT_EQ(mesh.vertex_count(), kFacets + 2u);
  EXPECT_EQ(mesh.triangles().size(), kFacets + 1u);
  EXPECT_EQ(mesh.triangles().back(), (Mesh::Triangle{0, 0, 1}));
  mesh.save(folder / "b.stl");
  EXPECT_EQ(read_text(folder / "b.stl"), read_text(folder / "a.stl"));
}

/// The material of an obj file whose library has this text behind newmtl, and what it drops.
struct ReadMaterial {
  std::vector<std::string> dropped;
  aiColor3D diffuse;
  float opacity = 0;
  int shading = 0;
  std::string picture;
};

ReadMaterial read_material(const std::string& library) {
  const TempFolder folder;
  folder.write("a.mtl", library);
  const Mesh mesh = Mesh::load(
      folder.write("a.obj", "mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  const unsigned number = mesh.scene().mMeshes[0]->mMaterialIndex;
  const aiMaterial& material = *mesh.scene().mMaterials[number];
  ReadMaterial read{mesh.dropped(), {}, 0, 0, ""};
  EXPECT_EQ(material.Get(AI_MATKEY_COLOR_DIFFUSE, read.diffuse), aiReturn_SUCCESS);
  EXPECT_EQ(material.Get(AI_MATKEY_OPACITY, read.opacity), aiReturn_SUCCESS);
  EXPECT_EQ(material.Get(AI_MATKEY_SHADING_MODEL, read.shading), aiReturn_SUCCESS);
  aiString picture;
  material.GetTexture(aiTextureType_DIFFUSE, 0, &picture);
  read.picture = picture.C_Str();
  return read;
}

/// Statements as the format has them; what none of it is, is named, and changes nothing.
TEST_F(MeshFormats, StatementsOfMaterialLibraries) {
  const aiColor3D grey(0.6f, 0.6f, 0.6f);  // of a material that says nothing
  struct Row {
    std::string text;
    aiColor3D diffuse;
    float opacity;
    int shading;
    std::string picture;
    std::vector<std::string> dropped;
  };
  const int plain = aiShadingMode_Gouraud;
  const std::vector<Row> rows{
      {"", grey, 1, plain, "", {}},
      {"Kd 0.25", {0.25f, 0.25f, 0.25f}, 1, plain, "", {}},
      {"KD 0.25 0.5 1 # blue", {0.25f, 0.5f, 1}, 1, plain, "", {}},
      {"Kd 0.25 0.5", grey, 1, plain, "", {"Kd"}},
      {"Kd", grey, 1, plain, "", {"Kd"}},
      {"Kd spectral a.rfl 1", grey, 1, plain, "", {"Kd"}},
      {"Kd 0.25 0.5 x", grey, 1, plain, "", {"Kd"}},
      {"d 0.75", grey, 0.75f, plain, "", {}},
      {"Tr 0.25", grey, 0.75f, plain, "", {}},
      {"Tr 0.25 0.5", grey, 1, plain, "", {"Tr"}},
      {"d -halo 0.5", grey, 1, plain, "", {"d"}},
      {"d half", grey, 1, plain, "", {"d"}},
      {"illum 0", grey, 1, aiShadingMode_NoShading, "", {}},
      {"illum 2", grey, 1, aiShadingMode_Phong, "", {}},
      {"sharpness 60", grey, 1, plain, "", {"sharpness"}},
      {"map_Kd my wood.png", grey, 1, plain, "my wood.png", {}},
      {"map_Kd -clamp on my wood.png", grey, 1, plain, "my wood.png", {"-clamp of map_Kd"}},
      {"map_Kd -s 2 wood.png", grey, 1, plain, "wood.png", {"-s of map_Kd"}},
      {"map_Kd -mm 0 1 -o 1 wood.png",
       grey,
       1,
       plain,
       "wood.png",
       {"-mm of map_Kd", "-o of map_Kd"}},
      {"map_Kd -bm wood.png", grey, 1, plain, "wood.png", {"-bm of map_Kd"}},
      {"map_Kd -1.png", grey, 1, plain, "-1.png", {}},
      {"map_Kd -draft wood.png", grey, 1, plain, "-draft wood.png", {}}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.text);
    const ReadMaterial read = read_material("Kd 1 0 0\nd 0\nnewmtl m\n" + row.text + "\n");
    EXPECT_EQ(read.diffuse, row.diffuse);
    EXPECT_EQ(read.opacity, row.opacity);
    EXPECT_EQ(read.shading, row.shading);
    EXPECT_EQ(read.picture, row.picture);
    std::vector<std::string> dropped;
    for (const std::string& name : row.dropped) {
      dropped.push_back("statement " + name + " of materials");
    }
    EXPECT_EQ(read.dropped, dropped);
  }
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
       "500000.1 4649776.55 100.125\n3 0 1 2\n"},
      {"a.stl",
       "solid\nfacet normal 0 0 1\nouter loop\nvertex 500000.1 4649776.25 100.125\n"
       "vertex 500000.4 4649776.25 100.125\nvertex 500000.1 4649776.55 100.125\nendloop\n"
       "endfacet\nendsolid\n"}};
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
