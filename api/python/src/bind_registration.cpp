#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "arguments.hpp"
#include "arrays.hpp"
#include "hwffd/device/device_map.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/refine.hpp"
#include "hwffd/registration/registration.hpp"
#include "lattice.hpp"

namespace hwffd::python {
namespace {

using namespace py::literals;
using Holder = std::unique_ptr<PyLattice>;
using Values = py::array_t<float, py::array::c_style>;
using Mask = py::array_t<std::uint8_t, py::array::c_style>;

/// Voxels of Python, (nz, ny, nx), which stay where they are as long as a call.
Volume volume_of(const std::string& name, const Values& values, const Eigen::Matrix4d& to_point,
                 const std::optional<Mask>& mask) {
  const auto count = [&](py::ssize_t axis) { return static_cast<int>(values.shape(axis)); };
  const auto nothing = [](const auto* /*of Python*/) {};
  Volume::Mask bytes;
  if (mask) bytes = Volume::Mask(mask->data(), nothing);
  return Volume(name, {count(2), count(1), count(0)}, Volume::Values(values.data(), nothing),
                AffineMap::of(to_point), std::move(bytes));
}

Holder moved_lattice(const Lattice& rest, const Lattice& deformed) {
  DeformableLattice lattice(rest);
  lattice.move(deformed.points());
  return std::make_unique<PyLattice>(std::move(lattice));
}

py::dict step_of(const RegistrationStep& step) {
  return py::dict("level"_a = step.level, "iteration"_a = step.iteration,
                  "evaluations"_a = step.evaluations, "metric"_a = step.metric,
                  "bending"_a = step.bending, "barrier"_a = step.barrier,
                  "objective"_a = step.objective, "voxels"_a = step.voxels);
}

py::dict state_of(const RegistrationState& state) {
  return py::dict("level"_a = state.level, "levels"_a = state.levels,
                  "iteration"_a = state.iteration, "evaluations"_a = state.evaluations,
                  "metric"_a = state.metric, "objective"_a = state.objective,
                  "voxels"_a = state.voxels, "seconds"_a = state.seconds, "dims"_a = state.dims);
}

/// A lattice to start from, over the fixed volume.
Lattice start_of(const PyLattice& given, const Volume& fixed) {
  const auto [rest, deformed, family] = given.alone([](const DeformableLattice& of) {
    return std::tuple(of.rest(), of.deformed(), of.family().kind());
  });
  const Index3 cells = rest.cells();
  const Points expected = rest_lattice(fixed, cells).points();
  const double size = (expected.colwise().maxCoeff() - expected.colwise().minCoeff()).maxCoeff();
  if (family != Family().kind() ||
      !((rest.points() - expected).cwiseAbs().maxCoeff() <= 1e-6 * size)) {
    throw Error(
        "start: not a lattice of B-splines whose cells at rest fill the fixed volume; give one of "
        "a "
        "registration of this volume");
  }
  return deformed;
}

/// What hwffd.volumes.register() hands on, checked: volumes as values, affine map and mask.
py::dict register_arrays(const Values& fixed, const Eigen::Matrix4d& fixed_to_point,
                         const std::optional<Mask>& mask, const Values& moving,
                         const Eigen::Matrix4d& moving_to_point,
                         const std::optional<Mask>& moving_mask,
                         const std::array<double, 3>& spacing, bool spacing_in_voxels, int levels,
                         bool smooth, const std::string& metric, int bins, double bending_weight,
                         bool no_folds, const std::optional<Eigen::Matrix4d>& start,
                         const PyLattice* start_lattice, int iterations, double tolerance,
                         const std::string& device, const std::string& org,
                         const std::string& format, const py::object& progress) {
  RegistrationOptions options;
  options.spacing = spacing;
  options.spacing_in_voxels = spacing_in_voxels;
  options.levels = levels;
  options.smooth = smooth;
  options.metric = parse_metric(metric);
  options.bins = bins;
  options.bending_weight = bending_weight;
  options.no_folds = no_folds;
  if (start) options.start = AffineMap::of(*start);
  options.iterations = iterations;
  options.tolerance = tolerance;
  const DeviceChoice choice{device, org, format};
  options.map = make_device_map(choice);
  const Volume fixed_volume = volume_of("fixed image", fixed, fixed_to_point, mask);
  const Volume moving_volume = volume_of("moving image", moving, moving_to_point, moving_mask);

  if (start_lattice != nullptr) options.start_lattice = start_of(*start_lattice, fixed_volume);

  RegistrationProgress told;
  if (!progress.is_none()) {
    told = [&](const RegistrationState& state) {
      const py::gil_scoped_acquire locked;
      const py::object answer = progress(state_of(state));
      return answer.is_none() || py::bool_(answer);
    };
  }
  const RegistrationResult result = [&] {
    const Unlocked unlocked;
    return register_volumes(fixed_volume, moving_volume, options, told);
  }();

  Holder lattice = moved_lattice(result.rest, result.deformed);
  lattice->alone([&](DeformableLattice& of) { of.set_device(choice); });
  py::list history;
  for (const RegistrationStep& step : result.history) history.append(step_of(step));
  py::dict found;
  found["lattice"] = py::cast(std::move(lattice));
  found["history"] = history;
  found["metric_start"] = result.metric_start;
  found["metric_end"] = result.metric_end;
  found["jacobian"] = py::make_tuple(result.least_jacobian, result.most_jacobian);
  found["folds"] = result.folds.text();
  found["evaluations"] = result.evaluations;
  found["voxels"] = result.voxels;
  found["seconds"] = result.seconds;
  found["overlap"] =
      static_cast<double>(result.overlap_voxels) / static_cast<double>(fixed_volume.size());
  found["stopped"] = result.stopped;
  found["warnings"] = result.warnings;
  return found;
}

Holder refine(const PyLattice& lattice, const std::array<bool, 3>& axes) {
  struct Copy {
    Lattice rest, deformed;
    DeviceChoice choice;
    std::string outside;
  };
  const Copy copy = lattice.alone([&](const DeformableLattice& of) {
    return Copy{refined(of.rest(), axes, of.family()), refined(of.deformed(), axes, of.family()),
                of.choice(), lattice.outside};
  });
  Holder result = moved_lattice(copy.rest, copy.deformed);
  result->alone([&](DeformableLattice& to) {
    to.set_device(copy.choice);
    to.set_outside(copy.outside);
    result->outside = copy.outside;
  });
  return result;
}

}  // namespace

void bind_refine(py::class_<PyLattice>& type) {
  type.def("refine", &refine, py::arg("axes") = std::array<bool, 3>{true, true, true},
           "The lattice of B-splines with each cell halved along the axes wanted, at rest and "
           "deformed: 2n - 3 control points for n, and the same map.");
}

void bind_registration(py::module_& module) {
  module.def("metrics", &metric_names, "The names of metrics that a registration takes.");
  module.def("register_arrays", &register_arrays, py::arg("fixed"), py::arg("fixed_to_point"),
             py::arg("mask").none(true), py::arg("moving"), py::arg("moving_to_point"),
             py::arg("moving_mask").none(true), py::arg("spacing"), py::arg("spacing_in_voxels"),
             py::arg("levels"), py::arg("smooth"), py::arg("metric"), py::arg("bins"),
             py::arg("bending_weight"), py::arg("no_folds"), py::arg("start").none(true),
             py::arg("start_lattice").none(true), py::arg("iterations"), py::arg("tolerance"),
             py::arg("device"), py::arg("org"), py::arg("format"), py::arg("progress").none(true),
             "What hwffd.volumes.register calls.");
}

}  // namespace hwffd::python
