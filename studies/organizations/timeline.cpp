#include "timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "hwffd/model/organizations.hpp"
#include "hwffd/model/schedule.hpp"

namespace hwffd::organizations {
namespace {

using Json = nlohmann::ordered_json;

/// ffd_eval.vh, FFD_POLY_LATENCY.
int polynomial_latency(const Configuration& row) {
  const int step = row.fma_latency > 0 ? row.fma_latency : row.mul_latency + row.add_latency;
  const bool iterative = std::string(row.evaluator) == "iterative";
  const bool powers = std::string(row.evaluator) == "powers";
  const int file = !overlaps(row) || powers ? 0 : iterative ? 2 : 1;
  return file + 3 * (iterative && step % 3 == 0 ? step + 1 : step) + row.convert_latency;
}

std::string units(int count, const std::string& name) {
  return fmt::format("{} {}{}", count, name, count == 1 ? "" : "s");
}

/// Adds lanes for units that operations pass one after the other.
class Pipeline {
 public:
  Pipeline(const tb::ScheduleRecorder& schedule, std::vector<std::uint64_t> entries)
      : schedule_(schedule), entries_(std::move(entries)) {}

  void pass(std::vector<Lane>& lanes, const std::string& name, int latency) {
    Lane lane{name, {}};
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      // Entries are steps in their order, or whole shares of a vertex.
      const std::size_t step = i * schedule_.sources().size() / entries_.size();
      lane.spans.push_back({entries_[i], entries_[i] + latency, schedule_.sources()[step]});
      entries_[i] += latency;
    }
    lanes.push_back(std::move(lane));
  }

  /// When each operation has passed all units so far.
  const std::vector<std::uint64_t>& arrivals() const { return entries_; }

  void expect(const std::vector<std::uint64_t>& arrivals, const char* row) const {
    if (entries_ != arrivals) {
      throw std::logic_error(fmt::format("{}: its probes do not fit its latencies", row));
    }
  }

