#include "labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "svg.hpp"

namespace hwffd::svg {
namespace {

constexpr double kRadius = 5;  // of a mark
constexpr double kAscent = 9;  // of 10 pixels of text, above its base line and below it
constexpr double kDescent = 2;
constexpr double kAdvance = 6;  // of a letter

struct Place {
  double x, y;  // of the text's anchor on its base line, from the mark's centre
  const char* anchor;
};

constexpr std::array<Place, 14> kPlaces = {{{0, -9, "middle"},
                                            {-7, -6, "end"},
                                            {7, -6, "start"},
                                            {0, 18, "middle"},
                                            {8, 4, "start"},
                                            {-8, 4, "end"},
                                            {7, 14, "start"},
                                            {-7, 14, "end"},
                                            {0, -20, "middle"},
                                            {0, 29, "middle"},
                                            {7, 25, "start"},
                                            {-7, 25, "end"},
                                            {7, 36, "start"},
                                            {-7, 36, "end"}}};

double left_of(const Place& place, double width) {
  const std::string anchor = place.anchor;
  return anchor == "start" ? 0 : anchor == "end" ? -width : -width / 2;
}

}  // namespace

void Labels::keep_free(double x, double y) {
  taken_.push_back({x - kRadius, y - kRadius, x + kRadius, y + kRadius});
}

void Labels::keep_free(double x1, double y1, double x2, double y2) {
  constexpr double kStep = 4;
  const double steps = std::ceil(std::hypot(x2 - x1, y2 - y1) / kStep);
  for (double i = 1; i < steps; ++i) {
    const double x = x1 + (x2 - x1) * i / steps;
    const double y = y1 + (y2 - y1) * i / steps;
    taken_.push_back({x - 1, y - 1, x + 1, y + 1});
  }
}

double Labels::covered(const Box& box) const {
  double area = 0;
  for (const Box& other : taken_) {
    const double width = std::min(box.right, other.right) - std::max(box.left, other.left);
    const double height = std::min(box.bottom, other.bottom) - std::max(box.top, other.top);
    if (width > 0 && height > 0) area += width * height;
  }
  return area;
}

std::string Labels::beside(double x, double y, const std::string& words, const std::string& colour,
                           bool above) {
  const double width = kAdvance * static_cast<double>(words.size());
  double least = -1;
  Box chosen{};
  std::string label;
  for (const Place& place : kPlaces) {
    // Below is above turned over: the base line goes where the top was.
    const double base = y + (above ? place.y : kAscent - kDescent - place.y);
    const double left = x + place.x + left_of(place, width);
    const Box box = {left, base - kAscent, left + width, base + kDescent};
    const double area = covered(box);
    if (least >= 0 && area >= least) continue;
    least = area;
    chosen = box;
    label =
        text(x + place.x, base, words,
             fmt::format("font-size=\"10\" text-anchor=\"{}\" fill=\"{}\"", place.anchor, colour));
    if (area == 0) break;
  }
  taken_.push_back(chosen);
  return label;
}

}  // namespace hwffd::svg
