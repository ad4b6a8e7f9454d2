#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "hwffd/model/configuration.hpp"

namespace hwffd::tangents {

/// Components of derivatives that seams have, at least.
inline constexpr std::size_t kSeamValues = 60000;

/// Of central differences: their own error, h^2 q''' / 6 and rounding in double.
inline constexpr double kDifferenceError = 1e-6;

/// What a row's RTL made of vertices with their derivatives. Errors are of components of dq/ds,
/// dq/dt, dq/du in units of 2^k > half the lattice's size, and of det J in that unit cubed.
struct RowResult {
  Configuration row;
  std::size_t vertices = 0;          ///< with four results, or two
  std::uint64_t mismatches = 0;      ///< results that are not the model's, of all runs
  std::string failure;               ///< the bench's report of the first run that failed
  double max_error = 0;              ///< of a derivative, against the oracle
  double bound = 0;                  ///< that max_error is held to (numerics.md section 9)
  double max_difference = 0;         ///< from central differences
  double max_determinant_error = 0;  ///< of det J
  double determinant_bound = 0;      ///< beyond which its sign is held to the oracle's
  std::size_t upright = 0;           ///< det J > 0 by the flag, of both lattices
  std::size_t folded = 0;            ///< det J <= 0 by the flag
  std::size_t wrong_flags = 0;       ///< where the oracle's sign is another
  std::size_t seam_values = 0;       ///< components of derivatives on seams, compared
  std::size_t seam_differences = 0;  ///< of them, not the bits of the cell next to it
  double clocks_per_vertex = 0;      ///< with derivatives, resident lattice

  bool finite_difference_ok() const { return max_difference <= bound + kDifferenceError; }
};

/// Runs the row's RTL: vertices of a twisted and of a folded lattice with their derivatives, and
/// with det J, then vertices that cells share.
/// @param vertices  in each of the two lattices
/// @param seed      of vertices, points and registers
/// @param progress  called with the fraction done
RowResult run(const Configuration& row, std::size_t vertices, std::uint64_t seed,
              const std::function<void(double)>& progress);

}  // namespace hwffd::tangents
