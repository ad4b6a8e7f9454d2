#include "agreement.hpp"

#include <algorithm>
#include <memory>

#include "hwffd/cores/evaluator_core_factory.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/evaluator_bench.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::bfp {
namespace {

/// Random vertices; one support in eight has a point that is no number.
tb::EvaluatorStimulus draw(const WordCodec& codec, std::size_t vertices, std::uint64_t seed) {
  tb::EvaluatorStimulus stimulus = tb::random_stimulus(codec, vertices, seed);
  tb::Random random(seed);
  for (tb::SupportWords& support : stimulus.supports) {
    if (!random.chance(0.125)) continue;
    support.points[random.below(192)] = random.pick({0x7F800000U, 0xFF800000U, 0x7FC00000U});
  }
  return stimulus;
}

bool same(const cores::EvaluatorCore::Result& a, const cores::EvaluatorCore::Result& b) {
  return a.words == b.words && a.saturated == b.saturated && a.nan == b.nan;
}

/// What a row gave, and how much of it the model did not expect.
struct Run {
  std::vector<cores::EvaluatorCore::Result> results;
  std::uint64_t mismatches = 0;
};

Run run(const Configuration& row, std::size_t vertices, std::uint64_t seed) {
  const WordCodec codec(row.format);
  const std::unique_ptr<cores::EvaluatorCore> core = cores::make_evaluator_core(row, seed);
  const std::unique_ptr<model::EvaluatorModel> model = model::make_evaluator_model(row);
  const AxisWords bspline = encode(watertight_bspline(codec), codec);
  tb::EvaluatorBench bench(*core, *model, {bspline, bspline, bspline});
  bench.run(draw(codec, vertices, seed));
  return {bench.results(), bench.mismatches()};
}

}  // namespace

std::string form_of(const Configuration& row) { return contracts(row) ? "factored" : "product"; }

std::vector<Agreement> compare(const std::vector<const Configuration*>& rows, std::size_t vertices,
                               std::uint64_t seed,
                               const std::function<void(std::size_t, std::size_t)>& progress) {
  std::vector<Run> runs(rows.size());
  on_threads(
      rows.size(), [&](std::size_t r) { runs[r] = run(*rows[r], vertices, seed); },
      [&](std::size_t done) { progress(done, rows.size()); });
  std::vector<Agreement> agreements;
  for (const char* form : {"product", "factored"}) {
    Agreement agreement{form, {}, vertices, 0, 0};
    const Run* first = nullptr;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (form_of(*rows[r]) != form) continue;
      if (first == nullptr) first = &runs[r];
      agreement.rows.emplace_back(rows[r]->name);
      agreement.mismatches += runs[r].mismatches;
      for (std::size_t v = 0; v < vertices; ++v) {
        agreement.disagreements += same(runs[r].results[v], first->results[v]) ? 0 : 1;
      }
    }
    if (!agreement.rows.empty()) agreements.push_back(agreement);
  }
  return agreements;
}

}  // namespace hwffd::bfp
