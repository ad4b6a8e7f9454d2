#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdlib>

#include "picture/camera.hpp"
#include "picture/image.hpp"

namespace hwffd::picture {

inline bool is_background(const Pixel& pixel) { return pixel[0] > 240 && pixel[2] > 245; }

/// Red far above blue, or blue far above red.
inline bool is_red(const Pixel& pixel) { return pixel[0] > pixel[2] + 60; }
inline bool is_blue(const Pixel& pixel) { return pixel[2] > pixel[0] + 60; }

inline int brightness(const Pixel& pixel) { return pixel[0] + pixel[1] + pixel[2]; }

/// Pixels of an image that have a property.
template <typename Property>
int count(const Image& image, Property property) {
  int number = 0;
  for (const Pixel& pixel : image.pixels) number += property(pixel) ? 1 : 0;
  return number;
}

/// Where a point is seen, in parts of half the picture from its middle: x right, y up.
inline Eigen::Vector2d seen_at(const Camera& camera, double aspect, const Point& point) {
  const Eigen::Vector4d clip = camera.projection(aspect) * camera.view() * point.homogeneous();
  return clip.head<2>() / clip.w();
}

/// The pixel where a point is seen.
inline std::array<int, 2> pixel_of(const Camera& camera, const Image& image, const Point& point) {
  const double aspect = static_cast<double>(image.width) / image.height;
  const Eigen::Vector2d place = seen_at(camera, aspect, point);
  return {static_cast<int>((1 + place.x()) / 2 * image.width),
          static_cast<int>((1 - place.y()) / 2 * image.height)};
}

}  // namespace hwffd::picture
