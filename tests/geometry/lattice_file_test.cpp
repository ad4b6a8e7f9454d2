#include "hwffd/lattice/lattice_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "errors.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/shape.hpp"
#include "hwffd/lattice/sphere.hpp"
#include "temp_folder.hpp"
#include "unprivileged.hpp"

namespace hwffd {
namespace {

Lattice crooked() {
  return Deformation::parse("random:5")
      .apply(Box(Point(0.1, 1e-9, -1e6), Point(1, 1e-3, 1e5).asDiagonal()).lattice({4, 5, 6}));
}

/// The example of docs/lattice.md: a box of 4 x 5 x 6 points, three edges of different length.
const char* const kBox =
    R"({"hwffd_lattice": 1, "dims": [4, 5, 6], "shape": "box", "origin": [0, 0, 0],
        "edges": [[1, 0, 0], [0, 20, 0], [0, 0, 300]]})";

TEST(LatticeFile, EveryBitComesBack) {
  const TempFolder folder;
  const Lattice lattice = crooked();
  write_lattice(folder / "crooked.json", lattice);
  const Lattice back = read_lattice_file(folder / "crooked.json").lattice;
  EXPECT_EQ(back.dims(), lattice.dims());
  EXPECT_EQ(back.points(), lattice.points());
  EXPECT_EQ(folder.files(), (std::set<std::string>{"crooked.json"}));
  EXPECT_EQ(lattice_text(back), read_text(folder / "crooked.json"));
}

/// So does the largest lattice with the one at rest, of numbers with as many digits as there are.
TEST(LatticeFile, TheLargestComesBack) {
  const TempFolder folder;
  const Index3 dims{Lattice::kMaxPoints, Lattice::kMaxPoints, Lattice::kMaxPoints};
  const Lattice box = Box(Point::Zero(), Eigen::Matrix3d::Identity()).lattice(dims);
  const Lattice deformed = Deformation::parse("random:1").apply(box);
  const Lattice rest(dims, -1.2345678901234567e-101 * deformed.points());
  write_lattice(folder / "largest.json", LatticeFile{deformed, rest, std::nullopt});
  const LatticeFile back = read_lattice_file(folder / "largest.json");
  EXPECT_EQ(back.lattice.points(), deformed.points());
  ASSERT_TRUE(back.rest);
  EXPECT_EQ(back.rest->points(), rest.points());
}

TEST(LatticeFile, FamilyAndRestComeBack) {
  const Lattice rest = crooked();
  const Lattice deformed = Deformation::parse("bend:40").apply(rest);
  const std::string text =
      lattice_text(LatticeFile{deformed, rest, Family(Family::Kind::kClamped)});
  const LatticeFile back = parse_lattice_file(text);
  EXPECT_EQ(back.lattice.points(), deformed.points());
  ASSERT_TRUE(back.rest && back.family);
  EXPECT_EQ(back.rest->points(), rest.points());
  EXPECT_EQ(back.rest->dims(), rest.dims());
  EXPECT_EQ(back.family->kind(), Family::Kind::kClamped);
  EXPECT_EQ(lattice_text(back), text);
  // Files of before have neither, and are written as they were.
  EXPECT_FALSE(parse_lattice_file(lattice_text(rest)).rest);
  EXPECT_FALSE(parse_lattice_file(kBox).family);
  EXPECT_EQ(lattice_text(parse_lattice_file(lattice_text(rest))), lattice_text(rest));
  EXPECT_EQ(lattice_text(LatticeFile{rest, rest, Family()}), lattice_text(rest));
  const std::string start = R"({"hwffd_lattice": 1, "dims": [2, 2, 2], "points": [)";
  std::string eight = "[0, 0, 0]";
  for (int i = 1; i < 8; ++i) eight += fmt::format(", [{}, {}, {}]", i / 4, i / 2 % 2, i % 2);
  EXPECT_EQ(parse_lattice_file(start + eight + R"(], "family": "linear"})").family->name(),
            "linear");
  EXPECT_ERROR(parse_lattice_file(start + eight + R"(], "family": "cubic"})"),
               "lattice file: unknown 'family'; give one of bspline, clamped, bernstein, "
               "catmull-rom, linear");
  EXPECT_ERROR(parse_lattice_file(start + eight + R"(], "family": 3})"),
               "lattice file: unknown 'family'; give one of bspline, clamped, bernstein, "
               "catmull-rom, linear");
  EXPECT_ERROR(parse_lattice_file(start + eight + R"(], "rest": 3})"),
               "lattice file: 'rest' is not a list; give [[x, y, z], ...]");
  EXPECT_ERROR(parse_lattice_file(start + eight + R"(], "rest": [[1, 2]]})"),
               "lattice file: point 0 at rest is not a point; give [x, y, z]");
  EXPECT_ERROR_PART(parse_lattice_file(start + eight + R"(], "rest": [[1, 2, 3]]})"),
                    "lattice file: 'rest': ");
}

