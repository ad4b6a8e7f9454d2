#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "mesh/format/content.hpp"

namespace hwffd {

/// The tangents of a content as they were read, and how they follow its vertices: a tangent t
/// becomes the direction of G t, where G is the derivative of the deformation, and stays at a right
/// angle to the normal if it was. Where G is not known it is taken for a shift. The fourth number,
/// the side on which the bitangent lies, changes its sign in a mirror.
class FollowingTangents {
 public:
  explicit FollowingTangents(const Content& content);

  /// @param content  whose normals have followed
  /// @param weld  vertex of the content -> welded vertex
  /// @param gradients  of welded vertices; none: not known
  /// @param turned  whether the deformation is a mirror
  void follow(Content& content, const std::vector<std::uint32_t>& weld,
              const std::vector<Eigen::Matrix3d>& gradients, bool turned) const;

 private:
  Eigen::Matrix<float, Eigen::Dynamic, 4, Eigen::RowMajor> read_;
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> normals_;  ///< as read
};

}  // namespace hwffd
