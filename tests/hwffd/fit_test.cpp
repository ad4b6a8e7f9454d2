// Lattices fitted to points: what the losses, weights and penalties make of it, and what is
// refused.
#include "hwffd/device/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "errors.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/closure.hpp"
#include "sample_lattices.hpp"

namespace hwffd {
namespace {

/// Points in a lattice, and where a deformation of it takes them.
struct FitScene {
  explicit FitScene(const std::string& shape = "box", const Index3& dims = {5, 6, 4})
      : lattice(lattice_around(shape, test::corners(), dims)),
        points(
            test::points_at(Embedder(lattice.rest()), test::known_places(lattice.rest(), 400, 1))) {
    DeformableLattice moved(lattice.rest());
    moved.deform("random:3");
    targets = moved.carry(points);
  }

  DeformableLattice lattice;
  Points points, targets;
};

std::vector<double> distances_of(const Points& a, const Points& b) {
  const Eigen::VectorXd norms = (a - b).rowwise().norm();
  return {norms.begin(), norms.end()};
}

TEST(Fit, TargetsOfALatticeAreReached) {
  FitScene scene;
  std::vector<int> iterations;
  const FitResult result =
      fit(scene.lattice, scene.points, scene.targets, {}, [&](int iteration, double /*objective*/) {
        iterations.push_back(iteration);
        return true;
      });
  EXPECT_GT(result.rms_start, 0.01);
  EXPECT_LT(result.rms_end, 2e-3 * result.rms_start);
  const std::vector<double> distances =
      distances_of(scene.lattice.carry(scene.points), scene.targets);
  ASSERT_EQ(result.distances.size(), 400U);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    EXPECT_NEAR(result.distances[i], distances[i], 1e-12) << "point " << i;
  }
  EXPECT_EQ(result.largest, *std::max_element(result.distances.begin(), result.distances.end()));
  EXPECT_EQ(result.outside, 0U);
  EXPECT_EQ(result.folds.verdict, FoldCheck::Verdict::kProved);
  EXPECT_FALSE(result.stopped);
  std::vector<int> counted(static_cast<std::size_t>(result.iterations));
  std::iota(counted.begin(), counted.end(), 1);
  EXPECT_EQ(iterations, counted);
  EXPECT_GE(result.evaluations, result.iterations);
}

/// What a distance costs, as the header says.
double loss_of(Loss loss, double d, double c) {
  if (loss == Loss::kSquares) return d * d;
  if (loss == Loss::kHuber) return d <= c ? d * d : 2 * c * d - c * c;
  return d * d * c * c / (d * d + c * c);
}

/// Every tenth target is an outlier.
TEST(Fit, EachLossIsWhatItSaysAndForgetsMoreOfOutliers) {
  constexpr double kScale = 0.05;
  std::vector<double> errors;
  for (const std::string& name : loss_names()) {
    FitScene scene;
    const Points truth = scene.targets;
    for (Eigen::Index row = 0; row < truth.rows(); row += 10) scene.targets(row, 2) += 0.5;
    FitOptions options;
    options.loss = parse_loss(name);
    options.scale = kScale;
    options.ridge = 0;
    options.weights.resize(400);
    for (std::size_t i = 0; i < 400; ++i) options.weights[i] = 1.0 + static_cast<double>(i % 3);
    double objective = 0;
    const FitResult result =
        fit(scene.lattice, scene.points, scene.targets, options, [&](int /*iteration*/, double at) {
          objective = at;
          return true;
        });
    double losses = 0, squares = 0, weights = 0, error = 0;
    for (std::size_t i = 0; i < 400; ++i) {
      const double d = result.distances[i];
      losses += options.weights[i] * loss_of(options.loss, d, kScale);
      squares += options.weights[i] * d * d;
      weights += options.weights[i];
    }
    EXPECT_NEAR(objective, losses / weights, 1e-12) << name;
    EXPECT_NEAR(result.rms_end, std::sqrt(squares / weights), 1e-12) << name;
    const std::vector<double> off = distances_of(scene.lattice.carry(scene.points), truth);
    for (std::size_t i = 0; i < 400; ++i) error += i % 10 == 0 ? 0 : off[i] / 360;
    errors.push_back(error);
  }
  EXPECT_EQ(loss_names(), (std::vector<std::string>{"squares", "huber", "geman-mcclure"}));
  EXPECT_LT(errors[1], 0.5 * errors[0]);
  EXPECT_LT(errors[2], 0.5 * errors[1]);
  EXPECT_USAGE_ERROR(parse_loss("joy"), "loss 'joy': give squares, huber, geman-mcclure");
}

/// Of two more points one is outside, wherever that goes; the other one has no weight.
TEST(Fit, PointsOutsideOrWithoutWeightCountInNoSum) {
  FitScene plain;
  const FitResult expected = fit(plain.lattice, plain.points, plain.targets);
  for (const char* outside : {"keep", "clamp"}) {
    FitScene more;
    more.lattice.set_outside(outside);
    const Eigen::RowVector3d moves(0.3, 0.4, 1.2);
    for (Points* points : {&more.points, &more.targets}) points->conservativeResize(402, 3);
    more.points.bottomRows(2) << 90, 0, 0, more.points.row(7);
    more.targets.bottomRows(2) = more.points.bottomRows(2).rowwise() + moves;
    FitOptions options;
    options.weights.assign(401, 2.5);
    options.weights.push_back(0);
    const FitResult result = fit(more.lattice, more.points, more.targets, options);
    EXPECT_EQ(more.lattice.deformed().points(), plain.lattice.deformed().points()) << outside;
    EXPECT_EQ(result.rms_end, expected.rms_end) << outside;
    EXPECT_EQ(result.largest, expected.largest) << outside;
    EXPECT_EQ(result.outside, 1U) << outside;
    EXPECT_NEAR(result.distances[400], 1.3, 1e-12) << outside << ": as at rest";
    EXPECT_GT(result.distances[401], result.largest) << outside;
  }
}

TEST(Fit, JointsStayClosed) {
  for (const char* shape : {"cylinder", "sphere"}) {
    FitScene scene(shape, {5, 6, 9});
    scene.targets = scene.points;  // their sides go apart, which tears what may be torn
    scene.targets.col(1) += 0.1 * scene.points.col(2).cwiseSign();
    FitOptions options;
    options.iterations = 60;
    const FitResult result = fit(scene.lattice, scene.points, scene.targets, options);
    EXPECT_LT(result.rms_end, 0.8 * result.rms_start) << shape;
    const Closure rest(scene.lattice.rest());
    const Closure deformed(scene.lattice.deformed());
    EXPECT_TRUE(rest.joined()) << shape;
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(deformed.repeated(axis), rest.repeated(axis));
    EXPECT_EQ(deformed.collapsed().size(), rest.collapsed().size()) << shape;
  }
}

TEST(Fit, ABendingWeightSmooths) {
  double energy = std::numeric_limits<double>::infinity(), rms = 0;
  for (const double weight : {0.0, 1e-3, 1e-1}) {
    FitScene scene;
    FitOptions options;
    options.bending_weight = weight;
    const FitResult result = fit(scene.lattice, scene.points, scene.targets, options);
    EXPECT_LT(scene.lattice.bending_energy(), 0.8 * energy) << weight;
    EXPECT_GT(result.rms_end, rms) << weight;
    energy = scene.lattice.bending_energy();
    rms = result.rms_end;
  }
}

TEST(Fit, WhatIsReachedAlreadyStays) {
  FitScene scene;
  scene.lattice.deform("bend:20");
  const Points before = scene.lattice.deformed().points();
  const FitResult result = fit(scene.lattice, scene.points, scene.lattice.carry(scene.points));
  EXPECT_EQ(result.rms_start, 0);
  EXPECT_EQ(result.rms_end, 0);
  EXPECT_EQ(result.largest, 0);
  EXPECT_EQ(scene.lattice.deformed().points(), before);
}

TEST(Fit, ACallbackStopsItWithAResultOrThrowsItAway) {
  FitScene scene;
  const Points rest = scene.lattice.rest().points();
  struct Enough : std::exception {};
  EXPECT_THROW(fit(scene.lattice, scene.points, scene.targets, {},
                   [](int iteration, double /*objective*/) -> bool {
                     if (iteration == 3) throw Enough();
                     return true;
                   }),
               Enough);
  EXPECT_EQ(scene.lattice.deformed().points(), rest);
  const FitResult result = fit(scene.lattice, scene.points, scene.targets, {},
                               [](int iteration, double /*objective*/) { return iteration < 3; });
  EXPECT_TRUE(result.stopped);
  EXPECT_EQ(result.iterations, 3);
  EXPECT_LT(result.rms_end, result.rms_start);
  EXPECT_NE(scene.lattice.deformed().points(), rest);
}

TEST(Fit, OptionsOutOfRangeAreRefused) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto with = [](auto member, auto value) {
    FitOptions options;
    options.*member = value;
    return options;
  };
  const auto robust = [](Loss loss, double scale) {
    FitOptions options;
    options.loss = loss;
    options.scale = scale;
    return options;
  };
  const auto weights = [](std::size_t count, double weight) {
    FitOptions options;
    options.weights.assign(count, 1.0);
    options.weights.back() = weight;
    return options;
  };
  const std::string scale =
      "; a robust loss wants --scale (scale=) above 0, the distance beyond which points are "
      "outliers";
  const std::pair<FitOptions, std::string> refused[] = {
      {with(&FitOptions::bending_weight, -1.0),
       "fit: bending weight -1; give a finite number from 0 on"},
      {with(&FitOptions::ridge, kInfinity), "fit: ridge inf; give a finite number from 0 on"},
      {with(&FitOptions::tolerance, std::nan("")),
       "fit: tolerance nan; give a finite number from 0 on"},
      {with(&FitOptions::iterations, -1), "fit: iterations -1; give 0 to 1000000"},
      {with(&FitOptions::iterations, 1'000'001), "fit: iterations 1000001; give 0 to 1000000"},
      {robust(Loss::kHuber, 0), "fit: scale 0" + scale},
      {robust(Loss::kGemanMcClure, 1e101), "fit: scale 1e+101" + scale},
      {weights(399, 1), "fit: 399 weights for 400 points; give one for each"},
      {weights(400, -0.5), "fit: weight -0.5; give a finite number from 0 on"},
      {weights(400, kInfinity), "fit: weight inf; give a finite number from 0 on"},
  };
  FitScene scene;
  const Points before = scene.lattice.deformed().points();
  for (const auto& row : refused) {
    EXPECT_USAGE_ERROR(fit(scene.lattice, scene.points, scene.targets, row.first), row.second);
  }
  FitOptions heavy;
  heavy.weights.assign(400, 1e308);
  EXPECT_USAGE_ERROR(
      fit(scene.lattice, scene.points, scene.targets, heavy),
      "fit: the sum of the weights is beyond what a double holds; give smaller ones");
  EXPECT_EQ(scene.lattice.deformed().points(), before);
}

