// Meshes saved and loaded: bits, faces, groups, materials, and failures that leave old files.

#include <assimp/material.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <cstdint>
#include <cstring>
#include <set>

#include "errors.hpp"
#include "mesh_files.hpp"

namespace hwffd {
namespace {

using MeshSave = MeshFiles;
using Place = std::array<double, 3>;

std::multiset<Place> places_of(const Mesh& mesh) {
  std::multiset<Place> result;
  for (Eigen::Index i = 0; i < mesh.positions().rows(); ++i) {
    result.insert({mesh.positions()(i, 0), mesh.positions()(i, 1), mesh.positions()(i, 2)});
  }
  return result;
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

/// Coordinates that need all bits of binary32, and a model smaller than the distance at which
/// Assimp's own steps join vertices: every bit comes back, but that its reader of dae rounds.
TEST_F(MeshSave, RoundTripOfEveryFormat) {
  for (const auto& [size, at, ulp] :
       {std::tuple(0.3, Eigen::RowVector3d(0.1, -5.0, 100.0), 0x1p-17),
        std::tuple(1e-6, Eigen::RowVector3d(0, 0, 0), 0x1p-42)}) {
    Mesh mesh = Mesh::procedural();
    mesh.set_positions((mesh.positions() * size).rowwise() + at);
    for (const std::string name :
         {"a.ply", "a.stl", "a.glb", "a.gltf", "a.obj", "a.dae", "a.PLY"}) {
      const Mesh got = again(mesh, name);
      EXPECT_EQ(got.vertex_count(), mesh.vertex_count()) << name;
      EXPECT_EQ(got.triangles().size(), mesh.triangles().size()) << name;
      if (name == "a.dae") {
        EXPECT_LE(largest_error(got, mesh), ulp) << name;  // of the largest coordinate
      } else {
        EXPECT_EQ(places_of(got), places_of(mesh)) << name;
      }
    }
  }
}

/// The bin file of a gltf does not fit: neither it nor the gltf is touched.
TEST_F(MeshSave, FailedWriteLeavesOldFiles) {
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

TEST_F(MeshSave, UnknownExtensionListsTheKnownOnes) {
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

const char* const kMtl = "newmtl red\nKd 1 0 0\nmap_Kd red.png\nnewmtl blue\nKd 0 0 1\n";

/// A quad and a triangle in a group of two materials, two triangles in another.
const char* const kHouse =
    "mtllib in.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\n"
    "vt 0.25 0\nvt 1 0.5\nvt 0 1\nvn 0 0 1\nvn 0.6 0 0.8\n"
    "g big house\nusemtl red\nf 1/1/1 2/2/1 3/3/1 4/1/1\nusemtl blue\nf 1/1/2 2/2/2 5/3/2\n"
    "g shed\nusemtl red\nf 2/1/2 3/2/2 5/3/2\nf 3/1/2 4/2/2 5/3/2\n";

void describe(const aiScene& scene, const aiNode& node, std::multiset<std::string>& descriptions) {
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& part = *scene.mMeshes[node.mMeshes[i]];
    aiString material;
    scene.mMaterials[part.mMaterialIndex]->Get(AI_MATKEY_NAME, material);
    std::string text = std::string(node.mName.C_Str()) + ", " + material.C_Str() + ":";
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      text += " " + std::to_string(part.mFaces[f].mNumIndices);
    }
    descriptions.insert(text);
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c)
    describe(scene, *node.mChildren[c], descriptions);
}

/// Of each part its group, its material and the corners of its faces.
std::multiset<std::string> descriptions_of(const Mesh& mesh) {
  std::multiset<std::string> descriptions;
  describe(mesh.scene(), *mesh.scene().mRootNode, descriptions);
  return descriptions;
}

/// Position, normal and texture coordinates of every corner of every face.
std::set<std::array<float, 8>> corners_of(const Mesh& mesh) {
  std::set<std::array<float, 8>> corners;
  each_vertex(mesh, [&](const aiMesh& part, unsigned v) {
    const aiVector3D p = part.mVertices[v];
    const aiVector3D n = part.HasNormals() ? part.mNormals[v] : aiVector3D();
    const aiVector3D t = part.HasTextureCoords(0) ? part.mTextureCoords[0][v] : aiVector3D();
    corners.insert({p.x, p.y, p.z, n.x, n.y, n.z, t.x, t.y});
  });
  return corners;
}

class MeshKeep : public MeshFiles {
 protected:
  MeshKeep() { folder.write("in.mtl", kMtl); }

  /// The mesh in twice its size, saved and loaded.
  Mesh again(Mesh& mesh, const std::string& name) {
    mesh.set_positions(
        2.0 * mesh.positions(),
        std::vector<Eigen::Matrix3d>(mesh.vertex_count(), 2.0 * Eigen::Matrix3d::Identity()));
    return MeshFiles::again(mesh, name);
  }
};

TEST_F(MeshKeep, FacesGroupsMaterialsAndCorners) {
  struct Format {
    const char* name;
    std::multiset<std::string> descriptions;
  };
  const std::multiset<std::string> all{"big house, red: 4", "big house, blue: 3", "shed, red: 3 3"};
  const std::multiset<std::string> triangles{"big house, red: 3 3", "big house, blue: 3",
                                             "shed, red: 3 3"};
  const std::vector<Format> formats{{"a.obj", all},
                                    {"a.gltf", triangles},
                                    {"a.glb", triangles},
                                    {"a.ply", {", : 4 3 3 3"}},
                                    {"a.stl", {", DefaultMaterial: 3 3 3 3 3"}}};
  for (const Format& format : formats) {
    Mesh mesh = load(kHouse);
    ASSERT_EQ(descriptions_of(mesh), all);
    const Mesh got = again(mesh, format.name);
    EXPECT_EQ(descriptions_of(got), format.descriptions) << format.name;
    EXPECT_EQ(got.vertex_count(), 5u) << format.name;
    if (std::string(format.name) != "a.stl") {
      EXPECT_EQ(corners_of(got), corners_of(mesh)) << format.name;
    }
  }
}

TEST_F(MeshKeep, AMaterialLibraryBesideAnObj) {
  load(kHouse).save(folder / "house.glb");
  Mesh mesh = Mesh::load(folder / "house.glb");
  const Mesh got = again(mesh, "out.obj");
  EXPECT_EQ(folder.files(),
            (std::set<std::string>{"a.obj", "house.glb", "in.mtl", "out.mtl", "out.obj"}));
  expect_part(read_text(folder / "out.obj"), "mtllib out.mtl\n");
  aiColor3D colour;
  const unsigned material = got.scene().mMeshes[1]->mMaterialIndex;
  got.scene().mMaterials[material]->Get(AI_MATKEY_COLOR_DIFFUSE, colour);
  EXPECT_EQ(colour, aiColor3D(0, 0, 1));
}

TEST_F(MeshKeep, TextureNames) {
  for (const std::string name : {"a.obj", "a.gltf", "a.glb", "a.ply"}) {
    Mesh mesh = load(kHouse);
    const Mesh got = again(mesh, name);
    std::set<std::string> textures;
    for (unsigned m = 0; m < got.scene().mNumMaterials; ++m) {
      aiString texture;
      got.scene().mMaterials[m]->GetTexture(aiTextureType_DIFFUSE, 0, &texture);
      textures.insert(texture.C_Str());
    }
    EXPECT_EQ(textures.count("red.png"), 1u) << name;
  }
}

/// Colours of 8 bits, also in ply, whose binary form Assimp writes wrongly.
TEST_F(MeshKeep, Colours) {
  for (const std::string name : {"a.obj", "a.gltf", "a.glb", "a.ply"}) {
    Mesh mesh = load("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0.2 0.4 1\nf 1 2 3\n");
    const Mesh got = again(mesh, name);
    ASSERT_EQ(got.vertex_count(), 3u) << name;
    const aiMesh& part = *got.scene().mMeshes[0];
    ASSERT_TRUE(part.HasVertexColors(0)) << name;
    for (unsigned v = 0; v < 3; ++v) {
      const aiColor4D& want = mesh.scene().mMeshes[0]->mColors[0][v];
      const aiColor4D& is = part.mColors[0][v];
      EXPECT_EQ(part.mVertices[v], mesh.scene().mMeshes[0]->mVertices[v]) << name;
      EXPECT_LE(std::abs(is.r - want.r) + std::abs(is.g - want.g) + std::abs(is.b - want.b), 0.012)
          << name;
    }
  }
}

/// Lines and points stay where the format has them, and do not disturb one that has none.
TEST_F(MeshKeep, LinesAndPoints) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 5 5 5\nf 1 2 3\nl 1 2\np 4\n";
  struct Format {
    const char* name;
    std::size_t vertices;
  };
  for (const Format& format :
       std::vector<Format>{{"a.obj", 4}, {"a.ply", 4}, {"a.glb", 4}, {"a.stl", 3}}) {
    Mesh mesh = load(text);
    const Mesh got = again(mesh, format.name);
    EXPECT_EQ(got.vertex_count(), format.vertices) << format.name;
    EXPECT_EQ(got.triangles().size(), 1u) << format.name;
  }
  const Mesh points = load("v 0 0 0\nv 1 0 0\nl 1 2\np 1\n");
  EXPECT_ERROR(points.save(folder / "b.stl"),
               (folder / "b.stl").string() +
                   ": the mesh has no faces, and stl holds nothing else; use obj, ply or glb");
  EXPECT_EQ(folder.files().count("b.stl"), 0u);
}

/// The number of corners has a byte in a ply file.
TEST_F(MeshKeep, FaceOfManyCorners) {
  std::string text;
  std::string face = "f";
  for (int n = 0; n < 300; ++n) {
    const double angle = 2 * 3.14159265358979 * n / 300;
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    face += " " + std::to_string(n + 1);
  }
  for (const std::string name : {"a.obj", "a.ply", "a.glb", "a.stl"}) {
    Mesh mesh = load(text + face + "\n");
    const Mesh got = again(mesh, name);
    EXPECT_EQ(got.vertex_count(), 300u) << name;
    EXPECT_EQ(got.triangles().size(), 298u) << name;
  }
}

/// Little-endian bytes of a number.
template <typename T>
std::string bytes_of(T value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

std::string chunk(std::uint16_t id, const std::string& body) {
  return bytes_of(id) + bytes_of(static_cast<std::uint32_t>(body.size() + 6)) + body;
}

/// A 3ds file of one square: two triangles, of two materials, with texture coordinates.
std::string square_3ds() {
  const auto text = [](const std::string& s) { return s + '\0'; };
  const auto words = [](const std::vector<std::uint16_t>& list) {
    std::string bytes;
    for (const std::uint16_t w : list) bytes += bytes_of(w);
    return bytes;
  };
  const auto floats = [](const std::vector<float>& list) {
    std::string bytes;
    for (const float f : list) bytes += bytes_of(f);
    return bytes;
  };
  const std::string materials =
      chunk(0xAFFF, chunk(0xA000, text("red"))) + chunk(0xAFFF, chunk(0xA000, text("blue")));
  const std::string faces = words({2, 0, 1, 2, 0, 0, 2, 3, 0}) +
                            chunk(0x4130, text("red") + words({1, 0})) +
                            chunk(0x4130, text("blue") + words({1, 1}));
  const std::string shape =
      chunk(0x4110, words({4}) + floats({0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0})) +
      chunk(0x4140, words({4}) + floats({0, 0, 0.25f, 0, 0.25f, 0.5f, 0, 0.5f})) +
      chunk(0x4120, faces);
  const std::string object = chunk(0x4000, text("square") + chunk(0x4100, shape));
  const std::string node = chunk(0xB010, text("square") + words({0, 0, 0xFFFF}));
  return chunk(0x4D4D, chunk(0x3D3D, materials + object) +
                           chunk(0xB000, chunk(0xB002, chunk(0xB030, words({0})) + node)));
}

/// An object of two materials is one group of two parts.
TEST_F(MeshKeep, FromA3dsFile) {
  for (const std::string name : {"a.obj", "a.gltf", "a.glb"}) {
    Mesh mesh = load(square_3ds(), "in.3ds");
    const std::multiset<std::string> descriptions = descriptions_of(mesh);
    ASSERT_EQ(descriptions, (std::multiset<std::string>{"square, red: 3", "square, blue: 3"}));
    EXPECT_EQ(mesh.positions()(2, 1), 2.0);  // as written: y up
    const Mesh got = again(mesh, name);
    EXPECT_EQ(descriptions_of(got), descriptions) << name;
    EXPECT_EQ(corners_of(got), corners_of(mesh)) << name;
    EXPECT_TRUE(got.scene().mMeshes[0]->HasTextureCoords(0)) << name;
  }
}

}  // namespace
}  // namespace hwffd
