// Gradients pulled back on devices: the transpose of evaluation on the reference, the bits of the
// model of a scatter core, and who has it not.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "device/stream_device.hpp"
#include "errors.hpp"
#include "hwffd/device/deformable_lattice.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/model/scatter.hpp"
#include "hwffd/model/scatter_stream.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/stream/blending.hpp"
#include "sample_lattices.hpp"

namespace hwffd {
namespace {

struct GradientScene {
  explicit GradientScene(std::size_t count)
      : vertices(test::known_places(lattice, count, 1)),
        gradient(Points::Random(static_cast<Eigen::Index>(count), 3)) {}

  Lattice lattice =
      Deformation::parse("random:3").apply(lattice_around("box", test::corners(), {6, 5, 7}));
  std::vector<Embedded> vertices;
  Points gradient;
};

double largest_of(const Points& difference) { return difference.cwiseAbs().maxCoeff(); }

double sum_of_products(const Points& a, const Points& b) { return a.cwiseProduct(b).sum(); }

class PullBackDevice : public ::testing::Test {
 protected:
  ~PullBackDevice() override { set_thread_count(0); }
};

TEST_F(PullBackDevice, ReferenceIsTheTransposeInEveryFamily) {
  for (const std::string& name : Family::names()) {
    const Family family = Family::parse(name);
    const Lattice lattice({7, 4, 10}, lattice_around("box", test::corners(), {7, 4, 10}).points() +
                                          0.1 * Points::Random(280, 3));
    const Index3 cells = family.cells(lattice.dims());
    const Grid grid = grid_between({0, 0.3, 0}, {double(cells[0]), 1, double(cells[2])}, {9, 4, 6});
    const std::vector<Embedded> places = places_of(grid, cells);
    const Points gradient = Points::Random(9 * 4 * 6, 3);
    const auto device = make_device({"reference"});
    const Points pulled = device->pull_back(lattice.dims(), places, gradient, family);
    ASSERT_EQ(pulled.rows(), 280);
    EXPECT_NEAR(sum_of_products(device->evaluate(lattice, places, family), gradient),
                sum_of_products(lattice.points(), pulled), 1e-10)
        << name;
    EXPECT_EQ(device->pull_back_grid(lattice.dims(), grid, gradient, family), pulled) << name;
    const auto model = make_pull_back_device("model");
    const Points near = model->pull_back(lattice.dims(), places, gradient, family);
    EXPECT_LT(largest_of(near - pulled), 2e-2) << name;
    EXPECT_GT(largest_of(near - pulled), 0) << name;
    EXPECT_EQ(model->pull_back_grid(lattice.dims(), grid, gradient, family), near) << name;
    const auto core = make_pull_back_device("rtl");
    EXPECT_EQ(core->pull_back(lattice.dims(), places, gradient, family), near) << name;
  }
}

// More vertices than a page takes, so that several threads add several pages.
TEST_F(PullBackDevice, BitsDoNotDependOnThreadsOrOrder) {
  constexpr std::size_t kCount = 40000;
  const GradientScene scene(kCount);
  std::vector<Embedded> backwards(scene.vertices.rbegin(), scene.vertices.rend());
  const Points turned = scene.gradient.colwise().reverse();
  const Index3& dims = scene.lattice.dims();
  for (const std::string kind : {"reference", "model"}) {
    set_thread_count(1);
    const Points expected =
        make_pull_back_device(kind)->pull_back(dims, scene.vertices, scene.gradient);
    for (const std::size_t threads : {1, 2, 3, 5}) {
      set_thread_count(threads);
      const auto device = make_pull_back_device(kind);
      EXPECT_EQ(device->pull_back(dims, scene.vertices, scene.gradient), expected) << kind;
      EXPECT_EQ(device->pull_back(dims, backwards, turned), expected) << kind;
      EXPECT_EQ(device->counts().vertices, 2 * kCount);
      EXPECT_EQ(device->counts().saturated, 0U) << kind;
    }
  }
}

// Three pages of sums, one after the other, and what came before is no part of them.
TEST_F(PullBackDevice, TheSimulatedCoreHasTheBitsOfTheModel) {
  constexpr std::size_t kCount = 40000;
  const GradientScene scene(kCount);
  const Index3& dims = scene.lattice.dims();
  const Points expected =
      make_pull_back_device("model")->pull_back(dims, scene.vertices, scene.gradient);
  const auto core = make_pull_back_device("rtl");
  EXPECT_EQ(core->name(), "rtl scatter-fx17");
  const std::vector<Embedded> few = {{{0, 1, 0}, {0.25, 0.5, 1}}};
  EXPECT_TRUE(core->pull_back({4, 5, 16}, few, Points::Constant(1, 3, 2)).any());
  double shown = 0;
  core->on_progress([&](double done) { shown = done; });
  EXPECT_EQ(core->pull_back(dims, scene.vertices, scene.gradient), expected);
  EXPECT_EQ(shown, 1);
  EXPECT_EQ(core->counts().vertices, kCount + 1);
  EXPECT_EQ(core->counts().saturated, 0U);
  EXPECT_GE(core->counts().clocks, 3 * kCount);
  EXPECT_LT(core->counts().clocks, 3 * kCount + 10'000);
  const Grid grid = grid_between({0, 0.5, 0}, {3, 2, 4}, {9, 4, 6});
  const Points of_grid = scene.gradient.topRows(9 * 4 * 6);
  EXPECT_EQ(core->pull_back_grid(dims, grid, of_grid),
            core->pull_back(dims, places_of(grid, {3, 2, 4}), of_grid))
      << "place by place";
}

// In pages that share layers of points, each with the vertices of its cells.
TEST_F(PullBackDevice, TheSimulatedCoreTakesLatticesOfAnySize) {
  for (const Index3& dims : {Index3{17, 4, 5}, Index3{16, 16, 16}, Index3{5, 30, 21}}) {
    const Lattice lattice = lattice_around("box", test::corners(), dims);
    const std::vector<Embedded> places = test::known_places(lattice, 3000, 2);
    const Points gradient = Points::Random(3000, 3);
    EXPECT_EQ(make_pull_back_device("rtl")->pull_back(dims, places, gradient),
              make_pull_back_device("model")->pull_back(dims, places, gradient));
  }
}

// Several slices, one, or some rows of one a page; either way along each axis, small lattices and
// large ones.
TEST_F(PullBackDevice, TheSimulatedCoreHasTheBitsOfAModelByRows) {
  const auto core = make_pull_back_device("rtl", true);
  const auto model = make_pull_back_device("model", true);
  std::uint64_t vertices = 0;
  for (const auto& [dims, count] : {std::pair<Index3, Index3>{{9, 6, 7}, {41, 7, 9}},
                                    {{4, 4, 4}, {1, 1, 1}},
                                    {{32, 5, 4}, {130, 150, 3}},
                                    {{5, 20, 17}, {300, 60, 2}}}) {
    const std::array<double, 3> first = {0, dims[1] - 3.0, 0.25};
    const std::array<double, 3> last = {dims[0] - 3.0, 0, dims[2] - 3.5};
    const Grid grid = grid_between(first, last, count);
    const Points gradient = Points::Random(static_cast<Eigen::Index>(vertex_count(grid)), 3);
    EXPECT_EQ(core->pull_back_grid(dims, grid, gradient),
              model->pull_back_grid(dims, grid, gradient));
    vertices += vertex_count(grid);
  }
  EXPECT_EQ(core->counts().vertices, vertices);
  EXPECT_GE(core->counts().clocks, vertices);
  EXPECT_LT(core->counts().clocks, 2 * vertices);

  const GradientScene scene(500);
  const Index3& dims = scene.lattice.dims();
  EXPECT_EQ(core->pull_back(dims, scene.vertices, scene.gradient),
            make_pull_back_device("model")->pull_back(dims, scene.vertices, scene.gradient))
      << "vertices have the bits of vertices";
  const std::string refusal =
      "rtl scatter-fx17: takes by rows lattices of up to 32 points an axis, and rows of up to "
      "16384 "
      "vertices; take the device model";
  EXPECT_ERROR(core->pull_back_grid({33, 4, 4}, grid_between({0, 0, 0}, {1, 1, 1}, {2, 2, 2}),
                                    Points::Zero(8, 3)),
               refusal);
  EXPECT_ERROR(core->pull_back_grid({4, 4, 4}, grid_between({0, 0, 0}, {1, 1, 1}, {16'385, 1, 1}),
                                    Points::Zero(16'385, 3)),
               refusal);
}

TEST_F(PullBackDevice, TheSimulatedCoreTellsOfSaturation) {
  const GradientScene scene(20);
  Oracle::Coefficients steep = Oracle::Coefficients::Zero();
  steep(0, 0) = 4;  // no weight is as large
  steep(1, 0) = -3;
  const Device::Blending blending{steep, steep, steep};
  const Index3& dims = scene.lattice.dims();
  const auto core = make_pull_back_device("rtl");
  const auto model = make_pull_back_device("model");
  EXPECT_EQ(core->pull_back(dims, scene.vertices, scene.gradient, blending),
            model->pull_back(dims, scene.vertices, scene.gradient, blending));
  EXPECT_EQ(model->counts().saturated, 20U);
  EXPECT_EQ(core->counts().saturated, 1U) << "of one page";
}

TEST_F(PullBackDevice, TheSimulatedCoreDoesNothingElse) {
  const GradientScene scene(10);
  const auto core = make_pull_back_device("rtl");
  const char* const kRefusal =
      "rtl scatter-fx17: pulls gradients back, and evaluates nothing; take another device";
  EXPECT_ERROR(core->evaluate(scene.lattice, scene.vertices), kRefusal);
  EXPECT_ERROR(core->tangents(scene.lattice, scene.vertices), kRefusal);
  const Oracle::Coefficients bspline = Oracle::uniform_bspline();
  EXPECT_ERROR(core->evaluate(std::vector<SupportedVertex>(1), {bspline, bspline, bspline}),
               kRefusal);
}

/// What a page of the model has, added up vertex by vertex, in whole numbers.
Points added_by_model(const GradientScene& scene, const char* row, int exponent) {
  constexpr int kWidth = 17;
  const WordCodec codec("fx17");
  const auto scatter = model::make_scatter_model(find_configuration(row));
  for (int axis = 0; axis < 3; ++axis) {
    scatter->load(axis, encode(watertight_bspline(codec), codec));
  }
  model::ScatterPage page(kWidth, scene.lattice.dims());
  for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
    model::GradientWords words;
    words.cell = scene.vertices[v].cell;
    for (int c = 0; c < 3; ++c) {
      words.local[c] = codec.coordinate(scene.vertices[v].local[c]);
      words.gradient[c] =
          codec.point(std::ldexp(scene.gradient(static_cast<Eigen::Index>(v), c), -exponent));
    }
    page.add(words.cell, scatter->parts(words));
  }
  Points result(scene.lattice.points().rows(), 3);
  for (Eigen::Index point = 0; point < result.rows(); ++point) {
    for (int c = 0; c < 3; ++c) {
      result(point, c) = std::ldexp(
          static_cast<double>(page.sum(static_cast<std::size_t>(point), c)), exponent - kWidth + 1);
    }
  }
  return result;
}

TEST_F(PullBackDevice, ModelsHaveTheBitsOfAScatterCoreWithTheirWeights) {
  GradientScene scene(3000);
  scene.gradient *= 11;
  scene.gradient(7, 1) = 13;
  const Index3& dims = scene.lattice.dims();
  int rows = 0;
  for (const std::string& row : device_rows("model")) {
    if (!model::has_scatter(find_configuration(row))) continue;
    const auto device = make_device({"model", row});
    EXPECT_EQ(device->pull_back(dims, scene.vertices, scene.gradient),
              added_by_model(scene, row.c_str(), 4))
        << row;
    ++rows;
  }
  EXPECT_GT(rows, 8);
  const Points exact = make_device({"reference"})->pull_back(dims, scene.vertices, scene.gradient);
  EXPECT_LT(largest_of(exact - added_by_model(scene, "affine-fx17-overlapped", 4)), 0.05);
}

/// A model that pulls grids back by rows.
std::unique_ptr<Device> device_by_rows(const char* org = "affine") {
  DeviceChoice choice{"model", org, "fx17"};
  choice.rows = true;
  return make_device(choice);
}

// Those of the stream model of a core with rows, which collects whole numbers.
TEST_F(PullBackDevice, ModelsByRowsHaveTheBitsOfACoreWithRows) {
  const WordCodec codec("fx17");
  const Index3 dims = {9, 6, 7};
  const Grid grid = grid_between({0, 3, 1.5}, {6, 0.25, 4}, {41, 7, 9});
  const Points gradient = 0.9 * Points::Random(41 * 7 * 9, 3);
  std::vector<std::array<std::uint32_t, 3>> words;
  for (const auto& of_vertex : gradient.rowwise()) {
    words.push_back(
        {codec.point(of_vertex[0]), codec.point(of_vertex[1]), codec.point(of_vertex[2])});
  }
  for (const char* org : {"affine", "affine-fx17-overlapped-powers"}) {
    Gradients how;
    how.dims = dims;
    const bool powers = std::string(org) != "affine";
    model::ScatterStreamModel core(find_configuration(powers ? org : "affine-fx17-overlapped"), 16,
                                   1, true);
    core.run(coefficients_packet(watertight_bspline(codec), codec));
    core.run(gradients_packet(0, grid, words, how));
    Points expected(9 * 6 * 7, 3);
    const std::vector<Beat> results = core.run(collect_packet(0));
    ASSERT_EQ(results.size(), 9U * 6 * 7);
    for (Eigen::Index point = 0; point < expected.rows(); ++point) {
      for (int c = 0; c < 3; ++c) {
        const std::uint32_t word = results[static_cast<std::size_t>(point)].words[c];
        expected(point, c) = std::ldexp(static_cast<std::int32_t>(word), -16);
      }
    }
    const auto device = device_by_rows(org);
    EXPECT_EQ(device->pull_back_grid(dims, grid, gradient), expected) << org;
    EXPECT_EQ(device->counts().vertices, 41U * 7 * 9);
    const Points by_vertices =
        make_device({"model", org, "fx17"})->pull_back_grid(dims, grid, gradient);
    EXPECT_EQ(device->pull_back(dims, places_of(grid, {6, 3, 4}), gradient), by_vertices);
    const Points exact = make_device({"reference"})->pull_back_grid(dims, grid, gradient);
    EXPECT_GT(largest_of(expected - by_vertices), 0);
    EXPECT_LT(largest_of(expected - exact), largest_of(by_vertices - exact)) << org;
  }
}

// More rows than a page takes, and rows that are longer than pages.
TEST_F(PullBackDevice, BitsOfRowsDoNotDependOnThreads) {
  const Index3 dims = {8, 6, 7};
  for (const std::array<int, 3>& count :
       {std::array<int, 3>{300, 40, 12}, std::array<int, 3>{20'000, 3, 2}}) {
    const Grid grid = grid_between({5, 0, 0}, {0, 3, 4}, count);
    const Points gradient = Points::Random(static_cast<Eigen::Index>(vertex_count(grid)), 3);
    set_thread_count(1);
    const auto device = device_by_rows();
    const Points expected = device->pull_back_grid(dims, grid, gradient);
    EXPECT_EQ(device->counts().saturated, 0U);
    const Points exact = make_device({"reference"})->pull_back_grid(dims, grid, gradient);
    EXPECT_LT(largest_of(expected - exact), 0.2);
    for (const std::size_t threads : {2, 3, 5}) {
      set_thread_count(threads);
      EXPECT_EQ(device_by_rows()->pull_back_grid(dims, grid, gradient), expected) << threads;
    }
  }
}

// What vertices add sums to their gradients, to the bit of their words.
TEST_F(PullBackDevice, ModelsConserveGradients) {
  const GradientScene scene(2000);
  Points rounded = scene.gradient;
  rounded = rounded.unaryExpr([](double g) { return std::ldexp(std::floor(g * 0x1p12), -12); });
  const Points pulled =
      make_pull_back_device("model")->pull_back(scene.lattice.dims(), scene.vertices, rounded);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(pulled.col(c).sum(), rounded.col(c).sum());
}

// Gradients whose largest is a power of two, or just below one, saturate nothing.
TEST_F(PullBackDevice, GradientsOfAnySizeFit) {
  const std::vector<Embedded> corner = {{{0, 0, 0}, {1, 0, 1}}};
  for (const std::string kind : {"model", "rtl"}) {
    for (const double size :
         {1.0, -1.0, 1 - 0x1p-20, -1 + 0x1p-20, 0x1.fffep299, 0x1p-300, 1e-308}) {
      const auto device = make_pull_back_device(kind);
      const Points gradient = size * (Points(1, 3) << 1, -1, 0.25).finished();
      const Points pulled = device->pull_back({4, 4, 4}, corner, gradient);
      EXPECT_EQ(device->counts().saturated, 0U) << size;
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(pulled.col(c).sum() / size, gradient(0, c) / size, 0x1p-16) << size;
      }
    }
    EXPECT_TRUE(make_pull_back_device(kind)->pull_back({4, 4, 5}, {}, Points(0, 3)).isZero());
    EXPECT_TRUE(
        make_pull_back_device(kind)->pull_back({4, 4, 4}, corner, Points::Zero(1, 3)).isZero());
  }
}

TEST_F(PullBackDevice, WhatHasItNotSaysWhatHas) {
  const GradientScene scene(10);
  const Index3& dims = scene.lattice.dims();
  const auto pull = [&](const DeviceChoice& choice) {
    return make_device(choice)->pull_back(dims, scene.vertices, scene.gradient);
  };
  EXPECT_ERROR(pull({"rtl"}),
               "rtl basic-fp32-overlapped: its core evaluates, and adds no gradients up; name "
               "device rtl, model or reference where they are pulled back");
  EXPECT_ERROR(pull({"model"}),
               "model basic-fp32-overlapped: has no transpose; take organization affine and format "
               "fx17, or device reference");
  EXPECT_ERROR_PART(pull({"model", "affine", "fx32"}),
                    "has no transpose; take organization affine");
  EXPECT_THROW(make_pull_back_device("fpga"), UsageError);
  EXPECT_ERROR(make_pull_back_device("uio:0"),
               "uio:0: its core evaluates, and adds no gradients up; name device rtl, model or "
               "reference where they are pulled back");
  DeviceChoice choice{"model"};
  choice.rows = true;
  const Grid grid = grid_between({0, 0, 0}, {1, 1, 1}, {5, 2, 1});
  EXPECT_ERROR_PART(make_device(choice)->pull_back_grid(dims, grid, scene.gradient),
                    "has no transpose; take organization affine");
}

TEST_F(PullBackDevice, RefusesWhatItCannotAdd) {
  const GradientScene scene(10);
  const Index3& dims = scene.lattice.dims();
  for (const std::string kind : {"reference", "model", "rtl"}) {
    const auto device = make_pull_back_device(kind);
    Points gradient = scene.gradient;
    EXPECT_ERROR(device->pull_back(dims, scene.vertices, gradient.topRows(9)),
                 "gradient of 9 positions for 10 vertices; give a row for each");
    gradient(4, 1) = std::nan("");
    EXPECT_ERROR(device->pull_back(dims, scene.vertices, gradient), "gradient 4 is not finite");
    const Grid grid = grid_between({0, 0, 0}, {1, 1, 1}, {5, 2, 1});
    EXPECT_ERROR(device->pull_back_grid(dims, grid, gradient), "gradient 4 is not finite");
    EXPECT_ERROR(device->pull_back_grid(dims, grid, gradient.topRows(9)),
                 "gradient of 9 positions for 10 vertices; give a row for each");
    EXPECT_ERROR_PART(device->pull_back_grid({4, 4, 3}, grid, gradient), "4 x 4 x 3");
    EXPECT_ERROR_PART(
        device->pull_back_grid({4, 4, 4}, grid_between({0, 0, 0}, {1, 2, 1}, {5, 2, 1}), gradient),
        "is not within the 1 x 1 x 1 cells");
    std::vector<Embedded> away = scene.vertices;
    away[3].cell[2] = 4;
    EXPECT_ERROR_PART(device->pull_back(dims, away, scene.gradient), "vertex 3: cell");
    const Points largest = Points::Constant(10, 3, 1.7e308);
    const std::vector<Embedded> same(10, scene.vertices[0]);
    EXPECT_ERROR_PART(device->pull_back(dims, same, largest), "beyond what double holds");
  }
  const Oracle::Coefficients hermite = Oracle::hermite();
  EXPECT_ERROR_PART(
      make_pull_back_device("model")->pull_back(dims, scene.vertices, scene.gradient,
                                                Device::Blending{hermite, hermite, hermite}),
      "functions that sum to one only");
}

TEST_F(PullBackDevice, LatticesClampPlacesAndChooseWhatAdds) {
  const GradientScene scene(300);
  DeformableLattice lattice(scene.lattice);
  std::vector<Embedded> outside = scene.vertices;
  outside[0].local = {-0.5, 0.25, 1.5};
  std::vector<Embedded> inside = scene.vertices;
  inside[0].local = {0, 0.25, 1};
  const Index3& dims = scene.lattice.dims();
  for (const std::string kind : {"reference", "model", "rtl"}) {
    EXPECT_EQ(lattice.pull_back(outside, scene.gradient, kind),
              make_pull_back_device(kind)->pull_back(dims, inside, scene.gradient));
  }
  EXPECT_EQ(lattice.pull_back(outside, scene.gradient),
            lattice.pull_back(outside, scene.gradient, "reference"));
  lattice.set_device({"model", "affine/3", "fx17"});
  EXPECT_EQ(lattice.pull_back(outside, scene.gradient),
            lattice.pull_back(outside, scene.gradient, "model"));
  const Grid grid = grid_between({0, 0, 0}, {3, 2, 4}, {5, 6, 10});
  EXPECT_EQ(lattice.pull_back_grid(grid, scene.gradient),
            lattice.pull_back(places_of(grid, {3, 2, 4}), scene.gradient));
}

}  // namespace
}  // namespace hwffd