TEST(Fit, WhatCannotBeFittedIsRefused) {
  FitScene scene;
  EXPECT_ERROR(fit(scene.lattice, scene.points, scene.targets.topRows(5)),
               "fit: 400 points and 5 targets; give a target for each point");
  Points broken = scene.targets;
  broken(17, 1) = std::nan("");
  EXPECT_ERROR_PART(fit(scene.lattice, scene.points, broken), "targets 17 is not finite");
  const Points away = scene.points.array() + 100;
  EXPECT_ERROR(fit(scene.lattice, away, scene.targets),
               "fit: no point with a weight is in the lattice; make it larger, or move it there");
  FitOptions options;
  options.weights.assign(400, 0);
  EXPECT_ERROR(fit(scene.lattice, scene.points, scene.targets, options),
               "fit: no point with a weight is in the lattice; make it larger, or move it there");
  options.weights.clear();
  options.bending_weight = 1e-3;
  FitScene ball("sphere", {5, 6, 9});
  EXPECT_ERROR(fit(ball.lattice, ball.points, ball.targets, options),
               "fit: a bending weight wants a lattice whose cells at rest divide a box evenly; "
               "leave it out, or take a lattice of the shape box");
  DeformableLattice linear(lattice_around("box", test::corners(), {4, 4, 4}),
                           Family::parse("linear"));
  EXPECT_ERROR(fit(linear, scene.points, scene.targets, options),
               "fit: a bending weight wants the family bspline; convert the lattice");
}

}  // namespace
}  // namespace hwffd
