#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/nearest_place.hpp"
#include "hwffd/lattice/outside.hpp"

namespace hwffd {

/// A set of points attached to a lattice at rest: the places to evaluate when the lattice is
/// deformed (eq. (1), by the oracle, a model or the hardware), and how the points follow them.
///
/// A point inside is its place (Embedder). A point outside that follows (Outside) has the nearest
/// place of the lattice (NearestPlace) and moves by that place's displacement times its weight. All
/// others stay and have no place.
class Attachment {
 public:
  /// @param points n x 3
  /// @throws Error that names the row of a point that is not finite or beyond kLargestCoordinate,
  /// or
  ///   that can neither be embedded nor proved to be outside; and what Embedder throws
  Attachment(const Lattice& rest, const Points& points, const Outside& outside,
             const Family& family = {});

  /// What becomes of points that can neither be embedded nor proved to be outside.
  enum class Unsure { kRefuse, kStay };

  /// The same, without the search for cells that an embedder has done already.
  Attachment(const Embedder& embedder, const Points& points, const Outside& outside,
             Unsure unsure = Unsure::kRefuse);

  /// How many points there are.
  Eigen::Index size() const { return points_.rows(); }
  const Lattice& rest() const { return rest_; }
  const Family& family() const { return family_; }

  /// The point that goes with a place.
  struct Follower {
    Eigen::Index row = 0;
    double weight = 1.0;           ///< of the place's displacement; 1 of points inside
    Point anchor = Point::Zero();  ///< the place at rest; only of points outside
  };

  /// The places to evaluate, in the order of their points; local coordinates in [0, 1].
  const std::vector<Embedded>& places() const { return all_inside() ? at_ : places_; }
  /// The point of one of places().
  Follower follower(std::size_t place) const {
    return all_inside() ? Follower{static_cast<Eigen::Index>(place)} : followers_[place];
  }
  bool is_inside(Eigen::Index row) const {
    return outcomes_[static_cast<std::size_t>(row)].status == EmbeddingStatus::kInside;
  }
  /// Whether some points follow the lattice and others stay, so that an edge between them tears.
  bool may_tear() const { return outside_.kind() == Outside::Kind::kKeep && !all_inside(); }
  /// The points as they were attached, n x 3.
  const Points& points() const { return points_; }

  /// All points, n x 3, when the lattice is deformed: a point inside is its row of `evaluated`, one
  /// that stays is what it was, both bit for bit.
  /// @param evaluated positions of places() in the deformed lattice, places().size() x 3
  /// @throws Error for another number of rows
  Points follow(Points evaluated) const;

  /// For every point the derivative of the map from the space at rest to the deformed one:
  /// J_deformed J_rest^-1 for a point inside, the identity for one that stays, that of what Outside
  /// says for one that follows. All NaN, unknown, where J_rest is singular to within 1e-9 (axes,
  /// poles, centres) and where the nearest place of a point outside jumps.
  /// @throws Error if the deformed lattice has other dimensions than the one at rest
  std::vector<Eigen::Matrix3d> gradients(const Lattice& deformed) const;
  /// The same from J_deformed and the position at each of places(), whoever computed them.
  /// @param evaluated  as for follow()
  /// @throws Error for another number of them
  std::vector<Eigen::Matrix3d> gradients(const std::vector<Eigen::Matrix3d>& jacobians,
                                         const Points& evaluated) const;

  const EmbeddingSummary& summary() const { return summary_; }
  /// Of a point, as Embedder gives it.
  Embedding embedding(Eigen::Index row) const;

  /// Edges, each counted once, between a point that stays because it is outside and one inside:
  /// the mesh may tear there. Only Outside::Kind::kKeep tears; with the others displacements are
  /// continuous across the faces of the lattice.
  /// @param triangles rows of points; unchecked
  std::size_t torn_edges(const std::vector<std::array<std::uint32_t, 3>>& triangles) const;

 private:
  /// What an Embedding says beside its place.
  struct Outcome {
    EmbeddingStatus status;
    int iterations;
    double residual;
  };

  bool all_inside() const { return summary_.inside == at_.size(); }
  bool is_outside(std::size_t row) const {
    return outcomes_[row].status == EmbeddingStatus::kOutside;
  }
  void embed(const Embedder& embedder);
  void find_places();
  void check_converged() const;
  void check_evaluated(const Points& evaluated) const;
  /// Of the points outside, in their order; none if they stay.
  std::vector<NearestPlace::Result> nearest_places() const;

  Lattice rest_;
  Family family_;
  Points points_;
  Outside outside_;
  std::vector<Embedded> at_;  ///< of every point
  std::vector<Outcome> outcomes_;
  EmbeddingSummary summary_;
  std::vector<Embedded> places_;     ///< none if all points are inside: then they are at_
  std::vector<Follower> followers_;  ///< of places_
};

}  // namespace hwffd
