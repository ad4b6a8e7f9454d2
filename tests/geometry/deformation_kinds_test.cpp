// Deformations of every kind on lattices of every shape.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "errors.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/closure.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/few_points.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "hwffd/lattice/sphere.hpp"
#include "same_bits.hpp"
#include "temp_folder.hpp"

namespace hwffd {
namespace {

constexpr double kTiny = 1e-13;
const Eigen::Matrix3d kKindsEdges = Eigen::Vector3d(1, 2, 1.5).asDiagonal();

Lattice deform(const std::string& text, const Lattice& lattice) {
  return Deformation::parse(text).apply(lattice);
}

struct Shape {
  const char* name;
  Lattice lattice;
};

std::vector<Shape> shapes() {
  return {{"box", Box(Point(1, 2, 3), kKindsEdges).lattice({5, 6, 7})},
          {"cylinder", Cylinder(Point(1, 2, 3), kKindsEdges).lattice({5, 6, 11})},
          {"tube", Cylinder(Point(1, 2, 3), kKindsEdges, 0.4).lattice({4, 6, 9})},
          {"sphere", Sphere(Point(1, 2, 3), kKindsEdges).lattice({5, 8, 11})},
          {"shell", Sphere(Point(1, 2, 3), kKindsEdges, 0.4).lattice({4, 7, 10})}};
}

/// One of each kind but none, so mild that nothing should fold.
const std::vector<std::string>& mild() {
  static const std::vector<std::string> texts{
      "twist:30",    "twist:20:x", "helix:30",          "helix:30:z",
      "shear:0.1",   "bend:30",    "bend:20:yz",        "taper:0.7",
      "taper:0.8:x", "scale:1.3",  "scale:1.2,0.8,1.1", "move:2,3,2:0.02,0.03,-0.01"};
  return texts;
}

/// Whether closed axes of `rest` repeat their layers bit for bit.
bool layers_repeat(const Lattice& rest, const Lattice& moved) {
  const Closure closure(rest);
  const Index3& d = moved.dims();
  for (const Index3& at : places(d)) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (!closure.closed(static_cast<int>(a)) || at[a] < d[a] - 3) continue;
      Index3 first = at;
      first[a] -= d[a] - 3;
      if (!same_bits(moved.point(at), moved.point(first))) return false;
    }
  }
  return true;
}

/// Joints that Closure still finds, to within 1e-12 of the size, of those that were there.
void expect_joints(const Lattice& rest, const Lattice& moved, const std::string& what) {
  const Closure before(rest);
  const Closure after(moved);
  EXPECT_TRUE(layers_repeat(rest, moved)) << what;
  EXPECT_EQ(after.collapsed().size(), before.collapsed().size()) << what;
  for (int a = 0; a < 3; ++a) EXPECT_EQ(after.closed(a), before.closed(a)) << what;
}

TEST(DeformationKinds, JointsStayAndMildOnesDoNotFold) {
  for (const Shape& shape : shapes()) {
    for (const std::string& text : mild()) {
      const std::string what = shape.name + (" " + text);
      const Lattice moved = deform(text, shape.lattice);
      EXPECT_NE(moved.points(), shape.lattice.points()) << what;
      expect_joints(shape.lattice, moved, what);
      const FoldCheck folds = check_folds(moved);
      EXPECT_EQ(folds.verdict, FoldCheck::Verdict::kProved) << what << ": " << folds.text();
    }
  }
}

TEST(DeformationKinds, JointsStayUnderStrongOnes) {
  for (const Shape& shape : shapes()) {
    for (const std::string text :
         {"random:3", "twist:170", "twist:170:z", "helix:400", "bend:300", "bend:300:zx", "taper:0",
          "scale:-2,3,0.1", "move:0,0,0:1,2,3", "move:1,1,8:1,2,3"}) {
      if (shape.name == std::string("box") && text == "move:1,1,8:1,2,3") continue;
      expect_joints(shape.lattice, deform(text, shape.lattice), shape.name + (" " + text));
    }
  }
}

TEST(DeformationKinds, NeutralOnesMoveNothing) {
  for (const Shape& shape : shapes()) {
    for (const std::string text : {"none", "twist:0", "twist:0:x", "helix:0", "shear:0", "bend:0",
                                   "taper:1", "scale:1", "scale:1,1,1", "move:0,0,0:0,0,0"}) {
      const Points difference = deform(text, shape.lattice).points() - shape.lattice.points();
      EXPECT_LT(difference.norm(), kTiny) << shape.name << " " << text;
    }
  }
}

