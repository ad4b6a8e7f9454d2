// A mesh that comes back in its own format is its file, edited.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "errors.hpp"
#include "mesh_files.hpp"

namespace hwffd {
namespace {

/// A file, and what it becomes at twice its size and as its mirror image along x.
struct Example {
  const char* name;
  std::string text;
  std::string doubled;
  std::string mirrored;
};

std::vector<Eigen::Matrix3d> everywhere(const Mesh& mesh, const Eigen::Matrix3d& gradient) {
  return std::vector<Eigen::Matrix3d>(mesh.vertex_count(), gradient);
}

class MeshEdit : public MeshFiles {
 protected:
  /// The file that is written of this one when it is moved by a matrix.
  std::string moved(const Example& example, const Eigen::Matrix3d& by) const {
    const std::string name = std::string("in.") + example.name;
    Mesh mesh = load(example.text, name);
    mesh.set_positions(mesh.positions() * by.transpose(), everywhere(mesh, by));
    const std::filesystem::path out = folder / (std::string("out.") + example.name);
    EXPECT_TRUE(mesh.edits(out));
    EXPECT_EQ(mesh.save(out), std::vector<std::string>());
    return read_text(out);
  }

  void check(const std::vector<Example>& examples) const {
    for (const Example& example : examples) {
      SCOPED_TRACE(example.text);
      // Rounding alone moves nothing.
      EXPECT_EQ(moved(example, Eigen::Matrix3d::Identity()), example.text);
      const Eigen::Matrix3d nearly = Eigen::Matrix3d::Identity() * (1 + 1e-15);
      Mesh mesh = load(example.text, std::string("in.") + example.name);
      mesh.set_positions(mesh.positions(), everywhere(mesh, nearly));
      mesh.save(folder / (std::string("same.") + example.name));
      EXPECT_EQ(read_text(folder / (std::string("same.") + example.name)), example.text);
      EXPECT_EQ(moved(example, 2 * Eigen::Matrix3d::Identity()), example.doubled);
      const Eigen::Matrix3d mirror = Eigen::Vector3d(-1, 1, 1).asDiagonal();
      const std::string mirrored = moved(example, mirror);
      if (!example.mirrored.empty()) {
        EXPECT_EQ(mirrored, example.mirrored);
      }
    }
  }
};

TEST_F(MeshEdit, Obj) {
  check({
      // Comments, blank lines, statements that no other format has, corners of every kind.
      {"obj",
       "# a  #b\n\nmtllib  none.mtl\nv 0.50 0 0 # first\n  v 1e0 +0 0\nv\t0 1.0 0\nvt .5 0\nvn 0 0 "
       "2\n"
       "vp 0.1\ns 1\ng a b\nf 1/1/1 2/1/1 3/1/1\nl 1 2 3\np 1 2\nf -3//-1 2//1 3//1 # last",
       "# a  #b\n\nmtllib  none.mtl\nv 1 0 0 # first\n  v 2 +0 0\nv\t0 2 0\nvt .5 0\nvn 0 0 2\n"
       "vp 0.1\ns 1\ng a b\nf 1/1/1 2/1/1 3/1/1\nl 1 2 3\np 1 2\nf -3//-1 2//1 3//1 # last",
       "# a  #b\n\nmtllib  none.mtl\nv -0.5 0 0 # first\n  v -1 +0 0\nv\t0 1.0 0\nvt .5 0\nvn 0 0 "
       "2\n"
       "vp 0.1\ns 1\ng a b\nf 1/1/1 3/1/1 2/1/1\nl 1 2 3\np 1 2\nf -3//-1 3//1 2//1 # last"},
      // A byte order mark, CR, weights, lines that go on, numbers of more digits than binary32 has.
      {"obj", "\xEF\xBB\xBFv 1.00000000001 0 \\\r 0\rv 2 2 0 2\rv 0 1 0 0.1 0.2 0.3\rf 1 \\\r2 3\r",
       "\xEF\xBB\xBFv 2.00000000002 0 \\\r 0\rv 4 4 0 2\rv 0 2 0 0.1 0.2 0.3\rf 1 \\\r2 3\r",
       "\xEF\xBB\xBFv -1.00000000001 0 \\\r 0\rv -2 2 0 2\rv 0 1 0 0.1 0.2 0.3\rf 1 \\\r3 2\r"},
      // A comment that ends in a backslash does not go on.
      {"obj", "# C:\\scenes\\\r\nv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
       "# C:\\scenes\\\r\nv 0 0 0\r\nv 2 0 0\r\nv 0 2 0\r\nf 1 2 3\r\n",
       "# C:\\scenes\\\r\nv 0 0 0\r\nv -1 0 0\r\nv 0 1 0\r\nf 1 3 2\r\n"},
  });
}

const std::string kPlyHead =
    "ply\r\nformat ascii 1.0\r\ncomment a\r\nelement vertex 3\r\nproperty float q\r\n"
    "property double z\r\nproperty float y\r\nproperty list uchar int l\r\nproperty float x\r\n"
    "property float nx\r\nproperty float ny\r\nproperty float nz\r\nelement face 1\r\n"
    "property list uchar int vertex_indices\r\nproperty list uchar float texcoord\r\n"
    "property int id\r\nelement edge 1\r\nproperty int vertex1\r\nend_header\r\n";

TEST_F(MeshEdit, PlyText) {
  check({{"ply",
          kPlyHead + "1.50 0.0 0 2 7 8 0 0 0 2\r\n\r\n 1e0 0 0 0 1.0 0 0 2 7 1E-9 1.25 0\r\n"
                     "0.5 0 0 1\r\n3 0 1 2 6 0 0 1.0 0 1 1.5 77\r\n9\r\n# trailing",
          kPlyHead + "1.50 0.0 0 2 7 8 0 0 0 2\r\n\r\n 1e0 0 0 0 2 0 0 2 7 2e-09 2.5 0\r\n"
                     "1 0 0 1\r\n3 0 1 2 6 0 0 1.0 0 1 1.5 77\r\n9\r\n# trailing",
          kPlyHead + "1.50 0.0 0 2 7 8 0 0 0 2\r\n\r\n 1e0 0 0 0 -1 0 0 2 7 1E-9 1.25 0\r\n"
                     "-0.5 0 0 1\r\n3 0 2 1 6 0 0 1 1.5 1.0 0 77\r\n9\r\n# trailing"}});
}

/// A binary file of every type, of either order of bytes, with a list and a face in between.
TEST_F(MeshEdit, PlyBinary) {
  const auto number = [](auto value, bool is_big) {
    std::string bytes(sizeof(value), '\0');
    std::memcpy(bytes.data(), &value, sizeof(value));
    if (is_big) std::reverse(bytes.begin(), bytes.end());
    return bytes;
  };
  for (const bool is_big : {false, true}) {
    const auto file = [&](float x, double y, std::int16_t z, std::uint8_t b, std::uint8_t c) {
      std::string bytes = "ply\nformat binary_" + std::string(is_big ? "big" : "little") +
                          "_endian 1.0\nelement face 1\nproperty list uchar uchar vertex_index\n"
                          "element vertex 3\nproperty short z\nproperty list ushort char l\n"
                          "property double y\nproperty float x\nend_header\n";
      bytes += std::string("\3\0", 2) + static_cast<char>(b) + static_cast<char>(c);
      for (int v = 0; v < 3; ++v) {
        bytes += number(v == 2 ? z : std::int16_t{0}, is_big) +
                 number(static_cast<std::uint16_t>(v), is_big) +
                 std::string(static_cast<std::size_t>(v), '\7') + number(v == 1 ? y : 0.0, is_big) +
                 number(v == 0 ? x : 0.0f, is_big);
      }
      return bytes + "beyond";
    };
    check({{"ply", file(1.5f, 0.1, -3, 1, 2), file(3, 0.2, -6, 1, 2), file(-1.5f, 0.1, -3, 2, 1)}});
    Mesh mesh = load(file(1.5f, 0.1, -3, 1, 2), "a.ply");
    mesh.set_positions(0.5 * mesh.positions());
    EXPECT_ERROR_PART(mesh.save(folder / "b.ply"),
                      "a coordinate becomes -1.5, which its type, short, does not hold");
  }
}

/// A coordinate of each type, in text and in either order of bytes, becomes twice as large; what
/// its type does not hold is refused.
TEST_F(MeshEdit, PlyCoordinatesOfEveryType) {
  int checked = 0;
  const auto check = [&](const std::string& type, auto value, double too_large) {
    for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
      SCOPED_TRACE(fmt::format("{} {}", type, format));
      const auto file = [&](auto number) {
        std::string bytes = fmt::format(
            "ply\nformat {} 1.0\nelement vertex 1\nproperty {} x\nproperty uchar y\n"
            "property char z\nend_header\n",
            format, type);
        if (format == "ascii") return bytes.append(std::to_string(number)).append(" 0 0\n");
        std::string data(sizeof(number), '\0');
        std::memcpy(data.data(), &number, sizeof(number));
        if (format == "binary_big_endian") std::reverse(data.begin(), data.end());
        return bytes + data + std::string(2, '\0');
      };
      using T = decltype(value);
      Mesh mesh = load(file(value), "in.ply");
      EXPECT_EQ(mesh.positions()(0, 0), static_cast<double>(value));
      mesh.set_positions(2 * mesh.positions());
      mesh.save(folder / "out.ply");
      if (format == "ascii") {
        EXPECT_EQ(Mesh::load(folder / "out.ply").positions(), mesh.positions());
      } else {
        EXPECT_EQ(read_text(folder / "out.ply"), file(static_cast<T>(2 * value)));
      }
      ++checked;
      if (too_large == 0) continue;
      for (const double bad : {too_large, value + 0.5, -too_large - 1}) {
        mesh.set_positions(Eigen::RowVector3d(bad, 0, 0));
        EXPECT_ERROR_PART(mesh.save(folder / "bad.ply"),
                          "which its type, " + type + ", does not hold; write another format");
      }
    }
  };
  check("char", std::int8_t{-64}, 0x1p7);
  check("uchar", std::uint8_t{100}, 0x1p8);
  check("short", std::int16_t{-16384}, 0x1p15);
  check("ushort", std::uint16_t{32767}, 0x1p16);
  check("int", std::int32_t{-70000}, 0x1p31);
  check("uint", std::uint32_t{2000000000}, 0x1p32);
  check("float", 1.5f, 0);
  check("double", 0.1, 0);
  EXPECT_EQ(checked, 24);
}

TEST_F(MeshEdit, StripsOfPly) {
  const auto file = [](const std::string& x, const std::string& strip) {
    return "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
           "property float z\nelement tristrips 1\nproperty list int int "
           "vertex_indices\nend_header\n"
           "0 0 0\n" +
           x + " 0 0\n0 1 0\n0 0 0\n0 0 0\n" + strip + "\n";
  };
  Mesh mesh = load(file("1", "9 0 1 2 -1 0 1 2 4 3"), "in.ply");
  const Eigen::Matrix3d mirror = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  mesh.set_positions(mesh.positions() * mirror, everywhere(mesh, mirror));
  mesh.save(folder / "out.ply");
  EXPECT_EQ(read_text(folder / "out.ply"), file("-1", "9 2 1 0 -1 3 4 2 1 0"));
  mesh = load(file("1", "4 0 1 2 4"), "in.ply");
  mesh.set_positions(mesh.positions() * mirror, everywhere(mesh, mirror));
  EXPECT_ERROR_PART(mesh.save(folder / "b.ply"), "a strip of 4 vertices cannot be turned round");
}

TEST_F(MeshEdit, Off) {
  check({{"off", "# a\nOFF\n\n3 2 0 # b\n0.50 0 0\n0 1.0 0\n0 0 -0\n3 0 1 2 255 0 0 # red\n2 0 1",
          "# a\nOFF\n\n3 2 0 # b\n1 0 0\n0 2 0\n0 0 -0\n3 0 1 2 255 0 0 # red\n2 0 1",
          "# a\nOFF\n\n3 2 0 # b\n-0.5 0 0\n0 1.0 0\n0 0 -0\n3 0 2 1 255 0 0 # red\n2 0 1"},
         {"off",
          "STCNOFF 3 1 0 0.3333333333333 0 0 0 0 1 9 8 7 6 .5 .5\n0 1 0 0 0 1 9 8 7 6 1 1\n"
          "0 0 0 0 0 1 9 8 7 6 0 0\n3 0 1 2\n",
          "STCNOFF 3 1 0 0.6666666666666 0 0 0 0 1 9 8 7 6 .5 .5\n0 2 0 0 0 1 9 8 7 6 1 1\n"
          "0 0 0 0 0 1 9 8 7 6 0 0\n3 0 1 2\n",
          "STCNOFF 3 1 0 -0.3333333333333 0 0 0 0 1 9 8 7 6 .5 .5\n0 1 0 0 0 1 9 8 7 6 1 1\n"
          "0 0 0 0 0 1 9 8 7 6 0 0\n3 0 2 1\n"}});
}

TEST_F(MeshEdit, StlText) {
  const std::string end = "endloop\n endfacet\nendsolid  A b\n";
  check({{"stl",
          "solid  A b\n FACET normal 0.0 0 1\n outer loop\nvertex 0.50 0 0 vertex 0 1.0 0\n"
          "vertex 0 0 0\n" +
              end,
          "solid  A b\n FACET normal 0.0 0 1\n outer loop\nvertex 1 0 0 vertex 0 2 0\n"
          "vertex 0 0 0\n" +
              end,
          "solid  A b\n FACET normal 0.0 0 1\n outer loop\nvertex -0.5 0 0 vertex 0 0 0\n"
          "vertex 0 1 0\n" +
              end},
         // Two solids, numbers of more digits than binary32 has, and a facet without a normal.
         {"stl",
          "solid\nfacet normal 0 0 0\nouter loop\nvertex 0.3333333333333 0 0\nvertex 0 1 0\n"
          "vertex 0 0 0\n" +
              end + "solid b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n" +
              "vertex 0 1 0\n" + end,
          "solid\nfacet normal 0 0 0\nouter loop\nvertex 0.6666666666666 0 0\nvertex 0 2 0\n"
          "vertex 0 0 0\n" +
              end + "solid b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\n" +
              "vertex 0 2 0\n" + end,
          "solid\nfacet normal 0 0 0\nouter loop\nvertex -0.3333333333333 0 0\nvertex 0 0 0\n"
          "vertex 0 1 0\n" +
              end + "solid b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\n" +
              "vertex -1 0 0\n" + end}});
}

/// The normal of a facet that moved is that of its corners, on the side where it was, in text and
/// in bytes; one that is none stays, and so does that of a facet that has shrunk to a line.
TEST_F(MeshEdit, NormalsOfStl) {
  Eigen::Matrix3d turn;  // x to y, y to z, z to x
  turn << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const Eigen::Matrix3d line = Eigen::Vector3d(2, 0, 0).asDiagonal();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  using Normal = std::array<float, 3>;
  struct Case {
    Normal read;
    Eigen::Matrix3d by;
    Normal written;
  };
  const std::vector<Case> cases{{{0, 0, 1}, turn, {1, 0, 0}},
                                {{0, 0, -1}, turn, {-1, 0, -0.0f}},
                                {{0, 0, 0}, turn, {0, 0, 0}},
                                {{0, nan, 1}, turn, {0, nan, 1}},
                                {{0, 0, 1}, line, {0, 0, 1}}};
  for (const Case& one : cases) {
    const auto numbers_of = [](const Normal& normal, const Eigen::Matrix3d& by) {
      std::vector<float> numbers(normal.begin(), normal.end());
      for (const Eigen::Vector3d& corner :
           {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0)}) {
        const Eigen::Vector3f to = (by * corner).cast<float>();
        numbers.insert(numbers.end(), to.data(), to.data() + 3);
      }
      return numbers;
    };
    const auto text = [](const std::vector<float>& numbers) {
      std::string words = "solid\n";
      for (std::size_t n = 0; n < numbers.size(); ++n) {
        words += n == 0       ? "facet normal"
                 : n == 3     ? "\nouter loop\nvertex"
                 : n % 3 == 0 ? "\nvertex"
                              : "";
        words += fmt::format(" {}", numbers[n]);
      }
      return words + "\nendloop\nendfacet\nendsolid\n";
    };
    const auto bytes = [](const std::vector<float>& numbers) {
      return std::string(80, ' ') + std::string("\1\0\0\0", 4) +
             std::string(reinterpret_cast<const char*>(numbers.data()), 48) + std::string(2, '\0');
    };
    const std::vector<float> before = numbers_of(one.read, Eigen::Matrix3d::Identity());
    const std::vector<float> after = numbers_of(one.written, one.by);
    EXPECT_EQ(moved({"stl", text(before), "", ""}, one.by), text(after));
    EXPECT_EQ(moved({"stl", bytes(before), "", ""}, one.by), bytes(after)) << text(after);
  }
}

