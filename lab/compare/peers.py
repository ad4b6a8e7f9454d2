"""Programs of others that evaluate the same sum with uniform cubic B-splines, on one core.

Each is given what it wants in the form it likes best, its results in arrays that are there already;
only the evaluation is timed. All of them are of the package index (lab/requirements-compare.txt).

SPDX-License-Identifier: Apache-2.0
"""

import dataclasses
import importlib.metadata
import time
from dataclasses import dataclass

import numpy

FEWEST_RUNS, ENOUGH = 3, 3.0  # runs, and seconds of all of them together
CALLS = 1000  # with one vertex, of a run
BOUNDS = {"binary64": 1e-12, "binary32": 2e-6}  # of a component of points in [-1, 1)


class PeerError(Exception):
    """Why a peer says nothing, in one line."""


@dataclass
class Scene:
    """Vertices in a lattice whose point (i, j, k) is at (i, j, k)."""

    points: numpy.ndarray  # 16 x 16 x 16 x 3
    places: numpy.ndarray  # n x 3: where the vertices are among the points
    exact: numpy.ndarray  # n x 3: where they go, by the oracle

    @classmethod
    def read(cls, folder):
        """What hwffd-compare wrote; (in its order, sorted by cell)."""
        points, local, exact = (numpy.fromfile(folder / f"{name}.f64").reshape(-1, 3)
                                for name in ("points", "local", "exact"))
        cells = numpy.fromfile(folder / "cells.i32", dtype=numpy.int32).reshape(-1, 3)
        axis = round(len(points) ** (1 / 3))
        points = points.reshape(axis, axis, axis, 3)
        order = numpy.lexsort(cells.T[::-1])
        places = cells + 1 + local
        return (cls(points, places, exact),
                cls(points, numpy.ascontiguousarray(places[order]), exact[order]))


def scipy_map_coordinates(scene):
    """A call for each component."""
    from scipy.ndimage import map_coordinates
    places = numpy.ascontiguousarray(scene.places.T)
    components = [numpy.ascontiguousarray(scene.points[..., c]) for c in range(3)]
    moved = numpy.empty((3, len(scene.places)))

    def evaluate():
        for component, out in zip(components, moved):
            map_coordinates(component, places, output=out, order=3, prefilter=False)
    return evaluate, lambda: moved.T


def vtk_transform(scene):
    """What it adds to a place is the sum; arrays of VTK have x fastest."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkFiltersHybrid import vtkBSplineTransform
    image = vtkImageData()
    image.SetDimensions(*scene.points.shape[2::-1])
    flat = numpy.ascontiguousarray(scene.points.transpose(2, 1, 0, 3)).reshape(-1, 3)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    transform = vtkBSplineTransform()
    transform.SetCoefficientData(image)
    transform.Update()
    places, moved = vtkPoints(), vtkPoints()
    for points in (places, moved):
        points.SetDataTypeToDouble()
    places.SetData(numpy_to_vtk(scene.places, deep=True))

    def evaluate():
        moved.Reset()
        transform.TransformPoints(places, moved)
    return evaluate, lambda: vtk_to_numpy(moved.GetData()) - scene.places


def econforge_interpolation(scene):
    """Compiled by Numba when it is first called. Its grid is that of the inner points."""
    from interpolation.splines import UCGrid
    from interpolation.splines.eval_splines import eval_cubic
    grid = UCGrid(*((1.0, points - 2.0, points - 2) for points in scene.points.shape[:3]))
    moved = numpy.empty(scene.places.shape)

    def evaluate():
        eval_cubic(grid, scene.points, scene.places, moved)
    return evaluate, lambda: moved


def interpn_bspline(scene, number, array):
    """A call for each component; its coefficients are the points as they are."""
    from interpn import MultiBsplineRegular, serialization
    wrap = getattr(serialization, array)
    splines = [MultiBsplineRegular(
        dims=list(scene.points.shape[:3]), starts=wrap(data=numpy.zeros(3, number)),
        steps=wrap(data=numpy.ones(3, number)), linearize_extrapolation=True,
        coeffs=wrap(data=scene.points[..., c].astype(number).ravel())) for c in range(3)]
    places = [scene.places[:, axis].astype(number) for axis in range(3)]
    moved = numpy.zeros((3, len(scene.places)), number)

    def evaluate():
        for spline, out in zip(splines, moved):
            spline.eval(places, out)
    return evaluate, lambda: moved.T


def interpn_binary32(scene):
    return interpn_bspline(scene, numpy.float32, "ArrayF32")


def interpn_binary64(scene):
    return interpn_bspline(scene, numpy.float64, "ArrayF64")


@dataclass(frozen=True)
class Peer:
    """A program: the package it is of, what of that is called, its numbers."""

    package: str
    called: str
    numbers: str
    prepare: object  # scene -> (what is timed, where its results are then)

    @property
    def what(self):
        try:
            return f"{self.package} {importlib.metadata.version(self.package)}, {self.called}"
        except importlib.metadata.PackageNotFoundError:
            raise PeerError(f"{self.package} is not in build/venv: "
                            "make compare installs it") from None


PEERS = (
    Peer("interpolation", "eval_cubic", "binary64", econforge_interpolation),
    Peer("interpn", "MultiBsplineRegular, float", "binary32", interpn_binary32),
    Peer("interpn", "MultiBsplineRegular, double", "binary64", interpn_binary64),
    Peer("vtk", "vtkBSplineTransform", "binary64", vtk_transform),
    Peer("scipy", "map_coordinates", "binary64", scipy_map_coordinates),
)


def latency_ns(peer, scene):
    """What a call takes that is given the first vertex by itself."""
    evaluate, _ = peer.prepare(dataclasses.replace(scene, places=scene.places[:1]))
    evaluate()
    runs = []
    for _ in range(FEWEST_RUNS):
        start = time.process_time()
        for _ in range(CALLS):
            evaluate()
        runs.append(time.process_time() - start)
    return 1e9 * min(runs) / CALLS


def best_seconds(evaluate):
    """Of the fastest of several runs behind one that is not counted; the processor's time, that of
    all threads."""
    evaluate()
    runs = []
    while len(runs) < FEWEST_RUNS or sum(runs) < ENOUGH:
        start = time.process_time()
        evaluate()
        runs.append(time.process_time() - start)
    return min(runs)


def row(peer, scene, is_sorted):
    """What a peer does with a scene. Raises PeerError where it evaluates something else."""
    what, count = peer.what, len(scene.places)
    if not count:
        raise PeerError(f"{what}: there is no vertex to evaluate")
    evaluate, results = peer.prepare(scene)
    seconds = best_seconds(evaluate)
    moved = results()
    if moved.shape != scene.exact.shape:
        raise PeerError(f"{what}: {moved.shape} results for {count} vertices")
    error = float(numpy.abs(moved - scene.exact).max())
    if not error <= BOUNDS[peer.numbers]:
        raise PeerError(f"{what}: error {error:.2e}, bound {BOUNDS[peer.numbers]:.0e}")
    number = 4 if peer.numbers == "binary32" else 8
    return {"what": what, "sorted": is_sorted, "vertices_per_s": count / seconds, "error": error,
            "latency_ns": latency_ns(peer, scene), "bytes_per_vertex": 6.0 * number}


def rows(scenes, show=lambda name: None, peers=PEERS):
    """A row for each peer and scene; scenes are (in any order, sorted)."""
    measured = []
    for peer in peers:
        for is_sorted, scene in enumerate(scenes):
            show(peer.what)
            measured.append(row(peer, scene, bool(is_sorted)))
    return measured