/// In a lattice with joints twist and shear are functions of position: with v the height within the
/// bounding box, points turn by v (R - 1) and rise by the same bilinear function everywhere.
TEST(DeformationKinds, FunctionsOfPositionWhereJoined) {
  const Eigen::RowVector3d lever(1, 0, 1);
  int checked = 0;
  for (const Shape& shape : shapes()) {
    // At poles the layer beyond the face moves a second time, to keep it collapsed.
    if (shape.name != std::string("cylinder") && shape.name != std::string("tube")) continue;
    const Points& rest = shape.lattice.points();
    const Eigen::RowVector3d low = rest.colwise().minCoeff();
    const Eigen::RowVector3d extent = rest.colwise().maxCoeff() - low;
    const Eigen::RowVector3d centre = low + extent / 2;
    const Points twisted = deform("twist:90", shape.lattice).points();
    const Points sheared = deform("shear:0.5", shape.lattice).points();
    for (Eigen::Index i = 0; i < rest.rows(); ++i, ++checked) {
      const Eigen::RowVector3d place = (rest.row(i) - low).cwiseQuotient(extent);
      const Eigen::RowVector3d arm = (rest.row(i) - centre).cwiseProduct(lever);
      const Eigen::RowVector3d turned(arm[2], 0, -arm[0]);
      EXPECT_LT((twisted.row(i) - rest.row(i) - place[1] * (turned - arm)).norm(), kTiny);
      const double lift = 0.5 * extent[1] * (2 * place[0] - 1) * (1 - place[1]);
      EXPECT_LT((sheared.row(i) - rest.row(i) - lift * Eigen::RowVector3d(0, 1, 0)).norm(), kTiny);
    }
  }
  EXPECT_EQ(checked, 5 * 6 * 11 + 4 * 6 * 9);
}

/// 4 x 4 x 4 points from (0, 0, 0) to (3, 3, 3).
Lattice cube() { return Box(Point(1, 1, 1), Eigen::Matrix3d::Identity()).lattice({4, 4, 4}); }

TEST(DeformationKinds, KnownTaperScaleAndMove) {
  const Lattice tapered = deform("taper:0.5", cube());
  const Lattice scaled = deform("scale:2,1,-1", cube());
  const Lattice moved = deform("move:1,2,3:0.5,-1,4", cube());
  for (const auto& [i, j, k] : places({4, 4, 4})) {
    const double f = 1 - 0.5 * j / 3;
    const Point taper(1.5 + f * (i - 1.5), j, 1.5 + f * (k - 1.5));
    EXPECT_LT((tapered.point(i, j, k) - taper).norm(), kTiny);
    EXPECT_LT((scaled.point(i, j, k) - Point(2 * i - 1.5, j, 3 - k)).norm(), kTiny);
    const bool named = i == 1 && j == 2 && k == 3;
    const Point displacement = named ? Point(0.5, -1, 4) : Point(0, 0, 0);
    EXPECT_LT((moved.point(i, j, k) - Point(i, j, k) - displacement).norm(), kTiny);
  }
}

/// The lattice with its axes renamed, in space and in the index: axis a becomes to[a].
Lattice renamed(const Lattice& lattice, const Index3& to) {
  const auto axis = [&](int a) {
    return static_cast<std::size_t>(to[static_cast<std::size_t>(a)]);
  };
  const Index3& d = lattice.dims();
  Index3 dims{};
  for (int a = 0; a < 3; ++a) dims[axis(a)] = d[static_cast<std::size_t>(a)];
  Points points(lattice.points().rows(), 3);
  for (const Index3& from : places(d)) {
    Index3 at{};
    for (int a = 0; a < 3; ++a) at[axis(a)] = from[static_cast<std::size_t>(a)];
    const Eigen::Index target = (at[0] * dims[1] + at[1]) * dims[2] + at[2];
    for (int a = 0; a < 3; ++a) points(target, static_cast<int>(axis(a))) = lattice.point(from)[a];
  }
  return Lattice(dims, points);
}

