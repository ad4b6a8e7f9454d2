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

/// A face of the outer cells as lines of points, each along the axis in it along which it may be
/// collapsed. Three layers of control points make it.
class FaceLines {
 public:
  FaceLines(const Layers& layers, const Closure::Collapsed& face, const FaceWeights& weights)
      : layers_(layers),
        face_(face),
        weights_(weights),
        inwards_(face.end == 0 ? layers.step(face.axis) : -layers.step(face.axis)),
        outermost_(face.end == 0 ? 0 : layers.step(face.axis) * (layers.size(face.axis) - 1)) {}

  /// Points of a line.
  int size() const { return layers_.size(face_.along); }

  /// One of the lines, whose points are counted from 0.
  class Line {
   public:
    /// @param row  of its first point on layer 0
    Line(const FaceLines& of, Eigen::Index row) : of_(of), first_(row + of.outermost_) {}

    /// The point of the face that a column of three control points makes.
    Eigen::RowVector3d knot(const Points& points, int n) const {
      const std::array<double, 3>& weight = of_.weights_.of;
      return (weight[0] * points.row(at(n, 0)) + weight[1] * points.row(at(n, 1)) +
              weight[2] * points.row(at(n, 2))) /
             of_.weights_.sum;
    }

    /// Moves that point, by the layer that moves.
    void move(Points& points, int n, const Eigen::RowVector3d& by) const {
      points.row(at(n, of_.weights_.moves)) += per_move() * by;
    }

    /// The transpose of move(): what the gradient has of `by`.
    Eigen::RowVector3d pulled(const Points& gradient, int n) const {
      return per_move() * gradient.row(at(n, of_.weights_.moves));
    }

    /// The transpose of knot(): gives the layers their parts of what the face has.
    void pull(Points& gradient, int n, const Eigen::RowVector3d& at_knot) const {
      for (int layer = 0; layer < 3; ++layer) {
        gradient.row(at(n, layer)) +=
            of_.weights_.of[static_cast<std::size_t>(layer)] / of_.weights_.sum * at_knot;
      }
    }

   private:
    /// The row of a control point, layers counted from the outermost inwards.
    Eigen::Index at(int n, int layer) const {
      return first_ + n * of_.layers_.step(of_.face_.along) + layer * of_.inwards_;
    }
    double per_move() const {
      return of_.weights_.sum / of_.weights_.of[static_cast<std::size_t>(of_.weights_.moves)];
    }

    const FaceLines& of_;
    Eigen::Index first_;
  };

  /// Calls f with every line.
  template <typename F>
  void each(F f) const {
    layers_.each(face_.axis, [&](Eigen::Index row) {
      if (row / layers_.step(face_.along) % size() == 0) f(Line(*this, row));
    });
  }

 private:
  const Layers& layers_;
  const Closure::Collapsed& face_;
  const FaceWeights& weights_;
  Eigen::Index inwards_;    ///< from a layer to the next one, in rows
  Eigen::Index outermost_;  ///< from layer 0 to the outermost one
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

bool is_collapsed(const FaceLines& lines, const Points& points, double tolerance) {
  bool same = true;
  lines.each([&](const FaceLines::Line& line) {
    const Eigen::RowVector3d start = line.knot(points, 0);
    for (int n = 1; n < lines.size(); ++n) {
      same = same && (line.knot(points, n) - start).norm() <= tolerance;
    }
  });
  return same;
}

/// @param repeated  points of a line that are those at its beginning
void collapse(const FaceLines& lines, Points& points, int repeated) {
  const int distinct = lines.size() - repeated;
  lines.each([&](const FaceLines::Line& line) {
    Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
    for (int n = 0; n < distinct; ++n) mean += line.knot(points, n) / distinct;
    for (int n = 0; n < lines.size(); ++n) line.move(points, n, mean - line.knot(points, n));
  });
}

/// The transpose of collapse().
void pull_collapse(const FaceLines& lines, Points& gradient, int repeated) {
  const int distinct = lines.size() - repeated;
  Points pulled(lines.size(), 3);
  lines.each([&](const FaceLines::Line& line) {
    for (int n = 0; n < lines.size(); ++n) pulled.row(n) = line.pulled(gradient, n);
    const Eigen::RowVector3d mean = pulled.colwise().sum() / distinct;
    for (int n = 0; n < lines.size(); ++n) {
      const Eigen::RowVector3d own = n < distinct ? mean : Eigen::RowVector3d::Zero();
      line.pull(gradient, n, own - pulled.row(n));
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
  const int joint = family.regular() ? 3 : 1;  // layers that are repeated where an axis is closed
  for (int axis = 0; axis < 3; ++axis) {
    if (layers.size(axis) < Lattice::kMinPoints) continue;  // it has no cells to join
    if (is_closed(layers, points, axis, joint, tolerance)) {
      repeated_[static_cast<std::size_t>(axis)] = joint;
    }
    for (int end = 0; end < 2; ++end) {
      for (int other = 1; other < 3; ++other) {
        const Collapsed face{axis, end, (axis + other) % 3};
        if (is_collapsed(FaceLines(layers, face, weights), points, tolerance)) {
          collapsed_.push_back(face);
        }
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
    const Eigen::Index period = layers.step(axis) * (layers.size(axis) - repeated(axis));
    layers.each(axis, [&](Eigen::Index row) {
      for (int layer = 0; layer < repeated(axis); ++layer, row += layers.step(axis)) {
        points.row(row + period) = points.row(row);
      }
    });
  }
  const FaceWeights weights(family_);
  for (const Collapsed& face : collapsed_) {
    collapse(FaceLines(layers, face, weights), points, repeated(face.along));
  }
  return Lattice(dims_, std::move(points));
}

Points Closure::pull_back(Points gradient) const {
  const Layers layers(dims_);
  const FaceWeights weights(family_);
  for (auto face = collapsed_.rbegin(); face != collapsed_.rend(); ++face) {
    pull_collapse(FaceLines(layers, *face, weights), gradient, repeated(face->along));
  }
  for (int axis = 2; axis >= 0; --axis) {
    if (!closed(axis)) continue;
    const Eigen::Index step = layers.step(axis);
    const Eigen::Index period = step * (layers.size(axis) - repeated(axis));
    layers.each(axis, [&](Eigen::Index row) {
      for (int layer = repeated(axis) - 1; layer >= 0; --layer) {
        const Eigen::Index from = row + layer * step + period;
        gradient.row(row + layer * step) += gradient.row(from);
        gradient.row(from).setZero();
      }
    });
  }
  return gradient;
}

}  // namespace hwffd
