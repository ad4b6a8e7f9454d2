#include "hwffd/lattice/attachment.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "follower_gradient.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/coordinates.hpp"
#include "hwffd/on_threads.hpp"
#include "same_dims.hpp"

namespace hwffd {
namespace {

constexpr double kSingularPivot = 1e-9;           // of the largest pivot
constexpr Eigen::Index kRowsAtOnce = 4096;        // between two looks at who waits
constexpr std::size_t kEmbeddedAtOnce = 1 << 16;  // that are embedded at once
constexpr std::size_t kGradientsAtOnce = 256;     // places that a thread takes at once

Oracle::Jet jet_at(const Embedded& place, const Lattice& lattice, const Family& family) {
  return Oracle().jet(family.support(lattice, place.cell), place.local);
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
  embed(embedder);
  if (unsure == Unsure::kRefuse) check_converged();
  if (!all_inside()) find_places();
}

void Attachment::embed(const Embedder& embedder) {
  const auto count = static_cast<std::size_t>(points_.rows());
  at_.reserve(count);
  outcomes_.reserve(count);
  std::vector<Embedding> block;
  for (std::size_t first = 0; first < count; first += block.size()) {
    const auto size = static_cast<Eigen::Index>(std::min(kEmbeddedAtOnce, count - first));
    block = embedder.embed(Points(points_.middleRows(static_cast<Eigen::Index>(first), size)));
    summary_ = joined(summary_, summarize(block));
    for (const Embedding& embedding : block) {
      at_.push_back(embedding.at);
      outcomes_.push_back({embedding.status, embedding.iterations, embedding.residual});
    }
  }
}

Embedding Attachment::embedding(Eigen::Index row) const {
  const auto i = static_cast<std::size_t>(row);
  return {at_[i], outcomes_[i].status, outcomes_[i].residual, outcomes_[i].iterations};
}

void Attachment::find_places() {
  const std::vector<NearestPlace::Result> nearest = nearest_places();
  auto next = nearest.begin();
  places_.reserve(summary_.inside + nearest.size());
  followers_.reserve(summary_.inside + nearest.size());
  for (Eigen::Index row = 0; row < points_.rows(); ++row) {
    if (row % kRowsAtOnce == 0) Watch::look();
    const auto i = static_cast<std::size_t>(row);
    if (is_inside(row)) {
      places_.push_back(at_[i]);
      followers_.push_back({row});
      continue;
    }
    if (outside_.kind() == Outside::Kind::kKeep || !is_outside(i)) continue;
    const NearestPlace::Result& place = *next++;
    const double weight = outside_.weight(place.distance);
    if (weight == 0.0) continue;
    places_.push_back(place.at);
    followers_.push_back({row, weight, place.point});
  }
}

void Attachment::check_converged() const {
  if (summary_.not_converged == 0) return;
  const auto first = std::find_if(outcomes_.begin(), outcomes_.end(), [](const Outcome& outcome) {
    return outcome.status == EmbeddingStatus::kNotConverged;
  });
  throw Error(
      fmt::format("point {} can neither be embedded nor proved to be outside; give a lattice that "
                  "does not fold there",
                  first - outcomes_.begin()));
}

std::vector<NearestPlace::Result> Attachment::nearest_places() const {
  if (outside_.kind() == Outside::Kind::kKeep) return {};
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < outcomes_.size(); ++i) {
    if (is_outside(i)) rows.push_back(static_cast<Eigen::Index>(i));
  }
  if (rows.empty()) return {};
  const NearestPlace nearest(rest_, family_);
  std::vector<NearestPlace::Result> places(rows.size());
  on_threads(rows.size(), [&](std::size_t i) { places[i] = nearest.find(points_.row(rows[i])); });
  return places;
}

void Attachment::check_evaluated(const Points& evaluated) const {
  if (evaluated.rows() == static_cast<Eigen::Index>(places().size())) return;
  throw Error(fmt::format("{} evaluated places given; give {}, one for each of places()",
                          evaluated.rows(), places().size()));
}

Points Attachment::follow(Points evaluated) const {
  check_evaluated(evaluated);
  if (all_inside()) return evaluated;
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
  std::vector<Eigen::Matrix3d> jacobians(places().size());
  Points evaluated(static_cast<Eigen::Index>(places().size()), 3);
  on_ranges(jacobians.size(), kGradientsAtOnce, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const Oracle::Jet jet = jet_at(places()[i], deformed, family_);
      jacobians[i] = jet.jacobian;
      evaluated.row(static_cast<Eigen::Index>(i)) = jet.value;
    }
  });
  return gradients(jacobians, evaluated);
}

std::vector<Eigen::Matrix3d> Attachment::gradients(const std::vector<Eigen::Matrix3d>& jacobians,
                                                   const Points& evaluated) const {
  check_evaluated(evaluated);
  if (jacobians.size() != places().size()) {
    throw Error(fmt::format("{} derivatives for {} places; give one for each place",
                            jacobians.size(), places().size()));
  }
  std::vector<Eigen::Matrix3d> result(at_.size(), Eigen::Matrix3d::Identity());
  on_ranges(places().size(), kGradientsAtOnce, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const Embedded& place = places()[i];
      const Eigen::Index at = follower(i).row;
      Eigen::Matrix3d& gradient = result[static_cast<std::size_t>(at)];
      if (is_inside(at)) {
        gradient = gradient_at(jet_at(place, rest_, family_).jacobian, jacobians[i]);
      } else {
        const Point moved = evaluated.row(static_cast<Eigen::Index>(i));
        gradient = follower_gradient({points_.row(at),
                                      place.local,
                                      family_.support(rest_, place.cell),
                                      {moved, jacobians[i]}},
                                     outside_);
      }
    }
  });
  return result;
}

std::size_t Attachment::torn_edges(
    const std::vector<std::array<std::uint32_t, 3>>& triangles) const {
  if (!may_tear()) return 0;
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
