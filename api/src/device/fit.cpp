#include "hwffd/device/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/lattice/closure.hpp"
#include "hwffd/lattice/coordinates.hpp"
#include "hwffd/registration/bending_form.hpp"
#include "hwffd/registration/l_bfgs.hpp"

namespace hwffd {
namespace {

constexpr int kMostIterations = 1'000'000;

/// A loss of a squared distance, and its derivative with respect to that.
struct Cost {
  double value, slope;
};

Cost cost(Loss loss, double square, double scale) {
  const double limit = scale * scale;
  if (loss == Loss::kHuber && square > limit) {
    const double distance = std::sqrt(square);
    return {2.0 * scale * distance - limit, scale / distance};
  }
  if (loss == Loss::kGemanMcClure) {
    const double part = limit / (square + limit);
    return {square * part, part * part};
  }
  return {square, 1.0};
}

/// Points that the lattice carries, with their targets.
struct Carried {
  std::vector<Embedded> places;
  std::vector<Eigen::Index> rows;
  Points targets;
  std::vector<double> weights;  ///< which sum to 1
};

bool is_weight(double number) { return number >= 0.0 && std::isfinite(number); }

void check(const Points& points, const Points& targets, const FitOptions& options) {
  if (points.rows() != targets.rows()) {
    throw Error(fmt::format("fit: {} points and {} targets; give a target for each point",
                            points.rows(), targets.rows()));
  }
  check_coordinates("targets", targets);
  const auto refuse = [](const char* name, double number) {
    throw UsageError(fmt::format("fit: {} {}; give a finite number from 0 on", name, number));
  };
  if (!is_weight(options.bending_weight)) refuse("bending weight", options.bending_weight);
  if (!is_weight(options.ridge)) refuse("ridge", options.ridge);
  if (!is_weight(options.tolerance)) refuse("tolerance", options.tolerance);
  if (options.iterations < 0 || options.iterations > kMostIterations) {
    throw UsageError(
        fmt::format("fit: iterations {}; give 0 to {}", options.iterations, kMostIterations));
  }
  if (options.loss != Loss::kSquares &&
      !(options.scale > 0.0 && options.scale <= kLargestCoordinate)) {
    throw UsageError(
        fmt::format("fit: scale {}; a robust loss wants --scale (scale=) above 0, the distance "
                    "beyond which points "
                    "are outliers",
                    options.scale));
  }
  if (!options.weights.empty() &&
      options.weights.size() != static_cast<std::size_t>(points.rows())) {
    throw UsageError(fmt::format("fit: {} weights for {} points; give one for each",
                                 options.weights.size(), points.rows()));
  }
  for (const double weight : options.weights) {
    if (!is_weight(weight)) refuse("weight", weight);
  }
}

Carried carried(const Attachment& attachment, const Points& targets, const FitOptions& options) {
  Carried result;
  double sum = 0.0;
  for (std::size_t place = 0; place < attachment.places().size(); ++place) {
    const Eigen::Index row = attachment.follower(place).row;
    if (!attachment.is_inside(row)) continue;
    const double weight =
        options.weights.empty() ? 1.0 : options.weights[static_cast<std::size_t>(row)];
    result.places.push_back(attachment.places()[place]);
    result.rows.push_back(row);
    result.weights.push_back(weight);
    sum += weight;
  }
  if (!(sum > 0.0)) {
    throw Error("fit: no point with a weight is in the lattice; make it larger, or move it there");
  }
  if (!std::isfinite(sum)) {
    throw UsageError(
        "fit: the sum of the weights is beyond what a double holds; give smaller ones");
  }
  for (double& weight : result.weights) weight /= sum;
  result.targets.resize(static_cast<Eigen::Index>(result.rows.size()), 3);
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    result.targets.row(static_cast<Eigen::Index>(i)) = targets.row(result.rows[i]);
  }
  return result;
}

/// The three edges of a cell of a lattice at rest, s, t and u in columns.
/// @throws Error where they differ from cell to cell
Eigen::Matrix3d even_edges(const Lattice& rest) {
  Eigen::Matrix3d edges = cell_edges(rest);
  const double largest = edges.cwiseAbs().maxCoeff();
  for (const Index3& at : places(rest.dims())) {
    const Point even = rest.point(0, 0, 0) + edges * Eigen::Vector3d(at[0], at[1], at[2]);
    if (!((rest.point(at) - even).cwiseAbs().maxCoeff() <= 1e-6 * largest)) {
      throw Error(
          "fit: a bending weight wants a lattice whose cells at rest divide a box evenly; leave it "
          "out, or take a lattice of the shape box");
    }
  }
  return edges;
}

class Objective {
 public:
  Objective(DeformableLattice& lattice, Carried points, const FitOptions& options)
      : lattice_(lattice),
        points_(std::move(points)),
        options_(options),
        closure_(lattice.rest(), lattice.family()),
        start_(lattice.deformed().points()) {
    if (options.bending_weight != 0.0) {
      if (lattice.family().kind() != Family().kind()) {
        throw Error("fit: a bending weight wants the family bspline; convert the lattice");
      }
      bending_.emplace(lattice.rest().dims(), even_edges(lattice.rest()));
    }
    scale();
  }

