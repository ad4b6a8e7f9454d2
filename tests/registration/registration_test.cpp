#include "hwffd/registration/registration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "errors.hpp"
#include "hwffd/lattice/bending.hpp"
#include "hwffd/on_threads.hpp"
#include "phantom.hpp"
#include "random_numbers.hpp"

namespace hwffd {
namespace {

constexpr MetricKind kMetrics[] = {MetricKind::kMeanSquares, MetricKind::kCorrelation,
                                   MetricKind::kMutualInformation};

/// Turned, sheared, of other lengths along each axis, and mirrored.
AffineMap scanner() {
  AffineMap map;
  map.linear = {{{0, -1.5, 0.25}, {2, 0, 0}, {0.5, 0, 1.25}}};
  map.offset = {10, -20, 30};
  return map;
}

RegistrationOptions options_of(double spacing, MetricKind metric = MetricKind::kMeanSquares) {
  RegistrationOptions options;
  options.spacing = {spacing, spacing, spacing};
  options.metric = metric;
  return options;
}

std::vector<double> numbers(const Lattice& lattice) {
  return {lattice.points().data(), lattice.points().data() + lattice.points().size()};
}

/// Through the whole chain: of the metric with respect to control points. Differences are those of
/// a metric whose samples are binary32 and kinked between cells of voxels, so they agree to some
/// parts in a thousand.
TEST(MetricEvaluator, GradientIsThatOfDifferences) {
  const Phantom phantom({16, 14, 12}, 1.5, scanner());
  const Volume fixed = phantom.fixed();
  const Volume moving = phantom.moving();
  const Lattice rest = rest_lattice(fixed, {3, 2, 2});
  RandomNumbers random(1);
  Points points = rest.points();
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] += random(-0.3, 0.3);
  for (const MetricKind kind : kMetrics) {
    MetricEvaluator evaluator(fixed, moving, rest.dims(), kind);
    const MetricEvaluation at = evaluator(points);
    EXPECT_EQ(evaluator(points, false).metric, at.metric);
    EXPECT_GT(at.voxels, 1500U);
    double dot = 0.0;
    double squares = 0.0;
    double off = 0.0;
    int compared = 0;
    for (Eigen::Index i = 0; i < points.size(); i += 7) {
      // Points that few voxels near the border see change how many count.
      const double step = 1e-3;
      Points more = points;
      Points less = points;
      more.data()[i] += step;
      less.data()[i] -= step;
      const MetricEvaluation above = evaluator(more, false);
      const MetricEvaluation below = evaluator(less, false);
      if (above.voxels != at.voxels || below.voxels != at.voxels) continue;
      const double difference = (above.metric - below.metric) / (2 * step);
      dot += difference * at.gradient.data()[i];
      squares += difference * difference;
      off += (difference - at.gradient.data()[i]) * (difference - at.gradient.data()[i]);
      ++compared;
    }
    EXPECT_GT(compared, 20) << metric_name(kind);
    EXPECT_LT(std::sqrt(off / squares), 5e-3) << metric_name(kind);
    EXPECT_NEAR(dot / squares, 1.0, 5e-3) << metric_name(kind);
  }
}

TEST(MetricEvaluator, RefusesOtherPoints) {
  const Phantom phantom({16, 14, 12}, 1.5);
  const Volume fixed = phantom.fixed();
  MetricEvaluator evaluator(fixed, fixed, {5, 5, 6}, MetricKind::kCorrelation);
  EXPECT_ERROR(evaluator(Points::Zero(149, 3)), "metric: 149 control points; give 5 x 5 x 6");
  EXPECT_EQ(evaluator.map().grid().counts, (Index3{16, 14, 12}));
}

TEST(RestLattice, FillsTheVolumeToItsOuterFaces) {
  const Phantom phantom({16, 14, 1}, 1.0, scanner());
  const Volume fixed = phantom.fixed();
  const Lattice rest = rest_lattice(fixed, {4, 2, 1});
  ASSERT_EQ(rest.dims(), (Index3{7, 5, 4}));
  const auto at = [&](const std::array<double, 3>& index) {
    const auto p = scanner()(index);
    return Point(p[0], p[1], p[2]);
  };
  EXPECT_LT((rest.point(1, 1, 1) - at({-0.5, -0.5, -0.5})).norm(), 1e-12);
  EXPECT_LT((rest.point(5, 3, 2) - at({15.5, 13.5, 0.5})).norm(), 1e-12);
  EXPECT_LT((rest.point(6, 4, 3) - at({19.5, 20.5, 1.5})).norm(), 1e-12);
}

TEST(Registration, RecoversA3dDeformation) {
  const Phantom phantom({40, 36, 32}, 1.5, scanner());
  const Volume fixed = phantom.fixed();
  const Volume moving = phantom.moving();
  for (const MetricKind kind : {MetricKind::kMeanSquares, MetricKind::kCorrelation}) {
    RegistrationOptions options = options_of(9, kind);
    options.smooth = false;  // there is no noise
    const RegistrationResult result = register_volumes(fixed, moving, options);
    EXPECT_GT(phantom.error(result.rest, 0), 0.9);
    EXPECT_LT(phantom.error(result.deformed, 0), 0.1) << metric_name(kind);
    EXPECT_LT(result.metric_end, 0.01 * result.metric_start);
    EXPECT_EQ(result.folds.verdict, FoldCheck::Verdict::kProved);
    EXPECT_TRUE(result.warnings.empty());
    EXPECT_FALSE(result.stopped);
    EXPECT_GT(result.least_jacobian, 0.3);
    EXPECT_LT(result.least_jacobian, 1.0);
    EXPECT_GT(result.most_jacobian, 1.0);
    EXPECT_GT(result.overlap_voxels, 40U * 36 * 32 / 2);
    EXPECT_LE(result.overlap_voxels, 40U * 36 * 32);
  }
}

TEST(Registration, RecoversOtherModalitiesByMutualInformation) {
  const Phantom phantom({40, 36, 32}, 1.5);
  RegistrationOptions options = options_of(9, MetricKind::kMutualInformation);
  options.smooth = false;  // there is no noise
  const RegistrationResult result =
      register_volumes(phantom.fixed_of_another_kind(), phantom.moving(), options);
  EXPECT_LT(phantom.error(result.deformed, 0), 0.1);
  EXPECT_LT(result.metric_end, result.metric_start);
}

TEST(Registration, RecoversA2dDeformation) {
  const Phantom phantom({64, 48, 1}, 2.0, scanner());
  for (const MetricKind kind : kMetrics) {
    const RegistrationResult result =
        register_volumes(phantom.fixed(), phantom.moving(), options_of(12, kind));
    EXPECT_EQ(result.deformed.dims()[2], 4);
    EXPECT_GT(phantom.error(result.rest, 0), 1.0);
    EXPECT_LT(phantom.error(result.deformed, 0), 0.1) << metric_name(kind);
    // It stays in the plane, and its layers move alike.
    const AffineMap to_index = scanner().inverse();
    for (const Index3& at : places(result.deformed.dims())) {
      const Point p = result.deformed.point(at);
      EXPECT_NEAR(to_index({p[0], p[1], p[2]})[2], at[2] - 1.5, 1e-9);
      const Point moved = p - result.rest.point(at);
      const Index3 first{at[0], at[1], 0};
      EXPECT_LT((moved - (result.deformed.point(first) - result.rest.point(first))).norm(), 1e-9);
    }
  }
}

TEST(Registration, HistoryAndCountsSayWhatWasDone) {
  const Phantom phantom({32, 32, 32}, 1.0);
  std::uint64_t voxels = 0;
  int calls = 0;
  const RegistrationResult result = register_volumes(
      phantom.fixed(), phantom.moving(), options_of(8), [&](const RegistrationState& state) {
        ++calls;
        EXPECT_EQ(state.evaluations, calls);
        EXPECT_EQ(state.levels, 3);
        const int points = (1 << state.level) + 3;
        EXPECT_EQ(state.dims, (Index3{points, points, points}));
        voxels = state.voxels;
        return true;
      });
  EXPECT_EQ(result.deformed.dims(), (Index3{7, 7, 7}));
  EXPECT_EQ(result.evaluations, static_cast<std::uint64_t>(calls) + 2);
  EXPECT_EQ(result.voxels, voxels + 2 * 32 * 32 * 32);
  EXPECT_GT(result.seconds, 0.0);
  int level = -1;
  double last = 0.0;
  for (const RegistrationStep& step : result.history) {
    if (step.iteration == 0) {
      EXPECT_EQ(step.level, ++level);
    } else {
      EXPECT_LT(step.objective, last);
    }
    EXPECT_EQ(step.metric, step.objective);  // no penalties
    last = step.objective;
  }
  EXPECT_EQ(level, 2);
  EXPECT_EQ(last, result.metric_end);
}

TEST(Registration, LevelsEndWhereFiveIterationsBringLittle) {
  const Phantom phantom({32, 32, 32}, 1.0);
  RegistrationOptions options = options_of(8);
  options.tolerance = 1e9;
  const RegistrationResult result = register_volumes(phantom.fixed(), phantom.moving(), options);
  ASSERT_EQ(result.history.size(), 18U);
  for (std::size_t n = 0; n < 18; ++n) {
    EXPECT_EQ(result.history[n].level, static_cast<int>(n / 6));
    EXPECT_EQ(result.history[n].iteration, static_cast<int>(n % 6));
  }
}

TEST(Registration, BitsDoNotDependOnThreads) {
  const Phantom phantom({32, 32, 32}, 1.0, scanner());
  const Volume fixed = phantom.fixed();
  // Sums of two slabs are the same in either order.
  ASSERT_GE(MetricEvaluator(fixed, fixed, {7, 7, 7}, MetricKind::kMeanSquares).map().slabs().size(),
            8U);
  for (const MetricKind kind : kMetrics) {
    RegistrationOptions options = options_of(8, kind);
    options.iterations = 8;
    options.bending_weight = 0.01;
    options.no_folds = true;
    std::vector<std::vector<double>> results;
    std::vector<double> metrics;
    for (const std::size_t threads : {1, 2, 5}) {
      set_thread_count(threads);
      const RegistrationResult result =
          register_volumes(phantom.fixed(), phantom.moving(), options);
      results.push_back(numbers(result.deformed));
      metrics.push_back(result.metric_end);
    }
    set_thread_count(0);
    EXPECT_EQ(results[0], results[1]) << metric_name(kind);
    EXPECT_EQ(results[0], results[2]) << metric_name(kind);
    EXPECT_EQ(metrics[0], metrics[1]);
    EXPECT_EQ(metrics[0], metrics[2]);
    EXPECT_NE(results[0], numbers(rest_lattice(phantom.fixed(), {4, 4, 4})));
  }
}

/// Of the same voxels, a nanometre or a kilometre apart.
TEST(Registration, UnitOfLengthDoesNotMatter) {
  std::vector<std::vector<double>> results;
  for (const double unit : {1.0, 0x1p-20, 0x1p20}) {
    AffineMap map;
    for (std::size_t a = 0; a < 3; ++a) map.linear[a][a] = unit;
    const Phantom phantom({32, 28, 24}, 1.0, map);
    RegistrationOptions options = options_of(8);
    options.bending_weight = 0.01 * unit * unit;
    const RegistrationResult result = register_volumes(phantom.fixed(), phantom.moving(), options);
    EXPECT_TRUE(result.warnings.empty()) << unit;
    results.push_back(numbers(result.deformed));
    for (double& number : results.back()) number /= unit;
  }
  EXPECT_EQ(results[1], results[0]);
  EXPECT_EQ(results[2], results[0]);
}

/// How thick the one slice of an image of two dimensions is.
TEST(Registration, ThicknessOfASliceDoesNotMatter) {
  std::vector<double> ends;
  for (const double thickness : {1.0, 0x1p-17}) {
    AffineMap map;
    map.linear[2][2] = thickness;
    const Phantom phantom({32, 28, 1}, 1.0, map);
    ends.push_back(register_volumes(phantom.fixed(), phantom.moving(), options_of(8)).metric_end);
  }
  EXPECT_EQ(ends[1], ends[0]);
}

TEST(Registration, BendingWeightMakesItSmoother) {
  const Phantom phantom({32, 32, 1}, 2.0);
  RegistrationOptions options = options_of(4);
  const RegistrationResult free = register_volumes(phantom.fixed(), phantom.moving(), options);
  options.bending_weight = 1.0;
  const RegistrationResult stiff = register_volumes(phantom.fixed(), phantom.moving(), options);
  const double of_free = bending_energy(free.rest, free.deformed);
  const double of_stiff = bending_energy(stiff.rest, stiff.deformed);
  EXPECT_LT(of_stiff, 0.8 * of_free);
  EXPECT_GT(of_stiff, 0.0);
  EXPECT_NEAR(stiff.history.back().bending, of_stiff, 1e-10 * of_stiff);
  EXPECT_NEAR(stiff.history.back().objective, stiff.history.back().metric + of_stiff, 1e-10);
}

/// Images that are best matched by folding: a pattern against its mirror image.
TEST(Registration, NoFoldsWhereItFoldsWithout) {
  const Index3 counts{40, 40, 1};
  std::vector<float> values;
  std::vector<float> mirrored;
  for (int n = 0; n < 1600; ++n) {
    const int row = n / 40;
    const double x = n % 40;
    const double y = row;
    const auto value = [](double a, double b) {
      return static_cast<float>(std::exp(-0.02 * ((a - 12) * (a - 12) + (b - 20) * (b - 20))) +
                                0.7 *
                                    std::exp(-0.03 * ((a - 26) * (a - 26) + (b - 22) * (b - 22))));
    };
    values.push_back(value(x, y));
    mirrored.push_back(value(39 - x, y));
  }
  const Volume fixed("fixed image", counts, values, {});
  const Volume moving("moving image", counts, mirrored, {});
  RegistrationOptions options = options_of(5);
  const RegistrationResult folded = register_volumes(fixed, moving, options);
  ASSERT_EQ(folded.folds.verdict, FoldCheck::Verdict::kFolded);
  EXPECT_LT(folded.least_jacobian, 0.0);
  ASSERT_EQ(folded.warnings.size(), 1U);
  expect_part(folded.warnings[0], "the lattice is folded at (cell ");
  options.no_folds = true;
  const RegistrationResult result = register_volumes(fixed, moving, options);
  EXPECT_EQ(result.folds.verdict, FoldCheck::Verdict::kProved);
  EXPECT_GT(result.least_jacobian, 0.0);
  EXPECT_LT(result.metric_end, 0.8 * result.metric_start);
  EXPECT_GT(result.history.back().barrier, 0.0);
}

TEST(Registration, StartsFromAnAffineMap) {
  const Phantom phantom({32, 30, 28}, 1.0);
  const Volume fixed = phantom.fixed();
  // The moving image elsewhere: its points are those of the phantom's, turned and moved.
  AffineMap elsewhere;
  elsewhere.linear = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
  elsewhere.offset = {300, 0, -40};
  const Volume original = phantom.moving();
  const Volume moving("moving image", original.counts(),
                      std::vector<float>(original.values(), original.values() + original.size()),
                      elsewhere);
  RegistrationOptions options = options_of(10);
  options.start = elsewhere;
  const RegistrationResult result = register_volumes(fixed, moving, options);
  Points back = result.deformed.points();
  const AffineMap inverse = elsewhere.inverse();
  for (Eigen::Index row = 0; row < back.rows(); ++row) {
    const auto p = inverse({back(row, 0), back(row, 1), back(row, 2)});
    back.row(row) = Eigen::RowVector3d(p[0], p[1], p[2]);
  }
  EXPECT_LT(phantom.error(Lattice(result.deformed.dims(), back), 0), 0.1);
  EXPECT_GT(result.most_jacobian, 0.0);
}

TEST(Registration, StartsFromALattice) {
  const Phantom phantom({32, 32, 32}, 1.0);
  RegistrationOptions options = options_of(8);
  const RegistrationResult first = register_volumes(phantom.fixed(), phantom.moving(), options);
  options.start_lattice = first.deformed;
  options.iterations = 2;
  const RegistrationResult more = register_volumes(phantom.fixed(), phantom.moving(), options);
  EXPECT_EQ(more.metric_start, first.metric_end);
  EXPECT_LE(more.metric_end, first.metric_end);
  EXPECT_EQ(more.deformed.dims(), first.deformed.dims());
}

TEST(Registration, OfTheSameImagesMovesNothing) {
  const Phantom phantom({32, 32, 32}, 1.0, scanner());
  const Volume same = phantom.moving();
  for (const MetricKind kind : {MetricKind::kMeanSquares, MetricKind::kCorrelation}) {
    const RegistrationResult result = register_volumes(same, same, options_of(8, kind));
    EXPECT_LT(result.metric_start, 1e-12);
    EXPECT_LE(result.metric_end, result.metric_start);
    EXPECT_EQ(numbers(result.deformed), numbers(result.rest)) << metric_name(kind);
    EXPECT_TRUE(result.warnings.empty());
    EXPECT_NEAR(result.folds.volume, same.to_point().determinant() * 32 * 32 * 32, 1e-6);
  }
}

/// Fine stripes agree as they are; a blob, which is all that coarse images have, is moved by half
/// of their period: coarse levels lead away from what is best.
TEST(Registration, IsNeverWorseThanTheStart) {
  const Index3 counts{48, 48, 1};
  const auto image = [&](const char* name, double centre) {
    std::vector<float> values;
    for (int n = 0; n < 48 * 48; ++n) {
      const double x = n % 48 - centre;
      const int row = n / 48;
      const double y = row - 24.0;
      values.push_back(static_cast<float>(40 * std::exp(-0.005 * (x * x + y * y)) +
                                          (n % 48 % 4 < 2 ? 30 : -30)));
    }
    return Volume(name, counts, values, {});
  };
  RegistrationOptions options = options_of(12);
  options.iterations = 4;
  const RegistrationResult result =
      register_volumes(image("fixed image", 23), image("moving image", 25), options);
  EXPECT_GT(result.history.size(), 6U);
  EXPECT_EQ(result.metric_end, result.metric_start);
  EXPECT_EQ(numbers(result.deformed), numbers(result.rest));
  ASSERT_EQ(result.warnings.size(), 1U);
  expect_part(result.warnings[0], "the objective did not get less, ");
  expect_part(result.warnings[0], ": the start is returned");
}

TEST(Registration, StopsWithTheBestSoFar) {
  const Phantom phantom({32, 32, 32}, 1.0);
  for (const int evaluations : {1, 6, 60}) {
    int calls = 0;
    const RegistrationResult result =
        register_volumes(phantom.fixed(), phantom.moving(), options_of(8),
                         [&](const RegistrationState&) { return ++calls < evaluations; });
    EXPECT_EQ(calls, evaluations);
    EXPECT_TRUE(result.stopped);
    EXPECT_EQ(result.deformed.dims(), (Index3{7, 7, 7}));
    EXPECT_LE(result.metric_end, result.metric_start);
    if (evaluations > 1) {
      EXPECT_LT(result.metric_end, result.metric_start);
    }
  }
}

/// A volume of 40 x 36 voxels with a margin that does not count, 8 voxels along x and 6 along y,
/// and has this value; without one, its own.
Volume with_margin(const Volume& clean, std::optional<float> value) {
  std::vector<float> values(clean.values(), clean.values() + clean.size());
  std::vector<std::uint8_t> mask(values.size(), 1);
  for (std::size_t n = 0; n < values.size(); ++n) {
    if (n % 40 >= 8 && n / 40 >= 6) continue;
    mask[n] = 0;
    values[n] = value.value_or(values[n]);
  }
  return {clean.name(), clean.counts(), std::move(values), {}, std::move(mask)};
}

TEST(Registration, MaskedVoxelsCountForNothing) {
  const Phantom phantom({40, 36, 1}, 1.5);
  RegistrationOptions options = options_of(10);
  const Volume fixed = with_margin(phantom.fixed(), 1e4F);
  const RegistrationResult result = register_volumes(fixed, phantom.moving(), options);
  EXPECT_LE(result.overlap_voxels, 32U * 30);
  EXPECT_LT(phantom.error(result.deformed, 9), 0.1);
}

/// Smoothed or sharp, not even between voxels.
TEST(Registration, ValuesOfMaskedVoxelsChangeNoBit) {
  const Phantom phantom({40, 36, 1}, 1.5);
  for (const bool smooth : {true, false}) {
    RegistrationOptions options = options_of(10);
    options.smooth = smooth;
    const auto registered = [&](std::optional<float> margin) {
      const Volume moving = with_margin(phantom.moving(), margin);
      return numbers(register_volumes(phantom.fixed(), moving, options).deformed);
    };
    EXPECT_EQ(registered(1e6F), registered(std::nullopt)) << smooth;
  }
}

/// The least part of the voxels that count at the beginning of a level that do at its steps.
double least_overlap(const RegistrationResult& result) {
  double least = 1.0;
  double start = 0.0;
  for (const RegistrationStep& step : result.history) {
    const double voxels = static_cast<double>(step.voxels);
    if (step.iteration == 0) start = voxels;
    least = std::min(least, voxels / start);
  }
  return least;
}

TEST(Registration, KeepsTheOverlapWanted) {
  const Phantom phantom({40, 36, 1}, 2.5);
  RegistrationOptions options = options_of(10);
  const double free = least_overlap(register_volumes(phantom.fixed(), phantom.moving(), options));
  EXPECT_LT(free, 0.99);
  EXPECT_GE(free, 0.5);
  options.overlap = 1.0;
  const RegistrationResult result = register_volumes(phantom.fixed(), phantom.moving(), options);
  EXPECT_EQ(least_overlap(result), 1.0);
  EXPECT_LT(result.metric_end, result.metric_start);
}

TEST(Registration, WatchEndsIt) {
  struct Interrupted {};
  const Phantom phantom({32, 32, 32}, 1.0);
  int looks = 0;
  const Watch watch([&] {
    if (++looks > 2) throw Interrupted();
  });
  RegistrationOptions options = options_of(4);
  options.tolerance = 0;
  options.iterations = 100000;
  EXPECT_THROW(register_volumes(phantom.fixed(), phantom.moving(), options), Interrupted);
}

}  // namespace
}  // namespace hwffd
