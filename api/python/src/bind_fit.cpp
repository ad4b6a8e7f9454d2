#include <pybind11/stl.h>

#include <string>
#include <utility>

#include "arrays.hpp"
#include "hwffd/device/fit.hpp"
#include "hwffd/error.hpp"
#include "lattice.hpp"

namespace hwffd::python {
namespace {

py::dict fit_points(PyLattice& lattice, const py::object& points, const py::object& targets,
                    const std::string& loss, double scale, double penalty, double ridge,
                    const std::vector<double>& weights, int iterations, double tolerance,
                    const py::object& progress) {
  FitOptions options;
  options.loss = parse_loss(loss);
  options.scale = scale;
  options.bending_weight = penalty;
  options.ridge = ridge;
  options.weights = weights;
  options.iterations = iterations;
  options.tolerance = tolerance;
  const Read from = read_points(points, "points");
  const Read targets_read = read_points(targets, "targets");
  if (targets_read.shape != from.shape) {
    throw UsageError("targets: another shape than points; give a target for each point");
  }
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0) {
    throw UsageError("progress: no function; give one of iteration and objective");
  }
  const Points to = targets_read.points();
  FitProgress visit;
  if (!progress.is_none()) {
    visit = [&](int iteration, double objective) {
      const py::gil_scoped_acquire locked;
      const py::object answer = progress(iteration, objective);
      return answer.is_none() || py::bool_(answer);
    };
  }
  FitResult result = lattice.alone(
      [&](DeformableLattice& of) { return fit(of, from.points(), to, options, visit); });
  py::dict summary;
  summary["rms_start"] = result.rms_start;
  summary["rms_end"] = result.rms_end;
  summary["largest"] = result.largest;
  const Shape shape(from.shape.begin(), from.shape.end() - 1);
  summary["distances"] = owning(std::move(result.distances), shape);
  summary["outside"] = result.outside;
  summary["iterations"] = result.iterations;
  summary["evaluations"] = result.evaluations;
  summary["stopped"] = result.stopped;
  summary["folds"] = result.folds.text();
  return summary;
}

}  // namespace

void bind_fit(py::module_& module) {
  module.def(
      "fit", &fit_points, py::arg("lattice"), py::arg("points"), py::arg("targets"), py::kw_only(),
      py::arg("loss") = "squares", py::arg("scale") = 0.0, py::arg("penalty") = 0.0,
      py::arg("ridge") = 1e-9, py::arg("weights") = std::vector<double>{},
      py::arg("iterations") = 500, py::arg("tolerance") = 1e-9, py::arg("progress") = py::none(),
      "Moves the control points of a lattice so that it takes points (..., 3), where they lie at "
      "rest, to targets of the same shape, by L-BFGS on its device. A dictionary: rms_start, "
      "rms_end and largest distance, distances (...), outside (how many it does not carry), "
      "iterations, evaluations, stopped and folds.\n\nloss: squares, or huber or geman-mcclure, to "
      "which points farther than scale from their targets are outliers. penalty: weight of the "
      "bending energy, of a box of B-splines. ridge: of the control points' moves. weights: of the "
      "points. progress: called with iteration and objective, and may not use the lattice; False "
      "ends.");
  module.def("losses", &loss_names, "The names of losses that a fit takes.");
}

}  // namespace hwffd::python
