#include "hwffd/cores/lanes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "hwffd/model/organizations.hpp"
#include "hwffd/model/schedule.hpp"

namespace hwffd::cores {
namespace {

/// ffd_eval.vh, FFD_POLY_LATENCY.
int polynomial_latency(const Configuration& row) {
  const int step = row.fma_latency > 0 ? row.fma_latency : row.mul_latency + row.add_latency;
  const bool iterative = std::string(row.evaluator) == "iterative";
  const bool powers = std::string(row.evaluator) == "powers";
  const int file = !overlaps(row) || powers ? 0 : iterative ? 2 : 1;
  return file + 3 * (iterative && step % 3 == 0 ? step + 1 : step) + row.convert_latency;
}

std::string count_of(int count, const std::string& name) {
  return fmt::format("{} {}{}", count, name, count == 1 ? "" : "s");
}

/// Adds lanes for units that operations pass one after the other.
class Pipeline {
 public:
  Pipeline(const Schedule& schedule, std::vector<Entry> entries)
      : schedule_(schedule), entries_(std::move(entries)) {}

  void pass(std::vector<Lane>& lanes, const std::string& name, int latency) {
    Lane lane{name, {}};
    for (Entry& entry : entries_) {
      lane.spans.push_back({entry.clock, entry.clock + latency, entry.vertex});
      entry.clock += latency;
    }
    passed_ += latency;
    lanes.push_back(std::move(lane));
  }

  /// When each operation has passed all units so far.
  const std::vector<Entry>& arrivals() const { return entries_; }

  /// Throws unless operations arrive at these clocks, as far as all was looked at. Those have
  /// passed units for so many clocks since a probe showed them.
  void expect(const std::vector<std::uint64_t>& clocks, const char* row, int passed = 0) const {
    if (seen(clocks_of(entries_), passed) == seen(clocks, passed)) return;
    throw std::logic_error(fmt::format("{}: its probes do not fit its latencies", row));
  }
  void expect(const std::vector<Entry>& entries, const char* row) const {
    expect(clocks_of(entries), row);
  }
  void expect(const Pipeline& other, const char* row) const {
    expect(clocks_of(other.entries_), row, other.passed_);
  }

 private:
  static std::vector<std::uint64_t> clocks_of(const std::vector<Entry>& entries) {
    std::vector<std::uint64_t> clocks;
    clocks.reserve(entries.size());
    for (const Entry& entry : entries) clocks.push_back(entry.clock);
    return clocks;
  }

  /// Those of clocks of which both probes have seen all.
  std::vector<std::uint64_t> seen(std::vector<std::uint64_t> clocks, int passed) const {
    const std::uint64_t first =
        schedule_.begin + static_cast<std::uint64_t>(std::max(passed_, passed));
    const auto unseen = [&](std::uint64_t clock) {
      return clock < first || clock >= schedule_.end;
    };
    clocks.erase(std::remove_if(clocks.begin(), clocks.end(), unseen), clocks.end());
    return clocks;
  }

