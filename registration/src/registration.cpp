#include "hwffd/registration/registration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/lattice/refine.hpp"
#include "hwffd/registration/bending_form.hpp"
#include "hwffd/registration/fold_barrier.hpp"
#include "hwffd/registration/l_bfgs.hpp"
#include "hwffd/registration/pyramid.hpp"
#include "level_evaluator.hpp"

namespace hwffd {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLevels = 3;  // unless told otherwise
constexpr int kMostIterations = 1'000'000;
constexpr int kWindow = 5;          // iterations whose decrease says whether there is progress
constexpr double kRounding = 1e-9;  // of a spacing
constexpr double kLittle = 1e-9;  // that the metric changes by if a control point moves by a voxel

int levels_of(const Volume& fixed, const RegistrationOptions& options) {
  const int most = most_levels(fixed.counts());
  if (options.levels == 0) return std::min(kLevels, most);
  if (options.levels < 1 || options.levels > most) {
    throw Error(fmt::format(
        "levels {}: the {} of {} x {} x {} voxels can have {}; give 1 to {}, or 0 to leave it open",
        options.levels, fixed.name(), fixed.counts()[0], fixed.counts()[1], fixed.counts()[2], most,
        most));
  }
  return options.levels;
}

/// Between voxels along each axis.
std::array<double, 3> voxel_lengths(const Volume& volume) {
  std::array<double, 3> result{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto& rows = volume.to_point().linear;
    result[a] =
        std::sqrt(rows[0][a] * rows[0][a] + rows[1][a] * rows[1][a] + rows[2][a] * rows[2][a]);
  }
  return result;
}

/// The least of these of axes with more than one voxel.
double nearest_voxels(const Volume& volume) {
  const auto lengths = voxel_lengths(volume);
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < 3; ++a) {
    if (volume.counts()[a] > 1) result = std::min(result, lengths[a]);
  }
  return result;
}

/// A length rounded up, to three digits at least.
double rounded_up(double length) {
  double unit = 1e-3;
  while (unit > length / 100) unit /= 10;
  return std::ceil(length / unit) * unit;
}

/// The cells of an axis at the finest level, and how often they can be halved.
struct AxisCells {
  int finest, halvings;
};

AxisCells cells_along(const Volume& fixed, const RegistrationOptions& options, std::size_t axis,
                      int levels) {
  const int voxels = fixed.counts()[axis];
  if (voxels == 1) return {1, 0};
  const double unit = options.spacing_in_voxels ? 1.0 : voxel_lengths(fixed)[axis];
  const double size = voxels * unit;
  const double spacing = options.spacing[axis];
  const char* const of = options.spacing_in_voxels ? " voxels" : "";
  if (!(spacing > 0.0)) {
    throw Error(
        fmt::format("spacing {:.6g} along {}: give a number above 0", spacing, "ijk"[axis]));
  }
  const double ratio = size / spacing;
  if (ratio < 1 - kRounding) {
    throw Error(
        fmt::format("spacing {:.6g}{} along {}: larger than the {} of {:.6g}{}; give at most "
                    "that",
                    spacing, of, "ijk"[axis], fixed.name(), size, of));
  }
  int halvings = 0;
  while (halvings < levels - 1 && std::ldexp(ratio, -halvings - 1) >= 1 - kRounding) ++halvings;
  constexpr int kMost = Lattice::kMaxPoints - 3;
  const double coarsest = std::max(1.0, std::floor(std::ldexp(ratio, -halvings) + 0.5));
  const double finest = std::ldexp(coarsest, halvings);
  if (finest > kMost) {
    const int most = (kMost >> halvings) << halvings;
    throw Error(fmt::format(
        "spacing {:.6g}{} along {}: {:.0f} control points, more than {} an axis; give "
        "{:.6g} or more",
        spacing, of, "ijk"[axis], finest + 3, Lattice::kMaxPoints, rounded_up(size / most)));
  }
  return {static_cast<int>(finest), halvings};
}

Index3 dims_of(const Index3& cells) { return {cells[0] + 3, cells[1] + 3, cells[2] + 3}; }

std::string text(const Index3& dims) {
  return fmt::format("{} x {} x {}", dims[0], dims[1], dims[2]);
}

Points moved(const Points& points, const AffineMap& map) {
  Points result(points.rows(), 3);
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    const auto to = map({points(row, 0), points(row, 1), points(row, 2)});
    for (std::size_t c = 0; c < 3; ++c) result(row, static_cast<int>(c)) = to[c];
  }
  return result;
}

