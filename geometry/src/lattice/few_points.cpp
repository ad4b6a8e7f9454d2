#include "hwffd/lattice/few_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "axis_points.hpp"
#include "hwffd/error.hpp"
#include "same_dims.hpp"

namespace hwffd {
namespace {

bool is_few(int points) { return points < Lattice::kMinPoints; }

bool has_few(const Index3& dims) { return std::any_of(dims.begin(), dims.end(), is_few); }

AxisPoint same(int at) { return {at, Eigen::RowVector4d::Unit(0)}; }

/// A Bezier curve of n = 2 or 3 points as one of four (degree elevation).
AxisPoint raised(int n, int at) {
  if (at == 0) return same(0);
  if (at == 3) return same(n - 1);
  if (n == 2) return {0, Eigen::RowVector4d(3 - at, at, 0, 0) / 3};
  return {at - 1,
          at == 1 ? Eigen::RowVector4d(1, 2, 0, 0) / 3 : Eigen::RowVector4d(2, 1, 0, 0) / 3};
}

/// The other way; a cubic's middle point is that of the parabola with its ends and its middle.
AxisPoint lowered(int n, int at) {
  if (at == 0) return same(0);
  if (at == n - 1) return same(3);
  return {0, Eigen::RowVector4d(-1, 3, 3, -1) / 4};
}

/// n points, and one more at each end.
AxisPoint extended(int n, int at) {
  if (at == 0) return {0, Eigen::RowVector4d(2, -1, 0, 0)};
  if (at == n + 1) return {n - 2, Eigen::RowVector4d(-1, 2, 0, 0)};
  return same(at - 1);
}

bool is_bernstein(const Family& family) { return family.kind() == Family::Kind::kBernstein; }

[[noreturn]] void throw_few(const Index3& dims, const Family& family) {
  std::string takers;
  for (const std::string& name : Family::names()) {
    if (!Family::parse(name).takes_few()) continue;
    takers += (takers.empty() ? "" : ", ") + name;
  }
  throw Error(fmt::format(
      "lattice of {} x {} x {} points: each axis takes {} to {} points where the family "
      "is {}, and from {} on where it is one of {}",
      dims[0], dims[1], dims[2], Lattice::kMinPoints, Lattice::kMaxPoints, family.name(),
      Lattice::kFewestPoints, takers));
}

}  // namespace

Index3 whole_dims(const Index3& dims, const Family& family) {
  if (family.takes_few()) {
    Lattice::check_dims(dims, Lattice::kFewestPoints);
  } else if (has_few(dims)) {
    throw_few(dims, family);
  }
  Index3 result = dims;
  for (int& n : result) {
    if (is_few(n)) n = is_bernstein(family) ? 4 : n + 2;
  }
  family.check_dims(result);
  return result;
}

Lattice whole(const Lattice& lattice, const Family& family) {
  const Index3& dims = lattice.dims();
  const Index3 more = whole_dims(dims, family);
  if (!has_few(dims)) return lattice;
  return mapped(lattice, more, [&](int axis, int at) {
    const int n = dims[static_cast<std::size_t>(axis)];
    if (!is_few(n)) return same(at);
    return is_bernstein(family) ? raised(n, at) : extended(n, at);
  });
}

Lattice thinned(const Lattice& lattice, const Index3& dims, const Family& family) {
  check_same_dims("lattice to thin", lattice.dims(), whole_dims(dims, family));
  if (!has_few(dims)) return lattice;
  return mapped(lattice, dims, [&](int axis, int at) {
    const int n = dims[static_cast<std::size_t>(axis)];
    if (!is_few(n)) return same(at);
    return is_bernstein(family) ? lowered(n, at) : same(at + 1);
  });
}

}  // namespace hwffd
