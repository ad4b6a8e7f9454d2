#include "hwffd/lattice/around.hpp"

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "hwffd/lattice/few_points.hpp"
#include "hwffd/lattice/shape.hpp"

namespace hwffd {
namespace {

const Shape& find(const std::string& name) {
  const Shape* shape = find_shape(name);
  if (shape != nullptr) return *shape;
  throw UsageError("shape '" + excerpt(name) + "' is unknown; one of " + shape_list());
}

}  // namespace

Index3 usual_dims(const std::string& shape) { return find(shape).usual; }

Lattice lattice_around(const std::string& shape, const Points& points, const Index3& dims,
                       double room) {
  const Point extent =
      points.rows() == 0 ? Point::Zero() : Point(room * points.cwiseAbs().colwise().maxCoeff());
  return find(shape).around(points, extent, dims);
}

Lattice lattice_around(const std::string& shape, const Points& points,
                       const std::optional<Index3>& dims, const Family& family, double room) {
  if (!dims) return family.from_bspline(lattice_around(shape, points, usual_dims(shape), room));
  const Index3 cells = family.bspline_dims(whole_dims(*dims, family));
  return thinned(family.from_bspline(lattice_around(shape, points, cells, room)), *dims, family);
}

}  // namespace hwffd
