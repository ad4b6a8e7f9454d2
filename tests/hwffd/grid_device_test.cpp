// Regular grids on devices: a core with grids makes the vertices of one packet, and gives the bits
// of its model and of the same places one by one.
#include <gtest/gtest.h>

#include "Vfeatures_cg1_expanded.h"
#include "device/stream_device.hpp"
#include "hwffd/cores/verilated_stream_core.hpp"
#include "hwffd/device/deformable_lattice.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/on_threads.hpp"
#include "sample_lattices.hpp"

namespace hwffd {
namespace {

constexpr const char* kRow = "cg1-fx18-overlapped";

Lattice twisted(const Index3& dims) {
  return Deformation::parse("twist:60").apply(lattice_around("box", test::corners(), dims));
}

/// From a place in the first cell to the last face, another way along t.
Grid some_grid(const Lattice& lattice) {
  const Index3 cells = lattice.cells();
  return grid_between({0.3, static_cast<double>(cells[1]), 0.1},
                      {static_cast<double>(cells[0]), 0.2, cells[2] - 0.05}, {13, 9, 11}, 0xFF00);
}

/// Passes on what a stream is told, and counts it.
class Heard final : public CommandStream {
 public:
  Heard(std::unique_ptr<CommandStream> stream, std::size_t& beats)
      : stream_(std::move(stream)), beats_(beats) {}
  std::vector<Beat> run(const std::vector<Beat>& commands, std::size_t results,
                        const Progress& progress, std::size_t steps) override {
    beats_ += commands.size();
    return stream_->run(commands, results, progress, steps);
  }
  void reset() override { stream_->reset(); }
  PointStore store() const override { return stream_->store(); }
  bool has_grids() const override { return stream_->has_grids(); }

