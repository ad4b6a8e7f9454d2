// Prints the iterates of minimize() of a function: its name, variables and how many numbers to keep
// are arguments.
#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "hwffd/registration/l_bfgs.hpp"

namespace {

using Vector = std::vector<double>;

double quadratic(const Vector& x, Vector& gradient) {
  double value = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double n = static_cast<double>(i + 1);
    const double off = x[i] - n;
    gradient[i] = n * off;
    value += n * off * off / 2;
    if (i == 0) continue;
    const double coupled = x[i] - x[i - 1];
    gradient[i] += coupled;
    gradient[i - 1] -= coupled;
    value += coupled * coupled / 2;
  }
  return value;
}

double rosenbrock(const Vector& x, Vector& gradient) {
  double value = 0.0;
  gradient.assign(x.size(), 0.0);
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double a = x[i + 1] - x[i] * x[i];
    gradient[i] += -400 * x[i] * a - 2 * (1 - x[i]);
    gradient[i + 1] += 200 * a;
    value += 100 * a * a + (1 - x[i]) * (1 - x[i]);
  }
  return value;
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) return 2;
  const std::string name = words[1];
  Vector x(static_cast<std::size_t>(std::atoi(words[2])));
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = i % 2 == 0 ? -1.2 : 1.0;
  hwffd::LbfgsOptions options;
  options.memory = std::atoi(words[3]);
  options.tolerance = 0.0;
  options.gradient = 1e-8;
  options.iterations = 1000;
  options.evaluations = 10000;
  hwffd::minimize(name == "quadratic" ? quadratic : rosenbrock, x, options,
                  [](const hwffd::LbfgsState& state) {
                    fmt::print("{}", state.evaluations);
                    for (const double x_i : *state.x) fmt::print(" {:.17g}", x_i);
                    fmt::print("\n");
                    return true;
                  });
}
