#include "picture/png.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include "errors.hpp"
#include "temp_folder.hpp"

namespace hwffd::picture {
namespace {

Image decoded(const std::string& bytes) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()), 0);
  EXPECT_EQ(header.format, static_cast<png_uint_32>(PNG_FORMAT_RGB)) << "as it is in the file";
  Image image{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  image.pixels.resize(std::size_t{header.width} * header.height);
  EXPECT_NE(png_image_finish_read(&header, nullptr, image.pixels.data(), 0, nullptr), 0);
  return image;
}

Image pattern() {
  Image image{37, 11, {}};
  for (int i = 0; i < 37 * 11; ++i) {
    image.pixels.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i * 7),
                            static_cast<std::uint8_t>(i * 31 / 5)});
  }
  return image;
}

TEST(Png, ComesBackPixelForPixel) {
  const Image image = pattern();
  const TempFolder folder;
  write_png(folder / "a.png", image);
  const Image again = decoded(read_text(folder / "a.png"));
  EXPECT_EQ(again.width, 37);
  EXPECT_EQ(again.height, 11);
  EXPECT_EQ(again.pixels, image.pixels);
  EXPECT_EQ(folder.files(), std::set<std::string>{"a.png"});
}

TEST(Png, EqualPicturesGiveEqualBytes) {
  EXPECT_EQ(png_bytes(pattern()), png_bytes(pattern()));
  Image other = pattern();
  other.pixels.back()[2] ^= 1;
  EXPECT_NE(png_bytes(other), png_bytes(pattern()));
}

TEST(Png, ErrorsNameTheThing) {
  EXPECT_ERROR_PART(png_bytes({}), "picture of 0x0 pixels");
  EXPECT_ERROR_PART(write_png("/nowhere/a.png", pattern()), "/nowhere/a.png");
}

}  // namespace
}  // namespace hwffd::picture