 private:
  std::unique_ptr<CommandStream> stream_;
  std::size_t& beats_;
};

struct Evaluated {
  Points positions;
  std::size_t beats = 0;
};

Evaluated evaluated(std::unique_ptr<CommandStream> stream, const Lattice& lattice,
                    const Grid& grid) {
  Evaluated result;
  StreamDevice device("heard", find_configuration(kRow),
                      std::make_unique<Heard>(std::move(stream), result.beats));
  result.positions = device.evaluate_grid(lattice, grid);
  return result;
}

std::unique_ptr<CommandStream> rtl_with_grids() {
  using Core = cores::VerilatedStreamCore<Vfeatures_cg1_expanded>;
  return rtl_stream(std::make_unique<Core>(1), kRow, {}, true);
}

TEST(GridDevice, RtlAndModelGiveTheBitsOfPlacesOneByOneOfOnePacket) {
  const Configuration& row = find_configuration(kRow);
  const Lattice lattice = twisted({6, 5, 7});
  const Grid grid = some_grid(lattice);
  const std::vector<Embedded> places = places_of(grid, lattice.cells());
  ASSERT_EQ(places.size(), 13U * 9 * 11);
  StreamDevice plain("model", row, model_stream(row));
  const Points expected = plain.evaluate(lattice, places);
  const Evaluated rtl = evaluated(rtl_with_grids(), lattice, grid);
  const Evaluated model = evaluated(model_stream(row, {}, true), lattice, grid);
  const Evaluated single = evaluated(model_stream(row), lattice, grid);
  EXPECT_EQ(rtl.positions, expected);
  EXPECT_EQ(model.positions, expected);
  EXPECT_EQ(single.positions, expected);
  EXPECT_EQ(rtl.beats, model.beats);
  // In place of four beats, a header for each 1,024 vertices and a beat for each of them.
  EXPECT_EQ(single.beats - rtl.beats, 2 + places.size() - 4);
  const Points exact = make_device({"reference"})->evaluate_grid(lattice, grid);
  EXPECT_LT((expected - exact).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_EQ(exact, make_device({"reference"})->evaluate(lattice, places));
}

// s fastest, from the first place to the last.
TEST(GridDevice, PlacesAreInTheOrderOfResults) {
  const std::vector<Embedded> places =
      places_of(grid_between({0, 0.5, 2}, {2, 0.5, 1}, {5, 1, 3}), {2, 1, 3});
  ASSERT_EQ(places.size(), 15U);
  for (std::size_t v = 0; v < places.size(); ++v) {
    const double s = 0.5 * static_cast<double>(v % 5);
    const std::size_t line = v / 5;
    const double u = 2 - 0.5 * static_cast<double>(line);
    EXPECT_EQ(places[v].cell[0] + places[v].local[0], s) << v;
    EXPECT_EQ(places[v].cell[1] + places[v].local[1], 0.5) << v;
    EXPECT_EQ(places[v].cell[2] + places[v].local[2], u) << v;
  }
}

// A lattice that the core does not keep whole goes by pages, with vertices.
TEST(GridDevice, LargeLatticesHaveTheSameBits) {
  const Configuration& row = find_configuration(kRow);
  const Lattice lattice = twisted({40, 5, 20});
  const Grid grid = some_grid(lattice);
  StreamDevice plain("model", row, model_stream(row));
  const Points expected = plain.evaluate(lattice, places_of(grid, lattice.cells()));
  EXPECT_EQ(evaluated(rtl_with_grids(), lattice, grid).positions, expected);
  EXPECT_EQ(evaluated(model_stream(row, {16, 4}, true), lattice, grid).positions, expected);
}

// Models of rows that contract one axis after the other go along the grid's rows, on any number of
// threads, and lattices of any size whole; a stream of the places has the same bits.
TEST(GridDevice, ModelsThatWalkGiveTheBitsOfPlacesOneByOne) {
  std::uint64_t saturated = 0;
  for (const auto& [org, format] : {std::pair{"walk", "fx17"},
                                    {"walk-fx17-overlapped-powers", ""},
                                    {"affine", "fx32"},
                                    {"factored", "fx18"},
                                    {"factored", "fp32"},
                                    {"factored", "bfp32"},
                                    {"basic", "fx18"}}) {
    for (const Index3& dims : {Index3{6, 5, 7}, Index3{40, 5, 20}}) {
      const Lattice lattice = twisted(dims);
      const Grid grid = some_grid(lattice);
      const std::vector<Embedded> places = places_of(grid, lattice.cells());
      const auto by_place = make_device({"model", org, format});
      const Points expected = by_place->evaluate(lattice, places);
      for (const std::size_t threads : {1, 3}) {
        set_thread_count(threads);
        const auto device = make_device({"model", org, format});
        double done = 0;
        device->on_progress([&](double fraction) { done = fraction; });
        EXPECT_EQ(device->evaluate_grid(lattice, grid), expected) << org << " " << threads;
        EXPECT_EQ(done, 1) << org;
        EXPECT_EQ(device->counts().vertices, places.size()) << org;
        EXPECT_EQ(device->counts().saturated, by_place->counts().saturated) << org;
      }
      set_thread_count(0);
      saturated += by_place->counts().saturated;
    }
  }
  EXPECT_EQ(saturated, 0U);
}

/// Four functions, each so many times a Bernstein polynomial: of more than one they make points
/// beyond the lattice, which fixed point does not hold.
Device::Blending larger_blending(double times) {
  const Oracle::Coefficients larger = times * Oracle::family("bernstein");
  return {larger, larger, larger};
}

TEST(GridDevice, ModelsThatWalkCountWhatSaturates) {
  const Lattice lattice = twisted({6, 5, 7});
  const Grid grid = some_grid(lattice);
  const auto walking = make_device({"model", "factored", "fx18"});
  const auto by_place = make_device({"model", "factored", "fx18"});
  EXPECT_EQ(walking->evaluate_grid(lattice, grid, larger_blending(1.3)),
            by_place->evaluate(lattice, places_of(grid, lattice.cells()), larger_blending(1.3)));
  EXPECT_GT(walking->counts().saturated, 10U);
  EXPECT_EQ(walking->counts().saturated, by_place->counts().saturated);
  const auto affine = make_device({"model", "walk", "fx17"});
  EXPECT_THROW(affine->evaluate_grid(lattice, grid, larger_blending(1.3)), Error);
}

TEST(GridDevice, FamiliesAreEvaluatedAtTheirOwnCells) {
  for (const char* name : {"bspline", "clamped", "bernstein", "catmull-rom", "linear"}) {
    DeformableLattice lattice(lattice_around("box", test::corners(), {7, 4, 7}),
                              Family::parse(name));
    lattice.deform("twist:40");
    lattice.set_device({"reference"});
    const Index3 cells = lattice.family().cells({7, 4, 7});
    const Grid grid = grid_between(
        {0, 0, 0}, {static_cast<double>(cells[0]), 1, static_cast<double>(cells[2])}, {9, 4, 6});
    EXPECT_EQ(lattice.evaluate_grid(grid), lattice.evaluate(places_of(grid, cells))) << name;
  }
}

TEST(GridDevice, GridsThatLeaveTheLatticeAreRefused) {
  const Lattice lattice = twisted({5, 4, 6});
  for (const char* kind : {"model", "reference"}) {
    const auto device = make_device({kind});
    for (const Grid& grid : {grid_between({0, 0, 0}, {2, 1, 3.01}, {3, 3, 3}),
                             grid_between({0, 1.5, 0}, {2, 1, 3}, {3, 3, 3}), Grid{}}) {
      EXPECT_THROW(device->evaluate_grid(lattice, grid), Error);
    }
    EXPECT_EQ(device->evaluate_grid(lattice, grid_between({0, 0, 0}, {2, 1, 3}, {3, 3, 3})).rows(),
              27);
  }
}

}  // namespace
}  // namespace hwffd
