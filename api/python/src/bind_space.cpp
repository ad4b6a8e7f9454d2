#include <string>

#include "arguments.hpp"
#include "arrays.hpp"
#include "hwffd/error.hpp"
#include "lattice.hpp"
#include "warning.hpp"

namespace hwffd::python {
namespace {

constexpr Eigen::Index kMostPlaces = Eigen::Index{1} << 56;  // their doubles have addresses

/// The places of a regular grid in space, x fastest.
struct SpaceGrid {
  std::array<double, 3> first, last;
  Index3 counts;

  Eigen::Index size() const { return static_cast<Eigen::Index>(counts[0]) * counts[1] * counts[2]; }

  Points rows(Eigen::Index begin, Eigen::Index count) const {
    Points points(count, 3);
    for (Eigen::Index row = 0; row < count; ++row) {
      Eigen::Index rest = begin + row;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto steps = static_cast<double>(counts[axis] - 1);
        const auto at = static_cast<double>(rest % counts[axis]);
        rest /= counts[axis];
        const double part = steps > 0.0 ? at / steps : 0.0;
        points(row, static_cast<Eigen::Index>(axis)) =
            (1.0 - part) * first[axis] + part * last[axis];
      }
    }
    return points;
  }
};

/// How far `count` points that read(first, count) gives move.
template <typename ReadRows>
py::array displaced(PyLattice& lattice, Eigen::Index count, const ReadRows& read, Target& target) {
  target.open();
  lattice.alone([&](DeformableLattice& of) {
    of.carry(
        count, read,
        [&](Eigen::Index first, const Points& rows) {
          target.write(first, rows - read(first, rows.rows()));
        },
        Attachment::Unsure::kStay);
  });
  return target.take();
}

py::array displacements(PyLattice& lattice, const py::object& points, const py::object& out) {
  const Read read = read_points(points, "points");
  Target target(out, read.shape, read.is_float);
  return displaced(
      lattice, read.count(),
      [&](Eigen::Index first, Eigen::Index count) { return read.rows(first, count); }, target);
}

py::array displacement_grid(PyLattice& lattice, const py::object& first, const py::object& last,
                            const py::object& numbers, const py::object& out) {
  const SpaceGrid grid{read_numbers(first, "first", "(x, y, z)"),
                       read_numbers(last, "last", "(x, y, z)"),
                       read_integers(numbers, "counts", "(cx, cy, cz)")};
  Eigen::Index places = 1;
  for (const int count : grid.counts) {
    if (count < 1) throw UsageError("counts: " + std::to_string(count) + "; give 1 or more each");
    if (places > kMostPlaces / count) throw UsageError("counts: 2^56 places or more; give fewer");
    places *= count;
  }
  Target target(out, {grid.counts[2], grid.counts[1], grid.counts[0], 3}, false);
  return displaced(
      lattice, grid.size(),
      [&](Eigen::Index begin, Eigen::Index count) { return grid.rows(begin, count); }, target);
}

py::array inverse(const PyLattice& lattice, const py::object& points, const py::object& out) {
  const Read read = read_points(points, "points");
  Target target(out, read.shape, read.is_float);
  Points origins =
      lattice.alone([&](const DeformableLattice& of) { return of.inverse(read.points()); });
  const Eigen::Index none = origins.col(0).array().isNaN().count();
  py::array to = target.take(std::move(origins));
  if (none > 0) {
    warn(std::to_string(none) + " of " + std::to_string(read.count()) +
         " points come from nowhere, as far as was found, and are NaN");
  }
  return to;
}

}  // namespace

void bind_space(py::class_<PyLattice>& type) {
  type.def("displacements", &displacements, py::arg("points"), py::kw_only(),
           py::arg("out") = py::none(),
           "(..., 3): how far points (..., 3) move, what hwffd.deform gives less the points.")
      .def("displacement_grid", &displacement_grid, py::arg("first"), py::arg("last"),
           py::arg("counts"), py::kw_only(), py::arg("out") = py::none(),
           "(cz, cy, cx, 3): how far the points of a regular grid in space move, counts (cx, cy, "
           "cz) of them from first (x, y, z) to last.")
      .def("inverse", &inverse, py::arg("points"), py::kw_only(), py::arg("out") = py::none(),
           "(..., 3): the points at rest that the deformation takes to points (..., 3), in double. "
           "NaN, with a warning, where there is none or none was found.")
      .def(
          "bending_energy",
          [](const PyLattice& lattice) {
            return lattice.alone([](const DeformableLattice& of) { return of.bending_energy(); });
          },
          "The mean over the cells of the squared second derivatives of the displacement, exact "
          "(docs/lattice.md section 11); of boxes.");
}

}  // namespace hwffd::python
