#include "plot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "report.hpp"
#include "svg.hpp"

namespace hwffd::words {

using svg::line, svg::picture, svg::polyline, svg::text, svg::turned_text;

namespace {

constexpr double kWidth = 880;
constexpr double kHeight = 560;
constexpr double kLeft = 80;
constexpr double kRight = 690;  // of the axes; what lines are called stands to the right of them
constexpr double kTop = 50;
constexpr double kBottom = 500;
constexpr int kFirstWidth = 12;
constexpr int kLastWidth = 32;
constexpr int kTopDecade = 0;
constexpr int kBottomDecade = -10;

double x_of(double width) {
  return kLeft + (width - kFirstWidth) / (kLastWidth - kFirstWidth) * (kRight - kLeft);
}
double y_of(double error) {
  return kTop + (kTopDecade - std::log10(error)) / (kTopDecade - kBottomDecade) * (kBottom - kTop);
}

std::string axes() {
  const std::string grid = "stroke=\"#dddddd\"";
  std::string drawing;
  for (int decade = kBottomDecade; decade <= kTopDecade; ++decade) {
    const double y = y_of(std::pow(10, decade));
    drawing += line(kLeft, y, kRight, y, grid);
    drawing += text(kLeft - 8, y + 4, fmt::format("1e{}", decade), "text-anchor=\"end\"");
  }
  for (int width = kFirstWidth; width <= kLastWidth; width += 2) {
    drawing += line(x_of(width), kTop, x_of(width), kBottom, grid);
    drawing += text(x_of(width), kBottom + 18, std::to_string(width), "text-anchor=\"middle\"");
  }
  drawing += line(kLeft, kTop, kLeft, kBottom, "stroke=\"black\"");
  drawing += line(kLeft, kBottom, kRight, kBottom, "stroke=\"black\"");
  drawing += text((kLeft + kRight) / 2, kBottom + 42, "word length, bits (fixed point)",
                  "text-anchor=\"middle\"");
  drawing += turned_text(24, (kTop + kBottom) / 2, "error of a component, points in [-1, 1)");
  drawing += text(kLeft, kTop - 20, "Error against double precision, uniform cubic B-spline",
                  "font-size=\"15\"");
  return drawing;
}

/// A curve over the word lengths of one form, called by its name at its end.
std::string curve(const std::vector<Result>& results, const std::string& form,
                  double Result::*error, const std::string& name, const std::string& style) {
  std::string points;
  double end = kBottom;
  for (const Result& r : results) {
    if (!r.fixed || r.form != form) continue;
    end = y_of(r.*error);
    points += fmt::format("{:.1f},{:.1f} ", x_of(r.word_length), end);
  }
  return polyline(points, "stroke-width=\"2\" " + style) + text(kRight + 8, end + 4, name);
}

std::string level(double error, const std::string& name, const std::string& colour, double rise) {
  const double y = y_of(error);
  return line(kLeft, y, kRight, y,
              fmt::format("stroke=\"{}\" stroke-width=\"1.5\" stroke-dasharray=\"7 4\"", colour)) +
         text(kRight + 8, y + rise, name, fmt::format("fill=\"{}\"", colour));
}

}  // namespace

std::string plot(const std::vector<Result>& results) {
  static const std::vector<std::string> kColours = {"#0060a8", "#c04000", "#2a8000", "#7a30a0"};
  std::string drawing = axes();
  drawing += level(kHalfPixel, fmt::format("half a pixel of {}", kPictureWidth), "#666666", 4);
  std::set<std::string> forms;
  for (const Result& r : results) forms.insert(r.form);
  for (const Result& r : results) {
    if (r.format == "fp32-sequential") {
      drawing += level(r.max_error, r.form + ", binary32, max", "#222222", 0);
    } else if (r.format == "fp32-tree") {
      drawing += level(r.max_error, r.form + ", binary32 tree, max", "#222222", 8);
    }
  }
  std::size_t next = 0;
  for (const std::string& form : forms) {
    const std::string stroke = fmt::format("stroke=\"{}\"", kColours[next++ % kColours.size()]);
    drawing += curve(results, form, &Result::bound, form + ", bound", stroke + " opacity=\"0.45\"");
    drawing += curve(results, form, &Result::max_error, form + ", max", stroke);
    drawing += curve(results, form, &Result::rms_error, form + ", rms",
                     stroke + " stroke-dasharray=\"2 3\"");
  }
  return picture(kWidth, kHeight, drawing);
}

}  // namespace hwffd::words