/// Header, attributes and what follows the facets stay.
TEST_F(MeshEdit, StlBinary) {
  const auto file = [](float x, float y) {
    std::string bytes = "solid part" + std::string(70, ' ') + std::string("\1\0\0\0", 4);
    for (const float value : {0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, x, 0.0f, 0.0f, 0.0f, y, 0.0f}) {
      std::string number(sizeof(float), '\0');
      std::memcpy(number.data(), &value, sizeof(float));
      bytes += number;
    }
    return bytes + "ab";
  };
  check({{"stl", file(1.5f, 1), file(3, 2), ""}});
  EXPECT_EQ(load(file(1.5f, 1), "a.stl").dropped(),
            std::vector<std::string>{"attributes of facets"});
}

/// A normal that is no vector is none, and stays.
TEST_F(MeshEdit, BrokenNormals) {
  const std::string obj = "v 0 0 0\nv 2 0 0\nv 0 2 0\nvn 1 nan 0\nvn inf 0 0\nf 1//1 2//2 3//1\n";
  const std::string doubled =
      "v 0 0 0\nv 4 0 0\nv 0 4 0\nvn 1 nan 0\nvn inf 0 0\nf 1//1 2//2 3//1\n";
  const std::string stl =
      "solid\nfacet normal 0 nan 0\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 2 0\n"
      "endloop\nendfacet\nendsolid\n";
  check({{"obj", obj, doubled, ""}});
  EXPECT_EQ(moved({"stl", stl, "", ""}, Eigen::Matrix3d::Identity()), stl);
}

