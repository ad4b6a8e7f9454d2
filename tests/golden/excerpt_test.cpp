#include "hwffd/excerpt.hpp"

#include <gtest/gtest.h>

namespace hwffd {
namespace {

TEST(Excerpt, KeepsWhatIsPrintableAndShort) {
  EXPECT_EQ(excerpt(""), "");
  EXPECT_EQ(excerpt("twist:90 ~"), "twist:90 ~");
  EXPECT_EQ(excerpt(std::string(60, 'x')), std::string(60, 'x'));
}

TEST(Excerpt, WritesOtherBytesInHex) {
  EXPECT_EQ(excerpt(std::string_view("a\nb\0c\x7f\xc3", 7)), "a\\x0ab\\x00c\\x7f\\xc3");
}

/// Never in the middle of a byte's hex.
TEST(Excerpt, CutsLongTexts) {
  EXPECT_EQ(excerpt(std::string(61, 'x')), std::string(57, 'x') + "...");
  EXPECT_EQ(excerpt("abcdefgh", 8), "abcdefgh");
  EXPECT_EQ(excerpt("abcdefghi", 8), "abcde...");
  EXPECT_EQ(excerpt("abc\n\n\n", 8), "abc...");
  EXPECT_EQ(excerpt("abc\n\n\n", 11), "abc\\x0a...");
  EXPECT_EQ(excerpt(std::string(1000000, '\n')).size(), 59u);
}

}  // namespace
}  // namespace hwffd