/// The lattice refined to those dims.
Lattice refined_to(Lattice lattice, const Index3& dims) {
  while (lattice.dims() != dims) {
    std::array<bool, 3> axes{};
    for (std::size_t a = 0; a < 3; ++a) axes[a] = lattice.dims()[a] < dims[a];
    lattice = refined(lattice, axes);
  }
  return lattice;
}

std::vector<double> numbers(const Points& points) {
  return {points.data(), points.data() + points.size()};
}

Points points_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Points>(numbers.data(), static_cast<Eigen::Index>(numbers.size() / 3), 3);
}

/// What control points may do where an image has one voxel along an axis. If the moving one has,
/// they stay in its plane, beyond which nothing counts; if the fixed one has, all layers along that
/// axis move alike, since only the middle is seen.
class Freedom {
 public:
  Freedom(const Volume& fixed, const Volume& moving) {
    const AffineMap to_index = moving.to_point().inverse();
    for (std::size_t a = 0; a < 3; ++a) {
      flat_[a] = fixed.counts()[a] == 1;
      if (moving.counts()[a] > 1) continue;
      std::array<double, 3> normal = to_index.linear[a];
      for (const auto& other : normals_) remove(other, normal);
      const double length = std::sqrt(dot(normal, normal));
      for (double& x : normal) x /= length;
      normals_.push_back(normal);
    }
  }

  /// Leaves of a gradient what may be followed.
  void project(const Index3& dims, Points& gradient) const {
    if (!normals_.empty()) {
      for (Eigen::Index row = 0; row < gradient.rows(); ++row) {
        std::array<double, 3> g{gradient(row, 0), gradient(row, 1), gradient(row, 2)};
        for (const auto& normal : normals_) remove(normal, g);
        for (std::size_t c = 0; c < 3; ++c) gradient(row, static_cast<int>(c)) = g[c];
      }
    }
    const std::array<Eigen::Index, 3> strides{static_cast<Eigen::Index>(dims[1]) * dims[2], dims[2],
                                              1};
    for (std::size_t a = 0; a < 3; ++a) {
      if (!flat_[a]) continue;
      const Eigen::Index n = dims[a];
      for (Eigen::Index row = 0; row < gradient.rows(); ++row) {
        if (row / strides[a] % n != 0) continue;
        Eigen::RowVector3d sum = gradient.row(row);
        for (Eigen::Index l = 1; l < n; ++l) sum += gradient.row(row + l * strides[a]);
        for (Eigen::Index l = 0; l < n; ++l) {
          gradient.row(row + l * strides[a]) = sum / static_cast<double>(n);
        }
      }
    }
  }

 private:
  static double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static void remove(const std::array<double, 3>& normal, std::array<double, 3>& from) {
    const double along = dot(normal, from);
    for (std::size_t c = 0; c < 3; ++c) from[c] -= along * normal[c];
  }

  std::array<bool, 3> flat_{};
  std::vector<std::array<double, 3>> normals_;
};

/// Thrown through the optimizer when the callback wants to end.
struct Stopped {};

void check_not_negative(const char* name, double value) {
  if (value >= 0.0 && std::isfinite(value)) return;
  throw UsageError(fmt::format("{} {:.6g}: give 0 or more", name, value));
}

void check_options(const RegistrationOptions& options) {
  check_not_negative("bending weight", options.bending_weight);
  check_not_negative("barrier weight", options.barrier_weight);
  if (options.iterations < 0 || options.iterations > kMostIterations) {
    throw UsageError(
        fmt::format("iterations {}: give 0 to {}", options.iterations, kMostIterations));
  }
  check_not_negative("tolerance", options.tolerance);
  if (!(options.overlap >= 0.0 && options.overlap <= 1.0)) {
    throw UsageError(fmt::format("overlap {:.6g}: give 0 to 1", options.overlap));
  }
  if (options.start && options.start_lattice) {
    throw UsageError("start: an affine map and a lattice; give one of them");
  }
  if (options.start) options.start->inverse();
}

/// The objective and what it is made of.
struct Value {
  double metric = 0.0, bending = 0.0, barrier = 0.0, objective = 0.0;
  std::uint64_t voxels = 0;
};

