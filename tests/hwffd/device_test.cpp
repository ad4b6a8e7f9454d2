// The devices against the oracle and against each other.

#include "hwffd/device/device.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

#include "errors.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/embedder.hpp"
#include "hwffd/model/configuration.hpp"
#include "sample_lattices.hpp"

namespace hwffd {
namespace {

struct Scene {
  Lattice lattice =
      Deformation::parse("random:3").apply(lattice_around("box", test::corners(), {6, 5, 7}));
  std::vector<Embedded> vertices = test::known_places(lattice, 500, 1);
};

double largest(const Points& difference) { return difference.cwiseAbs().maxCoeff(); }

// Its sums are in another order than the oracle's.
TEST(Device, ReferenceIsTheOracleButForRounding) {
  constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();
  const Scene scene;
  const std::unique_ptr<Device> device = make_device({"reference", "", ""});
  const Points got = device->evaluate(scene.lattice, scene.vertices);
  const Oracle oracle;
  ASSERT_EQ(got.rows(), 500);
  for (Eigen::Index i = 0; i < got.rows(); ++i) {
    const Embedded& v = scene.vertices[static_cast<std::size_t>(i)];
    const Eigen::Vector3d exact =
        oracle.evaluate(scene.lattice.support(v.cell), v.local[0], v.local[1], v.local[2]);
    EXPECT_LE((got.row(i).transpose() - exact).cwiseAbs().maxCoeff(), kRounding) << "vertex " << i;
  }
  EXPECT_EQ(device->counts().vertices, 500u);
  EXPECT_EQ(device->counts().clocks, 0u);
}

TEST(Device, ModelsOfEveryRowAreCloseToTheOracle) {
  const Scene scene;
  const Points exact = make_device({"reference", "", ""})->evaluate(scene.lattice, scene.vertices);
  std::size_t compared = 0;
  for (const std::string& name : device_rows("model")) {
    const std::string org = name.substr(0, name.find('-'));
    const std::string format =
        name.substr(org.size() + 1, name.find('-', org.size() + 1) - org.size() - 1);
    const std::string rest = name.substr(org.size() + 1 + format.size());
    if (rest != "-overlapped") continue;  // variants of a row
    const bool fixed = format.rfind("fx", 0) == 0;
    const double step = fixed ? 16 * std::ldexp(1.0, 2 - std::stoi(format.substr(2))) : 4e-6;
    const Points got = make_device({"model", org, format})->evaluate(scene.lattice, scene.vertices);
    EXPECT_LT(largest(got - exact), 4 * step) << name;
    EXPECT_GT(largest(got - exact), 0) << name;
    ++compared;
  }
  EXPECT_GE(compared, 20u);
}

TEST(Device, RtlGivesTheBitsOfItsModel) {
  const Scene scene;
  const std::vector<std::string> rows = device_rows("rtl");
  for (const std::string format : {"fp32", "fx18", "fx32", "bfp32"}) {
    ASSERT_NE(std::find(rows.begin(), rows.end(), "basic-" + format + "-overlapped"), rows.end());
    const std::unique_ptr<Device> rtl = make_device({"rtl", "basic", format});
    const std::unique_ptr<Device> model = make_device({"model", "basic", format});
    for (int run = 0; run < 2; ++run) {  // the second finds the core as the first left it
      EXPECT_EQ(rtl->evaluate(scene.lattice, scene.vertices),
                model->evaluate(scene.lattice, scene.vertices))
          << format << " run " << run;
    }
    EXPECT_EQ(rtl->counts().vertices, 1000u);
    EXPECT_GT(rtl->counts().clocks, 64 * 1000u);
    EXPECT_LT(rtl->counts().clocks, 70 * 1000u);
  }
}

/// Largest difference of two sets of derivatives.
double largest(const std::vector<Eigen::Matrix3d>& a, const std::vector<Eigen::Matrix3d>& b) {
  double most = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    most = std::max(most, (a[v] - b.at(v)).cwiseAbs().maxCoeff());
  }
  return most;
}

TEST(Device, TangentsAreTheDerivativesOfTheOracle) {
  const Scene scene;
  const std::unique_ptr<Device> reference = make_device({"reference", "", ""});
  const Device::Tangents exact = reference->tangents(scene.lattice, scene.vertices);
  EXPECT_EQ(exact.positions, reference->evaluate(scene.lattice, scene.vertices));
  ASSERT_EQ(exact.jacobians.size(), 500u);
  for (std::size_t v = 0; v < 500; ++v) {
    const Embedded& at = scene.vertices[v];
    const Oracle::Jet jet = Oracle().jet(scene.lattice.support(at.cell), at.local);
    EXPECT_EQ(exact.jacobians[v], jet.jacobian) << "vertex " << v;
  }
  for (const auto& [format, step] :
       {std::pair{"fp32", 4e-6}, std::pair{"fx18", 1e-3}, std::pair{"fx32", 6e-8}}) {
    const std::unique_ptr<Device> device = make_device({"model", "basic", format});
    const Device::Tangents got = device->tangents(scene.lattice, scene.vertices);
    EXPECT_EQ(got.positions, device->evaluate(scene.lattice, scene.vertices)) << format;
    EXPECT_LT(largest(got.jacobians, exact.jacobians), step) << format;
    EXPECT_GT(largest(got.jacobians, exact.jacobians), 0) << format;
  }
}

TEST(Device, TangentsOfTheRtlAreThoseOfItsModel) {
  const Scene scene;
  for (const std::string format : {"fp32", "fx18", "fx32"}) {
    const std::unique_ptr<Device> rtl = make_device({"rtl", "basic", format});
    const Device::Tangents got = rtl->tangents(scene.lattice, scene.vertices);
    const Device::Tangents expected =
        make_device({"model", "basic", format})->tangents(scene.lattice, scene.vertices);
    EXPECT_EQ(got.positions, expected.positions) << format;
    EXPECT_EQ(got.jacobians, expected.jacobians) << format;
    EXPECT_GT(rtl->counts().clocks, 4 * 64 * 500u);
    EXPECT_LT(rtl->counts().clocks, 4 * 70 * 500u);
  }
}

TEST(Device, TangentsWithBlendingFunctionsOfTheCallersOwn) {
  const Scene scene;
  const Device::Blending blending{Oracle::bernstein(), Oracle::linear(), Oracle::catmull_rom()};
  const Device::Tangents exact =
      make_device({"reference", "", ""})->tangents(scene.lattice, scene.vertices, blending);
  const Device::Tangents got = make_device({})->tangents(scene.lattice, scene.vertices, blending);
  EXPECT_LT(largest(got.jacobians, exact.jacobians), 2e-5);
  EXPECT_EQ(make_device({})->tangents(scene.lattice, {}).jacobians.size(), 0u);
}

TEST(Device, BlendingFunctionsOfTheCallersOwn) {
  const Scene scene;
  const Oracle::Coefficients bernstein = Oracle::bernstein();
  const Oracle::Coefficients linear = Oracle::linear();
  const Device::Blending blending{bernstein, linear, Oracle::uniform_bspline()};
  const Points exact =
      make_device({"reference", "", ""})->evaluate(scene.lattice, scene.vertices, blending);
  const Points got = make_device({})->evaluate(scene.lattice, scene.vertices, blending);
  EXPECT_LT(largest(got - exact), 4e-6);
  EXPECT_GT(largest(got - make_device({})->evaluate(scene.lattice, scene.vertices)), 1e-2);
}

/// Half a unit in the last place of a number in binary32.
double half_ulp(double value) {
  const auto word = static_cast<float>(std::abs(value));
  return (static_cast<double>(std::nextafter(word, HUGE_VALF)) - word) / 2;
}

TEST(Device, IdentityFarFromTheOrigin) {
  Points points = Points::Random(300, 3);
  points.rowwise() += Eigen::RowVector3d(1e6, -3e5, 1e6);
  points = points.cast<float>().cast<double>().eval();
  const Lattice lattice = lattice_around("box", points, {5, 6, 4});
  const std::vector<Embedding> embeddings = Embedder(lattice).embed(points);
  std::vector<Embedded> vertices;
  for (const Embedding& embedding : embeddings) {
    vertices.push_back(embedding.at);
    vertices.back().local = vertices.back().local.cwiseMax(0.0).cwiseMin(1.0);
  }
  for (const char* format : {"fp32", "bfp32", "fx32"}) {
    const Points got = make_device({"model", "basic", format})->evaluate(lattice, vertices);
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_LE(std::abs(got(row, axis) - points(row, axis)), half_ulp(points(row, axis)))
            << format << ", vertex " << row << ", axis " << axis;
      }
    }
  }
}