/// The order of axes by an asymmetric example: in the file, u runs fastest, s slowest.
TEST(LatticeFile, OrderOfAxes) {
  const nlohmann::json file = nlohmann::json::parse(lattice_text(parse_lattice(kBox)));
  EXPECT_EQ(file["dims"], (std::vector<int>{4, 5, 6}));
  const auto point = [&](int n) { return file["points"].at(n).get<std::vector<double>>(); };
  EXPECT_EQ(file["points"].size(), 120u);
  EXPECT_EQ(point(0), (std::vector<double>{-1, -10, -100}));
  EXPECT_EQ(point(1), (std::vector<double>{-1, -10, 0}));     // one step along u
  EXPECT_EQ(point(6), (std::vector<double>{-1, 0, -100}));    // one step along t
  EXPECT_EQ(point(30), (std::vector<double>{0, -10, -100}));  // one step along s
  EXPECT_EQ(parse_lattice(kBox).point(1, 0, 0), Point(0, -10, -100));
}

TEST(LatticeFile, Shapes) {
  Eigen::Matrix3d edges;
  edges.col(0) << 1, 0, 0.5;
  edges.col(1) << 0, 2, 0;
  edges.col(2) << 0, 1, 3;
  const Point origin(7, 8, 9);
  const auto parsed = [](const std::string& shape) {
    return parse_lattice(R"({"hwffd_lattice": 1, "dims": [5, 6, 7], "origin": [7, 8, 9],
                            "edges": [[1, 0, 0.5], [0, 2, 0], [0, 1, 3]], "shape": )" +
                         shape + "}")
        .points();
  };
  EXPECT_EQ(parsed("\"box\""), Box(origin, edges).lattice({5, 6, 7}).points());
  EXPECT_EQ(parsed("\"cylinder\""), Cylinder(origin, edges).lattice({5, 6, 7}).points());
  EXPECT_EQ(parsed("\"sphere\""), Sphere(origin, edges).lattice({5, 6, 7}).points());
  EXPECT_EQ(parsed("\"sphere\", \"inner\": 0.5"),
            Sphere(origin, edges, 0.5).lattice({5, 6, 7}).points());
}

struct Bad {
  const char* text;
  const char* message;
};

