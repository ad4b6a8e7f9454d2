#pragma once

#include <string>

namespace hwffd::svg {

/// A picture of the given size in pixels, white, with text in 12 pixels of a sans-serif font.
/// `elements` are what the functions below return. `style` arguments are attributes as they stand
/// in SVG.
std::string picture(double width, double height, const std::string& elements);

std::string line(double x1, double y1, double x2, double y2, const std::string& style);
std::string polyline(const std::string& points, const std::string& style);
std::string rectangle(double x, double y, double width, double height, const std::string& style);
std::string circle(double x, double y, double radius, const std::string& style,
                   const std::string& title = "");
std::string text(double x, double y, const std::string& words, const std::string& style = "");
/// Upright text turned a quarter to the left about its middle.
std::string turned_text(double x, double y, const std::string& words);

}  // namespace hwffd::svg
