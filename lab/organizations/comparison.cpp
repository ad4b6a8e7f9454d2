#include "comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>

#include "hwffd/cores/evaluator_core_factory.hpp"
#include "hwffd/error.hpp"
#include "hwffd/model/organizations.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/evaluator_bench.hpp"
#include "reference.hpp"

namespace hwffd::organizations {
namespace {

constexpr std::size_t kFewest = 250;  // vertices
constexpr double kEnough = 0.25;      // seconds

/// Vertices a second of a row's simulated RTL at its read port, on the calling thread. Timed alone
/// only if nothing else runs: processors share caches and their clock.
/// @throws std::invalid_argument where this build does not have the row
double simulated_vertices_per_s(const Configuration& row, std::uint64_t seed) {
  const WordCodec codec(row.format);
  const std::unique_ptr<cores::EvaluatorCore> core = cores::make_evaluator_core(row, seed);
  const std::unique_ptr<model::EvaluatorModel> model = model::make_evaluator_model(row);
  const AxisWords bspline = encode(watertight_bspline(codec), codec);
  tb::EvaluatorBench bench(*core, *model, {bspline, bspline, bspline});
  for (std::size_t vertices = kFewest;; vertices *= 2) {
    const double before = bench.simulation_seconds();
    bench.run(tb::random_stimulus(codec, vertices, seed));
    const double seconds = bench.simulation_seconds() - before;
    if (seconds >= kEnough) return static_cast<double>(vertices) / seconds;
  }
}

bool is_same(const Configuration& a, const Configuration& b) {
  return std::string(a.org) == b.org && a.n == b.n && std::string(a.format) == b.format &&
         (a.fma_latency > 0) == (b.fma_latency > 0);
}

/// Rough: what a vertex costs the simulator.
double cost(const Configuration& row) {
  const double units = row.n + 3;
  return units * expected_interval(row) * (std::string(row.format) == "fp32" ? 5 : 1);
}

/// What of the effort a row gets: the rows of the paper's schedule and the iterative ones have the
/// same bits as their partners and take ten times as long, so they get a tenth of the seams.
Effort share_of(const Effort& effort, const Configuration& row) {
  constexpr double kSlow = 100;  // clocks a vertex
  Effort share = effort;
  if (!overlaps(row) || expected_interval(row) > kSlow) {
    share.vertices = std::min<std::size_t>(effort.vertices, 1241);
    share.seam_values = std::max<std::size_t>(effort.seam_values / 10, 1);
  }
  return share;
}

}  // namespace

Comparison::Comparison(std::vector<Row> rows, double reference_vertices_per_s)
    : rows_(std::move(rows)), reference_vertices_per_s_(reference_vertices_per_s) {}

const Row* Comparison::partner(const Row& row, const std::string& schedule) const {
  for (const Row& other : rows_) {
    if (other.configuration->schedule == schedule &&
        is_same(*row.configuration, *other.configuration)) {
      return &other;
    }
  }
  return nullptr;
}

std::optional<double> Comparison::formula(const Row& row) const {
  return hwffd::paper_clocks(*row.configuration);
}

std::optional<VertexClocks> Comparison::paper_clocks(const Row& row) const {
  const Row* paper = partner(row, "paper");
  if (paper == nullptr) return std::nullopt;
  return paper->measured.vertex;
}

std::optional<bool> Comparison::equal(const Row& row) const {
  const Row* paper = partner(row, "paper");
  if (paper == nullptr) return std::nullopt;
  const double clocks = static_cast<double>(paper->measured.vertex.clocks);
  return clocks == formula(row) && paper->measured.interval == clocks;
}

const Row* Comparison::overlapped(const Row& row) const {
  return overlaps(*row.configuration) ? &row : partner(row, "overlapped");
}

std::optional<double> Comparison::overlapped_interval(const Row& row) const {
  const Row* match = overlapped(row);
  if (match == nullptr) return std::nullopt;
  return match->measured.interval;
}

std::optional<double> Comparison::overlapped_formula(const Row& row) const {
  const Row* match = overlapped(row);
  if (match == nullptr) return std::nullopt;
  return hwffd::overlapped_interval(*match->configuration);
}

std::optional<bool> Comparison::overlapped_equal(const Row& row) const {
  if (overlapped(row) == nullptr) return std::nullopt;
  return overlapped_interval(row) == overlapped_formula(row);
}

Comparison compare(const std::vector<const Configuration*>& rows,
                   const std::map<std::string, OperatorCount>& operators, const Effort& effort,
                   const Progress& progress) {
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cost(*rows[a]) > cost(*rows[b]); });
  std::vector<std::optional<Row>> measured(rows.size());
  on_threads(
      rows.size(),
      [&](std::size_t i) {
        const Configuration& row = *rows[order[i]];
        const auto count = operators.find(row.name);
        if (count == operators.end()) {
          throw Error(fmt::format(
              "{}: its operators are not counted: run python3 -m tools.synth.operators", row.name));
        }
        measured[order[i]] = Row{&row, measure(row, share_of(effort, row)), count->second};
      },
      [&](std::size_t done) { progress(done, rows.size()); });
  std::vector<Row> all;
  for (std::optional<Row>& row : measured) {
    row->vertices_per_s = simulated_vertices_per_s(*row->configuration, effort.seed);
    all.push_back(std::move(*row));
  }
  constexpr std::size_t kReferenceVertices = 500'000;
  return Comparison(std::move(all), reference_vertices_per_s(kReferenceVertices, effort.seed));
}

}  // namespace hwffd::organizations
