#pragma once

#include <assimp/scene.h>

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "hwffd/mesh/mesh.hpp"
#include "mesh/format/content.hpp"

namespace hwffd {

/// Unit normals of points, smooth over all edges, weighted by area; (0, 1, 0) where the faces give
/// no direction.
Points smooth_normals(const Points& points, const std::vector<Mesh::Triangle>& triangles);

/// Whether a deformation with these derivatives is a mirror: some are known, and the determinant
/// of each known one is negative. A matrix that is not finite or singular is not known.
bool is_mirror(const std::vector<Eigen::Matrix3d>& gradients);

/// Whether any part has normals.
bool has_normals(const aiScene& scene);

/// The normals of a content as they were read, and how they follow its vertices.
class FollowingNormals {
 public:
  /// Gives each row of normals to one welded vertex: where several share a row, those behind the
  /// first get rows of their own, behind all others.
  /// @param weld   vertex of the content -> welded vertex
  /// @param rest   the welded vertices as they were read
  FollowingNormals(Content& content, const std::vector<std::uint32_t>& weld, const Points& rest);

  /// Extra row (the first has number 0) -> the row that it shared.
  const std::vector<std::uint32_t>& origins() const { return origins_; }

  /// Makes each normal of a vertex that moved, or whose faces did, the mean, weighted by area, over
  /// the faces of the corners that are welded and had the same normal when it was read. Where they
  /// give no direction it is the one that was read.
  /// @param sign  1, or -1 if the faces have been turned round
  void follow_faces(Content& content, const Points& positions, double sign) const;

  /// As follow_faces(), and where the gradient of a vertex is known makes the normal the direction
  /// of sign * cofactor(gradient) times the one that was read, unless that has no direction.
  /// @param gradients one for each welded vertex
  void follow(Content& content, const Points& positions,
              const std::vector<Eigen::Matrix3d>& gradients, double sign) const;

 private:
  void split(Content& content, const std::vector<std::uint32_t>& weld);
  void find_classes();

  Points rest_;
  std::vector<std::uint32_t> weld_;  ///< vertex of the content -> welded vertex
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> read_;
  std::vector<std::uint32_t> owners_;  ///< row -> welded vertex, or kNone
  std::vector<std::uint32_t> class_;   ///< row -> rows of a welded vertex with the same normal
  std::uint32_t classes_ = 0;
  std::vector<std::uint32_t> origins_;
};

}  // namespace hwffd