const Bad kBad[] = {
    {"", "lattice file: line 1, column 1: no JSON; docs/lattice.md shows the format"},
    {"[1]", "lattice file: not a JSON object; docs/lattice.md shows the format"},
    {R"({"hwffd_lattice": 1,)",
     "lattice file: line 1, column 21: no JSON; docs/lattice.md shows the format"},
    {"{\"hwffd_lattice\": 1,\n\n  \"dims\": [4, 4, 4,]}",
     "lattice file: line 3, column 20: no JSON; docs/lattice.md shows the format"},
    {"{\"hwffd_lattice\": 1,\n\"dims\": [1e999]}",
     "lattice file: line 2, column 14: a number too large for double precision"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "dims": [5, 5, 5]})",
     "lattice file: 'dims' stands there twice; keep one"},
    {R"({"dims": [4, 4, 4]})",
     "lattice file: no 'hwffd_lattice'; give the version of the format, 1"},
    {R"({"hwffd_lattice": 2})",
     "lattice file: 'hwffd_lattice' is not 1, the version that this program reads"},
    {R"({"hwffd_lattice": 1})",
     "lattice file: no 'dims'; give three integers from 2 to 64, points along s, t and u"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4]})",
     "lattice file: 'dims' is not three integers from 2 to 64, points along s, t and u"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4.5, 4]})",
     "lattice file: 'dims' is not three integers from 2 to 64, points along s, t and u"},
    {R"({"hwffd_lattice": 1, "dims": [4, 1e300, 4]})",
     "lattice file: 'dims' is not three integers from 2 to 64, points along s, t and u"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4294967300, 4]})",
     "lattice file: 'dims' is not three integers from 2 to 64, points along s, t and u"},
    {R"({"hwffd_lattice": 1, "dims": 4})",
     "lattice file: 'dims' is not three integers from 2 to 64, points along s, t and u"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, -1e2]})",
     "lattice file: 'dims' is not three integers from 2 to 64, points along s, t and u"},
    {R"({"hwffd_lattice": 1, "dims": [-100, 4, 4]})",
     "lattice file: 'dims' is not three integers from 2 to 64, points along s, t and u"},
    {R"({"hwffd_lattice": 1, "dims": [4, 65, 4]})",
     "lattice of 4 x 65 x 4 points: each axis takes 2 to 64 points"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4]})",
     "lattice file: no 'points'; give [[x, y, z], ...], or a 'shape'"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "points": 3})",
     "lattice file: 'points' is not a list; give [[x, y, z], ...]"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "points": [[1, 2, 3], [1, 2]]})",
     "lattice file: point 1 is not a point; give [x, y, z]"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "points": [["1", 2, 3]]})",
     "lattice file: point 0 is not a point; give [x, y, z]"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "points": [[1, null, 3]]})",
     "lattice file: point 0 is not a point; give [x, y, z]"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "points": [[1, 2, []]]})",
     "lattice file: point 0 is not a point; give [x, y, z]"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "points": [[1, 2, 3]]})",
     "lattice of 4 x 4 x 4 points: 1 points given; give 64"},
    {R"({"hwffd_lattice": 1, "dim": [4, 4, 4]})",
     "lattice file: unknown 'dim'; known here are hwffd_lattice, order, dims, points, rest, "
     "family"},
    {R"({"hwffd_lattice": 1, "a\nb": 1})",
     "lattice file: unknown 'a\\x0ab'; known here are hwffd_lattice, order, dims, points, rest, "
     "family"},
    {R"({"hwffd_lattice": 1, "order": "s fastest"})",
     "lattice file: another 'order' of the points; sort them so that point (i, j, k) is number "
     "(i*n_t + j)*n_u + k"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "points": []})",
     "lattice file: unknown 'points'; known here are hwffd_lattice, dims, shape, origin, "
     "edges, "
     "inner, family"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "origin": 0})",
     "lattice file: 'origin' is not a point; give [x, y, z]"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "origin": [0, 0, 0],
           "edges": [1, 2]})",
     "lattice file: 'edges' is not a list of three; give [[x, y, z], ...]"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "origin": [0, 0, 0],
           "edges": {}})",
     "lattice file: 'edges' is not a list of three; give [[x, y, z], ...]"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "origin": [0, 0, 0],
           "edges": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "inner": 0})",
     "lattice file: a box has no 'inner'; leave it out"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 6], "shape": "cylinder", "origin": [0, 0, 0],
           "edges": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "inner": "x"})",
     "lattice file: 'inner' is not a number; give 0 (solid) or more, and less than 1"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "origin": [0, 0, 0],
           "edges": [[1, 0, 0], [0, 1, 0], [1, 1, 0]]})",
     "box lattice: its three edges span no volume; give finite edges in three directions"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box"})",
     "lattice file: no 'origin'; give [x, y, z]"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "origin": [0, 0, 0]})",
     "lattice file: no 'edges'; give three vectors, along s, t and u of the shape"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "origin": [0, 0, 0],
           "edges": [[1, 0, 0], "up", [0, 0, 1]]})",
     "lattice file: edge 1 is not a point; give [x, y, z]"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "origin": [0, 0, 0],
           "edges": [[1e308, 1e308, 0], [0, 1, 0], [0, 0, 1]]})",
     "box lattice: its three edges span no volume; give finite edges in three directions"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "origin": [1.7e308, 0, 0],
           "edges": [[1e308, 0, 0], [0, 1e-200, 0], [0, 0, 1e-200]]})",
     "box lattice: its three edges span no volume; give finite edges in three directions"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 6], "shape": "cylinder", "origin": [0, 0, 0],
           "edges": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "inner": 1})",
     "cylinder lattice: inner radius 1 of the outer; give 0 (solid) or more, and less than 1"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 5], "shape": "cylinder", "origin": [0, 0, 0],
           "edges": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]})",
     "cylinder lattice: 5 points along u, which goes around; give at least 6, as three of them "
     "repeat the first three"},
    {R"({"hwffd_lattice": 1, "dims": [4, 4, 6], "shape": "sphere", "origin": [0, 0, 0],
           "edges": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]})",
     "sphere lattice: 4 points along t, which goes around; give at least 5, as three of them lie "
     "at and beyond the poles"}};