/// A normal that several corners share and that they do no more stands once for each direction,
/// behind the one that was read.
TEST_F(MeshEdit, NormalsThatPart) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nvn 0 0 1\nf 1//2 2//2 3//2\nf 1//-2 2//-1 3//1\n";
  Mesh mesh = load(text, "a.obj");
  std::vector<Eigen::Matrix3d> gradients = everywhere(mesh, Eigen::Matrix3d::Identity());
  gradients[2] = Eigen::AngleAxisd(EIGEN_PI / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
  mesh.set_positions(mesh.positions(), gradients);
  mesh.save(folder / "b.obj");
  const std::string written = read_text(folder / "b.obj");
  expect_part(written, "v 0 1 0\nvn 1 0 0\nvn 0 0 1\nvn 0 -1 ");
  expect_part(written, "\nf 1//2 2//2 3//3\nf 1//-3 2//-2 3//1\n");
  const Mesh again = Mesh::load(folder / "b.obj");
  int checked = 0;
  each_vertex(again, [&](const aiMesh& part, unsigned v) {
    if (part.mVertices[v] != aiVector3D(0, 1, 0)) return;
    const aiVector3D n = part.mNormals[v];
    EXPECT_TRUE(n == aiVector3D(1, 0, 0) || (n - aiVector3D(0, -1, 0)).Length() < 1e-6f);
    ++checked;
  });
  EXPECT_EQ(checked, 2);
}

}  // namespace
}  // namespace hwffd
