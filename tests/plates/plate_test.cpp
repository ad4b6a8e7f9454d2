// Plates as they are made: on a device whose results are those of the model, and on one that errs.

#include "plates/plate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "colours.hpp"
#include "errors.hpp"
#include "plates/chairs.hpp"
#include "plates/report.hpp"
#include "temp_folder.hpp"

namespace hwffd::plates {
namespace {

using picture::count;
using picture::is_background;

/// The model, but for some results of each call.
class FaultyDevice final : public Device {
 public:
  explicit FaultyDevice(int faults) : faults_(faults) {}
  std::string name() const override { return "faulty"; }

 protected:
  Points run(const Lattice& lattice, const std::vector<Embedded>& vertices,
             const Blending& blending) override {
    Points results = model_->evaluate(lattice, vertices, blending);
    for (int fault = 0; fault < faults_; ++fault) {
      double& value = results(fault, fault % 3);
      value = std::nextafter(value, HUGE_VAL);
    }
    return results;
  }
  Points run(const std::vector<SupportedVertex>& vertices, const Blending& blending) override {
    return model_->evaluate(vertices, blending);
  }
  Tangents run_tangents(const Lattice& lattice, const std::vector<Embedded>& vertices,
                        const Blending& blending) override {
    return model_->tangents(lattice, vertices, blending);
  }

 private:
  std::unique_ptr<Device> model_ = make_device({"model"});
  int faults_;
};

Subject subject(std::size_t number) { return std::move(subjects().at(number)); }

std::vector<Plate> plates(std::size_t number, int faults) {
  FaultyDevice device(faults);
  return plates_of(subject(number), device, *make_device({"model"}), picture::Renderer(160, 120));
}

TEST(Plates, ModelsAreThoseOfThePaperInOneCellEach) {
  const std::vector<Subject> all = subjects();
  ASSERT_EQ(all.size(), 3u);
  std::size_t views = 0;
  for (const Subject& entry : all) {
    EXPECT_EQ(entry.rest.cells(), (Index3{1, 1, 1}));
    views += 2 * entry.views.size();
  }
  EXPECT_EQ(views, 10u);
  EXPECT_EQ(all[0].deformation, "twist:90");
  EXPECT_EQ(all[1].deformation, "shear:0.5");
  EXPECT_EQ(all[2].deformation, "twist:90");
}

TEST(Plates, OnlyStemAndWheelsOfTheOfficeChairAreInTheLattice) {
  const Subject office = subject(1);
  std::size_t below = 0;
  for (Eigen::Index v = 0; v < office.mesh.positions().rows(); ++v) {
    if (office.mesh.positions()(v, 1) < kOfficeStemTop) ++below;
  }
  const std::vector<Plate> office_plates = plates(1, 0);
  ASSERT_EQ(office_plates.size(), 4u);
  EXPECT_EQ(office_plates[0].vertices, below);
  EXPECT_GT(below, 1000u);
  EXPECT_LT(below, office.mesh.vertex_count() - 1000);
}

TEST(Plates, EachShowsSomethingOfItsOwn) {
  std::set<std::vector<picture::Pixel>> different;
  std::size_t number = 0;
  for (std::size_t s = 0; s < 3; ++s) {
    for (const Plate& plate : plates(s, 0)) {
      ++number;
      EXPECT_EQ(plate.mismatches, 0u) << number;
      EXPECT_GT(plate.vertices, 1000u) << number;
      ASSERT_EQ(plate.image.width, 160);
      ASSERT_EQ(plate.image.height, 120);
      const int drawn = 160 * 120 - count(plate.image, is_background);
      EXPECT_GT(drawn, 160 * 120 / 20) << number;
      EXPECT_LT(drawn, 160 * 120 / 2) << number;
      EXPECT_GT(count(plate.image, picture::is_red), 64) << number << ": control points";
      different.insert(plate.image.pixels);
    }
  }
  EXPECT_EQ(number, 10u);
  EXPECT_EQ(different.size(), number);
}

TEST(Plates, AResultThatIsNotTheModelsIsCounted) {
  const std::vector<Plate> faulty_plates = plates(2, 3);
  ASSERT_EQ(faulty_plates.size(), 2u);
  for (const Plate& plate : faulty_plates) EXPECT_EQ(plate.mismatches, 3u);
}

TEST(PlatesReport, FilesTableAndSheetSayWhatThePlatesAre) {
  picture::Image image{16, 8, std::vector<picture::Pixel>(128, {10, 20, 30})};
  const std::vector<Plate> two_plates{{"cat, at rest", image, 7340, 0},
                                      {"cat, twist:90", image, 7340, 2}};
  const auto json = nlohmann::json::parse(json_report(two_plates));
  ASSERT_EQ(json["plates"].size(), 2u);
  EXPECT_EQ(json["plates"][1],
            (nlohmann::json{{"file", "plate02.png"}, {"vertices", 7340}, {"mismatches", 2}}));
  EXPECT_EQ(file_name(10), "plate10.png");
  expect_part(table_line(2, two_plates[1]), "plate02.png   cat, twist:90");
  const TempFolder folder;
  write_plates(folder / "new", two_plates);
  for (const char* file : {"plates/plate01.png", "plates/plate02.png", "plates/plates.png"}) {
    EXPECT_EQ(read_text(folder / "new" / file).substr(1, 3), "PNG") << file;
  }
  EXPECT_EQ(read_text(folder / "new" / "reports" / "plates.json"), json_report(two_plates));
  const auto file = folder.write("file", "");
  EXPECT_ERROR_PART(write_plates(file, two_plates), "--output");
}

}  // namespace
}  // namespace hwffd::plates
