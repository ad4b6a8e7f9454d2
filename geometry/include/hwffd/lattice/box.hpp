#pragma once

#include <optional>
#include <vector>

#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// A parallelepiped: the deformable region of a box lattice. Its affine embedding is that of
/// section 2 of the paper. Other shapes of lattice get an embedding of their own; Lattice and
/// Embedded serve them all.
class Box {
 public:
  /// @param origin the corner s = t = u = 0
  /// @param edges 3 x 3, column a the edge along axis a (s, t, u)
  /// @throws Error if the edges are not finite or span no volume
  Box(const Point& origin, const Eigen::Matrix3d& edges);

  /// The bounding box of points (n x 3, n > 0), s along x, t along y (up), u along z. An axis
  /// without extent gets the largest extent of the others, or 1, so that flat models embed too.
  /// @param room  left free beyond the points along x, y, z
  /// @throws Error if there is no point or one is not finite
  static Box around(const Points& points, const Point& room = Point::Zero());

  /// The box whose lattice() this is, to within 1e-12 of its size; nothing for another shape.
  static std::optional<Box> of(const Lattice& lattice);

  const Point& origin() const { return origin_; }
  const Eigen::Matrix3d& edges() const { return edges_; }

  /// The lattice whose cells together are this box: along an axis of n points they are
  /// origin + edge*(i - 1)/(n - 3), one spacing beyond the box on either side. With 4 x 4 x 4
  /// points the box is the one cell in the middle.
  /// @throws Error for dims out of range (Lattice)
  Lattice lattice(const Index3& dims) const;

  /// Cell and local coordinates of a point in lattice(dims). A point on a face between cells
  /// belongs to the upper one (local coordinate 0), on the last face to the last cell (1). A point
  /// within 1e-12 of the box's size outside counts as on the face. A NaN is outside.
  Embedded embed(const Index3& dims, const Point& point) const;

  /// embed() for every row of points, n x 3.
  std::vector<Embedded> embed(const Index3& dims, const Points& points) const;

  /// The point with this embedding: the inverse of embed().
  Point point(const Index3& dims, const Embedded& embedded) const;

 private:
  Point origin_;
  Eigen::Matrix3d edges_;
  Eigen::Matrix3d inverse_;
};

}  // namespace hwffd
