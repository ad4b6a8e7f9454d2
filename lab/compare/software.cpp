#include "compare/software.hpp"

#include <fmt/format.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>

#include "hwffd/device/device.hpp"
#include "hwffd/lattice/lattice_evaluator.hpp"
#include "hwffd/model/configuration.hpp"

namespace hwffd::compare {
namespace {

constexpr int kFewestRuns = 5;
constexpr double kCallsShare = 4;  // of the time of all vertices, for calls with one

/// The processor's time: what other programs of the machine take away is not counted, and what
/// other threads of this one took would be.
double seconds_of(const std::function<void()>& run) {
  const std::clock_t start = std::clock();
  run();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Of the fastest of several runs: other programs only ever add time, by what they do to caches.
double best_seconds(const std::function<void()>& run, double enough) {
  double best = std::numeric_limits<double>::infinity();
  double all = 0;
  for (int runs = 0; runs < kFewestRuns || all < enough; ++runs) {
    const double seconds = seconds_of(run);
    all += seconds;
    best = std::min(best, seconds);
  }
  return best;
}

template <class Real>
VertexArrays<Real> arrays_of(const Scene& scene, const LatticeEvaluator<Real>& evaluator) {
  VertexArrays<Real> arrays;
  for (const Embedded& vertex : scene.vertices) {
    arrays.origins.push_back(evaluator.origin(vertex.cell));
    for (std::size_t a = 0; a < 3; ++a) {
      arrays.local[a].push_back(static_cast<Real>(vertex.local[static_cast<Eigen::Index>(a)]));
    }
  }
  for (auto& component : arrays.position) component.resize(scene.vertices.size());
  return arrays;
}

template <class Real>
Points positions_of(const VertexArrays<Real>& arrays) {
  Points positions(static_cast<Eigen::Index>(arrays.origins.size()), 3);
  for (Eigen::Index row = 0; row < positions.rows(); ++row) {
    for (std::size_t c = 0; c < 3; ++c) {
      positions(row, static_cast<Eigen::Index>(c)) =
          arrays.position[c][static_cast<std::size_t>(row)];
    }
  }
  return positions;
}

/// What a call takes that is given a vertex by itself, in nanoseconds: calls with some vertices of
/// a scene, one after the other.
double latency_ns(const Scene& scene, double enough,
                  const std::function<void(const Embedded&)>& call) {
  constexpr std::size_t kCalls = 4096;
  const Scene some = first_of(scene, kCalls);
  const double seconds = best_seconds(
      [&] { std::for_each(some.vertices.begin(), some.vertices.end(), call); }, enough);
  return 1e9 * seconds / static_cast<double>(some.vertices.size());
}

/// A row of how long a run takes that leaves its positions behind.
SoftwareRow timed(const std::string& what, const Scene& scene, bool sorted, double seconds,
                  const std::function<void()>& run) {
  SoftwareRow row;
  row.what = what;
  row.sorted = sorted;
  row.vertices_per_s = static_cast<double>(scene.vertices.size()) / best_seconds(run, seconds);
  return row;
}

}  // namespace

template <class Real>
SoftwareRow evaluator(const Scene& scene, bool sorted, double seconds) {
  constexpr double kRoundings = 64;  // as of the evaluator's own test
  constexpr bool kIsFloat = sizeof(Real) == sizeof(float);
  const Oracle::Coefficients bspline = Oracle::uniform_bspline();
  const LatticeEvaluator<Real> evaluator(scene.lattice, {bspline, bspline, bspline});
  VertexArrays<Real> arrays = arrays_of(scene, evaluator);
  SoftwareRow row = timed(fmt::format("LatticeEvaluator<{}>", kIsFloat ? "float" : "double"), scene,
                          sorted, seconds, [&] { evaluator.evaluate(arrays); });
  row.error = largest_error(scene, positions_of(arrays));
  row.bound = kRoundings * std::numeric_limits<Real>::epsilon();
  row.bytes_per_vertex = sizeof(std::uint32_t) + 6 * sizeof(Real);
  VertexArrays<Real> single = arrays_of(first_of(scene, 1), evaluator);
  row.latency_ns = latency_ns(scene, seconds / kCallsShare, [&](const Embedded& vertex) {
    single.origins[0] = evaluator.origin(vertex.cell);
    for (std::size_t a = 0; a < 3; ++a) {
      single.local[a][0] = static_cast<Real>(vertex.local[static_cast<Eigen::Index>(a)]);
    }
    evaluator.evaluate(single);
  });
  return row;
}

template SoftwareRow evaluator<float>(const Scene& scene, bool sorted, double seconds);
template SoftwareRow evaluator<double>(const Scene& scene, bool sorted, double seconds);

SoftwareRow device(const std::string& name, const Scene& scene, bool sorted, double seconds) {
  DeviceChoice choice;
  choice.device = name.empty() ? "reference" : "model";
  if (!name.empty()) choice.org = name;
  const std::unique_ptr<Device> device = make_device(choice);
  Points positions;
  SoftwareRow row = timed("device " + device->name(), scene, sorted, seconds,
                          [&] { positions = device->evaluate(scene.lattice, scene.vertices); });
  row.error = largest_error(scene, positions);
  row.bound = name.empty() ? error_bound("fx32") : error_bound(find_configuration(name).format);
  row.bytes_per_vertex = sizeof(Embedded) + 3 * sizeof(double);
  return row;
}

std::string vector_units() { return hwy::TargetName(hwy::SupportedAndGeneratedTargets().front()); }

double error_bound(const std::string& format) {
  constexpr double kUnits = 16;       // of the last place
  constexpr double kBinary32 = 1e-6;  // of control points below 1
  if (format.rfind("fx", 0) != 0) return kBinary32;
  return kUnits * std::ldexp(1.0, 1 - std::stoi(format.substr(2)));
}

}  // namespace hwffd::compare
