#include <limits>

#include "mesh/format/scene_of.hpp"
#include "mesh/normals.hpp"
#include "mesh/scene.hpp"

namespace hwffd {

Content content_of(const aiScene& scene) {
  Content content;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  each_part(scene, [&](const aiMesh& part, std::size_t) {
    vertices += part.mNumVertices;
    content.parts.push_back({part.mName.C_Str(), part.mMaterialIndex, faces, part.mNumFaces});
    faces += part.mNumFaces;
  });
  const auto rows = static_cast<Eigen::Index>(vertices);
  content.positions.resize(rows, 3);
  if (has_normals(scene)) {
    content.normals.rows.setConstant(rows, 3, std::numeric_limits<float>::quiet_NaN());
  }
  content.face_ends.reserve(faces);
  each_part(scene, [&](const aiMesh& part, std::size_t first) {
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const auto row = static_cast<Eigen::Index>(first + v);
      content.positions.row(row) = to_eigen(part.mVertices[v]).transpose();
      if (part.HasNormals()) {
        content.normals.rows.row(row) = to_eigen(part.mNormals[v]).cast<float>().transpose();
      }
    }
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      for (unsigned c = 0; c < face.mNumIndices; ++c) {
        content.corners.push_back(static_cast<std::uint32_t>(first) + face.mIndices[c]);
      }
      content.face_ends.push_back(content.corners.size());
    }
  });
  return content;
}

}  // namespace hwffd
