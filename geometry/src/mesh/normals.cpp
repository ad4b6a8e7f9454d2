#include "mesh/normals.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "cofactor.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

constexpr float kRounding = 0x1p-22f;   // of a number up to 1, twice
constexpr std::size_t kSearched = 256;  // normals of one vertex: a hostile file has any number
constexpr double kSameNormal = 0.9999;  // cosine; readers repeat a normal with rounding errors

/// The direction as a normal, or `otherwise` if it is none.
Eigen::RowVector3f normal_of(const Eigen::Vector3d& direction,
                             const Eigen::RowVector3f& otherwise) {
  const Eigen::Vector3d n = direction.stableNormalized();
  if (n.isZero() || !n.allFinite()) return otherwise;
  return n.cast<float>().transpose();
}

}  // namespace

Points smooth_normals(const Points& points, const std::vector<Mesh::Triangle>& triangles) {
  Points normals = Points::Zero(points.rows(), 3);
  for (const Mesh::Triangle& t : triangles) {
    const Point a = points.row(t[0]);
    const Point area = (Point(points.row(t[1])) - a).cross(Point(points.row(t[2])) - a);
    for (const std::uint32_t v : t) normals.row(v) += area;
  }
  for (Eigen::Index v = 0; v < normals.rows(); ++v) {
    const Point normal = normals.row(v).transpose().stableNormalized();
    normals.row(v) = normal.isZero() ? Point::UnitY() : normal;
  }
  return normals;
}

bool is_mirror(const std::vector<Eigen::Matrix3d>& gradients) {
  bool some = false;
  for (const Eigen::Matrix3d& gradient : gradients) {
    const double determinant = known(gradient).determinant();
    if (determinant > 0.0) return false;
    some = some || determinant < 0.0;
  }
  return some;
}

bool has_normals(const aiScene& scene) {
  bool some = false;
  each_part(scene, [&](const aiMesh& part, std::size_t) { some = some || part.HasNormals(); });
  return some;
}

FollowingNormals::FollowingNormals(Content& content, const std::vector<std::uint32_t>& weld,
                                   const Points& rest) {
  if (content.normals.empty()) return;
  rest_ = rest;
  weld_ = weld;
  split(content, weld);
  read_ = content.normals.rows;
  find_classes();
}

void FollowingNormals::split(Content& content, const std::vector<std::uint32_t>& weld) {
  Values<3>& normals = content.normals;
  if (normals.of_corner.empty()) {  // a row is a vertex
    owners_ = weld;
    for (std::size_t row = 0; row < owners_.size(); ++row) {
      if (std::isnan(normals.rows(static_cast<Eigen::Index>(row), 0))) owners_[row] = kNone;
    }
    return;
  }
  const auto rows = static_cast<std::uint32_t>(normals.rows.rows());
  owners_.assign(rows, kNone);
  std::unordered_map<std::uint64_t, std::uint32_t> extra;  // row and vertex -> row of its own
  for (std::size_t c = 0; c < content.corners.size(); ++c) {
    std::uint32_t& row = normals.of_corner[c];
    if (row == kNone) continue;
    const std::uint32_t vertex = weld[content.corners[c]];
    if (owners_[row] == kNone) owners_[row] = vertex;
    if (owners_[row] == vertex) continue;
    const std::uint64_t key = std::uint64_t{row} << 32 | vertex;
    const auto [entry, is_new] = extra.emplace(key, static_cast<std::uint32_t>(owners_.size()));
    if (is_new) {
      owners_.push_back(vertex);
      origins_.push_back(row);
    }
    row = entry->second;
  }
  normals.rows.conservativeResize(static_cast<Eigen::Index>(owners_.size()), 3);
  for (std::size_t n = 0; n < origins_.size(); ++n) {
    normals.rows.row(rows + static_cast<Eigen::Index>(n)) = normals.rows.row(origins_[n]);
  }
}

void FollowingNormals::find_classes() {
  std::vector<std::uint32_t> order(owners_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return owners_[a] < owners_[b]; });
  class_.resize(owners_.size());
  std::vector<std::pair<Eigen::Vector3d, std::uint32_t>> directions;  // at one vertex
  std::uint32_t vertex = kNone;
  for (const std::uint32_t row : order) {
    if (owners_[row] != vertex) directions.clear();
    vertex = owners_[row];
    const Eigen::Vector3d normal = read_.row(row).cast<double>().transpose().normalized();
    std::size_t c = directions.size() > kSearched ? directions.size() - kSearched : 0;
    while (c < directions.size() && !(directions[c].first.dot(normal) > kSameNormal)) ++c;
    if (c == directions.size()) directions.emplace_back(normal, classes_++);
    class_[row] = directions[c].second;
  }
}

void FollowingNormals::follow_faces(Content& content, const Points& positions, double sign) const {
  if (read_.rows() == 0) return;
  std::vector<Eigen::Vector3d> sums(classes_, Eigen::Vector3d::Zero());
  std::vector<bool> moved(classes_, false);
  const auto vertex_of = [&](std::size_t corner) { return weld_[content.corners[corner]]; };
  for (std::size_t f = 0; f < content.face_count(); ++f) {
    const std::size_t begin = content.face_begin(f);
    const std::size_t end = content.face_end(f);
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    bool moves = false;
    const Eigen::Vector3d origin = positions.row(vertex_of(begin));
    for (std::size_t c = begin; c < end; ++c) {
      moves = moves || positions.row(vertex_of(c)) != rest_.row(vertex_of(c));
      if (c < begin + 2) continue;
      area += (positions.row(vertex_of(c - 1)).transpose() - origin)
                  .cross(positions.row(vertex_of(c)).transpose() - origin);
    }
    for (std::size_t c = begin; c < end; ++c) {
      const std::uint32_t row = content.normals.row_of(c, content.corners[c]);
      if (row == kNone) continue;
      sums[class_[row]] += sign * area;
      if (moves) moved[class_[row]] = true;
    }
  }
  content.normals.rows = read_;
  for (Eigen::Index row = 0; row < read_.rows(); ++row) {
    const std::uint32_t c = class_[static_cast<std::size_t>(row)];
    const bool is_none =
        owners_[static_cast<std::size_t>(row)] == kNone || std::isnan(read_(row, 0));
    if (moved[c] && !is_none) {
      content.normals.rows.row(row) = normal_of(sums[c], read_.row(row));
    }
  }
}

void FollowingNormals::follow(Content& content, const Points& positions,
                              const std::vector<Eigen::Matrix3d>& gradients, double sign) const {
  follow_faces(content, positions, sign);
  for (Eigen::Index row = 0; row < read_.rows(); ++row) {
    const std::uint32_t vertex = owners_[static_cast<std::size_t>(row)];
    if (vertex == kNone || std::isnan(read_(row, 0))) continue;
    const Eigen::Matrix3d turn = sign * cofactor(known(gradients[vertex]));
    const Eigen::Vector3d read = read_.row(row).cast<double>().transpose();
    const Eigen::RowVector3f now = content.normals.rows.row(row);
    const Eigen::RowVector3f turned = normal_of(turn * read, now);
    // What no more than rounding has moved is what was read.
    const Eigen::RowVector3f before = normal_of(read, read_.row(row));
    const bool stays = (turned - before).cwiseAbs().maxCoeff() <= kRounding;
    content.normals.rows.row(row) = stays ? Eigen::RowVector3f(read_.row(row)) : turned;
  }
}

}  // namespace hwffd
