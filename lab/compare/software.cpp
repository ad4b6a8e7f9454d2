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
#include "hwffd/model/evaluator.hpp"
#include "hwffd/stream/blending.hpp"

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

/// The reference, where no row is named.
std::unique_ptr<Device> device_of(const std::string& row) {
  DeviceChoice choice;
  choice.device = row.empty() ? "reference" : "model";
  if (!row.empty()) choice.org = row;
  return make_device(choice);
}

double bound_of(const std::string& row) {
  return error_bound(row.empty() ? "fx32" : find_configuration(row).format);
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
  const std::unique_ptr<Device> device = device_of(name);
  Points positions;
  SoftwareRow row = timed("device " + device->name(), scene, sorted, seconds,
                          [&] { positions = device->evaluate(scene.lattice, scene.vertices); });
  row.error = largest_error(scene, positions);
  row.bound = bound_of(name);
  row.bytes_per_vertex = sizeof(Embedded) + 3 * sizeof(double);
  return row;
}

SoftwareRow walker(const std::string& name, const GridScene& grid, double seconds) {
  const Scene& scene = grid.scene;
  const Configuration& configuration = find_configuration(name);
  const WordCodec codec(configuration.format);
  const std::unique_ptr<model::EvaluatorModel> model = model::make_evaluator_model(configuration);
  const AxisWords axis = encode(watertight_bspline(codec), codec);
  for (int a = 0; a < 3; ++a) {
    for (int f = 0; f < 4; ++f) model->load(0, a, f, axis.degree, axis.shift, axis.word[f]);
  }
  model::ResidentPoints points;
  points.dims = scene.lattice.dims();
  for (const auto& point : scene.lattice.points().rowwise()) {
    points.points.push_back({codec.point(point[0]), codec.point(point[1]), codec.point(point[2])});
  }
  // As many rows at once as stay in the caches, as a device does.
  constexpr std::size_t kVerticesAtOnce = 8192;
  const std::size_t of_row = grid.grid.count[0];
  const std::size_t rows = scene.vertices.size() / of_row;
  const std::size_t at_once = std::max<std::size_t>(1, kVerticesAtOnce / of_row);
  std::vector<model::ResultWords> words;
  Points positions(static_cast<Eigen::Index>(scene.vertices.size()), 3);
  const auto run = [&](const auto& take) {
    const auto walker =
        model->walker(0, points, axis_places(grid.grid, scene.lattice.dims(), codec));
    for (std::size_t first = 0; first < rows; first += at_once) {
      walker->evaluate(first, std::min(rows, first + at_once), words);
      take(first * of_row);
    }
  };
  SoftwareRow row = timed("GridWalker of model " + name, scene, true, seconds,
                          [&] { run([](std::size_t /*first*/) {}); });
  run([&](std::size_t first) {
    for (std::size_t v = 0; v < words.size(); ++v) {
      for (Eigen::Index c = 0; c < 3; ++c) {
        positions(static_cast<Eigen::Index>(first + v), c) =
            codec.decode_point(words[v].words[static_cast<std::size_t>(c)]);
      }
    }
  });
  row.error = largest_error(scene, positions);
  row.bound = bound_of(name);
  row.bytes_per_vertex = sizeof(model::ResultWords);
  return row;
}

SoftwareRow grid_device(const std::string& name, const GridScene& grid, double seconds) {
  const std::unique_ptr<Device> device = device_of(name);
  Points positions;
  SoftwareRow row = timed("device " + device->name() + ", a grid", grid.scene, true, seconds, [&] {
    positions = device->evaluate_grid(grid.scene.lattice, grid.grid);
  });
  row.error = largest_error(grid.scene, positions);
  row.bound = bound_of(name);
  row.bytes_per_vertex = 3 * sizeof(double);
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
