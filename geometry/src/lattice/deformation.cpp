#include "hwffd/lattice/deformation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/lattice/few_points.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "movements.hpp"
#include "same_dims.hpp"

namespace hwffd {
namespace {

Lattice lattice_from(const std::string& name, const Index3& dims, const Family& family) {
  LatticeFile file = read_lattice_file(name);
  check_same_dims(fmt::format("deformation to:{}: that lattice", name).c_str(), file.lattice.dims(),
                  dims);
  if (file.family && file.family->kind() != family.kind()) {
    throw Error(
        fmt::format("deformation to:{}: its points are of the family {}, and the lattice that "
                    "moves there is of {}; give both the same family",
                    name, file.family->name(), family.name()));
  }
  return std::move(file.lattice);
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
    place[a] %= d[a] - closure.repeated(static_cast<int>(a));
  }
  return place;
}

/// The lowest and the highest corner of a cell along an axis: what a shape holds is between them.
std::array<double, 2> reach_of_cells(const Lattice& points, const Family& family, int axis) {
  const Lattice lattice = whole(points, family);
  const Oracle oracle;
  std::array<double, 2> reach{std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
  for (const Index3& cell : places(family.cells(lattice.dims()))) {
    const Support support = family.support(lattice, cell);
    for (int corner = 0; corner < 8; ++corner) {
      const double height =
          oracle.evaluate(support, corner >> 2 & 1, corner >> 1 & 1, corner & 1)[axis];
      reach = {std::min(reach[0], height), std::max(reach[1], height)};
    }
  }
  return reach;
}

/// The points whose bounding box has the corners of a lattice that is joined to itself. Those of
/// clamped knots lie unevenly around an axis that is closed, those of the same B-spline do not.
std::optional<Points> joined_points(const Lattice& lattice, const Family& family,
                                    const Closure& closure) {
  if (!closure.joined()) return std::nullopt;
  if (family.kind() != Family::Kind::kClamped) return lattice.points();
  return family.evaluable(lattice).lattice.points();
}

}  // namespace

Deformation Deformation::move(const Index3& place, const Eigen::Vector3d& by) {
  Arguments arguments;
  arguments.place = place;
  arguments.vector = by;
  return {Kind::kMove, std::move(arguments)};
}

Points Deformation::moved(const Lattice& lattice, const Family& family,
                          const Closure& closure) const {
  const Frame frame(lattice, joined_points(lattice, family, closure), arguments_.axis);
  Points points = lattice.points();
  switch (kind_) {
    case Kind::kTwist:
      twist(points, frame, arguments_.amount);
      break;
    case Kind::kHelix:
      helix(points, frame, arguments_.amount, reach_of_cells(lattice, family, arguments_.axis));
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

Lattice Deformation::apply(const Lattice& lattice, const Family& family) const {
  if (kind_ == Kind::kNone) return lattice;
  if (kind_ == Kind::kTo) return lattice_from(arguments_.file, lattice.dims(), family);
  const Closure closure(lattice, family);
  return closure.restore(Lattice(lattice.dims(), moved(lattice, family, closure)));
}

Lattice deform_lattice(const Lattice& lattice, const std::vector<Deformation>& deformations,
                       const Family& family) {
  Lattice result = lattice;
  for (const Deformation& deformation : deformations) result = deformation.apply(result, family);
  return result;
}

}  // namespace hwffd
