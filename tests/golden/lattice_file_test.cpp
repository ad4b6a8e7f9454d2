#include "hwffd/lattice/lattice_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/sphere.hpp"
#include "temp_folder.hpp"

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
  const Lattice back = read_lattice(folder / "crooked.json");
  EXPECT_EQ(back.dims(), lattice.dims());
  EXPECT_EQ(back.points(), lattice.points());
  EXPECT_EQ(folder.files(), (std::set<std::string>{"crooked.json"}));
  EXPECT_EQ(lattice_text(back), read_text(folder / "crooked.json"));
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

TEST(LatticeFile, RefusesInOneLine) {
  const std::vector<Bad> all{
      {"", "lattice file: not a JSON object; docs/lattice.md shows the format"},
      {"[1]", "lattice file: not a JSON object; docs/lattice.md shows the format"},
      {R"({"hwffd_lattice": 1,)",
       "lattice file: not a JSON object; docs/lattice.md shows the format"},
      {R"({"dims": [4, 4, 4]})",
       "lattice file: no 'hwffd_lattice'; give the version of the format, 1"},
      {R"({"hwffd_lattice": 2})",
       "lattice file: 'hwffd_lattice' is not 1, the version that this program reads"},
      {R"({"hwffd_lattice": 1})",
       "lattice file: no 'dims'; give three integers from 4 to 16, points along s, t and u"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4]})",
       "lattice file: 'dims' is not three integers from 4 to 16, points along s, t and u"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4.5, 4]})",
       "lattice file: 'dims' is not three integers from 4 to 16, points along s, t and u"},
      {R"({"hwffd_lattice": 1, "dims": [4, 1e300, 4]})",
       "lattice file: 'dims' is not three integers from 4 to 16, points along s, t and u"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4294967300, 4]})",
       "lattice file: 'dims' is not three integers from 4 to 16, points along s, t and u"},
      {R"({"hwffd_lattice": 1, "dims": [4, 17, 4]})",
       "lattice of 4 x 17 x 4 points: each axis takes 4 to 16 points"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4, 4]})",
       "lattice file: no 'points'; give [[x, y, z], ...], or a 'shape'"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "points": 3})",
       "lattice file: 'points' is not a list; give [[x, y, z], ...]"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "points": [[1, 2, 3], [1, 2]]})",
       "lattice file: point 1 is not a point; give [x, y, z]"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "points": [[1, 2, 3]]})",
       "lattice of 4 x 4 x 4 points: 1 points given; give 64"},
      {R"({"hwffd_lattice": 1, "dim": [4, 4, 4]})",
       "lattice file: unknown \"dim\"; known here are hwffd_lattice, order, dims, points"},
      {R"({"hwffd_lattice": 1, "a\nb": 1})",
       "lattice file: unknown \"a\\nb\"; known here are hwffd_lattice, order, dims, points"},
      {R"({"hwffd_lattice": 1, "order": "s fastest"})",
       "lattice file: another 'order' of the points; sort them so that point (i, j, k) is number "
       "(i*n_t + j)*n_u + k"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "cone"})",
       "lattice file: unknown 'shape'; give box, cylinder or sphere, or 'points' instead"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "points": []})",
       "lattice file: unknown \"points\"; known here are hwffd_lattice, dims, shape, origin, "
       "edges, "
       "inner"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "origin": 0})",
       "lattice file: 'origin' is not a point; give [x, y, z]"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "origin": [0, 0, 0],
           "edges": [1, 2]})",
       "lattice file: 'edges' is not a list of three; give [[x, y, z], ...]"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "origin": [0, 0, 0],
           "edges": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "inner": 0})",
       "lattice file: a box has no 'inner'; leave it out"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4, 6], "shape": "cylinder", "origin": [0, 0, 0],
           "edges": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "inner": "x"})",
       "lattice file: 'inner' is not a number; give 0 (solid) or more, and less than 1"},
      {R"({"hwffd_lattice": 1, "dims": [4, 4, 4], "shape": "box", "origin": [0, 0, 0],
           "edges": [[1, 0, 0], [0, 1, 0], [1, 1, 0]]})",
       "box lattice: its three edges span no volume; give finite edges in three directions"}};
  for (const Bad& bad : all) {
    EXPECT_EQ(message_of<Error>([&] { parse_lattice(bad.text); }), bad.message) << bad.text;
  }
}

TEST(LatticeFile, NamesTheFile) {
  const TempFolder folder;
  EXPECT_EQ(message_of<Error>([&] { read_lattice(folder / "none.json"); }),
            (folder / "none.json").string() +
                ": cannot read; check that the file exists and is readable");
  const auto path = folder.write("bad.json", "{}");
  EXPECT_EQ(
      message_of<Error>([&] { read_lattice(path); }),
      path.string() + ": lattice file: no 'hwffd_lattice'; give the version of the format, 1");
  expect_part(message_of<Error>([&] { read_lattice(folder / ""); }),
              "cannot read; check that the file exists");
  EXPECT_EQ(message_of<Error>([&] {
              write_lattice(folder / "no/lattice.json", crooked());
            }).rfind((folder / "no/lattice.json").string(), 0),
            0u);
  EXPECT_EQ(folder.files(), (std::set<std::string>{"bad.json"}));
}

/// Bytes changed, cut and doubled at random: refused or read, never anything else.
TEST(LatticeFile, MangledTextIsRefusedOrRead) {
  const std::string good = lattice_text(parse_lattice(kBox));
  const std::string text = std::string(kBox);
  std::uint64_t state = 1;
  const auto below = [&](std::size_t n) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::size_t>(state >> 33) % n;
  };
  int refused = 0;
  int read = 0;
  for (int n = 0; n < 4000; ++n) {
    std::string mangled = n % 8 == 0 ? good : text;
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
      const std::size_t at = below(mangled.size());
      const std::size_t kind = below(4);
      if (kind == 0) mangled[at] = static_cast<char>(below(256));
      if (kind == 1) mangled[at] = "0123456789-+.eE[]{},:\""[below(22)];
      if (kind == 2) mangled.erase(at, 1 + below(20));
      if (kind == 3) mangled.insert(at, mangled.substr(below(mangled.size()), below(20)));
    }
    try {
      const Lattice lattice = parse_lattice(mangled);
      EXPECT_TRUE(lattice.points().allFinite());
      ++read;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_EQ(refused + read, 4000);
  EXPECT_GT(refused, 1000);
  EXPECT_GT(read, 50);
}

}  // namespace
}  // namespace hwffd
