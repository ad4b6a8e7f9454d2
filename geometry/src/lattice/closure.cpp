#include "hwffd/lattice/closure.hpp"

#include "far_rounding.hpp"
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

/// What a family makes a face of: the weights of the three outermost layers, in parts of their sum,
/// and the outermost one that has any. The functions of all families are symmetric.
struct FaceWeights {
  explicit FaceWeights(const Family& family) {
    if (family.kind() == Family::Kind::kBspline) {
      of = {1, 4, 1};
      sum = 6;
    } else if (family.regular()) {
      of = {0, 1, 0};
      moves = 1;
    }
  }

  std::array<double, 3> of{1, 0, 0};
  double sum = 1;
  int moves = 0;
};

/// The three layers that make the face at one end of an axis: their step in rows from the outermost
/// layer inwards, and the first row of the outermost layer.
struct Face {
  Face(const Layers& layers, int axis, int end, const FaceWeights& of)
      : step(end == 0 ? layers.step(axis) : -layers.step(axis)),
        first(end == 0 ? 0 : layers.step(axis) * (layers.size(axis) - 1)),
        weights(of) {}

  /// The point of the face that a column of three control points makes.
  Eigen::RowVector3d knot(const Points& points, Eigen::Index row) const {
    const Eigen::Index outer = row + first;
    return (weights.of[0] * points.row(outer) + weights.of[1] * points.row(outer + step) +
            weights.of[2] * points.row(outer + 2 * step)) /
           weights.sum;
  }

  /// Moves that point, by the layer that moves.
  void move(Points& points, Eigen::Index row, const Eigen::RowVector3d& by) const {
    const auto layer = static_cast<std::size_t>(weights.moves);
    points.row(row + first + weights.moves * step) += weights.sum / weights.of[layer] * by;
  }

  /// The transpose of move(): what the gradient has of `by`.
  Eigen::RowVector3d pulled(const Points& gradient, Eigen::Index row) const {
    const auto layer = static_cast<std::size_t>(weights.moves);
    return weights.sum / weights.of[layer] * gradient.row(row + first + weights.moves * step);
  }

  /// The transpose of knot(): gives the layers their parts of what the face has.
  void pull(Points& gradient, Eigen::Index row, const Eigen::RowVector3d& at_knot) const {
    for (int layer = 0; layer < 3; ++layer) {
      gradient.row(row + first + layer * step) +=
          weights.of[static_cast<std::size_t>(layer)] / weights.sum * at_knot;
    }
  }

  Eigen::Index step;
  Eigen::Index first;
  FaceWeights weights;
};

bool is_closed(const Layers& layers, const Points& points, int axis, int repeated,
               double tolerance) {
  const Eigen::Index period = layers.step(axis) * (layers.size(axis) - repeated);
  bool same = true;
  layers.each(axis, [&](Eigen::Index row) {
    for (int layer = 0; layer < repeated; ++layer, row += layers.step(axis)) {
      same = same && (points.row(row) - points.row(row + period)).norm() <= tolerance;
    }
  });
  return same;
}

bool is_collapsed(const Layers& layers, const Points& points, const Closure::Collapsed& face,
                  const FaceWeights& weights, double tolerance) {
  const Face layer(layers, face.axis, face.end, weights);
  bool same = true;
  layers.each(face.axis, [&](Eigen::Index row) {
    const Eigen::Index start =
        row - row / layers.step(face.along) % layers.size(face.along) * layers.step(face.along);
    same = same && (layer.knot(points, row) - layer.knot(points, start)).norm() <= tolerance;
  });
  return same;
}

/// @param repeated  layers along the axis in the face that are those at its beginning
void collapse(const Layers& layers, Points& points, const Closure::Collapsed& face,
              const FaceWeights& weights, int repeated) {
  const Face layer(layers, face.axis, face.end, weights);
  const int size = layers.size(face.along);
  const int distinct = size - repeated;
  const Eigen::Index step = layers.step(face.along);
  layers.each(face.axis, [&](Eigen::Index row) {
    if (row / step % size != 0) return;
    Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
    for (int n = 0; n < distinct; ++n) mean += layer.knot(points, row + n * step) / distinct;
    for (int n = 0; n < size; ++n) {
      const Eigen::Index at = row + n * step;
      layer.move(points, at, mean - layer.knot(points, at));
    }
  });
}

/// The transpose of collapse().
void pull_collapse(const Layers& layers, Points& gradient, const Closure::Collapsed& face,
                   const FaceWeights& weights, int repeated) {
  const Face layer(layers, face.axis, face.end, weights);
  const int size = layers.size(face.along);
  const int distinct = size - repeated;
  const Eigen::Index step = layers.step(face.along);
  Points pulled(size, 3);
  layers.each(face.axis, [&](Eigen::Index row) {
    if (row / step % size != 0) return;
    for (int n = 0; n < size; ++n) pulled.row(n) = layer.pulled(gradient, row + n * step);
    const Eigen::RowVector3d mean = pulled.colwise().sum() / distinct;
    for (int n = 0; n < size; ++n) {
      const Eigen::RowVector3d own = n < distinct ? mean : Eigen::RowVector3d::Zero();
      layer.pull(gradient, row + n * step, own - pulled.row(n));
    }
  });
}

}  // namespace

Closure::Closure(const Lattice& lattice, const Family& family)
    : dims_(lattice.dims()), family_(family) {
  const Points& points = lattice.points();
  const double size = (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
  const double tolerance = kSame * size + far_rounding(points, size);
  const Layers layers(dims_);
  const FaceWeights weights(family);
  for (int axis = 0; axis < 3; ++axis) {
    if (layers.size(axis) < Lattice::kMinPoints) continue;  // it has no cells to join
    closed_[static_cast<std::size_t>(axis)] =
        is_closed(layers, points, axis, repeated(), tolerance);
    for (int end = 0; end < 2; ++end) {
      for (int other = 1; other < 3; ++other) {
        const Collapsed face{axis, end, (axis + other) % 3};
        if (is_collapsed(layers, points, face, weights, tolerance)) collapsed_.push_back(face);
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
    const Eigen::Index period = layers.step(axis) * (layers.size(axis) - repeated());
    layers.each(axis, [&](Eigen::Index row) {
      for (int layer = 0; layer < repeated(); ++layer, row += layers.step(axis)) {
        points.row(row + period) = points.row(row);
      }
    });
  }
  const FaceWeights weights(family_);
  for (const Collapsed& face : collapsed_) {
    collapse(layers, points, face, weights, closed(face.along) ? repeated() : 0);
  }
  return Lattice(dims_, std::move(points));
}

Points Closure::pull_back(Points gradient) const {
  const Layers layers(dims_);
  const FaceWeights weights(family_);
  for (auto face = collapsed_.rbegin(); face != collapsed_.rend(); ++face) {
    pull_collapse(layers, gradient, *face, weights, closed(face->along) ? repeated() : 0);
  }
  for (int axis = 2; axis >= 0; --axis) {
    if (!closed(axis)) continue;
    const Eigen::Index step = layers.step(axis);
    const Eigen::Index period = step * (layers.size(axis) - repeated());
    layers.each(axis, [&](Eigen::Index row) {
      for (int layer = repeated() - 1; layer >= 0; --layer) {
        const Eigen::Index from = row + layer * step + period;
        gradient.row(row + layer * step) += gradient.row(from);
        gradient.row(from).setZero();
      }
    });
  }
  return gradient;
}

}  // namespace hwffd
