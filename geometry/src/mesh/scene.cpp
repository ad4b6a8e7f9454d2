#include "mesh/scene.hpp"

#include <assimp/SceneCombiner.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>
#include <vector>

namespace hwffd {
namespace {

/// Deletes an array of owned pointers of the scene.
template <typename T>
void drop(T**& items, unsigned& count) {
  for (unsigned i = 0; i < count; ++i) delete items[i];
  delete[] items;
  items = nullptr;
  count = 0;
}

/// One vertex attribute as raw memory.
struct Attribute {
  char* data;
  std::size_t size;
};

std::vector<Attribute> attributes(aiMesh& mesh) {
  std::vector<Attribute> list;
  const auto add = [&list](auto* data) {
    if (data != nullptr) list.push_back({reinterpret_cast<char*>(data), sizeof(*data)});
  };
  add(mesh.mVertices);
  add(mesh.mNormals);
  for (aiVector3D* data : mesh.mTextureCoords) add(data);
  for (aiColor4D* data : mesh.mColors) add(data);
  return list;
}

/// Keeps these vertices in this order.
/// @param index  old vertex -> new vertex, for the faces
void select(aiMesh& mesh, const std::vector<unsigned>& order, const std::vector<unsigned>& index) {
  std::string buffer;
  for (const Attribute& a : attributes(mesh)) {
    buffer.clear();
    for (const unsigned v : order) buffer.append(a.data + v * a.size, a.size);
    std::copy(buffer.begin(), buffer.end(), a.data);
  }
  mesh.mNumVertices = static_cast<unsigned>(order.size());
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    aiFace& face = mesh.mFaces[f];
    for (unsigned c = 0; c < face.mNumIndices; ++c) face.mIndices[c] = index[face.mIndices[c]];
  }
}

void join_corners(aiMesh& mesh) {
  const std::vector<Attribute> list = attributes(mesh);
  std::unordered_map<std::string, unsigned> seen;
  std::vector<unsigned> index(mesh.mNumVertices);
  std::vector<unsigned> order;
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    std::string key;
    for (const Attribute& a : list) key.append(a.data + v * a.size, a.size);
    const auto [entry, is_new] = seen.emplace(std::move(key), static_cast<unsigned>(seen.size()));
    index[v] = entry->second;
    if (is_new) order.push_back(v);
  }
  select(mesh, order, index);
}

void transform(aiMesh& mesh, const aiMatrix4x4& matrix) {
  if (matrix == aiMatrix4x4()) return;
  aiMatrix3x3 normal_matrix(matrix);
  normal_matrix.Inverse().Transpose();
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    mesh.mVertices[v] = matrix * mesh.mVertices[v];
    if (mesh.HasNormals()) mesh.mNormals[v] = (normal_matrix * mesh.mNormals[v]).NormalizeSafe();
  }
  if (matrix.Determinant() < 0) turn_faces(mesh);
}

/// Drops faces of fewer corners.
void drop_faces_below(aiMesh& mesh, unsigned corners) {
  aiFace* const end =
      std::remove_if(mesh.mFaces, mesh.mFaces + mesh.mNumFaces,
                     [&](const aiFace& face) { return face.mNumIndices < corners; });
  mesh.mNumFaces = static_cast<unsigned>(end - mesh.mFaces);
}

