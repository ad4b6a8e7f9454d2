// Names beside crowded marks, read back from the SVG that they become.

#include "labels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace hwffd::svg {
namespace {

struct Read {
  double x, y;
  char anchor[8];
};

Read read(const std::string& text) {
  Read read{};
  EXPECT_EQ(std::sscanf(text.c_str(),
                        "<text x=\"%lf\" y=\"%lf\" font-size=\"10\" text-anchor=\"%7[a-z]\"",
                        &read.x, &read.y, read.anchor),
            3)
      << text;
  return read;
}

/// Where a text of a width begins.
double left(const Read& read, double width) {
  const std::string anchor = read.anchor;
  return read.x - (anchor == "end" ? width : anchor == "middle" ? width / 2 : 0);
}

TEST(Labels, ALoneOneIsAboveOrBelow) {
  Labels labels;
  labels.keep_free(100, 100);
  const Read above = read(labels.beside(100, 100, "above", "red", true));
  EXPECT_STREQ(above.anchor, "middle");
  EXPECT_EQ(above.x, 100);
  EXPECT_LT(above.y, 95);
  EXPECT_GT(read(labels.beside(100, 100, "below", "red", false)).y, 105);
}

// Five marks within five pixels: any two names are a line apart or lie side by side.
TEST(Labels, CrowdedOnesDoNotMeet) {
  Labels labels;
  for (int i = 0; i < 5; ++i) labels.keep_free(100 + i, 100 + i);
  std::vector<Read> all;
  for (int i = 0; i < 5; ++i) {
    all.push_back(read(labels.beside(100 + i, 100 + i, "a name", "red", true)));
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      constexpr double kWidth = 36;  // "a name"
      const double aside = std::abs(left(all[i], kWidth) - left(all[j], kWidth));
      EXPECT_TRUE(aside >= kWidth || std::abs(all[i].y - all[j].y) > 10) << i << " and " << j;
    }
  }
}

// A line that goes up to the right leaves the place to the left of it.
TEST(Labels, ALineIsNotCovered) {
  Labels labels;
  labels.keep_free(100, 100);
  labels.keep_free(100, 100, 200, 0);
  EXPECT_STREQ(read(labels.beside(100, 100, "a name", "red", true)).anchor, "end");
}

}  // namespace
}  // namespace hwffd::svg
