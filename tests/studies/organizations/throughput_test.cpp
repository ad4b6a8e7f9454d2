// Areas, rates and the rows that no other beats, of a report made here.
#include "throughput.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "hwffd/error.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/tb/random.hpp"
#include "pareto.hpp"
#include "reference.hpp"
#include "synthesis.hpp"

namespace hwffd::organizations {
namespace {

class Report : public ::testing::Test {
 protected:
  ~Report() override { std::filesystem::remove(path_); }

  Areas read(const std::string& text) {
    std::ofstream(path_) << text;
    return read_areas(path_);
  }

  std::filesystem::path path_ = ::testing::TempDir() + "throughput_test_synth.json";
};

TEST_F(Report, SizesOfOrganizationsOnly) {
  const Areas areas = read(R"({"rows": [
    {"name": "a", "top": "ffd_org_select", "target": "ecp5", "lut": 900, "dsp": 8, "fmax_mhz": 120},
    {"name": "a", "top": "hwffd_stream", "target": "ecp5", "lut": 3000, "dsp": 8, "fmax_mhz": 100},
    {"name": "a", "top": "ffd_org_select", "target": "osu018", "lut": null, "area_um2": 5e5,
     "cells": 9000, "dsp": null, "fmax_mhz": null},
    {"name": "a", "top": "ffd_org_select", "target": "generic", "lut": null, "cells": 9000}]})");
  ASSERT_EQ(areas.size(), 1U);
  const std::vector<Area>& found = areas.at("a");
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].size, 900);
  EXPECT_EQ(found[0].multipliers, 8);
  EXPECT_EQ(found[0].clock_mhz, 120);
  EXPECT_EQ(found[1].unit, "um2");
  EXPECT_EQ(found[1].size, 5e5);
  EXPECT_FALSE(found[1].clock_mhz);
  EXPECT_EQ(found[2].unit, "cells");
  EXPECT_FALSE(found[2].multipliers);
}

TEST_F(Report, MissingOrBroken) {
  EXPECT_TRUE(read_areas("/nowhere/synth.json").empty());
  EXPECT_NE(area_table({}).find("make synth"), std::string::npos);
  for (const char* text : {"", "{}", "[]", R"({"rows": [{}]})", R"({"rows": 3})"}) {
    EXPECT_THROW(read(text), Error) << text;
  }
}

Throughput row(const char* name, double size, std::optional<double> mhz, double interval) {
  return {name, name, "fx18", {"ecp5", "LUTs", size, 8, mhz}, interval};
}

TEST(Throughput, Rates) {
  const Throughput timed = row("a", 1000, 128, 64);
  EXPECT_DOUBLE_EQ(timed.per_second().value(), 2e6);
  EXPECT_DOUBLE_EQ(timed.per_size(), 2000);
  EXPECT_DOUBLE_EQ(timed.per_multiplier().value(), 250'000);
  Throughput untimed = row("b", 1000, std::nullopt, 4);
  EXPECT_FALSE(untimed.per_second());
  EXPECT_DOUBLE_EQ(untimed.rate(), 0.25);
  untimed.area.multipliers = 0;
  EXPECT_FALSE(untimed.per_multiplier());
}

TEST(Throughput, TheFrontIsWhatNoOtherBeats) {
  const std::vector<Throughput> rows = {row("large", 5000, 100, 1), row("small", 500, 100, 64),
                                        row("beaten", 900, 90, 64), row("slower", 500, 50, 64),
                                        row("untimed", 9000, std::nullopt, 8)};
  std::vector<std::string> names;
  for (const Throughput* best : front(rows)) names.push_back(best->name);
  EXPECT_EQ(names, (std::vector<std::string>{"small", "large", "untimed"}));
}

TEST(Throughput, TableAndPictureNameEveryRow) {
  const std::vector<Throughput> rows = {row("large", 5000, 100, 1), row("small", 500, 100, 64),
                                        row("beaten", 900, 90, 64)};
  const std::string text = area_table(rows);
  const std::string picture = pareto_chart(rows);
  for (const Throughput& each : rows) {
    EXPECT_NE(text.find(each.name), std::string::npos) << each.name;
    EXPECT_NE(picture.find(each.name + ":"), std::string::npos) << each.name;
  }
  EXPECT_EQ(picture.find(">beaten fx18<"), std::string::npos);
  EXPECT_NE(picture.find(">large fx18<"), std::string::npos);
}

// What the simulations are timed against does what they do.
TEST(Reference, IsEquationOne) {
  tb::Random random(1);
  const Oracle oracle;
  for (int v = 0; v < 1000; ++v) {
    std::array<double, 192> points{};
    for (double& coordinate : points) coordinate = 2 * random.unit() - 1;
    const std::array<double, 3> local{random.unit(), random.unit(), random.unit()};
    Support support;
    for (int i = 0; i < 192; ++i) support(i / 3, i % 3) = points[i];
    const Point exact = oracle.evaluate(support, local[0], local[1], local[2]);
    const std::array<double, 3> found = reference_vertex(points, local);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], exact[c], 1e-14);
  }
  EXPECT_GT(reference_vertices_per_s(1000, 1), 0);
}

}  // namespace
}  // namespace hwffd::organizations
