#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <functional>
#include <limits>

#include "errors.hpp"
#include "mesh_files.hpp"

namespace hwffd {
namespace {

constexpr double kRounding = 2e-7;  // of a unit vector of binary32
const Eigen::Matrix3d kUnknown =
    Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());

/// A unit sphere of quads with its exact normals, which are not those of the flat faces.
std::string sphere_text() {
  constexpr int kRings = 7;
  constexpr int kAround = 12;
  std::string text;
  for (int r = 0; r <= kRings; ++r) {
    for (int a = 0; a < kAround; ++a) {
      const double polar = M_PI * (r + 0.5) / (kRings + 1);
      const double turn = 2 * M_PI * a / kAround;
      const std::string place =
          fmt::format("{:.9g} {:.9g} {:.9g}", std::sin(polar) * std::sin(turn), std::cos(polar),
                      std::sin(polar) * std::cos(turn));
      text += fmt::format("v {}\nvn {}\n", place, place);
    }
  }
  for (int r = 0; r < kRings; ++r) {
    for (int a = 0; a < kAround; ++a) {
      const int here = 1 + r * kAround + a;
      const int next = 1 + r * kAround + (a + 1) % kAround;
      text += fmt::format("f {0}//{0} {1}//{1} {2}//{2} {3}//{3}\n", here, here + kAround,
                          next + kAround, next);
    }
  }
  return text;
}

/// A cube whose six faces have normals of their own: 24 corners at 8 places.
std::string cube_text() {
  return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
         "vn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 1 0 0\nvn 0 1 0\nvn -1 0 0\n"
         "f 1//1 4//1 3//1 2//1\nf 5//2 6//2 7//2 8//2\nf 1//3 2//3 6//3 5//3\n"
         "f 2//4 3//4 7//4 6//4\nf 3//5 4//5 8//5 7//5\nf 4//6 1//6 5//6 8//6\n";
}

/// Normals of all corners, in the order of the scene.
std::vector<Eigen::Vector3d> normals_of(const Mesh& mesh) {
  std::vector<Eigen::Vector3d> result;
  each_vertex(mesh, [&](const aiMesh& part, unsigned v) {
    result.emplace_back(part.mNormals[v].x, part.mNormals[v].y, part.mNormals[v].z);
  });
  return result;
}

void move(Mesh& mesh, const Eigen::Matrix3d& map) {
  mesh.set_positions(mesh.positions() * map.transpose(),
                     std::vector<Eigen::Matrix3d>(mesh.vertex_count(), map));
}

/// Moves the mesh and expects of each normal what `expected` makes of the one before.
void expect_normals(Mesh mesh, const Eigen::Matrix3d& map,
                    const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& expected,
                    std::size_t corners) {
  const std::vector<Eigen::Vector3d> before = normals_of(mesh);
  move(mesh, map);
  const std::vector<Eigen::Vector3d> after = normals_of(mesh);
  ASSERT_EQ(before.size(), corners);
  ASSERT_EQ(after.size(), corners);
  for (std::size_t i = 0; i < corners; ++i) {
    EXPECT_LT((after[i] - expected(before[i])).norm(), kRounding) << "corner " << i;
  }
}

TEST(MeshNormals, IdentityChangesNone) {
  const auto same = [](const Eigen::Vector3d& n) { return n; };
  expect_normals(load_text(sphere_text()), Eigen::Matrix3d::Identity(), same, 96);
  expect_normals(load_text(cube_text()), Eigen::Matrix3d::Identity(), same, 24);
}

/// A sphere scaled along x is an ellipsoid: the gradient of (x/2)^2 + y^2 + z^2 at (2x, y, z).
TEST(MeshNormals, ScaledSphereIsAnEllipsoid) {
  const auto ellipsoid = [](const Eigen::Vector3d& n) {
    return Eigen::Vector3d(n.x() / 2, n.y(), n.z()).normalized();
  };
  const Eigen::Matrix3d scale = Eigen::Vector3d(2, 1, 1).asDiagonal();
  expect_normals(load_text(sphere_text()), scale, ellipsoid, 96);
  // Entries whose products overflow or vanish.
  expect_normals(load_text(sphere_text()), 1e30 * scale, ellipsoid, 96);
  expect_normals(load_text(sphere_text()), 1e-30 * scale, ellipsoid, 96);
}

TEST(MeshNormals, RotationRotates) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto turned = [&](const Eigen::Vector3d& n) { return Eigen::Vector3d(turn * n); };
  expect_normals(load_text(sphere_text()), turn, turned, 96);
  expect_normals(load_text(cube_text()), turn, turned, 24);
}

