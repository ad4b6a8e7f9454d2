#pragma once

#include <assimp/scene.h>

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "hwffd/mesh/mesh.hpp"

namespace hwffd {

/// Unit normals of points, smooth over all edges, weighted by area; (0, 1, 0) where the faces give
/// no direction.
Points smooth_normals(const Points& points, const std::vector<Mesh::Triangle>& triangles);

/// Whether a deformation with these derivatives is a mirror: some are known, and the determinant
/// of each known one is negative. A matrix that is not finite or singular is not known.
bool is_mirror(const std::vector<Eigen::Matrix3d>& gradients);

/// Whether any part has normals.
bool has_normals(const aiScene& scene);

/// The normals of a scene as they were read, and how they follow its vertices. Parts without
/// normals stay without.
class SceneNormals {
 public:
  /// @param weld scene vertex (parts in order) -> welded vertex
  SceneNormals(const aiScene& scene, const std::vector<std::uint32_t>& weld);

  /// Makes each normal the mean, weighted by area, over the faces of the corners that are welded
  /// and had the same normal when it was read. Where they give no direction the normal stays.
  void follow_faces(aiScene& scene) const;

  /// As follow_faces(), and where the gradient of a vertex is known makes the normal the direction
  /// of sign * cofactor(gradient) times the one that was read, unless that has no direction.
  /// @param gradients one for each welded vertex
  /// @param sign 1, or -1 if the faces have been turned round
  void follow(aiScene& scene, const std::vector<Eigen::Matrix3d>& gradients, double sign) const;

 private:
  void find_classes(const aiScene& scene);

  std::vector<std::uint32_t> weld_;
  std::vector<Eigen::Vector3f> read_;  ///< scene vertex -> normal, if there are any; or zero
  std::vector<std::uint32_t> class_;   ///< scene vertex -> corners welded and with the same normal
  std::uint32_t classes_ = 0;
};

}  // namespace hwffd
