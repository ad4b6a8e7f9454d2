#include "chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labels.hpp"
#include "svg.hpp"

namespace hwffd::organizations {
namespace {

constexpr double kWidth = 900;
constexpr double kHeight = 620;
constexpr double kLeft = 80;
constexpr double kRight = 860;
constexpr double kTop = 60;
constexpr double kBottom = 540;
constexpr double kFewest = 6;  // operators
constexpr double kMost = 2000;
constexpr double kShortest = 0.7;  // clocks
constexpr double kLongest = 1000;

struct Mark {
  double operators;
  double clocks;
  std::string name;
};

struct Series {
  std::string name;
  std::string colour;
  bool hollow;
  int labels;  // above the marks 1, below them -1, none 0
  std::vector<Mark> marks;
};

double x_of(double operators) {
  return kLeft + std::log(operators / kFewest) / std::log(kMost / kFewest) * (kRight - kLeft);
}
double y_of(double clocks) {
  return kBottom - std::log(clocks / kShortest) / std::log(kLongest / kShortest) * (kBottom - kTop);
}

/// One mark a row of a format, schedule and kind of operators; the first of several evaluators.
std::vector<Mark> marks(const Comparison& comparison, const std::string& format,
                        const std::string& schedule, bool fused, Operators OperatorCount::*form) {
  std::vector<Mark> marks;
  for (const Row& row : comparison.rows()) {
    const Configuration& c = *row.configuration;
    if (c.format != format || c.schedule != schedule || (c.fma_latency > 0) != fused) continue;
    const std::string name = short_name(c);
    const bool drawn = std::any_of(marks.begin(), marks.end(),
                                   [&](const Mark& mark) { return mark.name == name; });
    if (drawn) continue;
    const double clocks = schedule == "paper" ? static_cast<double>(row.measured.vertex.clocks)
                                              : row.measured.interval;
    marks.push_back({static_cast<double>((row.count.*form).total()), clocks, name});
  }
  return marks;
}

std::string grid() {
  std::string drawing;
  for (const double clocks : {1, 10, 100, 1000}) {
    const double y = y_of(clocks);
    drawing += svg::line(kLeft, y, kRight, y, "stroke=\"#dddddd\"");
    drawing += svg::text(kLeft - 8, y + 4, fmt::format("{:.0f}", clocks), "text-anchor=\"end\"");
  }
  for (const double operators : {10, 20, 50, 100, 200, 500, 1000}) {
    const double x = x_of(operators);
    drawing += svg::line(x, kTop, x, kBottom, "stroke=\"#dddddd\"");
    drawing +=
        svg::text(x, kBottom + 18, fmt::format("{:.0f}", operators), "text-anchor=\"middle\"");
  }
  drawing += svg::text((kLeft + kRight) / 2, kBottom + 40,
                       "operators: multipliers + adders (a fused one counts two)",
                       "text-anchor=\"middle\"");
  drawing += svg::turned_text(24, (kTop + kBottom) / 2, "clocks a vertex, counted in RTL");
  return drawing;
}

std::string draw(const Series& series, svg::Labels& labels) {
  std::string drawing;
  const std::string fill = series.hollow ? "white" : series.colour;
  for (const Mark& mark : series.marks) {
    drawing += svg::circle(
        x_of(mark.operators), y_of(mark.clocks), 4.5,
        fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.5\"", fill, series.colour),
        fmt::format("{}, {}: {} operators, {} clocks", mark.name, series.name, mark.operators,
                    mark.clocks));
    if (series.labels != 0) {
      drawing += labels.beside(x_of(mark.operators), y_of(mark.clocks), mark.name, series.colour,
                               series.labels > 0);
    }
  }
  return drawing;
}

std::string legend(const std::vector<Series>& all) {
  std::string drawing;
  double y = kTop + 16;
  for (const Series& series : all) {
    if (series.marks.empty()) continue;
    drawing += svg::circle(kRight - 250, y - 4, 4.5,
                           fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.5\"",
                                       series.hollow ? "white" : series.colour, series.colour));
    drawing += svg::text(kRight - 238, y, series.name);
    y += 18;
  }
  return drawing;
}

}  // namespace

std::string tradeoff_chart(const Comparison& comparison) {
  std::string format = comparison.rows().front().configuration->format;
  for (const Row& row : comparison.rows()) {
    if (std::string(row.configuration->format) == "fx18") format = "fx18";
  }
  const std::string paper = "#c04000";
  const std::string overlapped = "#0060a8";
  const std::vector<Series> all = {
      {"paper's schedule, units as drawn", paper, true, 0,
       marks(comparison, format, "paper", false, &OperatorCount::drawn)},
      {"paper's schedule, as built", paper, false, 1,
       marks(comparison, format, "paper", false, &OperatorCount::built)},
      {"overlapped", overlapped, false, -1,
       marks(comparison, format, "overlapped", false, &OperatorCount::built)},
      {"paper's schedule, fused, binary32", "#2a8000", false, 0,
       marks(comparison, "fp32", "paper", true, &OperatorCount::built)}};
  std::string drawing = grid();
  svg::Labels labels;
  for (const Series& series : all) {
    for (const Mark& mark : series.marks) labels.keep_free(x_of(mark.operators), y_of(mark.clocks));
  }
  for (const Series& series : all) drawing += draw(series, labels);
  drawing += legend(all);
  drawing += svg::text(kLeft, kTop - 24, fmt::format("Clocks against operators, {}", format),
                       "font-size=\"15\"");
  return svg::picture(kWidth, kHeight, drawing);
}

}  // namespace hwffd::organizations