TEST(Device, VerticesWithSupportsAndFunctionsThatDoNotSumToOne) {
  const Oracle::Coefficients hermite = Oracle::hermite();
  const Device::Blending blending{hermite, Oracle::uniform_bspline(), hermite};
  std::vector<SupportedVertex> vertices(50);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    vertices[v].local = Eigen::Vector3d::Constant(static_cast<double>(v) / 50);
    vertices[v].support = Support::Random().array() / 4 + 10;
  }
  const Points exact = make_device({"reference", "", ""})->evaluate(vertices, blending);
  for (const auto& [format, step] : {std::pair{"fp32", 1e-5}, std::pair{"bfp32", 1e-4}}) {
    const Points got = make_device({"model", "basic", format})->evaluate(vertices, blending);
    EXPECT_LT(largest(got - exact), step) << format;
  }
}

TEST(Device, AffineTakesFunctionsThatSumToOneOnly) {
  const Scene scene;
  const auto device = make_device({"model", "affine/3", "fx17"});
  const Oracle::Coefficients bezier = Oracle::bernstein();
  const Points exact = make_device({"reference", "", ""})
                           ->evaluate(scene.lattice, scene.vertices, {bezier, bezier, bezier});
  const auto of = [&](const Oracle::Coefficients& along_u) {
    return device->evaluate(scene.lattice, scene.vertices, {bezier, bezier, along_u});
  };
  EXPECT_LT(largest(of(bezier) - exact), 2e-3);
  try {
    of(Oracle::hermite());
    FAIL() << "evaluated";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "model affine3-fx17-overlapped: takes blending functions that sum to one only; these "
              "do not: take factored");
  }
}