 private:
  const tb::ScheduleRecorder& schedule_;
  std::vector<std::uint64_t> entries_;
};

void add_summation(std::vector<Lane>& lanes, const Row& row) {
  const Configuration& c = *row.configuration;
  const tb::ScheduleRecorder& schedule = row.measured.schedule;
  const bool fused = c.fma_latency > 0;
  Pipeline pipeline(schedule, schedule.steps());
  pipeline.pass(lanes, "weight products B B", c.mul_latency);
  pipeline.pass(lanes, "weight products (BB) B", c.mul_latency);
  if (!fused || c.n > 1) {
    pipeline.pass(lanes, units(fused ? 3 * c.n / 2 : 3 * c.n, "product") + " (BBB) P",
                  c.mul_latency);
  }
  for (int level = c.n / 2; level >= 1; level /= 2) {
    const bool first = level == c.n / 2;
    pipeline.pass(lanes,
                  units(3 * level, fused && first ? "multiply-add" : "adder") + " of the tree",
                  fused && first ? c.fma_latency : c.add_latency);
  }
  pipeline.expect(schedule.sums(), c.name);
  if (c.n < 64) {
    pipeline.pass(lanes, "3 accumulators", fused && c.n == 1 ? c.fma_latency : c.add_latency);
  }
}

bool is_affine(const Configuration& c) { return organization_of(c).form == Form::kAffine; }

/// What an affine contraction does before it has its weights.
void add_differences(std::vector<Lane>& lanes, Pipeline& pipeline, const Configuration& c, int sums,
                     const std::string& axis, bool in_steps = false) {
  if (!is_affine(c)) return;
  pipeline.pass(lanes, units(in_steps ? sums : sums * 3, "difference") + " along " + axis,
                c.add_latency);
}

/// Four terms along one axis, of `sums` sums at once; in four steps a product each.
void add_contract(std::vector<Lane>& lanes, Pipeline& pipeline, const Configuration& c, int sums,
                  const std::string& axis, bool in_steps = false) {
  const bool fused = c.fma_latency > 0;
  const int products = in_steps ? 1 : is_affine(c) ? 3 : fused ? 2 : 4;
  pipeline.pass(lanes, units(sums * products, "product") + " along " + axis, c.mul_latency);
  pipeline.pass(
      lanes, units(in_steps ? sums : sums * 2, fused ? "multiply-add" : "adder") + " along " + axis,
      fused ? c.fma_latency : c.add_latency);
  pipeline.pass(lanes, units(sums, "adder") + " along " + axis, c.add_latency);
}

/// `factored` and `affine`: polynomials, of which those of t and s may be later than shown,
/// points, contractions. Of several lanes the first is shown.
void add_contraction(std::vector<Lane>& lanes, const Row& row) {
  const Configuration& c = *row.configuration;
  const int side_by_side = hwffd::lanes(c);
  // Of ffd_bench_evaluator; a clock more where reads of several lanes meet.
  const int read_latency = side_by_side > 1 && folds(c) == 3 ? 3 : 2;
  const tb::ScheduleRecorder& schedule = row.measured.schedule;
  const int turns = folds(c) % 3 == 0 ? 3 : 1;
  const int parts = folds(c) / turns;
  const int components = 3 / turns;
  const int more = gives_jacobian(c) ? 1 : 0;  // sums along each axis, one after the other
  Pipeline polynomials(schedule, schedule.polynomials().starts);
  if (folds(c) >= 3) polynomials.pass(lanes, "axis chosen", 1);
  polynomials.pass(lanes, units(row.count.evaluators / side_by_side, "polynomial evaluator"),
                   polynomial_latency(c));
  Pipeline points(schedule, schedule.steps());
  points.pass(lanes, units(c.n, "point") + " read", read_latency);
  add_differences(lanes, points, c, 16 * components / parts, "u");
  points.expect(polynomials.arrivals(), c.name);
  add_contract(lanes, points, c, 16 * components / parts * (1 + more), "u");
  points.pass(lanes, "narrowed", c.convert_latency);
  add_differences(lanes, points, c, 4 * components / parts * (1 + more), "t");
  add_contract(lanes, points, c, 4 * components / parts * (1 + 2 * more), "t");
  if (scans(c)) {  // what vertices do along s is not of these steps, and not shown
    points.expect(schedule.sums(), c.name);
    return;
  }
  points.pass(lanes, "narrowed", c.convert_latency);
  add_differences(lanes, points, c, components * (1 + 2 * more), "s", parts == 4);
  add_contract(lanes, points, c, components * (1 + 3 * more), "s", parts == 4);
  points.expect(schedule.sums(), c.name);
}

/// In sequence: a point a clock. Products along t and s take the clocks of the bases and are not
/// shown; the last of them ends a vertex.
void add_sequence(std::vector<Lane>& lanes, const Row& row) {
  constexpr std::size_t kPoints = 64;
  constexpr std::size_t kFills = 27;  // clocks of the polynomials' starts
  const Configuration& c = *row.configuration;
  const tb::ScheduleRecorder& schedule = row.measured.schedule;
  std::vector<std::uint64_t> starts;
  for (std::size_t i = 0; i < schedule.polynomials().starts.size(); ++i) {
    const std::size_t step = i % kPoints;
    if (step < kFills && step % 3 == 0) starts.push_back(schedule.polynomials().starts[i]);
  }
  Pipeline polynomials(schedule, starts);
  polynomials.pass(lanes, "1 polynomial evaluator", polynomial_latency(c));
  Pipeline points(schedule, schedule.steps());
  points.pass(lanes, "a point read", 2);
  points.pass(lanes, "3 differences", c.add_latency);
  points.pass(lanes, "3 products", c.mul_latency);
  points.pass(lanes, "3 adders", c.add_latency);
  // ffd_eval_serial: groups of four from u to t, two rounds of 16 from t to s, three along s.
  const int groups = (c.mul_latency + c.convert_latency + 8) / 4;
  std::vector<std::uint64_t> sums;
  for (std::size_t i = 0; i < points.arrivals().size(); i += kPoints) {
    sums.push_back(points.arrivals()[i] + 4 * groups + 2 * 16 + 3 * 16);
  }
  if (sums != schedule.sums()) {
    throw std::logic_error(fmt::format("{}: its probes do not fit its latencies", c.name));
  }
}

/// `nested`, within a cell: centred coordinates, then a cubic an axis, of which those that are
/// added later start later than shown.
void add_nested(std::vector<Lane>& lanes, const Row& row) {
  const Configuration& c = *row.configuration;
  const tb::ScheduleRecorder& schedule = row.measured.schedule;
  const int components = 3 / folds(c);
  const int step = c.fma_latency > 0 ? c.fma_latency : c.mul_latency + c.add_latency;
  Pipeline vertices(schedule, schedule.steps());
  vertices.pass(lanes, "3 adders, centring", c.add_latency);
  int cubics = 16 * components;
  for (const char* axis : {"upsilon", "tau", "sigma"}) {
    for (int n = 1; n <= 3; ++n) {
      vertices.pass(lanes, fmt::format("{} steps of {}, {} of 3", cubics, axis, n), step);
    }
    cubics /= 4;
  }
  vertices.expect(schedule.sums(), c.name);
}

struct Window {
  std::uint64_t begin;
  std::uint64_t end;
};

/// The first vertex and a little of what follows.
Window window_of(const Row& row, const std::vector<Lane>& lanes) {
  const std::uint64_t begin = lanes.front().spans.front().begin;
  const std::uint64_t end = row.measured.schedule.results().front();
  return {begin, end + std::max<std::uint64_t>(4, (end - begin) / 8)};
}

/// The format in which an organization is shown.
std::string timed_format(const Comparison& comparison, const std::string& org) {
  std::vector<std::string> formats;
  for (const Row& row : comparison.rows()) {
    if (row.configuration->org == org) formats.emplace_back(row.configuration->format);
  }
  for (const char* format : {"fx18", "fx17"}) {
    if (std::count(formats.begin(), formats.end(), format) > 0) return format;
  }
  return formats.front();
}

/// What of a lane lies in a window, in clocks from its beginning.
Json json_of(const Lane& lane, const Window& window) {
  Json spans = Json::array();
  for (const Lane::Span& span : lane.spans) {
    const std::uint64_t begin = std::max(span.begin, window.begin);
    const std::uint64_t end = std::min(span.end, window.end);
    if (begin >= end) continue;
    spans.push_back({begin - window.begin, end - window.begin, span.vertex});
  }
  return {{"name", lane.name}, {"spans", std::move(spans)}};
}

}  // namespace