/// y += 3x: the floor stays level underneath, walls across x lean, and corners stay hard.
TEST(MeshNormals, ShearedCubeStaysHard) {
  Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
  shear(1, 0) = 3.0;
  Mesh mesh = load_text(cube_text());
  expect_normals(
      load_text(cube_text()), shear,
      [&](const Eigen::Vector3d& n) {
        return Eigen::Vector3d(n.x() - 3.0 * n.y(), n.y(), n.z()).normalized();
      },
      24);
  move(mesh, shear);
  EXPECT_EQ(mesh.vertex_count(), 8u);
  const std::vector<Eigen::Vector3d> normals = normals_of(mesh);
  std::vector<Eigen::Vector3d> distinct;
  for (const Eigen::Vector3d& n : normals) {
    bool is_known = false;
    for (const Eigen::Vector3d& d : distinct) is_known = is_known || (d - n).norm() < kRounding;
    if (!is_known) distinct.push_back(n);
  }
  EXPECT_EQ(distinct.size(), 6u);
  // By hand: the top y = 1 becomes y = 3x + 1, across x = 1 stays upright.
  const Eigen::Vector3d top = Eigen::Vector3d(-3, 1, 0).normalized();
  int tops = 0;
  for (const Eigen::Vector3d& n : normals) tops += (n - top).norm() < kRounding ? 1 : 0;
  EXPECT_EQ(tops, 4);
}

/// Gradients are those from the shape that was read, however often the mesh has been moved.
TEST(MeshNormals, GradientsStartFromTheShapeRead) {
  Mesh once = load_text(sphere_text());
  Mesh often = load_text(sphere_text());
  const Points rest = once.positions();
  const Eigen::Matrix3d first = Eigen::Vector3d(3, 1, 0.2).asDiagonal();
  const Eigen::Matrix3d second = Eigen::Vector3d(1, 5, 1).asDiagonal();
  move(often, first);
  often.set_positions(2.0 * rest);
  const std::vector<Eigen::Matrix3d> gradients(once.vertex_count(), second);
  once.set_positions(rest * second, gradients);
  often.set_positions(rest * second, gradients);
  EXPECT_EQ(normals_of(often), normals_of(once));
  EXPECT_EQ(normals_of(once).size(), 96u);
}

/// Gradients that are unknown leave a vertex to its faces; its neighbours do not notice.
TEST(MeshNormals, UnknownGradientsFallBackOnFaces) {
  const Eigen::Matrix3d scale = Eigen::Vector3d(2, 1, 1).asDiagonal();
  Eigen::Matrix3d infinite = scale;
  infinite(1, 2) = std::numeric_limits<double>::infinity();
  const Eigen::Matrix3d flat = Eigen::Vector3d(1, 1, 1e-12).asDiagonal();
  Eigen::Matrix3d singular = scale;
  singular.col(2) = singular.col(0) + singular.col(1) * (1 + 1e-14);
  const std::vector<Eigen::Matrix3d> bad{kUnknown, infinite, singular, Eigen::Matrix3d::Zero()};

  Mesh known = load_text(sphere_text());
  Mesh faces = load_text(sphere_text());
  Mesh mixed = load_text(sphere_text());
  const Points moved = known.positions() * scale;
  std::vector<Eigen::Matrix3d> gradients(known.vertex_count(), scale);
  known.set_positions(moved, gradients);
  faces.set_positions(moved);
  for (std::size_t i = 0; i < gradients.size(); i += 3) gradients[i] = bad[i / 3 % bad.size()];
  mixed.set_positions(moved, gradients);
  int from_faces = 0;
  int from_gradients = 0;
  for (std::size_t i = 0; i < gradients.size(); ++i) {
    const bool is_known = i % 3 != 0;
    EXPECT_EQ(normals_of(mixed)[i], normals_of(is_known ? known : faces)[i]) << i;
    EXPECT_GT((normals_of(known)[i] - normals_of(faces)[i]).norm(), 1e-3) << i;
    ++(is_known ? from_gradients : from_faces);
  }
  EXPECT_EQ(from_faces, 32);
  EXPECT_EQ(from_gradients, 64);

  // Flat along an axis is not singular: how thin does not matter.
  gradients.assign(gradients.size(), flat);
  mixed.set_positions(mixed.positions(), gradients);
  EXPECT_LT((normals_of(mixed)[50] - Eigen::Vector3d::UnitZ()).cwiseAbs().head(2).norm(), 1e-6);
}

