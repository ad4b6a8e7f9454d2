#include "mask.hpp"

#include <assimp/scene.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <set>

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "points_file.hpp"

namespace hwffd::command {
namespace {

/// 1 for the vertices of the parts, 0 for others.
Eigen::VectorXd of_groups(const Geometry& geometry, const std::vector<std::string>& groups) {
  if (!geometry.is_mesh()) {
    throw Error(fmt::format("{}: points have no groups; use --mask", geometry.name()));
  }
  const Mesh& mesh = geometry.mesh();
  std::set<std::string> missing(groups.begin(), groups.end());
  std::vector<std::string> names;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(mesh.positions().rows());
  std::size_t next = 0;
  for (unsigned p = 0; p < mesh.scene().mNumMeshes; ++p) {
    const aiMesh& part = *mesh.scene().mMeshes[p];
    names.emplace_back(part.mName.C_Str());
    missing.erase(names.back());
    const bool moves = std::find(groups.begin(), groups.end(), names.back()) != groups.end();
    for (unsigned v = 0; v < part.mNumVertices; ++v, ++next) {
      if (moves) weights[mesh.welded()[next]] = 1;
    }
  }
  if (missing.empty()) return weights;
  throw Error(fmt::format("--group {}: {} has no such part; one of {}", excerpt(*missing.begin()),
                          geometry.name(), excerpt(fmt::format("{}", fmt::join(names, ", ")))));
}

/// The file's numbers, the largest of those of each position.
Eigen::VectorXd of_file(const Geometry& geometry, const std::string& name) {
  std::ifstream file(name);
  if (!file) throw Error(fmt::format("{}: cannot be read; check the name", name));
  const std::vector<double> read = read_column(file, name);
  std::vector<std::uint32_t> numbers;
  if (geometry.is_mesh()) numbers = geometry.mesh().numbers();
  const std::size_t count = geometry.is_mesh()
                                ? std::size_t{*std::max_element(numbers.begin(), numbers.end())} + 1
                                : static_cast<std::size_t>(geometry.positions().rows());
  if (read.size() != count) {
    throw Error(
        fmt::format("{}: {} numbers for {} vertices; give one for each", name, read.size(), count));
  }
  const auto wrong =
      std::find_if(read.begin(), read.end(), [](double x) { return !(x >= 0 && x <= 1); });
  if (wrong != read.end()) {
    throw Error(fmt::format("{}: {} is none from 0 to 1, of vertex {}", name, *wrong,
                            wrong - read.begin()));
  }
  if (!geometry.is_mesh()) {
    return Eigen::Map<const Eigen::VectorXd>(read.data(), static_cast<Eigen::Index>(count));
  }
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(geometry.positions().rows());
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    double& weight = weights[geometry.mesh().welded()[v]];
    weight = std::max(weight, read[numbers[v]]);
  }
  return weights;
}

}  // namespace

Mask::Mask(const Geometry& at_rest, const std::vector<std::string>& groups,
           const std::string& file) {
  if (groups.empty() && file.empty()) return;
  at_rest_ = at_rest.positions();
  weights_ = Eigen::VectorXd::Ones(at_rest_.rows());
  if (!groups.empty()) weights_ = of_groups(at_rest, groups);
  if (!file.empty()) weights_.array() *= of_file(at_rest, file).array();
}

void Mask::apply(Points& positions, std::vector<Eigen::Matrix3d>& gradients) const {
  for (Eigen::Index v = 0; v < weights_.size(); ++v) {
    const double weight = weights_[v];
    if (weight == 1) continue;
    auto position = positions.row(v);
    position = at_rest_.row(v) + weight * (position - at_rest_.row(v));
    if (gradients.empty()) continue;
    Eigen::Matrix3d& gradient = gradients[static_cast<std::size_t>(v)];
    gradient.setConstant(std::numeric_limits<double>::quiet_NaN());
    if (weight == 0) gradient.setIdentity();
  }
}

}  // namespace hwffd::command
