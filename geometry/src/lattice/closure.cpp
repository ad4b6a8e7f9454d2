#include "hwffd/lattice/closure.hpp"

#include "same_dims.hpp"

namespace hwffd {
namespace {

constexpr double kSame = 1e-12;  // of the lattice's size

/// The layers of points across an axis: each place on a layer is named by the row of its point on
/// layer 0, and going along an axis is a step in rows.
class Layers {
 public:
  explicit Layers(const Index3& dims) : dims_(dims), step_{dims[1] * dims[2], dims[2], 1} {}

  int size(int axis) const { return dims_[static_cast<std::size_t>(axis)]; }
  Eigen::Index step(int axis) const { return step_[static_cast<std::size_t>(axis)]; }

  /// Calls f with every row of layer 0 across the axis.
  template <typename F>
  void each(int axis, F f) const {
    const Eigen::Index rows = static_cast<Eigen::Index>(dims_[0]) * dims_[1] * dims_[2];
    for (Eigen::Index row = 0; row < rows; ++row) {
      if (row / step(axis) % size(axis) == 0) f(row);
    }
  }

 private:
  Index3 dims_;
  std::array<Eigen::Index, 3> step_;
};

/// The three layers that make the face at one end of an axis: their step in rows from the layer
/// beyond the face inwards, and the first row of the layer beyond.
struct Face {
  Face(const Layers& layers, int axis, int end)
      : step(end == 0 ? layers.step(axis) : -layers.step(axis)),
        first(end == 0 ? 0 : layers.step(axis) * (layers.size(axis) - 1)) {}

  /// The point of the face that a column of three control points makes: B(0) of the B-spline.
  Eigen::RowVector3d knot(const Points& points, Eigen::Index row) const {
    const Eigen::Index outer = row + first;
    return (points.row(outer) + 4 * points.row(outer + step) + points.row(outer + 2 * step)) / 6;
  }

  Eigen::Index step;
  Eigen::Index first;
};

bool is_closed(const Layers& layers, const Points& points, int axis, double tolerance) {
  const Eigen::Index period = layers.step(axis) * (layers.size(axis) - 3);
  bool same = true;
  layers.each(axis, [&](Eigen::Index row) {
    for (int layer = 0; layer < 3; ++layer, row += layers.step(axis)) {
      same = same && (points.row(row) - points.row(row + period)).norm() <= tolerance;
    }
  });
  return same;
}

bool is_collapsed(const Layers& layers, const Points& points, const Closure::Collapsed& face,
                  double tolerance) {
  const Face layer(layers, face.axis, face.end);
  bool same = true;
  layers.each(face.axis, [&](Eigen::Index row) {
    const Eigen::Index start =
        row - row / layers.step(face.along) % layers.size(face.along) * layers.step(face.along);
    same = same && (layer.knot(points, row) - layer.knot(points, start)).norm() <= tolerance;
  });
  return same;
}

void collapse(const Layers& layers, Points& points, const Closure::Collapsed& face, bool closed) {
  const Face layer(layers, face.axis, face.end);
  const int size = layers.size(face.along);
  const int distinct = closed ? size - 3 : size;
  const Eigen::Index step = layers.step(face.along);
  layers.each(face.axis, [&](Eigen::Index row) {
    if (row / step % size != 0) return;
    Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
    for (int n = 0; n < distinct; ++n) mean += layer.knot(points, row + n * step) / distinct;
    for (int n = 0; n < size; ++n) {
      const Eigen::Index at = row + n * step;
      points.row(at + layer.first) += 6 * (mean - layer.knot(points, at));
    }
  });
}

}  // namespace

Closure::Closure(const Lattice& lattice) : dims_(lattice.dims()) {
  const Points& points = lattice.points();
  const double tolerance =
      kSame * (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
  const Layers layers(dims_);
  for (int axis = 0; axis < 3; ++axis) {
    if (layers.size(axis) < Lattice::kMinPoints) continue;  // it has no cells to join
    closed_[static_cast<std::size_t>(axis)] = is_closed(layers, points, axis, tolerance);
    for (int end = 0; end < 2; ++end) {
      for (int other = 1; other < 3; ++other) {
        const Collapsed face{axis, end, (axis + other) % 3};
        if (is_collapsed(layers, points, face, tolerance)) collapsed_.push_back(face);
      }
    }
  }
}

Lattice Closure::restore(const Lattice& moved) const {
  check_same_dims("lattice to close", moved.dims(), dims_);
  Points points = moved.points();
  const Layers layers(dims_);
  for (int axis = 0; axis < 3; ++axis) {
    if (!closed(axis)) continue;
    const Eigen::Index period = layers.step(axis) * (layers.size(axis) - 3);
    layers.each(axis, [&](Eigen::Index row) {
      for (int layer = 0; layer < 3; ++layer, row += layers.step(axis)) {
        points.row(row + period) = points.row(row);
      }
    });
  }
  for (const Collapsed& face : collapsed_) collapse(layers, points, face, closed(face.along));
  return Lattice(dims_, std::move(points));
}

}  // namespace hwffd
