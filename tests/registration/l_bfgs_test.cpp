#include "hwffd/registration/l_bfgs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "errors.hpp"

namespace hwffd {
namespace {

using Vector = std::vector<double>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// sum of (i + 1) (x_i - i)^2
double quadratic(const Vector& x, Vector& gradient) {
  double value = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double n = static_cast<double>(i);
    gradient[i] = 2 * (n + 1) * (x[i] - n);
    value += (n + 1) * (x[i] - n) * (x[i] - n);
  }
  return value;
}

double rosenbrock(const Vector& x, Vector& gradient) {
  const double a = x[1] - x[0] * x[0];
  gradient = {-400 * x[0] * a - 2 * (1 - x[0]), 200 * a};
  return 100 * a * a + (1 - x[0]) * (1 - x[0]);
}

LbfgsOptions exact() {
  LbfgsOptions options;
  options.tolerance = 0.0;
  options.gradient = 1e-9;
  return options;
}

TEST(Lbfgs, FindsMinima) {
  const LbfgsResult of_quadratic = minimize(quadratic, Vector(30), exact());
  EXPECT_EQ(of_quadratic.end, LbfgsEnd::kConverged);
  for (std::size_t i = 0; i < 30; ++i) {
    EXPECT_NEAR(of_quadratic.x[i], static_cast<double>(i), 1e-9);
  }
  const LbfgsResult of_rosenbrock = minimize(rosenbrock, {-1.2, 1}, exact());
  EXPECT_EQ(of_rosenbrock.end, LbfgsEnd::kConverged);
  EXPECT_NEAR(of_rosenbrock.x[0], 1.0, 1e-8);
  EXPECT_NEAR(of_rosenbrock.x[1], 1.0, 1e-8);
  EXPECT_LE(of_rosenbrock.evaluations, 60);
}

/// Sufficient decrease and curvature (strong Wolfe), at each step.
TEST(Lbfgs, StepsHoldTheWolfeConditions) {
  Vector last{-1.2, 1};
  Vector gradient(2);
  double value = rosenbrock(last, gradient);
  int steps = 0;
  minimize(rosenbrock, last, exact(), [&](const LbfgsState& state) {
    Vector after(2);
    EXPECT_EQ(rosenbrock(*state.x, after), state.value);
    double slope = 0.0;
    double slope_after = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      slope += gradient[i] * ((*state.x)[i] - last[i]);
      slope_after += after[i] * ((*state.x)[i] - last[i]);
    }
    EXPECT_LE(state.value, value + 1e-3 * slope + 1e-15);
    EXPECT_LE(std::abs(slope_after), -0.9 * slope + 1e-15);
    EXPECT_EQ(state.iteration, ++steps);
    last = *state.x;
    gradient = after;
    value = state.value;
    return true;
  });
  EXPECT_GT(steps, 20);
}

TEST(Lbfgs, FirstStepIsAsLongAsTold) {
  LbfgsOptions options = exact();
  options.first_step = 0.125;
  Vector first;
  minimize(
      [&](const Vector& x, Vector& gradient) {
        if (first.empty() && x != Vector(3)) first = x;
        return quadratic(x, gradient);
      },
      Vector(3), options);
  EXPECT_DOUBLE_EQ(*std::max_element(first.begin(), first.end()), 0.125);
}

/// A power of two more in x changes no bit of what the minimum is found by.
TEST(Lbfgs, IteratesAreTheSameInAnyUnit) {
  const auto in_unit = [](double unit) {
    LbfgsOptions options = exact();
    options.gradient /= unit;
    options.first_step = 0.125 * unit;
    LbfgsResult result = minimize(
        [&](Vector x, Vector& gradient) {
          for (double& number : x) number /= unit;
          const double value = quadratic(x, gradient);
          for (double& slope : gradient) slope /= unit;
          return value;
        },
        Vector(30), options);
    for (double& number : result.x) number /= unit;
    return result;
  };
  const LbfgsResult one = in_unit(1);
  EXPECT_EQ(one.end, LbfgsEnd::kConverged);
  for (const double unit : {0x1p-40, 0x1p10, 0x1p40}) {
    const LbfgsResult other = in_unit(unit);
    EXPECT_EQ(other.x, one.x) << unit;
    EXPECT_EQ(other.evaluations, one.evaluations) << unit;
  }
}

TEST(Lbfgs, StaysInBounds) {
  // The minimum of -x in x < 2 is at its end.
  int outside = 0;
  const LbfgsResult result = minimize(
      [&](const Vector& x, Vector& gradient) {
        gradient = {-1};
        if (x[0] < 2) return -x[0];
        ++outside;
        return outside % 2 == 0 ? kInfinity : std::nan("");
      },
      {0}, exact());
  EXPECT_LT(result.x[0], 2.0);
  EXPECT_GT(result.x[0], 1.99);
  EXPECT_GT(outside, 0);
}

TEST(Lbfgs, TakesNoStepThatIsNotAccepted) {
  int refused = 0;
  const LbfgsResult result = minimize(quadratic, {-5, -5}, exact(), {}, [&](const Vector& x) {
    const bool allowed = x[1] < -1;
    refused += allowed ? 0 : 1;
    return allowed;
  });
  EXPECT_LT(result.x[1], -1.0);
  EXPECT_GT(refused, 0);
  Vector gradient(2);
  EXPECT_LT(result.value, quadratic({-5, -5}, gradient));
  EXPECT_EQ(result.value, quadratic(result.x, gradient));
}

TEST(Lbfgs, Ends) {
  LbfgsOptions options = exact();
  options.iterations = 3;
  EXPECT_EQ(minimize(rosenbrock, {-1.2, 1}, options).end, LbfgsEnd::kIterations);
  EXPECT_EQ(minimize(rosenbrock, {-1.2, 1}, options).iterations, 3);
  options.iterations = 100;
  options.evaluations = 7;
  EXPECT_EQ(minimize(rosenbrock, {-1.2, 1}, options).evaluations, 7);
  EXPECT_EQ(minimize(rosenbrock, {1, 1}, exact()).iterations, 0);
  EXPECT_EQ(minimize(rosenbrock, {1, 1}, exact()).end, LbfgsEnd::kConverged);
  const LbfgsResult stopped =
      minimize(rosenbrock, {-1.2, 1}, exact(), [](const LbfgsState& s) { return s.iteration < 5; });
  EXPECT_EQ(stopped.end, LbfgsEnd::kStopped);
  EXPECT_EQ(stopped.iterations, 5);
  // The gradient lies.
  const LbfgsResult uphill = minimize(
      [](const Vector& x, Vector& gradient) {
        gradient = {-1};
        return std::abs(x[0]);
      },
      {0}, exact());
  EXPECT_EQ(uphill.end, LbfgsEnd::kLineSearch);
  EXPECT_EQ(uphill.x, Vector{0});
  LbfgsOptions window = exact();
  window.tolerance = 0.5;
  window.window = 4;
  const LbfgsResult slow = minimize(
      [](const Vector& x, Vector& gradient) {
        gradient = {4 * x[0] * x[0] * x[0]};
        return std::pow(x[0], 4) + 1;
      },
      {1.7}, window);
  EXPECT_EQ(slow.end, LbfgsEnd::kConverged);
  EXPECT_GE(slow.iterations, 4);
  EXPECT_ERROR(minimize([](const Vector&, Vector&) { return std::nan(""); }, {1}),
               "minimize: the value at the start is not finite; start elsewhere");
}

}  // namespace
}  // namespace hwffd
