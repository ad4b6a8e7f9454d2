// glEvalCoord3, and the grid of glMapGrid3 that glEvalPoint3 and glEvalMesh3 walk.

#include <cstdint>
#include <limits>

#include "gl_error.hpp"
#include "hwffd/error.hpp"
#include "hwffd/glffd.h"
#include "map_evaluator.hpp"

namespace hwffd::gl {
namespace {

void evaluate_point(const Eigen::Vector3d& uvw) {
  guarded([&] { evaluate_maps(State::current(), {uvw}).issue(0); });
}

void map_grid(const Index3& segments, const std::array<double, 6>& domain) {
  if (!outside_begin_end()) return;
  for (const int count : segments) {
    if (count < 1) return raise_invalid_value();
  }
  State::current().grid = {segments, domain};
}

/// First and last number of a mesh's points along the three axes.
struct MeshRange {
  Index3 first;
  Index3 last;

  bool is_empty() const { return first[0] > last[0] || first[1] > last[1] || first[2] > last[2]; }
  std::uint64_t count(int axis) const {
    return static_cast<std::uint64_t>(std::int64_t{last[axis]} - first[axis] + 1);
  }
  /// Of all axes.
  /// @throws Error for more points than GLuint has numbers
  GLuint count() const {
    constexpr std::uint64_t kMost = std::numeric_limits<GLuint>::max();
    std::uint64_t all = 1;
    for (int axis = 0; axis < 3; ++axis) {
      if (count(axis) > kMost / all) throw Error("a mesh of more points than can be numbered");
      all *= count(axis);
    }
    return static_cast<GLuint>(all);
  }
  /// Point number n: the axes in their order, the first runs fastest.
  Index3 point(GLuint n) const {
    Index3 at = first;
    std::uint64_t rest = n;
    for (int axis = 0; axis < 3; ++axis) {
      at[axis] = static_cast<int>(at[axis] + static_cast<std::int64_t>(rest % count(axis)));
      rest /= count(axis);
    }
    return at;
  }
};

std::vector<Eigen::Vector3d> mesh_points(const MapGrid3& grid, const MeshRange& range) {
  std::vector<Eigen::Vector3d> points(range.count());
  for (GLuint n = 0; n < points.size(); ++n) points[n] = grid.point(range.point(n));
  return points;
}

/// The lines along an axis: for each pair of numbers along the other two, the higher axis
/// outermost, a strip.
void add_lines(VertexBatch::Primitives& strips, const MeshRange& range, int axis) {
  const std::array<std::uint64_t, 3> step{1, range.count(0), range.count(0) * range.count(1)};
  const int inner = axis == 0 ? 1 : 0;
  const int outer = axis == 2 ? 1 : 2;
  for (std::uint64_t o = 0; o < range.count(outer); ++o) {
    for (std::uint64_t i = 0; i < range.count(inner); ++i) {
      std::vector<GLuint>& strip = strips.emplace_back();
      for (std::uint64_t along = 0; along < range.count(axis); ++along) {
        strip.push_back(
            static_cast<GLuint>(o * step[outer] + i * step[inner] + along * step[axis]));
      }
    }
  }
}

VertexBatch::Primitives all_points(std::size_t count) {
  VertexBatch::Primitives primitives(1);
  for (std::size_t point = 0; point < count; ++point)
    primitives[0].push_back(static_cast<GLuint>(point));
  return primitives;
}

void evaluate_mesh(GLenum mode, const MeshRange& range) {
  State& state = State::current();
  if (range.is_empty() || !makes_vertices(state)) return;
  const std::vector<Eigen::Vector3d> points = mesh_points(state.grid, range);
  const VertexBatch batch = evaluate_maps(state, points);
  if (mode == GL_POINT) {
    batch.draw(GL_POINTS, all_points(points.size()));
    return;
  }
  VertexBatch::Primitives strips;
  for (int axis = 0; axis < 3; ++axis) add_lines(strips, range, axis);
  batch.draw(GL_LINE_STRIP, strips);
}

}  // namespace
}  // namespace hwffd::gl

using namespace hwffd::gl;

void glEvalCoord3f(GLfloat u, GLfloat v, GLfloat w) { evaluate_point({u, v, w}); }
void glEvalCoord3d(GLdouble u, GLdouble v, GLdouble w) { evaluate_point({u, v, w}); }
void glEvalCoord3fv(const GLfloat* u) { evaluate_point({u[0], u[1], u[2]}); }
void glEvalCoord3dv(const GLdouble* u) { evaluate_point({u[0], u[1], u[2]}); }

void glMapGrid3f(GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1, GLfloat v2, GLint wn,
                 GLfloat w1, GLfloat w2) {
  map_grid({un, vn, wn}, {u1, u2, v1, v2, w1, w2});
}

void glMapGrid3d(GLint un, GLdouble u1, GLdouble u2, GLint vn, GLdouble v1, GLdouble v2, GLint wn,
                 GLdouble w1, GLdouble w2) {
  map_grid({un, vn, wn}, {u1, u2, v1, v2, w1, w2});
}

void glEvalPoint3(GLint i, GLint j, GLint k) {
  evaluate_point(State::current().grid.point({i, j, k}));
}

void glEvalMesh3(GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2, GLint k1, GLint k2) {
  if (!outside_begin_end()) return;
  if (mode != GL_POINT && mode != GL_LINE) return raise_invalid_enum();
  guarded([&] { evaluate_mesh(mode, {{i1, j1, k1}, {i2, j2, k2}}); });
}

void glGetEval3dv(GLenum pname, GLdouble* v) {
  if (!outside_begin_end()) return;
  const MapGrid3& grid = State::current().grid;
  switch (pname) {
    case GL_MAP3_GRID_DOMAIN:
      for (const double bound : grid.domain) *v++ = bound;
      return;
    case GL_MAP3_GRID_SEGMENTS:
      for (const int count : grid.segments) *v++ = count;
      return;
    case GL_MAX_EVAL3_ORDER:
      *v = kMaxOrder;
      return;
    default:
      raise_invalid_enum();
  }
}