  const Schedule& schedule_;
  std::vector<Entry> entries_;
  int passed_ = 0;  // clocks
};

void add_summation(std::vector<Lane>& lanes, const Configuration& c, const Schedule& schedule) {
  const bool fused = c.fma_latency > 0;
  Pipeline pipeline(schedule, schedule.steps);
  pipeline.pass(lanes, "weight products B B", c.mul_latency);
  pipeline.pass(lanes, "weight products (BB) B", c.mul_latency);
  if (!fused || c.n > 1) {
    pipeline.pass(lanes, count_of(fused ? 3 * c.n / 2 : 3 * c.n, "product") + " (BBB) P",
                  c.mul_latency);
  }
  for (int level = c.n / 2; level >= 1; level /= 2) {
    const bool first = level == c.n / 2;
    pipeline.pass(lanes,
                  count_of(3 * level, fused && first ? "multiply-add" : "adder") + " of the tree",
                  fused && first ? c.fma_latency : c.add_latency);
  }
  pipeline.expect(schedule.sums, c.name);
  if (c.n < 64) {
    pipeline.pass(lanes, "3 accumulators", fused && c.n == 1 ? c.fma_latency : c.add_latency);
  }
}

bool is_affine(const Configuration& c) { return completes(organization_of(c).form); }

/// What an affine contraction does before it has its weights.
void add_differences(std::vector<Lane>& lanes, Pipeline& pipeline, const Configuration& c, int sums,
                     const std::string& axis, bool in_steps = false) {
  if (!is_affine(c)) return;
  pipeline.pass(lanes, count_of(in_steps ? sums : sums * 3, "difference") + " along " + axis,
                c.add_latency);
}

/// Four terms along one axis, of `sums` sums at once; in four steps a product each.
void add_contract(std::vector<Lane>& lanes, Pipeline& pipeline, const Configuration& c, int sums,
                  const std::string& axis, bool in_steps = false) {
  const bool fused = c.fma_latency > 0;
  const int products = in_steps ? 1 : is_affine(c) ? 3 : fused ? 2 : 4;
  pipeline.pass(lanes, count_of(sums * products, "product") + " along " + axis, c.mul_latency);
  pipeline.pass(
      lanes,
      count_of(in_steps ? sums : sums * 2, fused ? "multiply-add" : "adder") + " along " + axis,
      fused ? c.fma_latency : c.add_latency);
  pipeline.pass(lanes, count_of(sums, "adder") + " along " + axis, c.add_latency);
}

/// `factored` and `affine`: polynomials, of which those of t and s may be later than shown,
/// points, contractions. Of several lanes the first is shown.
void add_contraction(std::vector<Lane>& lanes, const Configuration& c, const Units& units,
                     const Schedule& schedule) {
  const int side_by_side = hwffd::lanes(c);
  const int turns = folds(c) % 3 == 0 ? 3 : 1;
  const int folds_of_turn = folds(c) / turns;
  const int components = 3 / turns;
  const int more = gives_jacobian(c) ? 1 : 0;  // sums along each axis, one after the other
  Pipeline polynomials(schedule, schedule.polynomials);
  if (folds(c) >= 3) polynomials.pass(lanes, "axis chosen", 1);
  polynomials.pass(lanes, count_of(units.evaluators / side_by_side, "polynomial evaluator"),
                   polynomial_latency(c));
  Pipeline points(schedule, schedule.steps);
  points.pass(lanes, count_of(c.n, "point") + " read", units.read_latency);
  add_differences(lanes, points, c, 16 * components / folds_of_turn, "u");
  points.expect(polynomials, c.name);
  add_contract(lanes, points, c, 16 * components / folds_of_turn * (1 + more), "u");
  points.pass(lanes, "narrowed", c.convert_latency);
  add_differences(lanes, points, c, 4 * components / folds_of_turn * (1 + more), "t");
  add_contract(lanes, points, c, 4 * components / folds_of_turn * (1 + 2 * more), "t");
  points.pass(lanes, "narrowed", c.convert_latency);
  if (folds(c) == 3 && c.n == 32) points.pass(lanes, "the half read first waits", 1);
  add_differences(lanes, points, c, components * (1 + 2 * more), "s", folds_of_turn == 4);
  add_contract(lanes, points, c, components * (1 + 3 * more), "s", folds_of_turn == 4);
  points.expect(schedule.sums, c.name);
}

/// `walk`: planes, four points a clock, and what vertices do with them along s.
void add_walk(std::vector<Lane>& lanes, const Configuration& c, const Schedule& schedule) {
  constexpr int kComponents = 3;
  Pipeline polynomials(schedule, schedule.polynomials);
  polynomials.pass(lanes, "axis chosen", 1);
  polynomials.pass(lanes, "3 polynomials of u and t", polynomial_latency(c));
  Pipeline points(schedule, schedule.steps);
  points.pass(lanes, count_of(c.n, "point") + " read", 2);
  add_differences(lanes, points, c, kComponents, "u");
  points.expect(polynomials, c.name);
  add_contract(lanes, points, c, kComponents, "u");
  points.pass(lanes, "narrowed", c.convert_latency);
  add_differences(lanes, points, c, kComponents, "t", true);
  add_contract(lanes, points, c, kComponents, "t", true);
  const auto before = static_cast<std::uint64_t>(c.mul_latency + 2 * c.add_latency);
  std::vector<Entry> weights, held;
  for (const Entry& result : schedule.results) {
    const std::uint64_t multiplied = result.clock - before;
    weights.push_back(
        {multiplied - static_cast<std::uint64_t>(polynomial_latency(c)), result.vertex});
    held.push_back({multiplied - static_cast<std::uint64_t>(c.add_latency), result.vertex});
  }
  Pipeline(schedule, weights).pass(lanes, "3 polynomials of s", polynomial_latency(c));
  Pipeline vertices(schedule, held);
  add_differences(lanes, vertices, c, kComponents, "s");
  add_contract(lanes, vertices, c, kComponents, "s");
}

/// In sequence: a point a clock. Products along t and s take the clocks of the bases and are not
/// shown; the last of them ends a vertex.
void add_sequence(std::vector<Lane>& lanes, const Configuration& c, const Schedule& schedule) {
  constexpr std::size_t kPoints = 64;
  constexpr std::size_t kFills = 27;  // clocks of the polynomials' starts
  std::vector<Entry> starts;
  for (std::size_t i = 0; i < schedule.polynomials.size(); ++i) {
    const std::size_t step = i % kPoints;
    if (step < kFills && step % 3 == 0) starts.push_back(schedule.polynomials[i]);
  }
  Pipeline polynomials(schedule, starts);
  polynomials.pass(lanes, "1 polynomial evaluator", polynomial_latency(c));
  Pipeline points(schedule, schedule.steps);
  points.pass(lanes, "a point read", 2);
  points.pass(lanes, "3 differences", c.add_latency);
  points.pass(lanes, "3 products", c.mul_latency);
  points.pass(lanes, "3 adders", c.add_latency);
  // ffd_eval_serial: groups of four from u to t, two rounds of 16 from t to s, three along s.
  const int groups = (c.mul_latency + c.convert_latency + 8) / 4;
  std::vector<std::uint64_t> sums;
  for (std::size_t i = 0; i < points.arrivals().size(); i += kPoints) {
    sums.push_back(points.arrivals()[i].clock + 4 * groups + 2 * 16 + 3 * 16);
  }
  if (sums != schedule.sums) {
    throw std::logic_error(fmt::format("{}: its probes do not fit its latencies", c.name));
  }
}

}  // namespace

std::vector<Lane> lanes_of(const Configuration& row, const Units& units, const Schedule& schedule) {
  std::vector<Lane> lanes;
  if (contracts(row)) {
    if (row.n == 1) {
      add_sequence(lanes, row, schedule);
    } else if (walks(row)) {
      add_walk(lanes, row, schedule);
    } else {
      add_contraction(lanes, row, units, schedule);
    }
    return lanes;
  }
  Pipeline polynomials(schedule, schedule.polynomials);
  polynomials.pass(lanes, count_of(units.evaluators, "polynomial evaluator"),
                   polynomial_latency(row));
  if (schedule.combinations) {
    Pipeline combinations(schedule, *schedule.combinations);
    combinations.pass(lanes, "combination generator", 1);
    combinations.expect(schedule.steps, row.name);
  } else {
    polynomials.expect(schedule.steps, row.name);
  }
  add_summation(lanes, row, schedule);
  return lanes;
}

}  // namespace hwffd::cores