// Its evaluator ignores what is loaded, and would give the B-spline's positions without a word.
TEST(Device, RowsWithTheBsplineWiredInTakeNoOtherFunctions) {
  constexpr const char* kText = "has the B-spline wired in and takes no other blending functions";
  const Lattice lattice =
      Deformation::parse("random:3").apply(lattice_around("box", test::corners(), {7, 7, 7}));
  const std::vector<Embedded> vertices{{{0, 0, 0}, {0.25, 0.5, 0.75}}};
  const Points exact = make_device({"reference", "", ""})->evaluate(lattice, vertices);
  const Points gradient = Points::Ones(1, 3);
  const Grid grid = grid_between({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  std::size_t rows = 0;
  for (const std::string& name : device_rows("model")) {
    if (!wired_in(find_configuration(name))) continue;
    ++rows;
    const std::unique_ptr<Device> device = make_device({"model", name, ""});
    EXPECT_LT(largest(device->evaluate(lattice, vertices) - exact), 1e-2) << name;
    EXPECT_NO_THROW(device->evaluate(lattice, vertices, Family::parse("clamped"))) << name;
    for (const char* other : {"bernstein", "catmull-rom", "linear"}) {
      const Family family = Family::parse(other);
      EXPECT_ERROR_PART(device->evaluate(lattice, vertices, family), kText);
      EXPECT_ERROR_PART(device->evaluate_grid(lattice, grid, family), kText);
      EXPECT_ERROR_PART(device->tangents(lattice, vertices, family), kText);
    }
  }
  EXPECT_GT(rows, 0u);
  const std::unique_ptr<Device> adds = make_device({"model", "affine-fx17-overlapped-powers", ""});
  EXPECT_ERROR_PART(adds->pull_back(lattice.dims(), vertices, gradient, Family::parse("linear")),
                    kText);
}

TEST(Device, VerticesWithTheSupportsOfALatticeGetItsBits) {
  const Oracle::Coefficients bspline = Oracle::uniform_bspline();
  Scene scene;
  scene.lattice = Lattice({4, 4, 4}, scene.lattice.points().topRows(64));
  std::vector<SupportedVertex> interleaved;
  for (Embedded& at : scene.vertices) {
    at.cell = {0, 0, 0};
    interleaved.push_back({at.local, scene.lattice.support(at.cell)});
  }
  for (const char* format : {"fp32", "fx18"}) {
    for (const char* kind : {"model", "rtl", "reference"}) {
      const auto device = make_device({kind, "basic", format});
      EXPECT_EQ(device->evaluate(interleaved, {bspline, bspline, bspline}),
                device->evaluate(scene.lattice, scene.vertices))
          << kind << " " << format;
    }
  }
}

TEST(Device, ProgressEndsAtOne) {
  const Scene scene;
  for (const char* kind : {"model", "rtl"}) {
    const std::unique_ptr<Device> device = make_device({kind, "basic", "fx18"});
    std::vector<double> seen;
    device->on_progress([&](double done) { seen.push_back(done); });
    device->evaluate(scene.lattice, scene.vertices);
    ASSERT_GT(seen.size(), 10u) << kind;
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end())) << kind;
    EXPECT_EQ(seen.back(), 1.0) << kind;
  }
}