TEST(LatticeFile, RefusesInOneLine) {
  for (const Bad& bad : kBad) {
    EXPECT_ERROR(parse_lattice(bad.text), bad.message) << bad.text;
  }
}

TEST(LatticeFile, AnUnknownShapeIsAnsweredByThoseKnown) {
  EXPECT_ERROR(
      parse_lattice(R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "cone"})"),
      "lattice file: unknown 'shape'; give " + shape_list(" or ") + ", or 'points' instead");
}

TEST(LatticeFile, NamesTheFile) {
  const TempFolder folder;
  EXPECT_ERROR(read_lattice_file(folder / "none.json"),
               (folder / "none.json").string() +
                   ": cannot read; check that the file exists and is readable");
  const auto path = folder.write("bad.json", "{}");
  EXPECT_ERROR(
      read_lattice_file(path),
      path.string() + ": lattice file: no 'hwffd_lattice'; give the version of the format, 1");
  EXPECT_ERROR_PART(read_lattice_file(folder / ""), "cannot read; check that the file exists");
  EXPECT_ERROR_PART(write_lattice(folder / "no/lattice.json", crooked()),
                    (folder / "no/lattice.json").string());
  EXPECT_EQ(folder.files(), (std::set<std::string>{"bad.json"}));
}

TEST(LatticeFile, LongNamesAreCut) {
  const std::string text = R"({"hwffd_lattice": 1, ")" + std::string(1000000, 'x') + R"(": 1})";
  EXPECT_ERROR(parse_lattice(text),
               "lattice file: unknown '" + std::string(57, 'x') +
                   "...'; known here are hwffd_lattice, order, dims, points, rest, family");
}

TEST(LatticeFile, PointsThatAreNotFinite) {
  std::string text = lattice_text(parse_lattice(kBox));
  text.replace(text.find("[-1, -10, 0]"), 12, "[-1, 1e999, 0]");
  EXPECT_ERROR(parse_lattice(text),
               "lattice file: line 7, column 10: a number too large for double precision");
}

/// What stands behind the object, whether the parser of JSON looks there or not.
TEST(LatticeFile, NothingFollowsTheObject) {
  const std::string text = lattice_text(parse_lattice(kBox));
  EXPECT_EQ(parse_lattice(text + "\n \t\r\n").points(), parse_lattice(text).points());
  for (const std::string& junk : {std::string("}"), std::string("{}"), std::string("x")}) {
    EXPECT_ERROR(parse_lattice(text + junk),
                 "lattice file: line 128, column 1: no JSON; docs/lattice.md shows the format");
  }
  for (const std::string& after : {std::string(1, '\0'), std::string("\0junk", 5)}) {
    EXPECT_ERROR(parse_lattice(text + after),
                 "lattice file: line 128, column 1: a zero byte; is this the right file?");
  }
}

/// A file without an end is read no further than a lattice file may reach.
TEST(LatticeFile, EndlessFile) {
  EXPECT_ERROR(read_lattice_file("/dev/zero"),
               "/dev/zero: more than 50331648 bytes; is this the right file?");
}

TEST(LatticeFile, UnreadableAndUnwritable) {
  const TempFolder folder;
  const auto path = folder.write("closed.json", kBox);
  std::filesystem::permissions(path, std::filesystem::perms(0));
  folder.open_to_all();
  // A file that opens, but whose first byte cannot be read.
  EXPECT_ERROR_PART(read_lattice_file("/proc/self/mem"),
                    "/proc/self/mem: cannot read; check that the file exists and is readable");
  std::filesystem::create_symlink("/dev/full", folder / "full.json");
  EXPECT_ERROR_PART(write_lattice(folder / "full.json", crooked()),
                    "full.json: cannot write: No space left on device");
  const Unprivileged nobody;
  if (!nobody.effective()) GTEST_SKIP() << "permissions do not hold for this user";
  EXPECT_ERROR(read_lattice_file(path),
               path.string() + ": cannot read; check that the file exists and is readable");
  EXPECT_ERROR_PART(write_lattice(folder / "new.json", crooked()),
                    "new.json: cannot write: Permission denied");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"closed.json", "full.json"}));
}

}  // namespace
}  // namespace hwffd