std::vector<Lane> lanes_of(const Row& row) {
  const tb::ScheduleRecorder& schedule = row.measured.schedule;
  std::vector<Lane> lanes;
  if (contracts(*row.configuration)) {
    const bool in_sequence = row.configuration->n == 1;
    (in_sequence ? add_sequence : add_contraction)(lanes, row);
    return lanes;
  }
  if (keeps_cell(*row.configuration)) {
    add_nested(lanes, row);
    return lanes;
  }
  Pipeline polynomials(schedule, schedule.polynomials().starts);
  polynomials.pass(lanes, units(row.count.evaluators, "polynomial evaluator"),
                   polynomial_latency(*row.configuration));
  if (const tb::ScheduleRecorder::Sequencer* generator = schedule.combinations()) {
    Pipeline combinations(schedule, generator->starts);
    combinations.pass(lanes, "combination generator", 1);
    combinations.expect(schedule.steps(), row.configuration->name);
  } else {
    polynomials.expect(schedule.steps(), row.configuration->name);
  }
  add_summation(lanes, row);
  return lanes;
}

std::string timelines(const Comparison& comparison) {
  Json list = Json::array();
  for (const Row& row : comparison.rows()) {
    const Configuration& c = *row.configuration;
    if (c.format != timed_format(comparison, c.org)) continue;
    const std::vector<Lane> lanes = lanes_of(row);
    const Window window = window_of(row, lanes);
    Json drawn = Json::array();
    for (const Lane& lane : lanes) drawn.push_back(json_of(lane, window));
    list.push_back({{"name", c.name},
                    {"org", c.org},
                    {"n", c.n},
                    {"schedule", c.schedule},
                    {"clocks", window.end - window.begin},
                    {"first_done", row.measured.schedule.results().front() - window.begin},
                    {"lanes", std::move(drawn)}});
  }
  return Json{{"rows", std::move(list)}}.dump() + "\n";
}

}  // namespace hwffd::organizations