TEST(Device, NoVerticesNoResults) {
  const Scene scene;
  EXPECT_EQ(make_device({})->evaluate(scene.lattice, {}).rows(), 0);
}

TEST(Device, RefusesWhatItCannotIndex) {
  const Scene scene;
  const std::unique_ptr<Device> device = make_device({});
  for (const Index3 cell : {Index3{3, 0, 0}, Index3{0, -1, 0}, Index3{0, 0, 4}}) {
    EXPECT_THROW(device->evaluate(scene.lattice, {{cell, {0, 0, 0}, true}}), Error);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(device->evaluate(scene.lattice, {{{0, 0, 0}, {0, nan, 0}, true}}), Error);
  const Oracle::Coefficients bspline = Oracle::uniform_bspline();
  std::vector<SupportedVertex> vertices(2, {Eigen::Vector3d::Zero(), Support::Zero()});
  EXPECT_EQ(device->evaluate(vertices, {bspline, bspline, bspline}), Points::Zero(2, 3));
  const std::string text = "vertex 1: a coordinate or control point is not finite; leave it out";
  vertices[1].support(63, 2) = nan;
  EXPECT_ERROR(device->evaluate(vertices, {bspline, bspline, bspline}), text);
  vertices[1] = {{0, 0, nan}, Support::Zero()};
  EXPECT_ERROR(device->evaluate(vertices, {bspline, bspline, bspline}), text);
}

// Before anything is opened, but for what is not there.
TEST(Device, BoardsSayWhatTheyWant) {
  const std::string folder = "/no/such/folder/x";
  const DeviceChoice pages{"", "", "", 4};
  const DeviceChoice points{"", "", "", 0, 20};
  for (const std::string& board : {"serial:" + folder, std::string("uio:7"), "socket:" + folder}) {
    const std::string kind = board.substr(0, board.find(':'));
    for (DeviceChoice choice : {pages, points}) {
      choice.device = board;
      EXPECT_USAGE_ERROR(make_device(choice),
                         "device " + kind +
                             ": its core has the pages and points an axis that it has; leave both "
                             "out");
    }
    EXPECT_USAGE_ERROR_PART(make_device({board, "", "fx99"}), "in format 'fx99' here; it has ");
    EXPECT_ERROR_PART(make_device({board, "", "fx18"}), kind == "uio" ? "/uio7/" : board);
    EXPECT_ERROR_PART(make_device({board, "cg1", ""}), kind == "uio" ? "/uio7/" : board);
  }
  for (const char* number : {"uio:", "uio:x", "uio:7/.."}) {
    EXPECT_USAGE_ERROR(make_device({number}),
                       "device uio: needs the number of its file, such as uio:0 for /dev/uio0");
  }
  EXPECT_EQ(device_rows("serial:PATH"), std::vector<std::string>{"cg1-fx18-overlapped"});
  for (const char* kind : {"uio:N", "socket:PATH", "reference"}) {
    EXPECT_EQ(device_rows(kind), std::vector<std::string>{}) << kind;
  }
}

TEST(Device, EveryRowCanBeChosen) {
  std::size_t checked = 0;
  for (const std::string& row : device_rows("model")) {
    EXPECT_EQ(make_device({"model", row})->name(), "model " + row);
    ++checked;
  }
  EXPECT_GE(checked, 70u);
  EXPECT_EQ(make_device({"model", "factored/3", "fx18"})->name(),
            "model factored3-fx18-overlapped");
  EXPECT_EQ(make_device({"model", "tree 8", "fx18"})->name(), "model tree8-fx18-overlapped");
  EXPECT_EQ(make_device({"model", "affine-fx17-overlapped-powers", "fx17"})->name(),
            "model affine-fx17-overlapped-powers");
}

TEST(Device, NamesThatWentSayWhatReplacesThem) {
  const std::string cg2 = "cg2 went with 0.3.0: take cg1";
  const std::string bspline = "bspline went with 0.3.0: take pipelined";
  const std::string jacobian = "jacobian/3x3 went with 0.3.0: take jacobian/3";
  const std::map<std::string, std::string> gone{{"cg2", cg2},
                                                {"cg2-fx18-overlapped", cg2},
                                                {"basic-fx18-overlapped-bspline", bspline},
                                                {"jacobian/3x3", jacobian},
                                                {"jacobian3x3", jacobian},
                                                {"jacobian3x3-fx17-overlapped", jacobian}};
  for (const auto& one : gone) {
    const auto& name = one.first;
    const auto& text = one.second;
    EXPECT_USAGE_ERROR(make_device({"model", name, ""}), "device model: " + text);
    EXPECT_USAGE_ERROR(make_device({"rtl", name, "fx18"}), "device rtl: " + text);
    EXPECT_EQ(message_of<std::invalid_argument>([&] { find_configuration(name); }), text);
    EXPECT_EQ(gone_text(name), text);
  }
  for (const char* name : {"cg1", "cg22", "", "cg1-fx18-overlapped", "jacobian/3"})
    EXPECT_EQ(gone_text(name), "");
}

TEST(Device, UnknownNamesAreListed) {
  const auto message = [](const DeviceChoice& choice) -> std::string {
    try {
      make_device(choice);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  const auto expect = [&](const DeviceChoice& choice, const std::string& expected) {
    EXPECT_EQ(message(choice), expected);
    EXPECT_LT(expected.size(), 240u);
  };
  const std::string said = message({"model", std::string(100, 'x'), "fp32"});
  const std::string begin = "device model: no organization '" + std::string(27, 'x') +
                            "...' here; one of basic, cg1, cg3, tree1 to tree32, parallel, "
                            "factored, factored3, affine to affine64, ";
  std::string expected = begin;
  for (const Configuration& row : configurations()) {
    const std::string word = std::string(row.name).substr(0, std::string(row.name).find('-'));
    const bool in_short = word.rfind("tree", 0) == 0 || word.rfind("affine", 0) == 0;
    if (!overlaps(row) || in_short || (expected + ",").find(" " + word + ",") != std::string::npos)
      continue;
    expected += (expected.back() == ' ' ? "" : ", ") + word;
  }
  EXPECT_EQ(said, expected);
  EXPECT_LT(said.size(), 240u);
  expect({"model", "affine/3", "bfp32"},
         "device model: no 'affine/3' in format 'bfp32' here; it has fx17, fx32");
  expect({"model", "basic-fx18-overlapped", "fp32"},
         "row basic-fx18-overlapped is in format fx18, not 'fp32'; leave the format out");
  expect({"model", "basic-fp32-paper", ""},
         "device model: no row 'basic-fp32-paper' here; hwffd info lists them");
  const std::vector<std::string> built = device_rows("rtl");
  for (const Configuration& row : configurations()) {
    if (!overlaps(row) || row.stream_tier == std::string("none")) continue;
    if (std::find(built.begin(), built.end(), row.name) != built.end()) continue;
    expect({"rtl", row.name, ""}, std::string("row ") + row.name +
                                      " is not among the simulated cores here: make hwffd TIER=" +
                                      row.stream_tier + " builds it, or take device model");
  }
  EXPECT_NE(message({"rtl", "cg9", "fx18"}).find("no organization 'cg9' here"), std::string::npos);
  EXPECT_NE(message({"fpga", "basic", "fp32"}).find("model, rtl, reference"), std::string::npos);
  EXPECT_NE(message({"model", "cg9", "fp32"}).find("cg3, "), std::string::npos);
  EXPECT_NE(message({"rtl", "basic", "fx99"}).find("fx18"), std::string::npos);
}

}  // namespace
}  // namespace hwffd
