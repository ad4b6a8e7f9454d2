#include "hwffd/lattice/attachment.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/lattice/coordinates.hpp"
#include "hwffd/lattice/nearest_place.hpp"
#include "same_dims.hpp"

namespace hwffd {
namespace {

constexpr double kSingular = 1e-9;  // of the largest pivot

/// J_deformed J_rest^-1 at a place; NaN where J_rest is singular.
Eigen::Matrix3d jacobian_at(const Embedded& place, const Lattice& lattice) {
  return Oracle().jet(lattice.support(place.cell), place.local).jacobian;
}

Eigen::Matrix3d gradient_at(const Embedded& place, const Lattice& rest,
                            const Eigen::Matrix3d& deformed) {
  Eigen::FullPivLU<Eigen::Matrix3d> decomposition(jacobian_at(place, rest));
  decomposition.setThreshold(kSingular);
  if (!decomposition.isInvertible()) {
    return Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  return deformed * decomposition.inverse();
}

}  // namespace

Attachment::Attachment(const Lattice& rest, const Points& points, const Outside& outside)
    : rest_(rest), points_(points), outside_(outside) {
  check_coordinates("point", points);
  embeddings_ = Embedder(rest).embed(points);
  summary_ = summarize(embeddings_);
  std::optional<NearestPlace> nearest;
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    const Embedding& embedding = embeddings_[static_cast<std::size_t>(row)];
    if (embedding.status == EmbeddingStatus::kNotConverged) {
      throw Error(fmt::format(
          "point {} can neither be embedded nor proved to be outside; give a lattice that does "
          "not fold there",
          row));
    }
    if (embedding.status == EmbeddingStatus::kInside) {
      places_.push_back(embedding.at);
      followers_.push_back({row, 1.0, Point::Zero()});
      continue;
    }
    if (outside.kind() == Outside::Kind::kKeep) continue;
    if (!nearest) nearest.emplace(rest);
    const NearestPlace::Result place = nearest->find(Point(points.row(row)));
    const double weight = outside.weight(place.distance);
    if (weight == 0.0) continue;
    places_.push_back(place.at);
    followers_.push_back({row, weight, place.point});
  }
}

Points Attachment::follow(const Points& evaluated) const {
  if (evaluated.rows() != static_cast<Eigen::Index>(places_.size())) {
    throw Error(fmt::format("{} evaluated places given; give {}, one for each of places()",
                            evaluated.rows(), places_.size()));
  }
  Points result = points_;
  for (std::size_t i = 0; i < followers_.size(); ++i) {
    const Follower& follower = followers_[i];
    const auto at = static_cast<Eigen::Index>(i);
    if (embeddings_[static_cast<std::size_t>(follower.row)].status == EmbeddingStatus::kInside) {
      result.row(follower.row) = evaluated.row(at);
    } else {
      result.row(follower.row) +=
          follower.weight * (evaluated.row(at) - follower.anchor.transpose());
    }
  }
  return result;
}

std::vector<Eigen::Matrix3d> Attachment::gradients(const Lattice& deformed) const {
  check_same_dims("deformed lattice", deformed.dims(), rest_.dims());
  std::vector<Eigen::Matrix3d> jacobians;
  jacobians.reserve(places_.size());
  for (const Embedded& place : places_) jacobians.push_back(jacobian_at(place, deformed));
  return gradients(jacobians);
}

std::vector<Eigen::Matrix3d> Attachment::gradients(
    const std::vector<Eigen::Matrix3d>& jacobians) const {
  if (jacobians.size() != places_.size()) {
    throw Error(fmt::format("{} derivatives for {} places; give one for each place",
                            jacobians.size(), places_.size()));
  }
  std::vector<Eigen::Matrix3d> result(embeddings_.size(), Eigen::Matrix3d::Identity());
  for (std::size_t i = 0; i < followers_.size(); ++i) {
    const auto row = static_cast<std::size_t>(followers_[i].row);
    if (embeddings_[row].status == EmbeddingStatus::kInside) {
      result[row] = gradient_at(places_[i], rest_, jacobians[i]);
    } else {
      result[row].setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }
  return result;
}

std::size_t Attachment::torn_edges(
    const std::vector<std::array<std::uint32_t, 3>>& triangles) const {
  if (outside_.kind() != Outside::Kind::kKeep) return 0;
  const auto inside = [&](std::uint32_t row) {
    return embeddings_[row].status == EmbeddingStatus::kInside;
  };
  std::set<std::pair<std::uint32_t, std::uint32_t>> torn;
  for (const auto& triangle : triangles) {
    for (std::size_t side = 0; side < 3; ++side) {
      const std::uint32_t a = triangle[side];
      const std::uint32_t b = triangle[(side + 1) % 3];
      if (inside(a) != inside(b)) torn.insert(std::minmax(a, b));
    }
  }
  return torn.size();
}

}  // namespace hwffd
