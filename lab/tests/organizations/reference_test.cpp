// Eq. (1) in C++, which the simulations are timed against.
#include "reference.hpp"

#include <gtest/gtest.h>

#include <array>

#include "hwffd/oracle/oracle.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::organizations {
namespace {

// What the simulations are timed against does what they do.
TEST(Reference, IsEquationOne) {
  tb::Random random(1);
  const Oracle oracle;
  for (int v = 0; v < 1000; ++v) {
    std::array<double, 192> points{};
    for (double& coordinate : points) coordinate = 2 * random.unit() - 1;
    const std::array<double, 3> local{random.unit(), random.unit(), random.unit()};
    Support support;
    for (int i = 0; i < 192; ++i) support(i / 3, i % 3) = points[i];
    const Point exact = oracle.evaluate(support, local[0], local[1], local[2]);
    const std::array<double, 3> computed = reference_vertex(points, local);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(computed[c], exact[c], 1e-14);
  }
  EXPECT_GT(reference_vertices_per_s(1000, 1), 0);
}

}  // namespace
}  // namespace hwffd::organizations
