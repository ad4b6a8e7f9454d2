#include "picture/image.hpp"

#include <gtest/gtest.h>

#include "errors.hpp"

namespace hwffd::picture {
namespace {

Image plain(int width, int height, const Pixel& colour) {
  return {width, height, std::vector<Pixel>(static_cast<std::size_t>(width * height), colour)};
}

TEST(Image, HalvedIsTheRoundedMeanOfFour) {
  const Image image{4,
                    2,
                    {{{1, 0, 255}},
                     {{2, 0, 255}},
                     {{9, 9, 9}},
                     {{9, 9, 9}},
                     {{3, 1, 255}},
                     {{4, 0, 255}},
                     {{9, 9, 9}},
                     {{9, 9, 13}}}};
  const Image half = halved(image);
  ASSERT_EQ(half.width, 2);
  ASSERT_EQ(half.height, 1);
  EXPECT_EQ(half.at(0, 0), (Pixel{3, 0, 255}));
  EXPECT_EQ(half.at(1, 0), (Pixel{9, 9, 10}));
}

TEST(Image, AStripOfThreeIsThreePicturesSideBySide) {
  const std::vector<Pixel> colours{{{10, 20, 30}}, {{40, 50, 60}}, {{70, 80, 90}}};
  const Image all =
      strip({plain(5, 3, colours[0]), plain(5, 3, colours[1]), plain(5, 3, colours[2])});
  ASSERT_EQ(all.width, 15);
  ASSERT_EQ(all.height, 3);
  int checked = 0;
  for (int y = 0; y < all.height; ++y) {
    for (int x = 0; x < all.width; ++x) {
      EXPECT_EQ(all.at(x, y), colours[static_cast<std::size_t>(x / 5)]) << x << " " << y;
      ++checked;
    }
  }
  EXPECT_EQ(checked, 45);
}

TEST(Image, ASheetRunsInReadingOrderAndEndsWhite) {
  const Image sheet =
      contact_sheet({plain(2, 2, {1, 1, 1}), plain(2, 2, {2, 2, 2}), plain(2, 2, {3, 3, 3})}, 2);
  ASSERT_EQ(sheet.width, 4);
  ASSERT_EQ(sheet.height, 4);
  EXPECT_EQ(sheet.at(1, 1), (Pixel{1, 1, 1}));
  EXPECT_EQ(sheet.at(2, 1), (Pixel{2, 2, 2}));
  EXPECT_EQ(sheet.at(1, 2), (Pixel{3, 3, 3}));
  EXPECT_EQ(sheet.at(2, 3), (Pixel{255, 255, 255}));
}

TEST(Image, SheetsRefuseOtherSizesAndNothing) {
  const Image image = plain(2, 2, {0, 0, 0});
  EXPECT_ERROR_PART(contact_sheet({image, plain(2, 3, {0, 0, 0})}, 2),
                    "picture 1 is 2x3, the first 2x2");
  EXPECT_ERROR_PART(contact_sheet({image}, 0), "1 pictures in 0 columns");
  EXPECT_ERROR_PART(strip({}), "0 pictures");
}

}  // namespace
}  // namespace hwffd::picture
