#include "hwffd/lattice/carried_normals.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <limits>

#include "cofactor.hpp"
#include "hwffd/error.hpp"

namespace hwffd {

Points carried_normals(const std::vector<Eigen::Matrix3d>& gradients, const Points& normals) {
  if (normals.rows() != static_cast<Eigen::Index>(gradients.size())) {
    throw Error(fmt::format("{} normals for {} points; give a row for each point", normals.rows(),
                            gradients.size()));
  }
  Points result(normals.rows(), 3);
  for (Eigen::Index row = 0; row < normals.rows(); ++row) {
    const Eigen::Matrix3d gradient = known(gradients[static_cast<std::size_t>(row)]);
    const double side = gradient.determinant() < 0.0 ? -1.0 : 1.0;
    const Point start = normals.row(row).transpose().stableNormalized();
    const Point normal = (side * cofactor(gradient) * start).stableNormalized();
    const bool has_direction = normal.allFinite() && !normal.isZero();
    result.row(row) =
        has_direction ? normal : Point::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  return result;
}

}  // namespace hwffd
