#include "simulation_speed.hpp"

#include <memory>

#include "hwffd/cores/evaluator_core_factory.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/evaluator_bench.hpp"

namespace hwffd::organizations {
namespace {

constexpr std::size_t kFewest = 250;  // vertices
constexpr double kEnough = 0.25;      // seconds

}  // namespace

double simulated_vertices_per_s(const Configuration& row, std::uint64_t seed) {
  const WordCodec codec(row.format);
  const std::unique_ptr<cores::EvaluatorCore> core = cores::make_evaluator_core(row, seed);
  const std::unique_ptr<model::EvaluatorModel> model = model::make_evaluator_model(row);
  const AxisWords bspline = encode(watertight_bspline(codec), codec);
  tb::EvaluatorBench bench(*core, *model, {bspline, bspline, bspline});
  for (std::size_t vertices = kFewest;; vertices *= 2) {
    const double before = bench.simulation_seconds();
    bench.run(tb::random_stimulus(codec, vertices, seed, keeps_cell(row) ? vertices : 1));
    const double seconds = bench.simulation_seconds() - before;
    if (seconds >= kEnough) return static_cast<double>(vertices) / seconds;
  }
}

}  // namespace hwffd::organizations