class Registration {
 public:
  Registration(const Volume& fixed, const Volume& moving, const RegistrationOptions& options,
               const RegistrationProgress& progress)
      : fixed_(fixed),
        options_(options),
        progress_(progress),
        freedom_(fixed, moving),
        levels_(levels_of(fixed, options)) {
    check_options(options);
    check_not_constant(fixed);
    check_not_constant(moving);
    for (int level = 0; level < levels_; ++level) {
      dims_.push_back(dims_of(cell_counts(fixed, options, level)));
    }
    start_ = start_lattice();
    for (Index3& dims : dims_) {
      if (is_coarser(dims, start_->dims())) dims = start_->dims();
    }
    fixed_levels_ = pyramid(fixed, levels_);
    moving_levels_ = pyramid(moving, std::min(levels_, most_levels(moving.counts())));
    if (options.smooth) {
      fixed_levels_.back().volume = smoothed(fixed);
      moving_levels_.back().volume = smoothed(moving);
    } else {
      moving_levels_.back().volume = filled(moving);
    }
    while (static_cast<int>(moving_levels_.size()) < levels_) {
      moving_levels_.insert(moving_levels_.begin(), moving_levels_.front());
    }
  }

  RegistrationResult run() {
    Lattice lattice = *start_;
    std::vector<std::string> warnings;
    bool stopped = false;
    for (int level = 0; level < levels_ && !stopped; ++level) {
      lattice = refined_to(std::move(lattice), dims_[static_cast<std::size_t>(level)]);
      stopped = run_level(level, lattice, warnings);
    }
    lattice = refined_to(std::move(lattice), dims_.back());
    return finished(std::move(lattice), std::move(warnings), stopped);
  }

 private:
  /// What a level's objective needs.
  struct Level {
    Level(Registration& of, int level)
        : rest(rest_lattice(of.fixed_, cells(of.dims_[static_cast<std::size_t>(level)]))),
          evaluator(of.fixed_levels_[static_cast<std::size_t>(level)].volume,
                    of.moving_levels_[static_cast<std::size_t>(level)].volume,
                    voxel_grid(of.fixed_.counts(),
                               of.fixed_levels_[static_cast<std::size_t>(level)].halvings,
                               of.fixed_levels_[static_cast<std::size_t>(level)].volume.counts(),
                               rest.dims()),
                    of.options_.metric, of.options_.bins, of.options_.map),
          bending(rest.dims(), cell_edges(rest)) {
      if (of.options_.no_folds) barrier.emplace(refined_to(*of.start_, rest.dims()));
    }
    static Index3 cells(const Index3& dims) { return {dims[0] - 3, dims[1] - 3, dims[2] - 3}; }

    Lattice rest;
    LevelEvaluator evaluator;
    BendingForm bending;
    std::optional<FoldBarrier> barrier;
  };

  static bool is_coarser(const Index3& dims, const Index3& than) {
    return dims[0] < than[0] || dims[1] < than[1] || dims[2] < than[2];
  }

  Lattice start_lattice() const {
    if (options_.start_lattice) {
      const Index3& dims = options_.start_lattice->dims();
      if (std::find(dims_.begin(), dims_.end(), dims) == dims_.end()) {
        std::string all;
        for (const Index3& some : dims_) all += (all.empty() ? "" : " or ") + text(some);
        throw Error(fmt::format("start lattice: {} control points; give {} for this spacing",
                                text(dims), all));
      }
      return *options_.start_lattice;
    }
    Lattice rest = rest_lattice(fixed_, Level::cells(dims_.front()));
    if (!options_.start) return rest;
    return {rest.dims(), moved(rest.points(), *options_.start)};
  }

  Value evaluate(Level& level, const Points& points, Points* gradient) {
    Value value;
    if (level.barrier) {
      Points ignored;
      value.barrier = (*level.barrier)(points).penalty;
      value.objective = std::numeric_limits<double>::infinity();
      if (!std::isfinite(value.barrier)) return value;
    }
    const Clock::time_point before = Clock::now();
    MetricEvaluation metric = level.evaluator.run(points, gradient != nullptr);
    seconds_ += std::chrono::duration<double>(Clock::now() - before).count();
    ++evaluations_;
    const Index3& counts = level.evaluator.map().grid().counts;
    voxels_ += static_cast<std::uint64_t>(counts[0]) * static_cast<std::uint64_t>(counts[1]) *
               static_cast<std::uint64_t>(counts[2]);
    value.metric = metric.metric;
    value.voxels = metric.voxels;
    value.objective = value.metric;
    if (!std::isfinite(value.metric)) return value;
    if (gradient != nullptr) *gradient = std::move(metric.gradient);
    if (options_.bending_weight != 0.0) {
      value.bending =
          level.bending(points - level.rest.points(), options_.bending_weight, gradient);
      value.objective += options_.bending_weight * value.bending;
    }
    if (level.barrier) {
      if (gradient != nullptr && value.barrier > 0.0) {
        (*level.barrier)(points, options_.barrier_weight, gradient);
      }
      value.objective += options_.barrier_weight * value.barrier;
    }
    return value;
  }

