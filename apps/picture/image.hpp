#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace hwffd::picture {

/// Red, green and blue, 0 to 255.
using Pixel = std::array<std::uint8_t, 3>;

/// A picture in memory: height rows of width pixels, the top row first.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Pixel> pixels;  ///< width * height

  const Pixel& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// Half the width and half the height: each pixel the rounded mean of four.
/// @param image  of even width and height, unchecked
Image halved(const Image& image);

/// Pictures of one size in rows of `columns`, in reading order; places left over are white.
/// @throws Error if there is no picture, no column, or the sizes differ
Image contact_sheet(const std::vector<Image>& images, int columns);

/// All in one row, from left to right.
/// @throws Error as contact_sheet() does
Image strip(const std::vector<Image>& images);

}  // namespace hwffd::picture
