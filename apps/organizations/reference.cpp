#include "reference.hpp"

#include <chrono>
#include <vector>

#include "hwffd/oracle/oracle.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::organizations {

double reference_vertices_per_s(std::size_t vertices, std::uint64_t seed) {
  constexpr std::size_t kSupports = 256;
  tb::Random random(seed);
  std::vector<Support> supports(kSupports);
  for (Support& support : supports) {
    for (int i = 0; i < support.size(); ++i) support.data()[i] = 2 * random.unit() - 1;
  }
  std::vector<Eigen::Vector3d> local(vertices);
  for (Eigen::Vector3d& l : local) l = {random.unit(), random.unit(), random.unit()};
  const Oracle oracle;

  const auto start = std::chrono::steady_clock::now();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t v = 0; v < vertices; ++v) {
    sum += oracle.evaluate(supports[v % kSupports], local[v][0], local[v][1], local[v][2]);
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  // The sum is used, so that no compiler leaves the loop out.
  return sum.allFinite() ? static_cast<double>(vertices) / seconds : 0;
}

}  // namespace hwffd::organizations
