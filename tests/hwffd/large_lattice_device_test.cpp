// Devices with lattices that are larger than their core keeps: results in the order of the
// vertices, with the bits of one lattice.
#include <gtest/gtest.h>

#include <functional>

#include "Vpages_cg1.h"
#include "device/stream_device.hpp"
#include "hwffd/cores/verilated_stream_core.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "sample_lattices.hpp"

namespace hwffd {
namespace {

/// Vertices all over a twisted lattice, in any order.
struct LargeScene {
  Lattice lattice =
      Deformation::parse("twist:60").apply(lattice_around("box", test::corners(), {40, 9, 27}));
  std::vector<Embedded> vertices = test::known_places(lattice, 3000, 1);
};

std::unique_ptr<Device> device_of(const std::string& format, int pages, int axis_points,
                                  const std::string& org = "basic") {
  return make_device({"model", org, format, pages, axis_points});
}

TEST(LargeLatticeDevice, PagesGiveTheBitsOfOneLattice) {
  const LargeScene scene;
  const Points exact = make_device({"reference"})->evaluate(scene.lattice, scene.vertices);
  for (const std::string format : {"fp32", "bfp32", "fx18"}) {
    // A core whose axis is long enough has it as one.
    const auto whole = device_of(format, 1, 64);
    const Points expected = whole->evaluate(scene.lattice, scene.vertices);
    EXPECT_LT((expected - exact).cwiseAbs().maxCoeff(), format == "fx18" ? 1e-3 : 1e-5) << format;
    const auto tangents = whole->tangents(scene.lattice, scene.vertices);
    for (const auto& [pages, axis_points] :
         {std::pair{0, 16}, {0, 32}, {1, 16}, {4, 16}, {30, 16}, {2, 32}, {3, 9}}) {
      const auto device = device_of(format, pages, axis_points);
      for (int again = 0; again < 2; ++again) {
        EXPECT_EQ(device->evaluate(scene.lattice, scene.vertices), expected)
            << format << " " << pages << " pages of " << axis_points;
      }
      const auto got = device->tangents(scene.lattice, scene.vertices);
      EXPECT_EQ(got.positions, tangents.positions);
      EXPECT_EQ(got.jacobians, tangents.jacobians);
    }
  }
}

TEST(LargeLatticeDevice, OtherLatticesAndOtherPointsAreSeen) {
  const LargeScene scene;
  const Lattice moved = Deformation::parse("bend:40").apply(scene.lattice);
  const Lattice small =
      Deformation::parse("random:2").apply(lattice_around("box", test::corners(), {5, 6, 7}));
  const auto places = test::known_places(small, 300, 2);
  const auto device = device_of("fp32", 3, 16), fresh = device_of("fp32", 0, 16);
  for (int turn = 0; turn < 2; ++turn) {
    for (const Lattice* lattice : {&scene.lattice, &moved}) {
      EXPECT_EQ(device->evaluate(*lattice, scene.vertices),
                fresh->evaluate(*lattice, scene.vertices));
      EXPECT_EQ(device->evaluate(small, places), fresh->evaluate(small, places));
    }
  }
}

// The RTL without pages, and with four; fixed point has the same bits in every product form.
TEST(LargeLatticeDevice, RtlGivesTheBitsOfItsModel) {
  const LargeScene scene;
  const Points expected =
      device_of("fx18", 1, 64, "basic")->evaluate(scene.lattice, scene.vertices);
  const auto plain = make_device({"rtl", "basic", "fx18"});
  EXPECT_EQ(plain->evaluate(scene.lattice, scene.vertices), expected);
  const Configuration& row = find_configuration("basic-fx18-overlapped");
  const PointStore store{16, 4};
  StreamDevice paged(
      "rtl", row,
      rtl_stream(std::make_unique<cores::VerilatedStreamCore<Vpages_cg1>>(1), row.name, store));
  const Lattice four = lattice_around("box", test::corners(), {24, 24, 16});
  const auto places = test::known_places(four, 40, 3);
  const Points still = plain->evaluate(four, places);
  EXPECT_EQ(paged.evaluate(scene.lattice, scene.vertices), expected);
  EXPECT_EQ(paged.evaluate(four, places), still);
  const std::uint64_t before = paged.counts().clocks;
  EXPECT_EQ(paged.evaluate(four, places), still);
  // All its pages are there: no lattice of some 3,000 points comes again.
  EXPECT_LT(paged.counts().clocks - before, 40 * 64 + 1000U);
}

/// A model whose answer is spoilt.
class SpoiltPageStream final : public CommandStream {
 public:
  SpoiltPageStream(const Configuration& row, const PointStore& store,
                   const std::function<void(std::vector<Beat>&)>& spoil)
      : model_(model_stream(row, store)), spoil_(spoil) {}

  std::vector<Beat> run(const std::vector<Beat>& commands, std::size_t results,
                        const Progress& progress, std::size_t steps) override {
    std::vector<Beat> beats = model_->run(commands, results, progress, steps);
    spoil_(beats);
    return beats;
  }
  void reset() override { model_->reset(); }
  PointStore store() const override { return model_->store(); }

 private:
  std::unique_ptr<CommandStream> model_;
  const std::function<void(std::vector<Beat>&)>& spoil_;
};

// After a fault the core has been reset, so its pages are loaded anew.
TEST(LargeLatticeDevice, ResultsThatWereNotAskedForAreAFault) {
  const LargeScene scene;
  const Configuration& row = find_configuration("basic-fp32-overlapped");
  std::function<void(std::vector<Beat>&)> spoil = [](auto&) {};
  StreamDevice device("spoilt", row,
                      std::make_unique<SpoiltPageStream>(row, PointStore{16, 64}, spoil));
  const Points good = device.evaluate(scene.lattice, scene.vertices);
  const std::function<void(std::vector<Beat>&)> spoilt[] = {
      [](auto& beats) { beats.pop_back(); },
      [](auto& beats) { beats.push_back(beats.back()); },
      [](auto& beats) { std::swap(beats[3], beats[5]); },
      [](auto& beats) { beats[1030].words[3] ^= 1; },
      [](auto& beats) { beats.back().last = false; },
      [](auto& beats) { beats[1].last = !beats[1].last; },
  };
  for (const auto& fault : spoilt) {
    spoil = fault;
    EXPECT_THROW(device.evaluate(scene.lattice, scene.vertices), Error);
    spoil = [](auto&) {};
    EXPECT_EQ(device.evaluate(scene.lattice, scene.vertices), good);
  }
}

TEST(LargeLatticeDevice, WhatNoCoreHasIsRefused) {
  const auto complaint = [](const DeviceChoice& choice) -> std::string {
    try {
      make_device(choice);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaint({"model", "basic", "fp32", 257}),
            "257 pages: a core has 1 to 256, or 0 for one without pages");
  EXPECT_EQ(complaint({"model", "basic", "fp32", -1}),
            "-1 pages: a core has 1 to 256, or 0 for one without pages");
  EXPECT_EQ(complaint({"model", "basic", "fp32", 0, 33}),
            "33 points an axis: a core without pages keeps 7 to 32");
  EXPECT_EQ(complaint({"model", "basic", "fp32", 4, 6}),
            "6 points an axis: a core with pages keeps 7 to 64");
  EXPECT_EQ(complaint({"rtl", "basic", "fp32", 4}),
            "device rtl: its cores have no pages, and 16 points an axis; leave both out, or take "
            "device model");
}

}  // namespace
}  // namespace hwffd
