#include "plot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "report.hpp"

namespace hwffd::words {
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

std::string line(double x1, double y1, double x2, double y2, const std::string& style) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1, y1,
                     x2, y2, style);
}

std::string text(double x, double y, const std::string& words, const std::string& style = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, style, words);
}

std::string axes() {
  const std::string grid = "stroke=\"#dddddd\"";
  std::string svg;
  for (int decade = kBottomDecade; decade <= kTopDecade; ++decade) {
    const double y = y_of(std::pow(10, decade));
    svg += line(kLeft, y, kRight, y, grid);
    svg += text(kLeft - 8, y + 4, fmt::format("1e{}", decade), "text-anchor=\"end\"");
  }
  for (int width = kFirstWidth; width <= kLastWidth; width += 2) {
    svg += line(x_of(width), kTop, x_of(width), kBottom, grid);
    svg += text(x_of(width), kBottom + 18, std::to_string(width), "text-anchor=\"middle\"");
  }
  svg += line(kLeft, kTop, kLeft, kBottom, "stroke=\"black\"");
  svg += line(kLeft, kBottom, kRight, kBottom, "stroke=\"black\"");
  svg += text((kLeft + kRight) / 2, kBottom + 42, "word length, bits (fixed point)",
              "text-anchor=\"middle\"");
  const double middle = (kTop + kBottom) / 2;
  svg += text(24, middle, "error of a component, points in [-1, 1)",
              fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 24 {:.1f})\"", middle));
  svg += text(kLeft, kTop - 20, "Error against double precision, uniform cubic B-spline",
              "font-size=\"15\"");
  return svg;
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
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke-width=\"2\" {}/>\n", points,
                     style) +
         text(kRight + 8, end + 4, name);
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
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      kWidth, kHeight);
  svg += axes();
  svg += level(kHalfPixel, fmt::format("half a pixel of {}", kPictureWidth), "#666666", 4);
  std::set<std::string> forms;
  for (const Result& r : results) forms.insert(r.form);
  for (const Result& r : results) {
    if (r.format == "fp32-sequential") {
      svg += level(r.max_error, r.form + ", binary32, max", "#222222", 0);
    } else if (r.format == "fp32-tree") {
      svg += level(r.max_error, r.form + ", binary32 tree, max", "#222222", 8);
    }
  }
  std::size_t next = 0;
  for (const std::string& form : forms) {
    const std::string stroke = fmt::format("stroke=\"{}\"", kColours[next++ % kColours.size()]);
    svg += curve(results, form, &Result::bound, form + ", bound", stroke + " opacity=\"0.45\"");
    svg += curve(results, form, &Result::max_error, form + ", max", stroke);
    svg += curve(results, form, &Result::rms_error, form + ", rms",
                 stroke + " stroke-dasharray=\"2 3\"");
  }
  return svg + "</svg>\n";
}

}  // namespace hwffd::words
