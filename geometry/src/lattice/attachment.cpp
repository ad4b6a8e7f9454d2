#include "hwffd/lattice/attachment.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/lattice/coordinates.hpp"
#include "hwffd/on_threads.hpp"
#include "same_dims.hpp"

namespace hwffd {
namespace {

constexpr double kSingularPivot = 1e-9;        // of the largest pivot
constexpr Eigen::Index kRowsAtOnce = 4096;     // between two looks at who waits
constexpr std::size_t kGradientsAtOnce = 256;  // places that a thread takes at once

bool is_outside(const Embedding& embedding) {
  return embedding.status == EmbeddingStatus::kOutside;
}

Eigen::Matrix3d jacobian_at(const Embedded& place, const Lattice& lattice, const Family& family) {
  return Oracle().jet(family.support(lattice, place.cell), place.local).jacobian;
}

/// J_deformed J_rest^-1 at a place; NaN where J_rest is singular.
Eigen::Matrix3d gradient_at(const Eigen::Matrix3d& rest, const Eigen::Matrix3d& deformed) {
  Eigen::FullPivLU<Eigen::Matrix3d> decomposition(rest);
  decomposition.setThreshold(kSingularPivot);
  if (!decomposition.isInvertible()) {
    return Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  return deformed * decomposition.inverse();
}

}  // namespace

Attachment::Attachment(const Lattice& rest, const Points& points, const Outside& outside,
                       const Family& family)
    : Attachment(Embedder(rest, family), points, outside) {}

Attachment::Attachment(const Embedder& embedder, const Points& points, const Outside& outside,
                       Unsure unsure)
    : rest_(embedder.lattice()), family_(embedder.family()), points_(points), outside_(outside) {
  Watch::look();
  check_coordinates("point", points);
  embeddings_ = embedder.embed(points);
  summary_ = summarize(embeddings_);
  if (unsure == Unsure::kRefuse) check_converged();
  const std::vector<NearestPlace::Result> nearest = nearest_places();
  auto next = nearest.begin();
  places_.reserve(summary_.inside + nearest.size());
  followers_.reserve(summary_.inside + nearest.size());
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    if (row % kRowsAtOnce == 0) Watch::look();
    const Embedding& embedding = embeddings_[static_cast<std::size_t>(row)];
    if (embedding.status == EmbeddingStatus::kInside) {
      places_.push_back(embedding.at);
      followers_.push_back({row, 1.0, Point::Zero()});
      continue;
    }
    if (outside.kind() == Outside::Kind::kKeep || !is_outside(embedding)) continue;
    const NearestPlace::Result& place = *next++;
    const double weight = outside.weight(place.distance);
    if (weight == 0.0) continue;
    places_.push_back(place.at);
    followers_.push_back({row, weight, place.point});
  }
}

void Attachment::check_converged() const {
  if (summary_.not_converged == 0) return;
  const auto first =
      std::find_if(embeddings_.begin(), embeddings_.end(), [](const Embedding& embedding) {
        return embedding.status == EmbeddingStatus::kNotConverged;
      });
  throw Error(
      fmt::format("point {} can neither be embedded nor proved to be outside; give a lattice that "
                  "does not fold there",
                  first - embeddings_.begin()));
}

std::vector<NearestPlace::Result> Attachment::nearest_places() const {
  if (outside_.kind() == Outside::Kind::kKeep) return {};
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < points_.rows(); ++row) {
    if (is_outside(embeddings_[static_cast<std::size_t>(row)])) rows.push_back(row);
  }
  if (rows.empty()) return {};
  const NearestPlace nearest(rest_, family_);
  std::vector<NearestPlace::Result> places(rows.size());
  on_threads(rows.size(), [&](std::size_t i) { places[i] = nearest.find(points_.row(rows[i])); });
  return places;
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
    if (is_inside(follower.row)) {
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
  std::vector<Eigen::Matrix3d> jacobians(places_.size());
  on_ranges(places_.size(), kGradientsAtOnce, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      jacobians[i] = jacobian_at(places_[i], deformed, family_);
    }
  });
  return gradients(jacobians);
}

std::vector<Eigen::Matrix3d> Attachment::gradients(
    const std::vector<Eigen::Matrix3d>& jacobians) const {
  if (jacobians.size() != places_.size()) {
    throw Error(fmt::format("{} derivatives for {} places; give one for each place",
                            jacobians.size(), places_.size()));
  }
  std::vector<Eigen::Matrix3d> result(embeddings_.size(), Eigen::Matrix3d::Identity());
  on_ranges(followers_.size(), kGradientsAtOnce, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const Eigen::Index at = followers_[i].row;
      Eigen::Matrix3d& gradient = result[static_cast<std::size_t>(at)];
      if (is_inside(at)) {
        gradient = gradient_at(jacobian_at(places_[i], rest_, family_), jacobians[i]);
      } else {
        gradient.setConstant(std::numeric_limits<double>::quiet_NaN());
      }
    }
  });
  return result;
}

std::size_t Attachment::torn_edges(
    const std::vector<std::array<std::uint32_t, 3>>& triangles) const {
  if (outside_.kind() != Outside::Kind::kKeep) return 0;
  const auto inside = [&](std::uint32_t row) { return is_inside(static_cast<Eigen::Index>(row)); };
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