/// A deformation about another axis is the one about y with the axes renamed in turn; a bend
/// towards z instead of x is one in a mirror.
TEST(DeformationKinds, AxesOnlyChangeTheirNames) {
  struct Names {
    const char* axis;
    Index3 to;  ///< what x, y, z are called
  };
  const std::vector<Names> turns{{":y", {0, 1, 2}}, {":z", {1, 2, 0}}, {":x", {2, 0, 1}}};
  for (const Shape& shape : shapes()) {
    for (const std::string text : {"twist:50", "helix:50", "bend:50", "taper:0.5"}) {
      const Lattice moved = deform(text, shape.lattice);
      for (const Names& names : turns) {
        const Lattice got = deform(text + names.axis, renamed(shape.lattice, names.to));
        EXPECT_LT((got.points() - renamed(moved, names.to).points()).norm(), 1e-12)
            << shape.name << " " << text << names.axis;
      }
    }
    const Index3 mirror{2, 1, 0};
    const Lattice mirrored = deform("bend:50:yz", renamed(shape.lattice, mirror));
    const Lattice expected = renamed(deform("bend:50:yx", shape.lattice), mirror);
    EXPECT_LT((mirrored.points() - expected.points()).norm(), 1e-12) << shape.name;
  }
}

/// Naming a repeated point or the point that it repeats is the same.
TEST(DeformationKinds, RepeatedPointsMoveTogether) {
  const Lattice tube = Cylinder(Point(1, 2, 3), kKindsEdges, 0.4).lattice({4, 6, 9});
  const Lattice moved = deform("move:3,2,1:0.1,0,0", tube);
  EXPECT_EQ(deform("move:3,2,7:0.1,0,0", tube).points(), moved.points());
  EXPECT_EQ(moved.point(3, 2, 7), moved.point(3, 2, 1));
  EXPECT_NEAR(moved.point(3, 2, 7).x() - tube.point(3, 2, 7).x(), 0.1, kTiny);
  EXPECT_EQ(((moved.points() - tube.points()).rowwise().norm().array() > 0).count(), 2);
}

TEST(DeformationKinds, ToTakesTheFileAsItIs) {
  const TempFolder folder;
  for (const Shape& shape : shapes()) {
    const Lattice target = deform("bend:40", shape.lattice);
    write_lattice(folder / "target.json", target);
    const Lattice moved = deform("to:" + (folder / "target.json").string(), shape.lattice);
    EXPECT_EQ(moved.points(), target.points());
    expect_joints(shape.lattice, moved, shape.name);
  }
}

// Each family makes the faces of its cells of other points, and joints are where faces meet.
class DeformationKindsOf : public testing::TestWithParam<std::string> {
 protected:
  const Family family = Family::parse(GetParam());

  Lattice around(const char* shape, const Index3& dims) const {
    const Points corners = corners_of(Point(-1, -2, -1), Point(1, 2, 1));
    return whole(lattice_around(shape, corners, std::optional<Index3>(dims), family), family);
  }

  Lattice moved(const std::string& text, const Lattice& lattice) const {
    return Deformation::parse(text).apply(lattice, family);
  }

  /// The point at coordinates from 0 to 1 over all cells.
  Point at(const Lattice& lattice, double s, double t, double u) const {
    const Eigen::Vector3d place(s, t, u);
    Index3 cell{};
    Eigen::Vector3d local;
    for (int a = 0; a < 3; ++a) {
      const int count = family.cells(lattice.dims())[static_cast<std::size_t>(a)];
      const int of_axis = std::min(static_cast<int>(place[a] * count), count - 1);
      cell[static_cast<std::size_t>(a)] = of_axis;
      local[a] = place[a] * count - of_axis;
    }
    return Oracle().evaluate(family.support(lattice, cell), local[0], local[1], local[2]);
  }
};

TEST_P(DeformationKindsOf, JointsStay) {
  constexpr double kJoined = 1e-12;
  for (const char* shape : {"cylinder", "sphere"}) {
    const Lattice rest = around(shape, {7, 7, 13});
    for (const std::string text : {"random:2", "move:2,3,0:0.1,0.2,0", "move:2,3,12:0.1,0.2,0",
                                   "move:1,2,2:0.1,0.2,0", "twist:90", "bend:60", "helix:50"}) {
      const Lattice now = moved(text, rest);
      EXPECT_GT((now.points() - rest.points()).norm(), 0.01);
      for (const double v : {0.0, 0.3, 1.0}) {
        EXPECT_LT((at(now, v, 0.4, 0) - at(now, v, 0.4, 1)).norm(), kJoined) << shape << text << v;
        EXPECT_LT((at(now, 0, v, 0.1) - at(now, 0, v, 0.6)).norm(), kJoined) << shape << text << v;
      }
      const Closure before(rest, family);
      const Closure after(now, family);
      EXPECT_TRUE(before.closed(2));
      EXPECT_TRUE(after.closed(2)) << shape << text;
      EXPECT_EQ(after.collapsed().size(), before.collapsed().size()) << shape << text;
    }
  }
}

