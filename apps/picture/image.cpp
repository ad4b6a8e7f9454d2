#include "picture/image.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hwffd/error.hpp"

namespace hwffd::picture {
namespace {

constexpr Pixel kWhite{255, 255, 255};

std::size_t offset(const Image& image, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
         static_cast<std::size_t>(x);
}

Image blank(int width, int height) {
  return {width, height,
          std::vector<Pixel>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                             kWhite)};
}

/// Copies `part` to where its left upper corner is at (x, y).
void paste(Image& onto, const Image& part, int x, int y) {
  for (int row = 0; row < part.height; ++row) {
    std::copy_n(&part.pixels[offset(part, 0, row)], part.width,
                &onto.pixels[offset(onto, x, y + row)]);
  }
}

}  // namespace

Image halved(const Image& image) {
  Image half = blank(image.width / 2, image.height / 2);
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        const int sum = image.at(2 * x, 2 * y)[c] + image.at(2 * x + 1, 2 * y)[c] +
                        image.at(2 * x, 2 * y + 1)[c] + image.at(2 * x + 1, 2 * y + 1)[c];
        half.pixels[offset(half, x, y)][c] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
    }
  }
  return half;
}

Image contact_sheet(const std::vector<Image>& images, int columns) {
  if (images.empty() || columns < 1) {
    throw Error(fmt::format("contact sheet: {} pictures in {} columns; give at least one of each",
                            images.size(), columns));
  }
  const int width = images.front().width;
  const int height = images.front().height;
  const int count = static_cast<int>(images.size());
  Image sheet = blank(width * columns, height * ((count + columns - 1) / columns));
  for (int i = 0; i < count; ++i) {
    const Image& image = images[static_cast<std::size_t>(i)];
    if (image.width != width || image.height != height) {
      throw Error(
          fmt::format("contact sheet: picture {} is {}x{}, the first {}x{}; give all one "
                      "size",
                      i, image.width, image.height, width, height));
    }
    paste(sheet, image, i % columns * width, i / columns * height);
  }
  return sheet;
}

Image strip(const std::vector<Image>& images) {
  return contact_sheet(images, static_cast<int>(images.size()));
}

}  // namespace hwffd::picture
