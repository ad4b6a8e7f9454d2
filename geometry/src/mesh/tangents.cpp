#include "mesh/tangents.hpp"

#include <cmath>

#include "cofactor.hpp"

namespace hwffd {
namespace {

constexpr double kRightAngle = 0.01;          // cosine of what counts as one
constexpr double kTangentRounding = 0x1p-22;  // of a number up to 1, twice

Eigen::Vector3d direction_of(const Eigen::Vector3d& tangent, const Eigen::Vector3d* normal) {
  const Eigen::Vector3d along =
      normal == nullptr ? tangent : Eigen::Vector3d(tangent - *normal * normal->dot(tangent));
  return along.stableNormalized();
}

}  // namespace

FollowingTangents::FollowingTangents(const Content& content) : read_(content.tangents) {
  if (read_.rows() > 0) normals_ = content.normals.rows;
}

void FollowingTangents::follow(Content& content, const std::vector<std::uint32_t>& weld,
                               const std::vector<Eigen::Matrix3d>& gradients, bool turned) const {
  for (Eigen::Index v = 0; v < read_.rows(); ++v) {
    const Eigen::Vector3d read = read_.row(v).head<3>().cast<double>().transpose();
    content.tangents.row(v) = read_.row(v);
    if (std::isnan(read_(v, 0))) continue;
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    if (!gradients.empty()) gradient = known(gradients[weld[static_cast<std::size_t>(v)]]);
    if (gradient.isZero()) gradient.setIdentity();
    Eigen::Vector3d before;
    Eigen::Vector3d now;
    bool is_square = false;
    if (normals_.rows() > 0 && !std::isnan(normals_(v, 0))) {
      before = normals_.row(v).cast<double>().transpose().stableNormalized();
      now = content.normals.rows.row(v).cast<double>().transpose().stableNormalized();
      is_square = std::abs(before.dot(read)) <= kRightAngle * read.norm();
    }
    const Eigen::Vector3d moved = direction_of(gradient * read, is_square ? &now : nullptr);
    const Eigen::Vector3d rest = direction_of(read, is_square ? &before : nullptr);
    const bool stays = (moved - rest).cwiseAbs().maxCoeff() <= kTangentRounding;
    if (!stays && !moved.isZero() && moved.allFinite()) {
      content.tangents.row(v).head<3>() = moved.cast<float>().transpose();
    }
    if (turned) content.tangents(v, 3) = -read_(v, 3);
  }
}

}  // namespace hwffd
