#include "corpus.hpp"

#include <assimp/camera.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <memory>
#include <stdexcept>

#include "gltf_model.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "temp_folder.hpp"

namespace hwffd {
namespace {

const char* const kBox =
    R"({"hwffd_lattice": 1, "dims": [4, 5, 4], "shape": "box", "origin": [0, 0.5, -1e3],
        "edges": [[1, 0, 0], [0.25, 20, 0], [0, 0, 300]]})";
const char* const kCylinder =
    R"({"hwffd_lattice": 1, "dims": [4, 4, 6], "shape": "cylinder", "origin": [0, 0, 0],
        "edges": [[1, 0, 0], [0, 2, 0], [0, 0, 1]], "inner": 0.25})";
const char* const kSphere =
    R"({"hwffd_lattice": 1, "dims": [4, 5, 6], "shape": "sphere", "origin": [1, 2, 3],
        "edges": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]})";

const char* const kObj =
    "# a corner\nmtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1e-3\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nvn 1 0 0\n"
    "o part\ng floor\nusemtl red\ns 1\nf 1/1/1 2/2/1 3/3/1 4/1/1\n"
    "g wall\ns off\nf 1//2 2//2 5//2\nf -1 -2 -3\nl 1 2\np 4\n";

const char* const kPly =
    "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty float x\n"
    "property float y\nproperty float z\nproperty float nx\nproperty float ny\n"
    "property float nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 0 0 1 255 0 0\n1 0 0 0 0 1 255 0 0\n1 1 0 0 0 1 0 255 0\n0 1 0 0 0 1 0 0 255\n"
    "3 0 1 2\n3 0 2 3\n";

/// Strips, texture coordinates of corners, a list, whole numbers, an element of its own.
const char* const kPlyMore =
    "ply\nformat ascii 1.0\ncomment TextureFile a.png\nelement tristrips 1\n"
    "property list int int vertex_indices\nelement vertex 4\nproperty double x\n"
    "property short y\nproperty list uchar float l\nproperty float z\nelement face 2\n"
    "property list uchar int vertex_indices\nproperty list uchar float texcoord\nelement edge 1\n"
    "property int vertex1\nend_header\n7 0 1 2 -1 1 2 3\n0.1 0 1 5 0\n1 0 0 0\n1 1 2 3 4 0\n0 1 0 "
    "0\n"
    "3 0 1 2 6 0 0 1 0 1 1\n4 0 1 2 3 0\n3\n";

const char* const kStl =
    "solid wedge\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
    "endloop\nendfacet\nfacet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
    "vertex 0.5 0 -1\nendloop\nendfacet\nendsolid wedge\n";

/// The mesh of kObj in another format, which the extension chooses.
std::string converted(const std::string& extension) {
  const TempFolder folder;
  const Mesh mesh = Mesh::load(folder.write("a.obj", kObj));
  mesh.save(folder / ("b" + extension));
  return read_text(folder / ("b" + extension));
}

const char* const kOff =
    "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 1e-3\n4 0 1 2 3\n3 0 1 4\n";

const char* const kOffMore =
    "STCNOFF # all\n3 2 0\n0 0 0 0 0 1 255 0 0 255 0 0\n1 0 0 0 0 1 0 255 0 255 1 0\n"
    "0 1.5 0 0 0 1 0 0 255 255 0 1\n3 0 1 2 1 0 0\n2 0 1\n";

const char* const kRaw = "0 0 0 1 0 0 1 1 0\n0 0 0 1 1 0 0 1 0\n0 0 1 1 0 1 1 1 1\n";

}  // namespace

std::vector<std::string> lattice_corpus() {
  return {kBox, kCylinder, kSphere, lattice_text(parse_lattice(kBox))};
}

std::vector<std::string> deformation_corpus() {
  return {"none",       "twist",      "twist:90",    "twist:45:x",
          "helix:30",   "bend:40:yz", "shear:-0.5",  "bend:1e2",
          "taper:0.5",  "scale:2",    "scale:1,2,3", "move:1,2,3:0.5,-1,0",
          "random:123", "bend:-90.",  "to:a.json",   "random:18446744073709551615"};
}

std::vector<std::string> outside_corpus() { return {"keep", "clamp", "fade:0.5", "fade:1e-3"}; }

std::vector<std::string> stages_corpus() {
  return {"--lattice box --dims 4x5x6 --region 0,0,0,1,2,3 --deform twist:90",
          "--lattice sphere --deform bend:30 --deform taper:0.5 --lattice cylinder --dims 5x4x9",
          "--dims=16x16x16 --region=-1e-3,0,0,1,1,1"};
}

std::vector<std::string> points_corpus() {
  return {"# a comment\n0 0 0\n1.5,-2e3;+4\n\n\t7 8 9 # end\r\n", "1 2 3",
          "\xEF\xBB\xBF"
          "1,2,3\n4,5,6\n"};
}

std::vector<std::string> obj_corpus() { return {kObj}; }

std::vector<std::string> ply_corpus() { return {kPly, kPlyMore, converted(".ply")}; }

std::vector<std::string> stl_corpus() { return {kStl, converted(".stl")}; }

std::vector<std::string> off_corpus() { return {kOff, kOffMore}; }

std::vector<std::string> raw_corpus() { return {kRaw}; }

const TempFolder& mesh_folder() {
  static const TempFolder folder;
  return folder;
}

std::vector<std::string> exported_corpus(const std::vector<std::string>& exporters) {
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.ReadFileFromMemory(
      kObj, std::string(kObj).size(),
      aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_JoinIdenticalVertices, "obj");
  const std::unique_ptr<aiScene> scene(importer.GetOrphanedScene());
  if (scene == nullptr) throw std::logic_error(importer.GetErrorString());
  scene->mRootNode->mChildren[0]->mTransformation.a4 = 1;
  scene->mCameras = new aiCamera* [1] { new aiCamera() };
  scene->mNumCameras = 1;
  scene->mCameras[0]->mName = scene->mRootNode->mChildren[0]->mName;
  std::vector<std::string> corpus;
  for (const std::string& name : exporters) {
    Assimp::Exporter exporter;
    const std::filesystem::path path = mesh_folder() / name;
    if (exporter.Export(scene.get(), name, path.string()) != aiReturn_SUCCESS) {
      throw std::logic_error(name + ": " + exporter.GetErrorString());
    }
    corpus.push_back(read_text(path));
  }
  return corpus;
}

std::vector<std::string> gltf_corpus() { return {varied().text()}; }

std::vector<std::string> glb_corpus() { return {varied().container()}; }

}  // namespace hwffd
