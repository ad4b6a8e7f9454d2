#include "hwffd/lattice/family.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "axis_points.hpp"
#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "hwffd/lattice/conversion.hpp"

namespace hwffd {
namespace {

constexpr int kMostBernsteinPoints = 49;  // 16 cells of 4 points each

/// The functions of a cell of a clamped axis (Cox and de Boor), as polynomials of x = t - cell.
Oracle::Coefficients clamped(int points, int cell) {
  const auto knot = [&](int i) { return std::clamp(i - 3, 0, points - 3); };
  // (a + x) times a polynomial, over `by`; functions that end here have no width.
  const auto ramp = [](double a, double sign, double by, const Eigen::RowVector4d& f) {
    Eigen::RowVector4d product = a * f;
    product.tail<3>() += sign * f.head<3>();
    return Eigen::RowVector4d(product / by);
  };
  Oracle::Coefficients functions = Oracle::Coefficients::Zero();
  functions(3, 0) = 1;
  for (int degree = 1; degree <= 3; ++degree) {
    for (int l = 3 - degree; l <= 3; ++l) {
      const int j = cell + l;
      Eigen::RowVector4d sum = Eigen::RowVector4d::Zero();
      if (l > 3 - degree) {
        sum += ramp(cell - knot(j), 1, knot(j + degree) - knot(j), functions.row(l));
      }
      if (l < 3) {
        sum += ramp(knot(j + degree + 1) - cell, -1, knot(j + degree + 1) - knot(j + 1),
                    functions.row(l + 1));
      }
      functions.row(l) = sum;
    }
  }
  return functions;
}

constexpr int kBernsteinStep = 4;  // points that a cell has of its own, for devices

/// The control points that devices evaluate.
struct OtherPoints {
  Index3 dims;
  AxisPoints point_of;
};

/// Those of a lattice of so many points an axis, where they are not the lattice's own.
std::optional<OtherPoints> points_evaluated(const Family& family, const Index3& dims) {
  Index3 cells = family.cells(dims);
  if (family.kind() == Family::Kind::kClamped) {
    return OtherPoints{dims, [=](int axis, int at) {
                         const auto a = static_cast<std::size_t>(axis);
                         const int cell = std::min(at, cells[a] - 1);
                         const Eigen::Matrix4d map =
                             conversion(family.functions(dims[a], cell), Oracle::uniform_bspline());
                         return AxisPoint{cell, map.row(at - cell)};
                       }};
  }
  if (family.kind() != Family::Kind::kBernstein) return std::nullopt;
  for (int& n : cells) n *= kBernsteinStep;
  return OtherPoints{
      cells, [](int, int at) {
        return AxisPoint{at / kBernsteinStep * 3, Eigen::RowVector4d::Unit(at % kBernsteinStep)};
      }};
}

}  // namespace

const std::vector<std::string>& Family::names() {
  static const std::vector<std::string> names{"bspline", "clamped", "bernstein", "catmull-rom",
                                              "linear"};
  return names;
}

Family Family::parse(std::string_view name) {
  const auto it = std::find(names().begin(), names().end(), name);
  if (it == names().end()) {
    throw UsageError(fmt::format("blending functions '{}' are unknown; one of {}", excerpt(name),
                                 fmt::join(names(), ", ")));
  }
  return Family(static_cast<Kind>(it - names().begin()));
}

const std::string& Family::name() const { return names()[static_cast<std::size_t>(kind_)]; }

void Family::check_dims(const Index3& dims) const {
  Lattice::check_dims(dims);
  if (kind_ != Kind::kBernstein) return;
  for (const int n : dims) {
    if (n % 3 == 1 && n <= kMostBernsteinPoints) continue;
    throw Error(
        fmt::format("lattice of {} x {} x {} points: each axis of bernstein takes 4, 7, 10, ... or "
                    "{} points",
                    dims[0], dims[1], dims[2], kMostBernsteinPoints));
  }
}

Index3 Family::cells(const Index3& dims) const {
  Index3 result = dims;
  for (int& n : result) n = kind_ == Kind::kBernstein ? (n - 1) / 3 : n - 3;
  return result;
}

Oracle::Coefficients Family::functions(int points, int cell) const {
  switch (kind_) {
    case Kind::kClamped:
      return clamped(points, cell);
    case Kind::kBernstein:
      return Oracle::bernstein();
    case Kind::kCatmullRom:
      return Oracle::catmull_rom();
    case Kind::kLinear:
      return Oracle::linear();
    case Kind::kBspline:
      break;
  }
  return Oracle::uniform_bspline();
}

Support Family::support(const Lattice& lattice, const Index3& cell) const {
  if (kind_ == Kind::kBspline) return lattice.support(cell);
  const Index3 count = cells(lattice.dims());
  std::array<Eigen::Matrix4d, 3> axes;
  for (std::size_t a = 0; a < 3; ++a) {
    if (cell[a] < 0 || cell[a] >= count[a]) {
      throw Error(fmt::format("cell ({}, {}, {}) is outside the lattice; it has {} x {} x {} cells",
                              cell[0], cell[1], cell[2], count[0], count[1], count[2]));
    }
    axes[a] = conversion(functions(lattice.dims()[a], cell[a]), Oracle::uniform_bspline());
  }
  return convert(lattice.support({first(cell[0]), first(cell[1]), first(cell[2])}), axes);
}

Index3 Family::bspline_dims(const Index3& dims) const {
  check_dims(dims);
  Index3 result = cells(dims);
  for (int& n : result) n += 3;
  return result;
}

Lattice Family::from_bspline(const Lattice& lattice) const {
  if (regular()) return lattice;
  const Index3 cells = lattice.cells();
  Index3 dims = lattice.dims();
  if (kind_ == Kind::kBernstein) {
    for (std::size_t a = 0; a < 3; ++a) dims[a] = 3 * cells[a] + 1;
  }
  check_dims(dims);
  return mapped(lattice, dims, [&](int axis, int at) {
    const auto a = static_cast<std::size_t>(axis);
    const int cell = std::min(kind_ == Kind::kBernstein ? at / 3 : at, cells[a] - 1);
    const Eigen::Matrix4d map = conversion(Oracle::uniform_bspline(), functions(dims[a], cell));
    return AxisPoint{cell, map.row(at - first(cell))};
  });
}

Family::Evaluable Family::evaluable(const Lattice& lattice) const {
  const Index3& dims = lattice.dims();
  check_dims(dims);
  const Oracle::Coefficients all =
      kind_ == Kind::kClamped ? Oracle::uniform_bspline() : functions(0, 0);
  const std::optional<OtherPoints> other = points_evaluated(*this, dims);
  if (!other) return {lattice, {all, all, all}};
  return {mapped(lattice, other->dims, other->point_of),
          {all, all, all},
          kind_ == Kind::kBernstein ? kBernsteinStep : 1};
}

Points Family::pull_back(const Index3& dims, const Points& gradient) const {
  check_dims(dims);
  const std::optional<OtherPoints> other = points_evaluated(*this, dims);
  return other ? mapped_back(gradient, other->dims, dims, other->point_of) : gradient;
}

Embedded Family::Evaluable::at(const Embedded& place) const {
  Embedded result = place;
  for (int& cell : result.cell) cell *= step;
  return result;
}

}  // namespace hwffd