TEST_P(DeformationKindsOf, AxesOfCylindersStayWhereTheyAre) {
  const Lattice rest = around("cylinder", {4, 7, 13});
  for (const std::string text : {"twist:90", "helix:90", "taper:0.5"}) {
    const Lattice now = moved(text, rest);
    for (const double t : {0.0, 0.4, 1.0}) {
      EXPECT_LT((at(now, 0, t, 0.2) - at(rest, 0, t, 0.2)).norm(), 1e-12) << text << t;
    }
  }
}

TEST_P(DeformationKindsOf, HelixTurnsWhatTheCellsHold) {
  std::vector<Index3> all{{4, 4, 4}, {4, 7, 4}, {4, 13, 4}};
  if (family.takes_few()) all.insert(all.end(), {{2, 4, 3}, {2, 2, 2}, {3, 7, 2}});
  for (const Index3& dims : all) {
    const Points corners = corners_of(Point(-1, -2, -1), Point(1, 2, 1));
    const Lattice few = lattice_around("box", corners, std::optional<Index3>(dims), family);
    const Lattice now = whole(moved("helix:90", few), family);
    const Point bottom = at(now, 1, 0, 0.5);
    const Point top = at(now, 1, 1, 0.5);
    EXPECT_NEAR(bottom.z(), 0, kTiny) << dims[1];
    EXPECT_NEAR(top.x(), 0, kTiny) << dims[1];
    EXPECT_NEAR(top.z(), -bottom.x(), kTiny) << dims[1];
    EXPECT_GT(bottom.x(), 0.5) << dims[1];
  }
}

TEST_P(DeformationKindsOf, ToTakesPointsOfTheSameFamily) {
  const TempFolder folder;
  const Lattice rest = around("box", {4, 7, 4});
  const std::string file = (folder / "target.json").string();
  for (const std::string& name : Family::names()) {
    write_lattice(file, LatticeFile{moved("bend:40", rest), {}, Family::parse(name)});
    // A file of B-splines does not say so.
    if (name == GetParam() || name == "bspline") {
      EXPECT_EQ(moved("to:" + file, rest).points(), moved("bend:40", rest).points());
      continue;
    }
    EXPECT_ERROR(moved("to:" + file, rest),
                 fmt::format("deformation to:{}: its points are of the family {}, and the lattice "
                             "that moves there is of {}; give both the same family",
                             file, name, GetParam()));
  }
}

INSTANTIATE_TEST_SUITE_P(, DeformationKindsOf, testing::ValuesIn(Family::names()),
                         [](const auto& info) {
                           return info.param.substr(0, info.param.find('-'));
                         });

TEST(DeformationKinds, RefusesWhatDoesNotFit) {
  const TempFolder folder;
  write_lattice(folder / "cube.json", cube());
  const std::string file = (folder / "cube.json").string();
  EXPECT_ERROR(deform("to:" + file, shapes()[0].lattice),
               "deformation to:" + file + ": that lattice has 4 x 4 x 4 points; give 5 x 6 x 7");
  EXPECT_ERROR_PART(deform("to:" + (folder / "none.json").string(), cube()), "none.json");
  EXPECT_ERROR(deform("move:0,4,0:1,0,0", cube()),
               "deformation move: no point 0,4,0 in a lattice of 4 x 4 x 4 points; count from 0");
  EXPECT_ERROR_PART(deform("scale:1e308", deform("scale:9", cube())), "is not finite");
}

TEST(DeformationKinds, OneAfterTheOther) {
  const Lattice start = shapes()[1].lattice;
  const std::vector<Deformation> list{Deformation::parse("twist:40"), Deformation::parse("bend:30"),
                                      Deformation::parse("scale:1,2,1")};
  const Lattice expected = deform("scale:1,2,1", deform("bend:30", deform("twist:40", start)));
  EXPECT_EQ(deform_lattice(start, list).points(), expected.points());
  EXPECT_EQ(deform_lattice(start, {}).points(), start.points());
  EXPECT_NE(deform_lattice(start, {list[1], list[0], list[2]}).points(), expected.points());
}

}  // namespace
}  // namespace hwffd