/// A mirrored sphere still faces outwards, by its triangles and by its normals; going back restores
/// every face.
TEST(MeshNormals, MirrorTurnsFacesRound) {
  Mesh mesh = load_text(sphere_text());
  const double volume = volume_times_six(mesh);
  const std::vector<Mesh::Triangle> read = mesh.triangles();
  ASSERT_GT(volume, 0.0);
  const Eigen::Matrix3d mirror = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  move(mesh, mirror);
  EXPECT_NEAR(volume_times_six(mesh), volume, 1e-6);
  ASSERT_EQ(mesh.triangles().size(), read.size());
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    const Eigen::Vector3d place = mesh.positions().row(static_cast<Eigen::Index>(i));
    EXPECT_LT((normals_of(mesh)[i] - place).norm(), kRounding);
  }
  // As loaded: the same quads, cut along the same diagonals.
  const TempFolder folder;
  mesh.save(folder / "mirrored.obj");
  EXPECT_NEAR(volume_times_six(Mesh::load(folder / "mirrored.obj")), volume, 1e-5);
  mesh.set_positions(mesh.positions() * mirror);
  EXPECT_EQ(mesh.triangles(), read);
  EXPECT_NEAR(volume_times_six(mesh), volume, 1e-6);
}

/// One vertex that is not mirrored makes it a fold: faces stay, and normals agree with them.
TEST(MeshNormals, FoldKeepsFaces) {
  Mesh mesh = load_text(sphere_text());
  const std::vector<Mesh::Triangle> read = mesh.triangles();
  const double volume = volume_times_six(mesh);
  const Eigen::Matrix3d mirror = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  std::vector<Eigen::Matrix3d> gradients(mesh.vertex_count(), mirror);
  gradients[0].setIdentity();
  mesh.set_positions(mesh.positions() * mirror, gradients);
  EXPECT_EQ(mesh.triangles(), read);
  EXPECT_NEAR(volume_times_six(mesh), -volume, 1e-6);
  const Points faces = mesh.smooth_normals();
  for (std::size_t i = 1; i < mesh.vertex_count(); ++i) {
    const Eigen::Vector3d face = faces.row(static_cast<Eigen::Index>(i));
    EXPECT_GT(face.dot(normals_of(mesh)[i]), 0.9) << i;
  }
}

TEST(MeshNormals, WrongCountChangesNothing) {
  Mesh mesh = load_text(cube_text());
  const Points before = mesh.positions();
  const std::vector<Eigen::Vector3d> normals = normals_of(mesh);
  const std::vector<Eigen::Matrix3d> seven(7, Eigen::Matrix3d::Identity());
  EXPECT_ERROR(mesh.set_positions(2.0 * before, seven),
               "a.obj: 7 gradients for 8 vertices; give one for each vertex");
  EXPECT_ERROR(mesh.set_positions(before.topRows(7), seven),
               "a.obj: 7 new positions for 8 vertices; give one for each vertex");
  EXPECT_EQ(mesh.positions(), before);
  EXPECT_EQ(normals_of(mesh), normals);
}

/// A mesh without normals gets none.
TEST(MeshNormals, MeshWithoutNormalsStaysWithout) {
  Mesh mesh = load_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  move(mesh, Eigen::Matrix3d::Identity() * 2.0);
  EXPECT_FALSE(mesh.scene().mMeshes[0]->HasNormals());
  EXPECT_EQ(mesh.positions()(1, 0), 2.0);
}

}  // namespace
}  // namespace hwffd
