#include "picture/lattice_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "picture/opengl.hpp"

namespace hwffd::picture {
namespace {

constexpr int kSlices = 12;               // of a sphere, around
constexpr int kStacks = 6;                // and from pole to pole
constexpr double kRadius = 0.04;          // of the mean distance between neighbours
constexpr double kPixelsPerLine = 450.0;  // height of the viewport by width of a line
constexpr double kPi = 3.14159265358979323846;

/// Ends of the lines between neighbours, as rows of lattice.points(), two a line.
std::vector<GLuint> lines_of(const Lattice& lattice) {
  const Index3& dims = lattice.dims();
  std::vector<GLuint> ends;
  for (const Index3& here : places(dims)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Index3 next = here;
      if (++next[axis] == dims[axis]) continue;
      ends.push_back(static_cast<GLuint>(lattice.index(here)));
      ends.push_back(static_cast<GLuint>(lattice.index(next)));
    }
  }
  return ends;
}

double mean_length(const Lattice& lattice, const std::vector<GLuint>& ends) {
  double sum = 0.0;
  for (std::size_t e = 0; e < ends.size(); e += 2) {
    sum += (lattice.points().row(ends[e]) - lattice.points().row(ends[e + 1])).norm();
  }
  return 2 * sum / static_cast<double>(ends.size());
}

/// A sphere of radius 1 as one strip of triangles, from pole to pole for each slice; its points are
/// its normals. Where it jumps from pole to pole its triangles have no area.
std::vector<GLfloat> unit_sphere() {
  std::vector<GLfloat> points;
  const auto put = [&](int slice, int stack) {
    const double around = 2 * kPi * slice / kSlices;
    const double down = kPi * stack / kStacks;
    points.push_back(static_cast<GLfloat>(std::sin(down) * std::sin(around)));
    points.push_back(static_cast<GLfloat>(std::cos(down)));
    points.push_back(static_cast<GLfloat>(std::sin(down) * std::cos(around)));
  };
  for (int slice = 0; slice < kSlices; ++slice) {
    for (int stack = 0; stack <= kStacks; ++stack) {
      put(slice + 1, stack);  // first, so that triangles run counterclockwise seen from outside
      put(slice, stack);
    }
  }
  return points;
}

void draw_lines(const Lattice& lattice, const std::vector<GLuint>& ends) {
  GLint viewport[4] = {0, 0, 0, 0};
  glGetIntegerv(GL_VIEWPORT, viewport);
  glLineWidth(static_cast<GLfloat>(std::max(1.0, viewport[3] / kPixelsPerLine)));
  glDisable(GL_LIGHTING);
  glColor3f(0.30f, 0.38f, 0.50f);
  glVertexPointer(3, GL_DOUBLE, 0, lattice.points().data());
  glDrawElements(GL_LINES, static_cast<GLsizei>(ends.size()), GL_UNSIGNED_INT, ends.data());
  glEnable(GL_LIGHTING);
}

void draw_spheres(const Lattice& lattice, double radius) {
  const std::vector<GLfloat> sphere = unit_sphere();
  glColor3f(0.80f, 0.28f, 0.16f);
  glEnableClientState(GL_NORMAL_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, sphere.data());
  glNormalPointer(GL_FLOAT, 0, sphere.data());
  for (Eigen::Index p = 0; p < lattice.points().rows(); ++p) {
    const Point centre = lattice.points().row(p);
    glPushMatrix();
    glTranslated(centre.x(), centre.y(), centre.z());
    glScaled(radius, radius, radius);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, static_cast<GLsizei>(sphere.size() / 3));
    glPopMatrix();
  }
  glDisableClientState(GL_NORMAL_ARRAY);
}

}  // namespace

void draw_lattice(const Lattice& lattice) {
  const std::vector<GLuint> ends = lines_of(lattice);
  glEnableClientState(GL_VERTEX_ARRAY);
  draw_lines(lattice, ends);
  draw_spheres(lattice, kRadius * mean_length(lattice, ends));
  glDisableClientState(GL_VERTEX_ARRAY);
}

}  // namespace hwffd::picture
