#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/lattice.hpp"
#include "hwffd/registration/metric.hpp"
#include "hwffd/registration/volume.hpp"
#include "hwffd/registration/voxel_map.hpp"

namespace hwffd {

struct RegistrationOptions {
  /// Distance of control points along i, j and k of the fixed image at the finest level. Cells fill
  /// the image, so that their number is rounded: cell_counts().
  std::array<double, 3> spacing{16, 16, 16};
  bool spacing_in_voxels = true;  ///< else in units of length
  /// Of the image pyramid; lattices are halved with it. 0: three, or as many as there can be.
  int levels = 0;
  /// Whether the volumes of the finest level are smoothed(), as those of the others are. Without it
  /// linear samples are drawn to the middle between voxels, where they smooth the noise.
  bool smooth = true;
  MetricKind metric = MetricKind::kMeanSquares;
  int bins = 32;  ///< of mutual information
  /// Of the bending energy, which is in 1/length^2: in length^2.
  double bending_weight = 0.0;
  /// Whether det J may have no other sign than at the start. Then there is a FoldBarrier, steps
  /// that are not proved free of folds are refused, and so is such a start.
  bool no_folds = false;
  double barrier_weight = 0.01;
  /// From points of the fixed image to points of the moving one: where the lattice starts.
  std::optional<AffineMap> start;
  /// Or a lattice that starts, over the fixed image as rest_lattice() makes it, with as many points
  /// an axis as one of the levels has. Levels with a coarser lattice take this one.
  std::optional<Lattice> start_lattice;
  int iterations = 50;      ///< of L-BFGS, most a level; to 1,000,000
  double tolerance = 1e-4;  ///< of the objective's decrease in 5 iterations, in parts of its size
  /// Of the voxels that count at the start, part that always has to. A step that takes more out of
  /// the moving image is refused.
  double overlap = 0.5;
  VoxelMapFactory map = make_reference_map;
};

/// What the loop has reached, after each evaluation.
struct RegistrationState {
  int level = 0;  ///< 0 is the coarsest
  int levels = 1;
  int iteration = 0;         ///< of this level, complete
  int evaluations = 0;       ///< of all levels
  double metric = 0.0;       ///< after the last iteration
  double objective = 0.0;    ///< with penalties
  std::uint64_t voxels = 0;  ///< evaluated with gradient, in all levels
  double seconds = 0.0;      ///< that these took: voxels / seconds is the rate
  Index3 dims{4, 4, 4};      ///< of this level's lattice
};

/// An iteration, or a level's beginning, which is iteration 0.
struct RegistrationStep {
  int level, iteration;
  int evaluations;  ///< of all levels so far
  double metric, bending, barrier, objective;
  std::uint64_t voxels;  ///< that count
};

struct RegistrationResult {
  Lattice rest;      ///< over the fixed image
  Lattice deformed;  ///< takes points of the fixed image to those of the moving one
  /// At the finest level.
  double metric_start = 0.0, metric_end = 0.0;
  std::vector<RegistrationStep> history = {};
  double least_jacobian = 0.0, most_jacobian = 0.0;  ///< det J at the places of FoldBarrier
  FoldCheck folds = {};
  std::uint64_t evaluations = 0;     ///< of the metric
  std::uint64_t voxels = 0;          ///< of these: voxels walked, all levels
  double seconds = 0.0;              ///< that these took
  std::uint64_t overlap_voxels = 0;  ///< of the fixed image, that count at the end
  bool stopped = false;              ///< by the callback
  /// One line each: the result was no better than the start, which was returned; a level ended
  /// because no step was found; it folds; nothing was moved.
  std::vector<std::string> warnings = {};
};

/// Called after each evaluation; false ends the registration, which returns the best lattice so
/// far.
using RegistrationProgress = std::function<bool(const RegistrationState&)>;

/// Cells along s, t and u at a level, the coarsest 0. At the finest they are 2^h times a whole
/// number, so that h levels can be halved: as many as there are, but no more than leave a cell.
/// @throws Error for a spacing larger than the image along an axis of more than one voxel, or not
///   above 0; for levels that the pyramid has not; for more than 64 control points an axis: it
///   says which spacing would do
Index3 cell_counts(const Volume& fixed, const RegistrationOptions& options, int level);

/// The lattice at rest over a fixed image: its cells fill the volume to the outer faces of its
/// voxels, s, t and u along i, j and k, as lattice_over() of Python has it.
Lattice rest_lattice(const Volume& fixed, const Index3& cells);

/// Aligns a moving image with a fixed one: finds the lattice of uniform cubic B-splines that takes
/// each point x of the fixed image to the point T(x) of the moving one with the same content, by
/// L-BFGS on
///
///     metric(fixed(x), moving(T(x))) + bending_weight * bending energy + barrier_weight * barrier
///
/// level by level from coarse images and lattices to fine ones; the lattice of a level is refined
/// exactly for the next. Image samples are trilinear.
///
/// Where an image has one voxel along an axis, control points stay in the plane of a moving image,
/// and layers of them along that axis of a fixed one move alike.
///
/// The same bits for any number of threads; with the reference map on any processor and compiler
/// that keeps to IEEE-754 (make_reference_map). Beside both images it takes memory for their
/// pyramids, 1/7 of each, 3/4 of one while it is halved (with a mask twice that), and some MB for
/// each thread. What a Watch of the calling thread throws ends the registration without a result; a
/// callback that returns false ends it with one.
/// @throws Error, one line with the cure: a constant image; images that do not overlap at the
/// start;
///   a start that folds, if that is not allowed; a start lattice of other dims; and as Volume,
///   pyramid(), cell_counts() and make_metric() say. UsageError for an option out of range
RegistrationResult register_volumes(const Volume& fixed, const Volume& moving,
                                    const RegistrationOptions& options = {},
                                    const RegistrationProgress& progress = {});

/// The metric of a lattice over the fixed image at its finest level, with or without its gradient
/// with respect to the control points: one evaluation of the loop, for who writes another loop.
struct MetricEvaluation {
  double metric = std::numeric_limits<double>::infinity();
  std::uint64_t voxels = 0;  ///< that count
  Points gradient;           ///< m x 3, per unit of length; empty if none was wanted
};
class MetricEvaluator {
 public:
  /// @param fixed, moving  stay alive as long as the evaluator
  /// @param dims  control points an axis of a lattice whose cells fill the fixed image
  MetricEvaluator(const Volume& fixed, const Volume& moving, const Index3& dims, MetricKind kind,
                  int bins = 32, const VoxelMapFactory& map = make_reference_map);
  ~MetricEvaluator();

  /// @param points  of the deformed lattice, in points of the moving image
  /// @throws Error for another number of points
  MetricEvaluation operator()(const Points& points, bool with_gradient = true);
  const VoxelMap& map() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace hwffd
