#include "measure.hpp"

#include <cmath>
#include <memory>

#include "hwffd/cores/evaluator_core_factory.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/numerics/largest_error.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/evaluator_bench.hpp"

namespace hwffd::organizations {
namespace {

constexpr std::size_t kRecorded = 8;  // vertices whose schedule is kept
constexpr std::size_t kWarmUp = 40;   // results before the interval is counted

double largest_error(const tb::EvaluatorStimulus& stimulus,
                     const std::vector<cores::EvaluatorCore::Result>& results,
                     const WordCodec& codec) {
  const Oracle oracle;
  double largest = 0;
  for (std::size_t v = 0; v < stimulus.vertices.size(); ++v) {
    const tb::EvaluatorVertex& vertex = stimulus.vertices[v];
    const tb::SupportWords& words = stimulus.supports[vertex.support];
    Support support;
    for (int i = 0; i < 192; ++i) {
      support.data()[i] = codec.decode_point(words.points[i]);
    }
    std::array<double, 3> local{};
    for (int a = 0; a < 3; ++a) local[a] = codec.decode_coordinate(vertex.local[a]);
    const Point exact = oracle.evaluate(support, local[0], local[1], local[2]);
    for (int c = 0; c < 3; ++c) {
      const double error = codec.decode_point(results[v].words[c]) - exact[c];
      raise_to(largest, std::ldexp(std::abs(error), -words.exponent));
    }
  }
  return largest;
}

/// Of those that give the Jacobian every vertex wants it.
void want_all(tb::EvaluatorStimulus& stimulus, const Configuration& row) {
  for (tb::EvaluatorVertex& vertex : stimulus.vertices) vertex.jacobian = gives_jacobian(row);
}

/// How results of vertices on seams, the last ones, differ between cells.
void compare_seams(const tb::SeamStimulus& seams,
                   const std::vector<cores::EvaluatorCore::Result>& results,
                   const Configuration& row, Measurement& measured) {
  const std::size_t offset = results.size() - seams.vertices.size();
  const std::size_t each = gives_jacobian(row) ? 4 : 1;
  const auto words = [&](std::size_t v, std::size_t r) {
    return r == 0 ? results[offset + v].words : results[offset + v].along[r - 1].words;
  };
  const auto differences = seams.differences(each, words);
  measured.seam_values = differences.values;
  measured.seam_differences = differences.count;
}

}  // namespace

VertexClocks vertex_clocks(const tb::ScheduleRecorder& schedule, std::size_t index) {
  const std::size_t vertices = schedule.results().size();
  const auto& polynomials = schedule.polynomials().starts;
  const std::size_t starts = polynomials.size() / vertices;
  const std::size_t sums = schedule.sums().size() / vertices;
  const std::uint64_t start = polynomials.at(starts * index);
  const std::uint64_t next = polynomials.at(starts * (index + 1));
  const std::uint64_t tree = schedule.sums().at(sums * (index + 1) - 1);
  const std::uint64_t result = schedule.results().at(index);
  const std::uint64_t end = next >= result ? result : tree;
  return {end - start, result - end};
}

Measurement measure(const Configuration& row, const Effort& effort) {
  const WordCodec codec(row.format);
  const std::unique_ptr<cores::EvaluatorCore> core = cores::make_evaluator_core(row, effort.seed);
  const std::unique_ptr<model::EvaluatorModel> model = model::make_evaluator_model(row);
  const AxisWords bspline = encode(watertight_bspline(codec), codec);
  tb::EvaluatorBench bench(*core, *model, {bspline, bspline, bspline});
  Measurement measured{0, 0, {}, 0, 0, {}, 0, 0, tb::ScheduleRecorder(*core)};

  auto random = tb::random_stimulus(codec, kRecorded, effort.seed);
  want_all(random, row);
  bench.run(random, tb::Throttle::always(), tb::Throttle::always(), &measured.schedule);
  if (!overlaps(row)) {
    measured.vertex = vertex_clocks(measured.schedule, kRecorded / 2);
  }

  random = tb::random_stimulus(codec, effort.vertices, effort.seed + 1);
  want_all(random, row);
  bench.run(random);
  measured.interval = tb::mean_interval(bench.result_clocks(), kRecorded + kWarmUp, lanes(row));
  const auto last = static_cast<std::ptrdiff_t>(effort.vertices);
  measured.max_error =
      largest_error(random, {bench.results().end() - last, bench.results().end()}, codec);

  auto seams = tb::seam_stimulus(codec, effort.seam_values, effort.seed + 2);
  want_all(seams, row);
  bench.run(seams);
  compare_seams(seams, bench.results(), row, measured);

  measured.checked = bench.checked();
  measured.mismatches = bench.mismatches();
  measured.first_mismatch = bench.first_mismatch();
  return measured;
}

}  // namespace hwffd::organizations
