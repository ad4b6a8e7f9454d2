// Points as text, and the order of the options that make stages.

#include "geometry.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "errors.hpp"
#include "program.hpp"
#include "stages.hpp"
#include "temp_folder.hpp"

namespace hwffd::command {
namespace {

class Text : public testing::Test {
 protected:
  Geometry read(const std::string& text) {
    return Geometry::read(folder_.write("a.xyz", text).string());
  }
  std::string refused(const std::string& text) {
    return message_of<Error>([&] { read(text); });
  }

  TempFolder folder_;
};

TEST_F(Text, PointsAndComments) {
  const Geometry geometry = read("# three\n1 2 3\n\n  -4,5e-1;+6 # one more\r\n7\t8\t9");
  ASSERT_EQ(geometry.positions().rows(), 3);
  EXPECT_EQ(geometry.positions(), (Points(3, 3) << 1, 2, 3, -4, 0.5, 6, 7, 8, 9).finished());
  EXPECT_FALSE(geometry.is_mesh());
}

/// The mark before UTF-8, and only there.
TEST_F(Text, ByteOrderMark) {
  EXPECT_EQ(read("\xEF\xBB\xBF"
                 "1,2,3\n4,5,6\n")
                .positions(),
            (Points(2, 3) << 1, 2, 3, 4, 5, 6).finished());
  expect_part(refused("1 2 3\n\xEF\xBB\xBF"
                      "4 5 6\n"),
              "line 2 ");
}

TEST_F(Text, EveryDigitComesBack) {
  Geometry geometry = read("0.1 1e-300 3.141592653589793\n");
  geometry.write((folder_ / "b.xyz").string());
  EXPECT_EQ(Geometry::read((folder_ / "b.xyz").string()).positions(), geometry.positions());
}

TEST_F(Text, WhatIsNotThreeNumbersIsNamed) {
  for (const char* line : {"1 2", "1 2 x", "1 2 nan", "1 2 inf", "1 2 3a", "1 2 1e999"}) {
    expect_part(refused(std::string("0 0 0\n") + line + "\n"), "line 2 ");
  }
  for (const char* text : {"", "# nothing\n"}) expect_part(refused(text), "no points");
}

std::vector<StageText> stages_of(std::vector<std::string> words) {
  CLI::App app;
  const StageOptions options(app);
  std::vector<char*> argv;
  words.insert(words.begin(), "hwffd");
  for (std::string& word : words) argv.push_back(word.data());
  parse_command_line(app, static_cast<int>(argv.size()), argv.data());
  return options.texts();
}

TEST(Stages, OptionsBelongToTheLatticeBeforeThem) {
  const std::vector<StageText> stages =
      stages_of({"--deform", "twist:90", "--dims", "5x5x5", "--lattice", "sphere", "--deform",
                 "bend:1", "--deform=taper:2", "--lattice", "box", "--region", "0,0,0,1,1,1"});
  ASSERT_EQ(stages.size(), 3u);
  EXPECT_EQ(stages[0].lattice, "box");
  EXPECT_EQ(stages[0].dims, "5x5x5");
  EXPECT_EQ(stages[0].deformations, std::vector<std::string>{"twist:90"});
  EXPECT_EQ(stages[1].lattice, "sphere");
  EXPECT_EQ(stages[1].deformations, (std::vector<std::string>{"bend:1", "taper:2"}));
  EXPECT_EQ(stages[2].region, "0,0,0,1,1,1");
  EXPECT_TRUE(stages[2].deformations.empty());
  EXPECT_EQ(stages_of({}).size(), 1u);
}

TEST(Stages, WhatDoesNotBelongIsRefused) {
  EXPECT_THROW(stages_of({"--dims", "4x4x4", "--dims", "5x5x5"}), UsageError);
  EXPECT_THROW(stages_of({"--lattice", "file.json", "--dims", "4x4x4"}), UsageError);
  const Points unit = (Points(2, 3) << 0, 0, 0, 1, 1, 1).finished();
  for (const char* region : {"", "1", "0,0,0,1,1", "0,0,0,1,1,1,1", "0,0,0,1,1,nan", "0 0 0 1 1 1",
                             "0,0,0,0,0,0", "0,0,2,1,1,2"}) {
    StageText text;
    text.region = region;
    if (*region == '\0') {
      EXPECT_NO_THROW(given_lattice(text, unit));
    } else {
      EXPECT_THROW(given_lattice(text, unit), UsageError) << region;
    }
  }
}

}  // namespace
}  // namespace hwffd::command
