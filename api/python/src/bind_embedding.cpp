#include <pybind11/stl.h>

#include <Eigen/LU>
#include <cstdint>
#include <limits>

#include "arrays.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/carried_normals.hpp"
#include "hwffd/lattice/coordinates.hpp"
#include "hwffd/lattice/weights.hpp"
#include "lattice.hpp"
#include "warning.hpp"

namespace hwffd::python {
namespace {

/// The shape of an array that has `last` in place of the 3 of each point.
Shape with(const PyEmbedding& embedding, const Shape& last) {
  Shape shape(embedding.shape.begin(), embedding.shape.end() - 1);
  shape.insert(shape.end(), last.begin(), last.end());
  return shape;
}

/// An array of what put(embedding of a point, to) writes there; it gives the place behind.
template <typename Number, typename Put>
py::array array_of(const PyEmbedding& embedding, const Shape& last, const Put& put) {
  py::array_t<Number> result(with(embedding, last));
  Number* to = result.mutable_data();
  for (Eigen::Index row = 0; row < embedding.attachment->size(); ++row) {
    to = put(embedding.attachment->embedding(row), to);
  }
  return read_only(std::move(result));
}

py::array cells(const PyEmbedding& embedding) {
  return array_of<std::int32_t>(embedding, {3}, [](const Embedding& at, std::int32_t* to) {
    return std::copy(at.at.cell.begin(), at.at.cell.end(), to);
  });
}

py::array local(const PyEmbedding& embedding) {
  return array_of<double>(embedding, {3}, [](const Embedding& at, double* to) {
    return std::copy(at.at.local.data(), at.at.local.data() + 3, to);
  });
}

py::array residual(const PyEmbedding& embedding) {
  return array_of<double>(embedding, {}, [](const Embedding& at, double* to) {
    *to = at.residual;
    return to + 1;
  });
}

py::array inside(const PyEmbedding& embedding) {
  return array_of<bool>(embedding, {}, [](const Embedding& at, bool* to) {
    *to = at.status == EmbeddingStatus::kInside;
    return to + 1;
  });
}

/// Warns of points that the deformation leaves where they are.
void warn_of_stayers(const EmbeddingSummary& summary, const std::string& outside) {
  std::string text;
  if (summary.outside > 0 && outside == "keep") {
    text = std::to_string(summary.outside) + " of " + std::to_string(summary.points) +
           " points are outside the lattice and stayed; see set_outside";
  } else if (summary.not_converged > 0) {
    text = std::to_string(summary.not_converged) + " of " + std::to_string(summary.points) +
           " points could neither be embedded nor proved to be outside, and stayed";
  }
  if (!text.empty()) warn(text);
}

py::array deform_embedded(const PyEmbedding& embedding, PyLattice& lattice, const py::object& out) {
  Target target(out, embedding.shape, embedding.is_float);
  py::array to = target.take(
      lattice.alone([&](DeformableLattice& of) { return of.carry(*embedding.attachment); }));
  warn_of_stayers(embedding.attachment->summary(), embedding.outside);
  return to;
}

py::array deform_points(PyLattice& lattice, const py::object& points, const py::object& out) {
  const Read read = read_points(points, "points");
  Target target(out, read.shape, read.is_float);
  target.open();
  EmbeddingSummary summary;
  std::string outside;
  lattice.alone([&](DeformableLattice& of) {
    of.carry(
        read.count(),
        [&](Eigen::Index first, Eigen::Index count) { return read.rows(first, count); },
        [&](Eigen::Index first, const Points& rows) { target.write(first, rows); },
        Attachment::Unsure::kStay);
    summary = of.summary();
    outside = lattice.outside;
  });
  py::array to = target.take();
  warn_of_stayers(summary, outside);
  return to;
}

/// Points of Dask go where that is known to be there.
py::object deform(PyLattice& lattice, const py::object& points, const py::object& out) {
  if (py::isinstance<PyEmbedding>(points)) {
    return deform_embedded(points.cast<const PyEmbedding&>(), lattice, out);
  }
  if (py::hasattr(points, "__dask_graph__")) {
    return py::module_::import("hwffd._chunks").attr("deform")(&lattice, points, out);
  }
  return deform_points(lattice, points, out);
}

std::vector<Eigen::Matrix3d> gradients(const PyEmbedding& embedding, const PyLattice& lattice) {
  return lattice.alone(
      [&](const DeformableLattice& of) { return of.gradients(*embedding.attachment); });
}

py::array jacobians(const PyEmbedding& embedding, const PyLattice& lattice) {
  const std::vector<Eigen::Matrix3d> all = gradients(embedding, lattice);
  py::array_t<double> result(with(embedding, {3, 3}));
  double* to = result.mutable_data();
  for (const Eigen::Matrix3d& gradient : all) {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>{to} = gradient;
    to += 9;
  }
  return std::move(result);
}

py::array determinants(const PyEmbedding& embedding, const PyLattice& lattice) {
  const std::vector<Eigen::Matrix3d> all = gradients(embedding, lattice);
  py::array_t<double> result(with(embedding, {}));
  double* to = result.mutable_data();
  for (const Eigen::Matrix3d& gradient : all) *to++ = gradient.determinant();
  return std::move(result);
}

py::array normals(const PyEmbedding& embedding, const PyLattice& lattice, const py::object& at_rest,
                  const py::object& out) {
  const Points read = read_rows(at_rest, "normals", embedding.attachment->size());
  check_coordinates("normals", read);
  Target target(out, embedding.shape, embedding.is_float);
  return target.take(carried_normals(gradients(embedding, lattice), read));
}

/// Numbers as 32 bits, as SciPy keeps them beside other such indices without a copy; as they are
/// where one is too large.
py::array narrow(std::vector<std::int64_t> numbers) {
  if (numbers.back() > std::numeric_limits<std::int32_t>::max()) return owning(std::move(numbers));
  return owning(std::vector<std::int32_t>(numbers.begin(), numbers.end()));
}

/// (values, columns, starts), as SciPy takes them.
py::tuple csr(const PyEmbedding& embedding) {
  SparseRows rows;
  {
    const Unlocked unlocked;
    rows = weights_of(*embedding.attachment);
  }
  return py::make_tuple(owning(std::move(rows.values)), owning(std::move(rows.columns)),
                        narrow(std::move(rows.starts)));
}

py::object weights(const PyEmbedding& embedding) {
  const py::object make = py::module_::import("scipy.sparse").attr("csr_array");
  const py::tuple shape =
      py::make_tuple(embedding.attachment->size(), embedding.attachment->rest().points().rows());
  return make(csr(embedding), py::arg("shape") = shape);
}

py::array unmoved(const PyEmbedding& embedding) {
  return new_array(embedding.shape, unmoved_part(*embedding.attachment).data());
}

py::array pull_back_gradient(const PyEmbedding& embedding, const py::object& gradient) {
  const Points read = read_rows(gradient, "gradient", embedding.attachment->size());
  check_coordinates("gradient", read);
  Points pulled;
  {
    const Unlocked unlocked;
    pulled = pull_back(*embedding.attachment, read);
  }
  return new_array(grid_shape(embedding.attachment->rest().dims()), pulled.data());
}

/// What embedding the points again needs, for pickle.
py::tuple state_of_embedding(const PyEmbedding& embedding) {
  const Attachment& of = *embedding.attachment;
  return py::make_tuple(new_array(grid_shape(of.rest().dims()), of.rest().points().data()),
                        of.family().name(), embedding.outside,
                        new_array(embedding.shape, of.points().data()), embedding.is_float);
}

/// @param state  that, or an embedding, whose points the new one shares
PyEmbedding embedding_from(const py::tuple& state) {
  if (state.size() == 1 && py::isinstance<PyEmbedding>(state[0])) {
    return state[0].cast<const PyEmbedding&>();
  }
  if (state.size() != 5 || !py::isinstance<py::str>(state[1]) ||
      !py::isinstance<py::str>(state[2]) || !py::isinstance<py::bool_>(state[4])) {
    throw Error("this pickle holds no embedding; pickle one again");
  }
  const Read rest = read_points(state[0], "control points");
  const Read points = read_points(state[3], "points");
  const auto family = Family::parse(state[1].cast<std::string>());
  const auto outside = state[2].cast<std::string>();
  const Index3 dims = dims_of_grid(rest.shape);
  const bool is_float = state[4].cast<bool>();
  const Unlocked unlocked;
  return {
      std::make_shared<Attachment>(Embedder(Lattice(dims, rest.points()), family), points.points(),
                                   Outside::parse(outside), Attachment::Unsure::kStay),
      points.shape, is_float, outside};
}

template <std::size_t EmbeddingSummary::*Count>
std::size_t count(const PyEmbedding& embedding) {
  return embedding.attachment->summary().*Count;
}

void bind_places(py::class_<PyEmbedding>& type) {
  type.def_readonly("shape", &PyEmbedding::shape, "of the points, [..., 3]")
      .def("__len__", [](const PyEmbedding& of) { return of.attachment->size(); })
      .def_property_readonly("cells", &cells, "(..., 3), int32: along s, t, u")
      .def_property_readonly("local", &local, "(..., 3): s, t, u, in [0, 1] if inside")
      .def_property_readonly("residual", &residual, "(...): distance of the place from the point")
      .def_property_readonly("inside", &inside, "(...), bool")
      .def_property_readonly("outside", &count<&EmbeddingSummary::outside>,
                             "how many points no cell has, which is proved")
      .def_property_readonly("not_converged", &count<&EmbeddingSummary::not_converged>,
                             "how many were neither found nor excluded; they stay")
      .def(
          "__iter__",
          [](const PyEmbedding& of) {
            return py::make_tuple(cells(of), local(of), residual(of), inside(of))
                .attr("__iter__")();
          },
          "cells, local, residual, inside")
      .def(py::pickle(&state_of_embedding, &embedding_from))
      .def("__repr__", [](const PyEmbedding& of) {
        const EmbeddingSummary& summary = of.attachment->summary();
        return "<hwffd.Embedding of " + std::to_string(summary.points) + " points, " +
               std::to_string(summary.outside) + " outside, " +
               std::to_string(summary.not_converged) + " not converged>";
      });
}

}  // namespace

PyEmbedding embed(const PyLattice& lattice, const py::object& points) {
  Read read = read_points(points, "points");
  std::string outside;
  auto attachment = lattice.alone([&](const DeformableLattice& of) {
    outside = lattice.outside;
    return std::make_shared<const Attachment>(of.attach(read.points(), Attachment::Unsure::kStay));
  });
  return {std::move(attachment), std::move(read.shape), read.is_float, std::move(outside)};
}

void bind_embedding(py::module_& module) {
  py::class_<PyEmbedding> type(
      module, "Embedding",
      "Points attached to a lattice at rest, to be deformed again and again. It never changes, and "
      "any lattice with the same points at rest and family takes it.");
  bind_places(type);
  type.def("deform", &deform_embedded, py::arg("lattice"), py::kw_only(),
           py::arg("out") = py::none(), "hwffd.deform(lattice, self)")
      .def("jacobians", &jacobians, py::arg("lattice"),
           "(..., 3, 3): derivative [r, c] of coordinate r of the moved point along coordinate c "
           "of the point at rest; NaN where it is not known (poles, axes, points that follow).")
      .def("determinants", &determinants, py::arg("lattice"),
           "(...): determinants of jacobians(), the growth of volume; negative where it folds.")
      .def("normals", &normals, py::arg("lattice"), py::arg("normals"), py::kw_only(),
           py::arg("out") = py::none(),
           "(..., 3): normals (..., 3), of any length, as the deformation turns them, of length 1.")
      .def("weights", &weights,
           "W, scipy.sparse.csr_array (n, m) for n points and m control points: the moved points "
           "(n, 3) are W @ lattice.points + unmoved().reshape(-1, 3).")
      .def("csr", &csr, "(values, columns, starts) of weights(), without SciPy")
      .def("unmoved", &unmoved,
           "(..., 3): what does not move with the control points; 0 for points inside.")
      .def("pull_back", &pull_back_gradient, py::arg("gradient"),
           "W.T @ gradient, (ns, nt, nu, 3): of a gradient (..., 3) with respect to the points "
           "that with respect to the control points.");
  module.def("deform", &deform, py::arg("lattice"), py::arg("points"), py::kw_only(),
             py::arg("out") = py::none(),
             "Points (..., 3), or an Embedding, where the deformed lattice takes them: an array of "
             "their shape, float32 if they were, or out. Warns of points that stay. Points of Dask "
             "are deformed when Dask computes the result.");
}

}  // namespace hwffd::python
