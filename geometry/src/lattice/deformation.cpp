#include "hwffd/lattice/deformation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "movements.hpp"
#include "same_dims.hpp"

namespace hwffd {
namespace {

Lattice lattice_from(const std::string& file, const Index3& dims) {
  Lattice lattice = read_lattice(file);
  check_same_dims(fmt::format("deformation to:{}: that lattice", file).c_str(), lattice.dims(),
                  dims);
  return lattice;
}

/// The point that move names; of points repeated along a closed axis the first.
Index3 first_place(Index3 place, const Lattice& lattice, const Closure& closure) {
  const Index3& d = lattice.dims();
  for (std::size_t a = 0; a < 3; ++a) {
    if (place[a] < 0 || place[a] >= d[a]) {
      throw Error(
          fmt::format("deformation move: no point {},{},{} in a lattice of {} x {} x {} "
                      "points; count from 0",
                      place[0], place[1], place[2], d[0], d[1], d[2]));
    }
  }
  for (std::size_t a = 0; a < 3; ++a) {
    if (closure.closed(static_cast<int>(a))) place[a] %= d[a] - 3;
  }
  return place;
}

/// The lowest and the highest corner of a cell along an axis: what a shape holds is between them.
/// Of a lattice of few points (few_points.hpp) those of its points.
std::array<double, 2> reach_of_cells(const Lattice& lattice, int axis) {
  if (places(lattice.cells()).empty()) {
    const auto along = lattice.points().col(axis);
    return {along.minCoeff(), along.maxCoeff()};
  }
  const Oracle oracle;
  std::array<double, 2> reach{std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
  for (const Index3& cell : places(lattice.cells())) {
    const Support support = lattice.support(cell);
    for (int corner = 0; corner < 8; ++corner) {
      const double height =
          oracle.evaluate(support, corner >> 2 & 1, corner >> 1 & 1, corner & 1)[axis];
      reach = {std::min(reach[0], height), std::max(reach[1], height)};
    }
  }
  return reach;
}

}  // namespace

Deformation Deformation::move(const Index3& place, const Eigen::Vector3d& by) {
  Arguments arguments;
  arguments.place = place;
  arguments.vector = by;
  return {Kind::kMove, std::move(arguments)};
}

Points Deformation::moved(const Lattice& lattice, const Closure& closure) const {
  const Frame frame(lattice, closure.joined(), arguments_.axis);
  Points points = lattice.points();
  switch (kind_) {
    case Kind::kTwist:
      twist(points, frame, arguments_.amount);
      break;
    case Kind::kHelix:
      helix(points, frame, arguments_.amount, reach_of_cells(lattice, arguments_.axis));
      break;
    case Kind::kShear:
      shear(points, frame, arguments_.amount);
      break;
    case Kind::kBend:
      bend(points, frame, arguments_.amount, arguments_.towards);
      break;
    case Kind::kTaper:
      taper(points, frame, arguments_.amount);
      break;
    case Kind::kScale:
      scale(points, frame, arguments_.vector);
      break;
    case Kind::kRandom:
      jitter(points, frame, arguments_.seed);
      break;
    case Kind::kMove:
      points.row(lattice.index(first_place(arguments_.place, lattice, closure))) +=
          arguments_.vector.transpose();
      break;
    case Kind::kNone:
    case Kind::kTo:
      break;
  }
  return points;
}

Lattice Deformation::apply(const Lattice& lattice) const {
  if (kind_ == Kind::kNone) return lattice;
  if (kind_ == Kind::kTo) return lattice_from(arguments_.file, lattice.dims());
  const Closure closure(lattice);
  return closure.restore(Lattice(lattice.dims(), moved(lattice, closure)));
}

Lattice deform_lattice(const Lattice& lattice, const std::vector<Deformation>& deformations) {
  Lattice result = lattice;
  for (const Deformation& deformation : deformations) result = deformation.apply(result);
  return result;
}

}  // namespace hwffd
