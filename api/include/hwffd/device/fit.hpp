#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "hwffd/device/deformable_lattice.hpp"
#include "hwffd/lattice/fold.hpp"

namespace hwffd {

/// What a distance d of a point from its target costs, with a scale c:
///
/// - `squares`: d^2
/// - `huber`: d^2 up to c, beyond it 2 c d - c^2, so that outliers pull no harder than at c
/// - `geman-mcclure`: d^2 c^2 / (d^2 + c^2), so that far outliers hardly pull
enum class Loss { kSquares, kHuber, kGemanMcClure };

/// @throws UsageError for a name that is none of loss_names(), which it lists
Loss parse_loss(std::string_view name);
const std::vector<std::string>& loss_names();

struct FitOptions {
  Loss loss = Loss::kSquares;
  double scale = 0.0;  ///< of huber and geman-mcclure, a distance above 0
  /// Of the bending energy of the displacements, which is in 1/length^2: in length^4. Only of
  /// lattices whose cells at rest divide a parallelepiped evenly.
  double bending_weight = 0.0;
  /// Of the mean square of the control points' moves from where they start, which holds those that
  /// no point needs.
  double ridge = 1e-9;
  int iterations = 500;     ///< of L-BFGS, most; to 1,000,000
  double tolerance = 1e-9;  ///< of the objective's decrease in 5 iterations, in parts of its size
  std::vector<double> weights;  ///< of the points, 0 and more; empty: 1 each
};

struct FitResult {
  double rms_start = 0.0, rms_end = 0.0;  ///< distances of points from their targets, weighted
  double largest = 0.0;                   ///< distance at the end of what counts
  std::vector<double> distances;          ///< at the end, of each point
  std::size_t outside = 0;                ///< points that the lattice does not carry
  int iterations = 0;
  int evaluations = 0;
  bool stopped = false;  ///< by the callback
  FoldCheck folds;
};

/// Called after each iteration with its number and the objective; false ends the fit.
using FitProgress = std::function<bool(int iteration, double objective)>;

/// Moves the control points of a lattice so that it takes points to targets:
///
///     1/W sum over i of w_i loss(|T(x_i) - y_i|) + bending_weight * bending energy + ridge * moves
///
/// by L-BFGS, from where the control points are. The lattice's device evaluates, and
/// its transpose (Device::pull_back) makes the gradient. Points that the lattice does not carry
/// count in no sum. Joints of the lattice at rest (Closure) stay closed. No bit depends on the
/// number of threads.
/// @param points, targets  n x 3, row by row: where points lie at rest and where they shall be
/// @throws Error for other numbers of rows, coordinates that are not finite or beyond
///   kLargestCoordinate, no point in the lattice, and a lattice at rest that has no bending energy;
///   UsageError for weights of another number, for weights and other options that are not finite or
///   below 0, and for a scale that is not above 0
FitResult fit(DeformableLattice& lattice, const Points& points, const Points& targets,
              const FitOptions& options = {}, const FitProgress& progress = {});

}  // namespace hwffd
