#include "reference.hpp"

#include <chrono>
#include <cmath>
#include <vector>

#include "hwffd/tb/random.hpp"

namespace hwffd::organizations {
namespace {

std::array<double, 4> weights(double x) {
  const double y = 1 - x;
  return {y * y * y / 6, (4 - 6 * x * x + 3 * x * x * x) / 6, (4 - 6 * y * y + 3 * y * y * y) / 6,
          x * x * x / 6};
}

}  // namespace

std::array<double, 3> reference_vertex(const std::array<double, 192>& points,
                                       const std::array<double, 3>& local) {
  const std::array<double, 4> s = weights(local[0]);
  const std::array<double, 4> t = weights(local[1]);
  const std::array<double, 4> u = weights(local[2]);
  std::array<double, 3> sum{};
  const double* point = points.data();
  for (int l = 0; l < 4; ++l) {
    for (int m = 0; m < 4; ++m) {
      for (int n = 0; n < 4; ++n, point += 3) {
        const double weight = s[l] * t[m] * u[n];
        for (int c = 0; c < 3; ++c) sum[c] += weight * point[c];
      }
    }
  }
  return sum;
}

double reference_vertices_per_s(std::size_t vertices, std::uint64_t seed) {
  constexpr std::size_t kSupports = 256;
  tb::Random random(seed);
  std::vector<std::array<double, 192>> supports(kSupports);
  for (auto& support : supports) {
    for (double& coordinate : support) coordinate = 2 * random.unit() - 1;
  }
  std::vector<std::array<double, 3>> local(vertices);
  for (auto& l : local) l = {random.unit(), random.unit(), random.unit()};

  const auto start = std::chrono::steady_clock::now();
  double sum = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    const std::array<double, 3> q = reference_vertex(supports[v % kSupports], local[v]);
    sum += q[0] + q[1] + q[2];
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  // The sum is used, so that no compiler leaves the loop out.
  return std::isfinite(sum) ? static_cast<double>(vertices) / seconds : 0;
}

}  // namespace hwffd::organizations
