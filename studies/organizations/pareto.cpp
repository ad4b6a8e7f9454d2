#include "pareto.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labels.hpp"
#include "svg.hpp"

namespace hwffd::organizations {
namespace {

constexpr double kPanelWidth = 560;
constexpr double kPanelHeight = 420;
constexpr double kColumns = 2;
constexpr double kLeft = 80;
constexpr double kRight = 530;
constexpr double kTop = 40;
constexpr double kBottom = 360;
const char* const kColour = "#0060a8";

/// Whole decades around the values, on a logarithmic axis between two pixels.
class Axis {
 public:
  Axis(double least, double most, double from, double to)
      : low_(std::floor(std::log10(least))),
        high_(std::max(low_ + 1, std::ceil(std::log10(most)))),
        from_(from),
        to_(to) {}

  double at(double value) const {
    return from_ + (std::log10(value) - low_) / (high_ - low_) * (to_ - from_);
  }
  std::vector<double> decades() const {
    std::vector<double> values;
    for (double power = low_; power <= high_; ++power) values.push_back(std::pow(10, power));
    return values;
  }

 private:
  double low_, high_, from_, to_;
};

/// The rows of a target that its panel can compare: those with a clock, or all if none has one.
std::vector<Throughput> of_panel(const std::vector<Throughput>& rows, const std::string& target) {
  std::vector<Throughput> timed;
  std::vector<Throughput> all;
  for (const Throughput& row : rows) {
    if (row.area.target != target) continue;
    all.push_back(row);
    if (row.per_second()) timed.push_back(row);
  }
  return timed.empty() ? all : timed;
}

template <class Figure>
Axis axis(const std::vector<Throughput>& rows, double from, double to, Figure figure) {
  const auto [least, most] = std::minmax_element(
      rows.begin(), rows.end(),
      [&](const Throughput& a, const Throughput& b) { return figure(a) < figure(b); });
  return {figure(*least), figure(*most), from, to};
}

std::string number(double value) {
  return value >= 1e6 ? fmt::format("{:g}M", value / 1e6) : fmt::format("{:g}", value);
}

std::string grid(const Axis& x, const Axis& y, const Throughput& sample) {
  std::string drawing;
  for (const double size : x.decades()) {
    drawing += svg::line(x.at(size), kTop, x.at(size), kBottom, "stroke=\"#dddddd\"");
    drawing += svg::text(x.at(size), kBottom + 18, number(size), "text-anchor=\"middle\"");
  }
  for (const double rate : y.decades()) {
    drawing += svg::line(kLeft, y.at(rate), kRight, y.at(rate), "stroke=\"#dddddd\"");
    drawing += svg::text(kLeft - 8, y.at(rate) + 4, number(rate), "text-anchor=\"end\"");
  }
  const char* unit = sample.per_second() ? "vertices per second" : "vertices per clock";
  drawing +=
      svg::text((kLeft + kRight) / 2, kBottom + 38, sample.area.unit, "text-anchor=\"middle\"");
  drawing += svg::turned_text(22, (kTop + kBottom) / 2, unit);
  return drawing + svg::text(kLeft, kTop - 14, sample.area.target, "font-size=\"15\"");
}

std::string mark(const Axis& x, const Axis& y, const Throughput& row, const char* colour) {
  return svg::circle(
      x.at(row.area.size), y.at(row.rate()), 4, fmt::format("fill=\"{}\"", colour),
      fmt::format("{}: {:.0f} {}, {:.4g}", row.name, row.area.size, row.area.unit, row.rate()));
}

std::string panel(const std::vector<Throughput>& rows) {
  const Axis x = axis(rows, kLeft, kRight, [](const Throughput& row) { return row.area.size; });
  const Axis y = axis(rows, kBottom, kTop, [](const Throughput& row) { return row.rate(); });
  std::string drawing = grid(x, y, rows.front());
  svg::Labels labels;
  for (const Throughput& row : rows) {
    drawing += mark(x, y, row, "#bbbbbb");
    labels.keep_free(x.at(row.area.size), y.at(row.rate()));
  }
  const std::vector<const Throughput*> best = front(rows);
  std::string points;
  for (std::size_t i = 0; i < best.size(); ++i) {
    const double left = x.at(best[i]->area.size);
    const double above = y.at(best[i]->rate());
    points += fmt::format("{:.1f},{:.1f} ", left, above);
    if (i == 0) continue;
    labels.keep_free(x.at(best[i - 1]->area.size), y.at(best[i - 1]->rate()), left, above);
  }
  drawing += svg::polyline(points, fmt::format("stroke=\"{}\"", kColour));
  for (const Throughput* row : best) {
    drawing += mark(x, y, *row, kColour);
    drawing += labels.beside(x.at(row->area.size), y.at(row->rate()),
                             fmt::format("{} {}", row->org, row->format), kColour, true);
  }
  return drawing;
}

}  // namespace

std::string pareto_chart(const std::vector<Throughput>& rows) {
  std::string drawing;
  double panels = 0;
  for (const std::string& target : targets(rows)) {
    drawing += fmt::format(
        "<g transform=\"translate({} {})\">\n{}</g>\n", std::fmod(panels, kColumns) * kPanelWidth,
        std::floor(panels / kColumns) * kPanelHeight, panel(of_panel(rows, target)));
    ++panels;
  }
  return svg::picture(kPanelWidth * std::min(panels, kColumns),
                      kPanelHeight * std::ceil(panels / kColumns), drawing);
}

}  // namespace hwffd::organizations
