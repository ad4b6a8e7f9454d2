#pragma once

#include <assimp/scene.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "mesh/format/content.hpp"

namespace hwffd {

/// A scene and where its vertices (parts in order) come from.
struct ContentScene {
  std::unique_ptr<aiScene> scene;
  std::vector<std::uint32_t> vertices;  ///< scene vertex -> vertex of the content
  std::vector<std::uint32_t> normals;   ///< scene vertex -> row of the content's normals, or kNone
};

/// The content as a scene, for renderers and the writers of other formats. Corners of a part that
/// agree in every value are one vertex; those of a part come in the order of the content.
/// @param content   gives its materials and pictures away
/// @param vertices  of the content, whose positions may be gone
/// @param position  of a vertex of the content
ContentScene scene_of(Content& content, std::size_t vertices,
                      const std::function<Eigen::RowVector3d(std::uint32_t)>& position);

/// The geometry of a scene: each of its vertices is one of the content. Materials and nodes stay.
Content content_of(const aiScene& scene);

}  // namespace hwffd