/// Walks the nodes and collects one part for each place where a part is shown.
class Baker {
 public:
  explicit Baker(aiScene& scene) : scene_(scene), used_(scene.mNumMeshes, false) {
    visit(*scene.mRootNode, aiMatrix4x4());
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
      if (!used_[m]) delete scene.mMeshes[m];
    }
    delete[] scene.mMeshes;
    scene.mNumMeshes = static_cast<unsigned>(parts_.size());
    scene.mMeshes = new aiMesh*[parts_.size()];
    std::copy(parts_.begin(), parts_.end(), scene.mMeshes);
  }

 private:
  void visit(aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 matrix = parent * node.mTransformation;
    node.mTransformation = aiMatrix4x4();
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const unsigned old = node.mMeshes[i];
      node.mMeshes[i] = static_cast<unsigned>(parts_.size());
      parts_.push_back(claim(old));
      matrices_.push_back(matrix);
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c) visit(*node.mChildren[c], matrix);
    if (&node != scene_.mRootNode) return;
    for (std::size_t p = 0; p < parts_.size(); ++p) transform(*parts_[p], matrices_[p]);
  }

  /// The part itself the first time, a copy afterwards. Transforms wait until all copies are made.
  aiMesh* claim(unsigned old) {
    if (!used_[old]) {
      used_[old] = true;
      return scene_.mMeshes[old];
    }
    aiMesh* copy = nullptr;
    Assimp::SceneCombiner::Copy(&copy, scene_.mMeshes[old]);
    return copy;
  }

  aiScene& scene_;
  std::vector<bool> used_;
  std::vector<aiMesh*> parts_;
  std::vector<aiMatrix4x4> matrices_;
};

}  // namespace

void turn_faces(aiMesh& mesh) {
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices > 2) std::reverse(face.mIndices + 1, face.mIndices + face.mNumIndices);
  }
}

std::vector<std::string> strip_scene(aiScene& scene) {
  unsigned bones = 0;
  unsigned targets = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    bones += scene.mMeshes[m]->mNumBones;
    targets += scene.mMeshes[m]->mNumAnimMeshes;
  }
  std::vector<std::string> dropped;
  const auto name = [&](unsigned count, const char* what) {
    if (count > 0) dropped.push_back(fmt::format("{} {}{}", count, what, count == 1 ? "" : "s"));
  };
  name(scene.mNumAnimations, "animation");
  name(bones, "bone");
  name(targets, "morph target");
  name(scene.mNumCameras, "camera");
  name(scene.mNumLights, "light");
  drop(scene.mAnimations, scene.mNumAnimations);
  drop(scene.mCameras, scene.mNumCameras);
  drop(scene.mLights, scene.mNumLights);
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    aiMesh& mesh = *scene.mMeshes[m];
    drop(mesh.mBones, mesh.mNumBones);
    drop(mesh.mAnimMeshes, mesh.mNumAnimMeshes);
    drop_faces_below(mesh, 1);
    delete[] mesh.mTangents;
    delete[] mesh.mBitangents;
    mesh.mTangents = nullptr;
    mesh.mBitangents = nullptr;
  }
  return dropped;
}

void join_corners(aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) join_corners(*scene.mMeshes[m]);
}

void bake_transforms(aiScene& scene) { Baker{scene}; }

void undo_3ds_turn(aiScene& scene) {
  const aiMatrix4x4 back(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1);
  scene.mRootNode->mTransformation = back * scene.mRootNode->mTransformation;
}

Space take_space(aiScene& scene) {
  constexpr float kNearly = 1e-6f;  // what rounding makes of 1
  Space space;
  aiMatrix4x4& matrix = scene.mRootNode->mTransformation;
  const float unit = aiVector3D(matrix.a1, matrix.b1, matrix.c1).Length();
  if (!std::isfinite(unit) || unit <= 0) return space;
  for (unsigned row = 0; row < 3; ++row) {
    for (unsigned column = 0; column < 4; ++column) {
      float& entry = matrix[row][column];
      entry /= unit;
      if (std::abs(entry - std::round(entry)) < kNearly) entry = std::round(entry);
    }
  }
  space.unit = std::stod(fmt::format("{}", unit));  // the decimal number that the file has
  const aiMatrix4x4 from_x(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  const aiMatrix4x4 from_z(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1);
  if (matrix.b1 == 1) space.up = 0;
  if (matrix.b3 == 1) space.up = 2;
  if (space.up == 0) matrix = matrix * from_x;
  if (space.up == 2) matrix = matrix * from_z;
  return space;
}

void drop_points_and_lines(aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    drop_faces_below(*scene.mMeshes[m], 3);
    scene.mMeshes[m]->mPrimitiveTypes &=
        ~static_cast<unsigned>(aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  }
}

}  // namespace hwffd
