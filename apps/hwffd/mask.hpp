#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "geometry.hpp"

namespace hwffd::command {

/// How much of a deformation's displacement each vertex takes: 0, it stays, to 1, all of it.
class Mask {
 public:
  /// @param groups  names of parts of a mesh whose vertices move; none: those of all parts
  /// @param file  text with a number from 0 to 1 for each vertex of the input's file, which the
  ///   displacement is multiplied by; empty: 1
  /// Equal positions move as one, by the largest of their numbers.
  /// @throws Error for a group that is not there, a file with another number of numbers, or one
  ///   that is none from 0 to 1
  Mask(const Geometry& at_rest, const std::vector<std::string>& groups, const std::string& file);

  /// Whether every vertex takes all.
  bool empty() const { return weights_.size() == 0; }

  /// Leaves of a deformation what the weights say. Derivatives of vertices between 0 and 1 are
  /// unknown: the mask has slopes of its own.
  /// @param gradients  those of the positions, or none
  void apply(Points& positions, std::vector<Eigen::Matrix3d>& gradients) const;

 private:
  Points at_rest_;
  Eigen::VectorXd weights_;
};

}  // namespace hwffd::command