  void show(int level, int iteration, const Value& last) {
    if (!progress_) return;
    RegistrationState state;
    state.level = level;
    state.levels = levels_;
    state.iteration = iteration;
    state.evaluations = evaluations_;
    state.metric = last.metric;
    state.objective = last.objective;
    state.voxels = voxels_;
    state.seconds = seconds_;
    state.dims = dims_[static_cast<std::size_t>(level)];
    if (!progress_(state)) throw Stopped();
  }

  void record(int level, int iteration, const Value& value) {
    history_.push_back({level, iteration, evaluations_, value.metric, value.bending, value.barrier,
                        value.objective, value.voxels});
  }

  /// Moves the lattice; whether it was stopped.
  bool run_level(int at, Lattice& lattice, std::vector<std::string>& warnings) {
    Level level(*this, at);
    int iteration = 0;
    Value current;
    Value last;  // of the latest evaluation
    std::vector<double> best = numbers(lattice.points());
    std::uint64_t least_voxels = 0;
    const LbfgsObjective objective = [&](const std::vector<double>& x,
                                         std::vector<double>& gradient) {
      Points sum;
      last = evaluate(level, points_of(x), &sum);
      if (least_voxels == 0) {
        if (std::isfinite(last.barrier) && last.voxels == 0) throw no_overlap();
        if (!std::isfinite(last.objective)) {
          throw Error(
              "the metric has no value at the start: an image is constant where they overlap; give "
              "a start that aligns them roughly");
        }
        const auto size =
            static_cast<double>(fixed_levels_[static_cast<std::size_t>(at)].volume.size());
        if (at == 0) share_ = static_cast<double>(last.voxels) / size;
        const auto wanted = static_cast<std::uint64_t>(options_.overlap * share_ * size);
        least_voxels =
            std::clamp<std::uint64_t>(wanted, 1, std::max<std::uint64_t>(1, last.voxels));
        current = last;
        record(at, 0, current);
      }
      show(at, iteration, current);
      if (!std::isfinite(last.objective) || last.voxels < least_voxels) {
        return std::numeric_limits<double>::infinity();
      }
      freedom_.project(level.rest.dims(), sum);
      gradient = numbers(sum);
      values_.emplace_back(x, last);
      return last.objective;
    };
    const auto visit = [&](const LbfgsState& state) {
      iteration = state.iteration;
      best = *state.x;
      // Of the evaluations of this line search, the one that was taken.
      const auto taken = std::find_if(values_.rbegin(), values_.rend(), [&](const auto& evaluated) {
        return evaluated.first == best;
      });
      if (taken != values_.rend()) current = taken->second;
      values_.clear();
      record(at, iteration, current);
      return true;
    };
    LbfgsOptions limits;
    limits.iterations = options_.iterations;
    limits.evaluations = 20 * options_.iterations + 20;
    limits.tolerance = options_.tolerance;
    limits.window = kWindow;
    limits.first_step = nearest_voxels(fixed_levels_[static_cast<std::size_t>(at)].volume);
    limits.gradient = kLittle / limits.first_step;
    std::function<bool(const std::vector<double>&)> accepts;
    if (level.barrier) {
      accepts = [&](const std::vector<double>& x) {
        return level.barrier->proves_no_fold(points_of(x));
      };
    }
    bool stopped = false;
    values_.clear();
    try {
      LbfgsResult result = minimize(objective, numbers(lattice.points()), limits, visit, accepts);
      best = std::move(result.x);
      if (result.end == LbfgsEnd::kLineSearch && result.iterations == 0) {
        warnings.push_back(fmt::format(
            "level {} of {}: no step along the gradient makes the metric less", at + 1, levels_));
      }
    } catch (const Stopped&) {
      stopped = true;
    }
    lattice = Lattice(lattice.dims(), points_of(best));
    return stopped;
  }

