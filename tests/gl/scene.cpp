#include "scene.hpp"

#include <algorithm>
#include <cmath>

namespace hwffd::gltest {

double uniform(tb::Random& random, double low, double high) {
  return low + (high - low) * random.unit();
}

RandomMap::RandomMap(tb::Random& random, const Index3& count, int width)
    : points(count), components(width) {
  // The first axis runs fastest, so that no two axes can be mistaken for one another.
  strides[0] = width + 1;
  strides[1] = strides[0] * points[0] + 2;
  strides[2] = strides[1] * points[1] + 3;
  values.resize(static_cast<std::size_t>(strides[2]) * points[2]);
  for (GLdouble& value : values) value = uniform(random, -0.9, 0.9);
}

void RandomMap::raise(int c, double by) {
  for (int i = 0; i < points[0]; ++i) {
    for (int j = 0; j < points[1]; ++j) {
      for (int k = 0; k < points[2]; ++k) values[place(i, j, k, c)] += by;
    }
  }
}

void RandomMap::define(GLenum target, const std::array<double, 6>& domain) const {
  glMap3d(target, domain[0], domain[1], strides[0], points[0], domain[2], domain[3], strides[1],
          points[1], domain[4], domain[5], strides[2], points[2], values.data());
}

Eigen::VectorXd RandomMap::expected(const std::array<Oracle::Coefficients, 3>& functions,
                                    const std::array<int, 3>& degrees,
                                    const Eigen::Vector3d& position) const {
  Index3 cell;
  std::array<Eigen::Vector4d, 3> weights;
  for (int axis = 0; axis < 3; ++axis) {
    const int cells = points[axis] - degrees[axis];
    cell[axis] = std::min(static_cast<int>(position[axis] * cells), cells - 1);
    const double x = position[axis] * cells - cell[axis];
    weights[axis] = functions[axis] * Eigen::Vector4d(1, x, x * x, x * x * x);
  }
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(components);
  for (int l = 0; l <= degrees[0]; ++l) {
    for (int m = 0; m <= degrees[1]; ++m) {
      for (int n = 0; n <= degrees[2]; ++n) {
        const double weight = weights[0][l] * weights[1][m] * weights[2][n];
        for (int c = 0; c < components; ++c) {
          sum[c] += weight * at(cell[0] + l, cell[1] + m, cell[2] + n, c);
        }
      }
    }
  }
  return sum;
}

std::vector<GLdouble> rows_of(const Oracle::Coefficients& functions) {
  std::vector<GLdouble> rows;
  for (int function = 0; function < 4; ++function) {
    for (int power = 0; power < 4; ++power) rows.push_back(functions(function, power));
  }
  return rows;
}

Oracle::Coefficients bernstein(int degree) {
  constexpr int kBinomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
  Oracle::Coefficients functions = Oracle::Coefficients::Zero();
  for (int l = 0; l <= degree; ++l) {
    for (int p = 0; p <= degree - l; ++p) {
      functions(l, l + p) = kBinomial[degree][l] * kBinomial[degree - l][p] * (p % 2 == 0 ? 1 : -1);
    }
  }
  return functions;
}

void reset_state() {
  for (GLenum map = GL_MAP3_COLOR_4; map <= GL_MAP3_VERTEX_4; ++map) glDisableMap3(map);
  glDisableMap3(GL_AUTO_NORMAL);
  for (const GLenum axis : {GL_MAP3_U, GL_MAP3_V, GL_MAP3_W}) {
    glBlendCoefficientd(axis, 0, nullptr);
  }
  glMapGrid3d(1, 0, 1, 1, 0, 1, 1, 0, 1);
  glFfdDevice(nullptr);
}

}  // namespace hwffd::gltest
