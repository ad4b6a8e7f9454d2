#include <fmt/format.h>

#include <cmath>
#include <map>

#include "report.hpp"
#include "svg.hpp"

namespace hwffd::streams {
namespace {

constexpr double kPanel = 300;  // width of a mesh's axes
constexpr double kGap = 40;
constexpr double kLeft = 70;
constexpr double kTop = 60;
constexpr double kBottom = 460;
constexpr double kLegend = 190;
constexpr double kFewest = 3;  // words
constexpr double kMost = 400;
constexpr double kFirst = 3;  // points an axis
constexpr double kLast = 17;

double y_of(double words) {
  return kBottom - std::log(words / kFewest) / std::log(kMost / kFewest) * (kBottom - kTop);
}

std::string colour_of(const std::string& arrangement) {
  static const std::map<std::string, std::string> kColours = {
      {"interleaved", "#222222"}, {"changed points", "#c04000"}, {"1 cell", "#7a30a0"},
      {"4 cells", "#0060a8"},     {"16 cells", "#008080"},       {"resident", "#2a8000"}};
  return kColours.at(arrangement);
}

std::string dashes_of(const std::string& order) {
  if (order == "cell") return " stroke-dasharray=\"7 4\"";
  return order == "curve" ? " stroke-dasharray=\"2 3\"" : "";
}

/// The axes of one mesh.
class Panel {
 public:
  explicit Panel(double left) : left_(left) {}

  double x_of(double points) const { return left_ + (points - kFirst) / (kLast - kFirst) * kPanel; }
  std::string axes(const std::string& title, bool first) const {
    std::string drawing;
    for (const double words : {4, 10, 20, 50, 100, 200}) {
      drawing += svg::line(left_, y_of(words), left_ + kPanel, y_of(words), "stroke=\"#dddddd\"");
      if (!first) continue;
      drawing += svg::text(left_ - 8, y_of(words) + 4, fmt::format("{:.0f}", words),
                           "text-anchor=\"end\"");
    }
    for (const int points : {4, 8, 12, 16}) {
      drawing +=
          svg::text(x_of(points), kBottom + 18, std::to_string(points), "text-anchor=\"middle\"");
    }
    drawing += svg::line(left_, kBottom, left_ + kPanel, kBottom, "stroke=\"black\"");
    return drawing + svg::text(left_, kTop - 8, title);
  }
  std::string curve(const std::vector<const Row*>& rows) const {
    std::string points;
    for (const Row* row : rows)
      points += fmt::format("{:.1f},{:.1f} ", x_of(row->points), y_of(row->words_per_vertex()));
    return svg::polyline(
        points, fmt::format("stroke-width=\"1.8\" stroke=\"{}\"{}",
                            colour_of(rows.front()->arrangement), dashes_of(rows.front()->order)));
  }

 private:
  double left_;
};

using Curves = std::map<std::string, std::vector<const Row*>>;  // by arrangement and order

std::string legend(double left, const Curves& curves) {
  std::string drawing;
  double y = kTop + 10;
  for (const auto& [name, rows] : curves) {
    drawing += svg::line(
        left, y - 4, left + 30, y - 4,
        fmt::format("stroke-width=\"1.8\" stroke=\"{}\"{}", colour_of(rows.front()->arrangement),
                    dashes_of(rows.front()->order)));
    drawing += svg::text(left + 38, y, name);
    y += 20;
  }
  return drawing;
}

std::string name_of(const Row& row) {
  const bool one_order = row.arrangement != "changed points" && row.arrangement != "1 cell";
  return one_order ? row.arrangement : fmt::format("{}, {}", row.arrangement, row.order);
}

}  // namespace

std::string plot(const std::vector<Row>& rows) {
  std::map<std::string, Curves> meshes;
  for (const Row& row : rows) meshes[row.mesh][name_of(row)].push_back(&row);
  std::string drawing;
  double left = kLeft;
  for (const auto& [mesh, curves] : meshes) {
    const Panel panel(left);
    const std::size_t vertices = curves.begin()->second.front()->vertices;
    drawing += panel.axes(fmt::format("{}, {} vertices", mesh, vertices), left == kLeft);
    for (const auto& [name, of_curve] : curves) drawing += panel.curve(of_curve);
    left += kPanel + kGap;
  }
  drawing += legend(left, meshes.begin()->second);
  drawing += svg::turned_text(24, (kTop + kBottom) / 2, "words moved to the core, a vertex");
  drawing += svg::text((kLeft + left - kGap) / 2, kBottom + 40, "control points an axis",
                       "text-anchor=\"middle\"");
  drawing += svg::text(kLeft, kTop - 34, "What arrangements of the control points move",
                       "font-size=\"15\"");
  return svg::picture(left + kLegend, kBottom + 60, drawing);
}

}  // namespace hwffd::streams