  double operator()(const std::vector<double>& x, std::vector<double>& gradient) {
    const Points control = points_of(x);
    lattice_.move(control);
    const Points at = lattice_.evaluate(points_.places);
    Points pulls(at.rows(), 3);
    double value = 0.0;
    for (Eigen::Index i = 0; i < at.rows(); ++i) {
      const Point off = (at.row(i) - points_.targets.row(i)).transpose();
      const double square = off[0] * off[0] + off[1] * off[1] + off[2] * off[2];
      const double weight = points_.weights[static_cast<std::size_t>(i)];
      const Cost c = cost(options_.loss, square, options_.scale);
      value += weight * c.value;
      pulls.row(i) = (2.0 * weight * c.slope) * off.transpose();
    }
    Points slope = lattice_.pull_back(points_.places, pulls, lattice_.choice().device);
    if (bending_) {
      value += options_.bending_weight *
               (*bending_)(control - lattice_.rest().points(), options_.bending_weight, &slope);
    }
    const double ridge = options_.ridge / static_cast<double>(control.rows());
    for (Eigen::Index row = 0; row < control.rows(); ++row) {
      for (Eigen::Index c = 0; c < 3; ++c) {
        const double move = control(row, c) - start_(row, c);
        value += ridge * move * move;
        slope(row, c) += 2.0 * ridge * move;
      }
    }
    if (closure_.joined()) slope = closure_.pull_back(std::move(slope));
    slope.array().colwise() /= scale_;
    gradient.assign(slope.data(), slope.data() + slope.size());
    return value;
  }

  std::vector<double> start() const {
    return std::vector<double>(static_cast<std::size_t>(start_.size()));
  }
  double largest_scale() const { return scale_.maxCoeff(); }
  /// Control points of the minimizer's variables, which are their scaled moves. Where the lattice
  /// at rest is joined to itself it stays so.
  Points points_of(const std::vector<double>& x) const {
    Points moves = Eigen::Map<const Points>(x.data(), start_.rows(), 3);
    moves.array().colwise() /= scale_;
    moves += start_;
    if (!closure_.joined()) return moves;
    return closure_.restore(Lattice(lattice_.rest().dims(), std::move(moves))).points();
  }

  /// The distances of points that are carried from their targets, where control points are now.
  std::vector<double> distances() const {
    const Points at = lattice_.evaluate(points_.places);
    std::vector<double> result;
    for (Eigen::Index i = 0; i < at.rows(); ++i) {
      result.push_back((at.row(i) - points_.targets.row(i)).norm());
    }
    return result;
  }
  double rms(const std::vector<double>& distances) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
      sum += points_.weights[i] * distances[i] * distances[i];
    }
    return std::sqrt(sum);
  }
  const Carried& points() const { return points_; }

 private:
  /// Moves are counted in roots of what weighs on a control point, the row sums of W^T W: else
  /// those that points hardly see would take thousands of iterations.
  void scale() {
    Points ones(static_cast<Eigen::Index>(points_.weights.size()), 3);
    for (Eigen::Index i = 0; i < ones.rows(); ++i) {
      ones.row(i).setConstant(points_.weights[static_cast<std::size_t>(i)]);
    }
    Points sums = lattice_.pull_back(points_.places, ones, lattice_.choice().device);
    if (closure_.joined()) sums = closure_.pull_back(std::move(sums));
    constexpr double kLeast = 1e-6;  // of the largest: where no point is, the ridge is alone
    scale_ = sums.col(0).array().max(kLeast * sums.col(0).maxCoeff()).sqrt();
  }

  DeformableLattice& lattice_;
  Carried points_;
  const FitOptions& options_;
  Closure closure_;
  Points start_;
  Eigen::ArrayXd scale_;  ///< of each control point
  std::optional<BendingForm> bending_;
};

}  // namespace

const std::vector<std::string>& loss_names() {
  static const std::vector<std::string> names{"squares", "huber", "geman-mcclure"};
  return names;
}

Loss parse_loss(std::string_view name) {
  const auto& names = loss_names();
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) {
    throw UsageError(fmt::format("loss '{}': give {}", name, fmt::join(names, ", ")));
  }
  return static_cast<Loss>(at - names.begin());
}

FitResult fit(DeformableLattice& lattice, const Points& points, const Points& targets,
              const FitOptions& options, const FitProgress& progress) {
  check(points, targets, options);
  const Attachment attachment = lattice.attach(points, Attachment::Unsure::kStay);
  const Points before = lattice.deformed().points();
  Objective objective(lattice, carried(attachment, targets, options), options);
  FitResult result;
  result.rms_start = objective.rms(objective.distances());
  try {
    LbfgsOptions how;
    how.iterations = options.iterations;
    how.evaluations = 4 * options.iterations + 20;
    how.tolerance = options.tolerance;
    how.window = 5;
    how.first_step = result.rms_start > 0.0 ? result.rms_start * objective.largest_scale() : 1.0;
    const LbfgsResult least = minimize(
        [&](const std::vector<double>& x, std::vector<double>& g) { return objective(x, g); },
        objective.start(), how,
        [&](const LbfgsState& state) {
          result.stopped = progress && !progress(state.iteration, state.value);
          return !result.stopped;
        });
    lattice.move(objective.points_of(least.x));
    result.iterations = least.iterations;
    result.evaluations = least.evaluations;

    const std::vector<double> ends = objective.distances();
    result.rms_end = objective.rms(ends);
    result.distances.resize(static_cast<std::size_t>(points.rows()));
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
      result.distances[static_cast<std::size_t>(row)] = (points.row(row) - targets.row(row)).norm();
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
      result.distances[static_cast<std::size_t>(objective.points().rows[i])] = ends[i];
      if (objective.points().weights[i] > 0.0) result.largest = std::max(result.largest, ends[i]);
    }
    result.outside = result.distances.size() - ends.size();
    result.folds = check_folds(lattice.deformed(), kFoldDepth, lattice.family());
  } catch (...) {
    lattice.move(before);
    throw;
  }
  return result;
}

}  // namespace hwffd
