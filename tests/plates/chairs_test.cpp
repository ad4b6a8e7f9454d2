#include "plates/chairs.hpp"

#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <set>

namespace hwffd::plates {
namespace {

Point point(const aiVector3D& p) { return {p.x, p.y, p.z}; }

class Chairs : public testing::TestWithParam<Mesh (*)()> {
 protected:
  Mesh chair_ = GetParam()();
};

/// Every edge of a part has one face on either side, and its faces look outwards.
TEST_P(Chairs, PartsAreClosedAndTurnedOutwards) {
  int part_count = 0;
  for (unsigned m = 0; m < chair_.scene().mNumMeshes; ++m) {
    const aiMesh& part = *chair_.scene().mMeshes[m];
    std::set<std::pair<unsigned, unsigned>> edges;
    double volume = 0.0;
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const unsigned* corner = part.mFaces[f].mIndices;
      for (int c = 0; c < 3; ++c) {
        EXPECT_TRUE(edges.insert({corner[c], corner[(c + 1) % 3]}).second) << m << " " << f;
      }
      volume += point(part.mVertices[corner[0]])
                    .cross(point(part.mVertices[corner[1]]))
                    .dot(point(part.mVertices[corner[2]])) /
                6;
    }
    for (const auto& [a, b] : edges) EXPECT_EQ(edges.count({b, a}), 1u) << m;
    EXPECT_GT(volume, 1e-7) << m;
    ++part_count;
  }
  EXPECT_GE(part_count, 10);
}

TEST_P(Chairs, NormalsAreUnitAndLookOutwards) {
  int checked = 0;
  for (unsigned m = 0; m < chair_.scene().mNumMeshes; ++m) {
    const aiMesh& part = *chair_.scene().mMeshes[m];
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const unsigned* corner = part.mFaces[f].mIndices;
      const Point a = point(part.mVertices[corner[0]]);
      const Point face =
          (point(part.mVertices[corner[1]]) - a).cross(point(part.mVertices[corner[2]]) - a);
      for (int c = 0; c < 3; ++c) {
        const Point normal = point(part.mNormals[corner[c]]);
        EXPECT_NEAR(normal.norm(), 1.0, 1e-5);
        EXPECT_GT(normal.dot(face), 0.0) << m << " " << f;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 10000);
}

TEST_P(Chairs, EdgesAreShortEnoughToBend) {
  double longest = 0.0;
  for (const Mesh::Triangle& t : chair_.triangles()) {
    for (const auto& [a, b] : {std::pair(t[0], t[1]), {t[1], t[2]}, {t[2], t[0]}}) {
      longest = std::max(longest, (chair_.positions().row(a) - chair_.positions().row(b)).norm());
    }
  }
  EXPECT_LT(longest, 0.045);
  EXPECT_GT(chair_.vertex_count(), 5000u);
}

TEST_P(Chairs, StandsOnTheFloorAtHumanSize) {
  const Point low = chair_.positions().colwise().minCoeff();
  const Point high = chair_.positions().colwise().maxCoeff();
  EXPECT_NEAR(low.y(), 0.0, 2e-3);
  EXPECT_NEAR(high.y(), 1.0, 0.2);
  EXPECT_NEAR(high.x() - low.x(), 0.55, 0.15);
}

INSTANTIATE_TEST_SUITE_P(All, Chairs, testing::Values(&office_chair, &wooden_chair),
                         [](const auto& info) { return info.index == 0 ? "office" : "wooden"; });

/// In how many places, 8 cm or more apart, it stands on the floor.
int feet(const Mesh& chair) {
  std::vector<Point> distinct;
  for (Eigen::Index v = 0; v < chair.positions().rows(); ++v) {
    const Point p = chair.positions().row(v);
    if (p.y() > 0.01) continue;
    bool is_new = true;
    for (const Point& foot : distinct) is_new = is_new && (foot - p).norm() > 0.08;
    if (is_new) distinct.push_back(p);
  }
  return static_cast<int>(distinct.size());
}

TEST(OfficeChair, HasFiveCastors) { EXPECT_EQ(feet(office_chair()), 5); }
TEST(WoodenChair, HasFourLegs) { EXPECT_EQ(feet(wooden_chair()), 4); }

/// The plates shear the stem and what is below it: no part crosses its top.
TEST(OfficeChair, StemAndCastorsEndWhereTheSeatBegins) {
  const Mesh chair = office_chair();
  int below = 0;
  int above = 0;
  for (unsigned m = 0; m < chair.scene().mNumMeshes; ++m) {
    const aiMesh& part = *chair.scene().mMeshes[m];
    double low = 9;
    double high = -9;
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      low = std::min(low, static_cast<double>(part.mVertices[v].y));
      high = std::max(high, static_cast<double>(part.mVertices[v].y));
    }
    if (high <= kOfficeStemTop) {
      ++below;
    } else {
      EXPECT_GE(low, kOfficeStemTop - 1e-6) << m;
      ++above;
    }
  }
  EXPECT_EQ(below, 5 * 5 + 4);
  EXPECT_EQ(above, 2 + 2 + 4);
}

}  // namespace
}  // namespace hwffd::plates
