#include "timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "hwffd/model/schedule.hpp"
#include "svg.hpp"

namespace hwffd::organizations {
namespace {

constexpr double kLeft = 220;
constexpr double kPlotWidth = 900;
constexpr double kLaneHeight = 20;
constexpr double kHead = 34;
constexpr double kFoot = 40;
constexpr std::array<const char*, 4> kColours = {"#0060a8", "#e08000", "#2a8000", "#a03060"};

/// ffd_eval.vh, FFD_POLY_LATENCY.
int polynomial_latency(const Configuration& row) {
  const int step = row.fma_latency > 0 ? row.fma_latency : row.mul_latency + row.add_latency;
  const bool iterative = std::string(row.evaluator) == "iterative";
  const int file = !overlaps(row) ? 0 : iterative ? 2 : 1;
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

/// Four terms along one axis, of `sums` sums at once.
void add_contract(std::vector<Lane>& lanes, Pipeline& pipeline, const Configuration& c, int sums,
                  const std::string& axis) {
  const bool fused = c.fma_latency > 0;
  pipeline.pass(lanes, units(sums * (fused ? 2 : 4), "product") + " along " + axis, c.mul_latency);
  pipeline.pass(lanes, units(sums * 2, fused ? "multiply-add" : "adder") + " along " + axis,
                fused ? c.fma_latency : c.add_latency);
  pipeline.pass(lanes, units(sums, "adder") + " along " + axis, c.add_latency);
}

/// `factored`: polynomials, of which those of t and s may be later than shown,
/// points, contractions.
void add_contraction(std::vector<Lane>& lanes, const Row& row) {
  constexpr int kReadLatency = 2;  // of ffd_bench_evaluator
  const Configuration& c = *row.configuration;
  const tb::ScheduleRecorder& schedule = row.measured.schedule;
  const int components = 3 / folds(c);
  Pipeline polynomials(schedule, schedule.polynomials().starts);
  if (folds(c) > 1) polynomials.pass(lanes, "axis chosen", 1);
  polynomials.pass(lanes, units(row.count.evaluators, "polynomial evaluator"),
                   polynomial_latency(c));
  Pipeline points(schedule, schedule.steps());
  points.pass(lanes, "64 points read", kReadLatency);
  points.expect(polynomials.arrivals(), c.name);
  add_contract(lanes, points, c, 16 * components, "u");
  points.pass(lanes, "narrowed", c.convert_latency);
  add_contract(lanes, points, c, 4 * components, "t");
  points.pass(lanes, "narrowed", c.convert_latency);
  add_contract(lanes, points, c, components, "s");
  points.expect(schedule.sums(), c.name);
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

/// A rectangle for every run of clocks in which the last operation to enter is of one vertex.
std::string draw_lane(const Lane& lane, const Window& window, double y, double scale) {
  std::vector<int> busy(window.end - window.begin, -1);
  for (const Lane::Span& span : lane.spans) {
    for (std::uint64_t clock = span.begin; clock < std::min(span.end, window.end); ++clock) {
      if (clock >= window.begin) busy[clock - window.begin] = static_cast<int>(span.vertex);
    }
  }
  std::string drawing;
  for (std::size_t from = 0; from < busy.size();) {
    std::size_t to = from + 1;
    while (to < busy.size() && busy[to] == busy[from]) ++to;
    if (busy[from] >= 0) {
      drawing += svg::rectangle(kLeft + scale * static_cast<double>(from), y + 2,
                                scale * static_cast<double>(to - from), kLaneHeight - 4,
                                fmt::format("fill=\"{}\"", kColours[busy[from] % kColours.size()]));
    }
    from = to;
  }
  return drawing;
}

double panel_height(std::size_t lanes) {
  return kHead + kLaneHeight * static_cast<double>(lanes) + kFoot;
}

std::string panel(const Row& row, const std::vector<Lane>& lanes, double top) {
  const Window window = window_of(row, lanes);
  const auto clocks = static_cast<double>(window.end - window.begin);
  const double scale = kPlotWidth / clocks;
  const double bottom = top + kHead + kLaneHeight * static_cast<double>(lanes.size());
  std::string drawing =
      svg::text(16, top + 20, row.configuration->name, "font-size=\"15\" font-weight=\"bold\"");
  double tick = 1;
  while (tick * scale < 40) tick *= tick * scale * 2 < 40 && tick * 5 * scale >= 40 ? 5 : 2;
  for (double clock = 0; clock <= clocks; clock += tick) {
    const double x = kLeft + scale * clock;
    drawing += svg::line(x, top + kHead, x, bottom, "stroke=\"#dddddd\"");
    drawing += svg::text(x, bottom + 16, fmt::format("{:.0f}", clock), "text-anchor=\"middle\"");
  }
  double y = top + kHead;
  for (const Lane& lane : lanes) {
    drawing += svg::text(kLeft - 10, y + 14, lane.name, "text-anchor=\"end\"");
    drawing += draw_lane(lane, window, y, scale);
    y += kLaneHeight;
  }
  const double end =
      kLeft + scale * static_cast<double>(row.measured.schedule.results().front() - window.begin);
  drawing += svg::line(end, top + kHead - 6, end, bottom, "stroke=\"black\"");
  drawing += svg::text(end - 4, top + kHead - 8, "first vertex done", "text-anchor=\"end\"");
  return drawing;
}

}  // namespace

std::vector<Lane> lanes_of(const Row& row) {
  const tb::ScheduleRecorder& schedule = row.measured.schedule;
  std::vector<Lane> lanes;
  if (contracts(*row.configuration)) {
    add_contraction(lanes, row);
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

std::string timeline(const Row* paper, const Row* overlapped) {
  std::string drawing;
  double y = 8;
  for (const Row* row : {paper, overlapped}) {
    if (row == nullptr) continue;
    const std::vector<Lane> lanes = lanes_of(*row);
    drawing += panel(*row, lanes, y);
    y += panel_height(lanes.size());
  }
  drawing += svg::text(
      16, y + 6, "clocks from the start of the first vertex; a colour is a vertex, white is idle");
  return svg::picture(kLeft + kPlotWidth + 30, y + 20, drawing);
}

}  // namespace hwffd::organizations