  Error no_overlap() const {
    return Error(
        fmt::format("{} and {} do not overlap: no voxel that counts comes to lie in the other; "
                    "give a start that "
                    "aligns them roughly, or check their origins, directions and masks",
                    fixed_.name(), moving_levels_.back().volume.name()));
  }

  RegistrationResult finished(Lattice lattice, std::vector<std::string> warnings, bool stopped) {
    Level finest(*this, levels_ - 1);
    const Lattice start = refined_to(*start_, dims_.back());
    const Value at_start = evaluate(finest, start.points(), nullptr);
    Value at_end = evaluate(finest, lattice.points(), nullptr);
    if (at_end.voxels == 0 || !(at_end.objective <= at_start.objective)) {
      warnings.push_back(fmt::format(
          "the objective did not get less, {:.6g} at the start and {:.6g} at the end: the start is "
          "returned",
          at_start.objective, at_end.objective));
      lattice = start;
      at_end = at_start;
    } else if (at_end.metric > at_start.metric) {
      warnings.push_back(
          fmt::format("the metric got worse for the sake of penalties, from {:.6g} to "
                      "{:.6g}; give these less weight",
                      at_start.metric, at_end.metric));
    }
    RegistrationResult result{finest.rest, std::move(lattice)};
    result.metric_start = at_start.metric;
    result.metric_end = at_end.metric;
    result.overlap_voxels = at_end.voxels;
    result.history = std::move(history_);
    const FoldBarrier::Result range = jacobian_range(result.rest, result.deformed);
    result.least_jacobian = range.least;
    result.most_jacobian = range.most;
    result.folds = check_bspline_folds(result.deformed);
    if (result.folds.verdict == FoldCheck::Verdict::kFolded) {
      warnings.push_back(
          "the lattice is " + result.folds.text() +
          ": it is not invertible there; ask for no folds, or give more bending weight");
    } else if (result.folds.verdict == FoldCheck::Verdict::kUndecided) {
      warnings.push_back("whether the lattice folds is " + result.folds.text());
    }
    result.evaluations = static_cast<std::uint64_t>(evaluations_);
    result.voxels = voxels_;
    result.seconds = seconds_;
    result.stopped = stopped;
    result.warnings = std::move(warnings);
    return result;
  }

  const Volume& fixed_;
  const RegistrationOptions& options_;
  const RegistrationProgress& progress_;
  Freedom freedom_;
  int levels_;
  double share_ = 1.0;        // of the fixed volume that counted at the start
  std::vector<Index3> dims_;  ///< of each level's lattice
  std::optional<Lattice> start_;
  std::vector<PyramidLevel> fixed_levels_, moving_levels_;
  std::vector<RegistrationStep> history_;
  std::vector<std::pair<std::vector<double>, Value>> values_;  ///< of one line search
  int evaluations_ = 0;
  std::uint64_t voxels_ = 0;
  double seconds_ = 0.0;
};

}  // namespace

Index3 cell_counts(const Volume& fixed, const RegistrationOptions& options, int level) {
  const int levels = levels_of(fixed, options);
  if (level < 0 || level >= levels) {
    throw Error(fmt::format("level {}: give 0 to {}", level, levels - 1));
  }
  Index3 result{};
  for (std::size_t a = 0; a < 3; ++a) {
    const AxisCells cells = cells_along(fixed, options, a, levels);
    result[a] = cells.finest >> std::min(cells.halvings, levels - 1 - level);
  }
  return result;
}

Lattice rest_lattice(const Volume& fixed, const Index3& cells) {
  const Index3 dims = dims_of(cells);
  Lattice::check_dims(dims);
  Points points(static_cast<Eigen::Index>(dims[0]) * dims[1] * dims[2], 3);
  Eigen::Index row = 0;
  for (const Index3& at : places(dims)) {
    std::array<double, 3> index{};
    for (std::size_t a = 0; a < 3; ++a) {
      index[a] = (at[a] - 1) * (static_cast<double>(fixed.counts()[a]) / cells[a]) - 0.5;
    }
    const auto point = fixed.to_point()(index);
    for (std::size_t c = 0; c < 3; ++c) points(row, static_cast<int>(c)) = point[c];
    ++row;
  }
  return {dims, points};
}

RegistrationResult register_volumes(const Volume& fixed, const Volume& moving,
                                    const RegistrationOptions& options,
                                    const RegistrationProgress& progress) {
  return Registration(fixed, moving, options, progress).run();
}

}  // namespace hwffd
