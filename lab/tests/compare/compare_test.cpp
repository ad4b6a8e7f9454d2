// What `make compare` evaluates, and what it calls wrong: it ends with 1 where that is not empty.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/report.hpp"

namespace hwffd::compare {
namespace {

constexpr std::size_t kVertices = 2000;

TEST(CompareScene, EveryFormatHoldsItsNumbers) {
  const Scene scene = random_scene(kVertices, 1);
  const auto is_held = [](double number) {
    return std::ldexp(number, 16) == std::rint(std::ldexp(number, 16));
  };
  const Points& points = scene.lattice.points();
  EXPECT_TRUE(std::all_of(points.data(), points.data() + points.size(), is_held));
  EXPECT_EQ(points.maxCoeff(), 1 - std::ldexp(1.0, -16));
  EXPECT_EQ(points.minCoeff(), -points.maxCoeff());
  for (const Embedded& vertex : scene.vertices) {
    for (Eigen::Index a = 0; a < 3; ++a) EXPECT_TRUE(is_held(vertex.local[a]));
  }
}

TEST(CompareScene, SortedItHasTheSameVerticesByCell) {
  const Scene scene = random_scene(kVertices, 2);
  const Scene sorted = sorted_by_cell(scene);
  const auto by_cell = [](const Embedded& a, const Embedded& b) { return a.cell < b.cell; };
  EXPECT_FALSE(std::is_sorted(scene.vertices.begin(), scene.vertices.end(), by_cell));
  EXPECT_TRUE(std::is_sorted(sorted.vertices.begin(), sorted.vertices.end(), by_cell));
  EXPECT_NEAR(sorted.exact.sum(), scene.exact.sum(), 1e-9);
  EXPECT_EQ(largest_error(scene, scene.exact), 0);
  EXPECT_GT(largest_error(scene, sorted.exact), 0.1);
  EXPECT_EQ(first_of(sorted, 7).vertices.size(), 7U);
  EXPECT_EQ(first_of(sorted, 7).exact, sorted.exact.topRows(7));
}

TEST(CompareScene, ItsFilesAreReadAsTheyWereWritten) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "compare_scene";
  const Scene scene = random_scene(50, 3);
  write_scene(scene, folder);
  std::ifstream file(folder / "exact.f64", std::ios::binary);
  std::array<double, 3> first{};
  file.read(reinterpret_cast<char*>(first.data()), sizeof first);
  EXPECT_EQ(first,
            (std::array<double, 3>{scene.exact(0, 0), scene.exact(0, 1), scene.exact(0, 2)}));
  EXPECT_EQ(std::filesystem::file_size(folder / "cells.i32"), 50 * 3 * 4U);
  EXPECT_EQ(std::filesystem::file_size(folder / "points.f64"), 16 * 16 * 16 * 3 * 8U);
  std::filesystem::remove_all(folder);
}

TEST(CompareScene, ALostResultIsAnErrorOfItsOwn) {
  const Scene scene = random_scene(10, 4);
  EXPECT_ANY_THROW(largest_error(scene, scene.exact.topRows(9)));
  Points spoilt = scene.exact;
  spoilt(3, 1) = std::nan("");
  EXPECT_EQ(largest_error(scene, spoilt), HUGE_VAL);
}

TEST(CompareScene, AGridIsHeldByEveryFormatToo) {
  const Scene scene = random_scene(1, 6);
  const GridScene grid = grid_scene(scene.lattice, 1100);
  EXPECT_EQ(grid.grid.count, (std::array<std::uint16_t, 3>{10, 10, 10}));
  ASSERT_EQ(grid.scene.vertices.size(), 1000U);
  for (const Embedded& vertex : grid.scene.vertices) {
    for (Eigen::Index a = 0; a < 3; ++a) {
      EXPECT_EQ(std::ldexp(vertex.local[a], 16), std::rint(std::ldexp(vertex.local[a], 16)));
    }
  }
  EXPECT_EQ(grid.scene.vertices.front().cell, (Index3{0, 0, 0}));
  EXPECT_EQ(grid.scene.vertices.back().cell, (Index3{12, 12, 12}));
}

TEST(CompareSoftware, AWalkerAndItsDeviceHaveTheSameError) {
  const GridScene grid = grid_scene(random_scene(1, 7).lattice, 4096);
  for (const char* row : {"walk-fx17-overlapped", "factored-fp32-overlapped"}) {
    const SoftwareRow walked = walker(row, grid, 0.001);
    const SoftwareRow device = grid_device(row, grid, 0.001);
    EXPECT_GT(walked.error, 0) << row;
    EXPECT_EQ(walked.error, device.error) << row;
    EXPECT_LE(walked.error, walked.bound) << row;
    EXPECT_GT(walked.vertices_per_s, 0) << row;
  }
}

TEST(CompareCore, LatencyIsThatOfTheInterface) {
  const Scene scene = random_scene(40, 5);
  const CoreRow row = count(find_configuration("basic-fx18-overlapped"), scene, false, 1);
  EXPECT_EQ(row.failure, "");
  EXPECT_EQ(row.clocks_per_vertex, 64);
  EXPECT_EQ(row.latency_clocks, 97U);  // docs/datasheet.md section 4
  EXPECT_EQ(row.bytes_per_vertex, 16 * (40 + 1 + 40) / 40.0);
  EXPECT_GT(row.error, 0);
  EXPECT_LE(row.error, row.bound);
}

Measured good() {
  SoftwareRow program;
  program.what = "a program";
  program.vertices_per_s = 1e6;
  program.error = program.bound = 1e-7;
  CoreRow core{};
  core.row.name = "a core";
  core.clocks_per_vertex = 3;
  core.latency_clocks = 50;
  core.error = core.bound = 1e-4;
  return {1000, {program}, {core}};
}

/// Whether one fault is said, with this text in it.
bool says(void (*spoil)(Measured&), const std::string& part) {
  Measured measured = good();
  spoil(measured);
  const std::string text = faults(measured);
  return text.find(part) != std::string::npos && text.find('\n') == text.size() - 1;
}

TEST(CompareFaults, EachIsSaid) {
  EXPECT_EQ(faults(good()), "");
  EXPECT_TRUE(says([](Measured& m) { m.software.clear(); }, "no program was measured"));
  EXPECT_TRUE(says([](Measured& m) { m.software[0].vertices_per_s = 0; }, "a program: no vertex"));
  EXPECT_TRUE(
      says([](Measured& m) { m.software[0].vertices_per_s = NAN; }, "a program: no vertex"));
  EXPECT_TRUE(says([](Measured& m) { m.software[0].error = 2e-7; }, "a program: error 2.00e-07"));
  EXPECT_TRUE(says([](Measured& m) { m.cores[0].failure = "watchdog"; }, "a core: watchdog"));
  EXPECT_TRUE(says([](Measured& m) { m.cores[0].mismatches = 3; }, "3 results differ"));
  EXPECT_TRUE(says([](Measured& m) { m.cores[0].clocks_per_vertex = 0; }, "no clock was counted"));
  EXPECT_TRUE(says([](Measured& m) { m.cores[0].latency_clocks = 0; }, "no clock was counted"));
  EXPECT_TRUE(says([](Measured& m) { m.cores[0].error = HUGE_VAL; }, "a core: error inf"));
}

TEST(CompareReport, HasARowOfEach) {
  const auto report = nlohmann::json::parse(json_report(good()));
  EXPECT_EQ(report["vertices"], 1000);
  EXPECT_EQ(report["software"][0]["what"], "a program");
  EXPECT_EQ(report["cores"][0]["latency_clocks"], 50);
}

}  // namespace
}  // namespace hwffd::compare
