"""What is measured: from an array of points to the array of where they go, the whole way. Each
library is given points and control points as they are and has to find its own coordinates.

SPDX-License-Identifier: Apache-2.0
"""

import importlib.metadata
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy

from lab.compare.arrays.scene import DIMS, Scene

POINTS_OF_A_CALL = 1 << 18


def _hwffd(scene, threads, reuse, *device):
    import hwffd
    hwffd.set_threads(threads)
    lattice = hwffd.Lattice.of(scene.rest)
    lattice.set_device(*device)
    lattice.control_points = scene.moved
    if reuse:
        embedding = lattice.embed(scene.points)
        return lambda: embedding.deform(lattice)
    return lambda: hwffd.deform(lattice, scene.points)


def hwffd_reference(scene, threads):
    return _hwffd(scene, threads, False, "reference")


def hwffd_kept(scene, threads):
    return _hwffd(scene, threads, True, "reference")


def hwffd_model(scene, threads):
    return _hwffd(scene, threads, False, "model", "factored", "fx18")


def _in_parts(scene, threads, evaluate):
    """evaluate(points, where results go) part by part, on so many threads."""
    def deform():
        moved = numpy.empty_like(scene.points)
        slices = [slice(first, first + POINTS_OF_A_CALL)
                  for first in range(0, len(scene.points), POINTS_OF_A_CALL)]
        with ThreadPoolExecutor(threads) as pool:
            list(pool.map(lambda part: evaluate(scene.points[part], moved[part]), slices))
        return moved
    return deform


def scipy(scene, threads):
    """A call for each component, of all points' coordinates among the control points."""
    from scipy.ndimage import map_coordinates
    components = [numpy.ascontiguousarray(scene.moved[..., c]) for c in range(3)]

    def evaluate(points, moved):
        places = numpy.ascontiguousarray(Scene.places(points).T)
        for c, component in enumerate(components):
            moved[:, c] = map_coordinates(component, places, order=3, prefilter=False)
    return _in_parts(scene, threads, evaluate)


def interpolation(scene, threads):
    """Its grid is that of the inner control points."""
    from interpolation.splines import UCGrid
    from interpolation.splines.eval_splines import eval_cubic
    grid = UCGrid(*((0.0, 1.0, n - 2) for n in DIMS))
    return _in_parts(scene, threads,
                     lambda points, moved: eval_cubic(grid, scene.moved, points, moved))


def vtk(scene, threads):
    """It adds the sum of displacements to a point; arrays of VTK have x fastest."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkPoints, vtkSMPTools
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkFiltersHybrid import vtkBSplineTransform
    vtkSMPTools.Initialize(threads)
    image = vtkImageData()
    image.SetDimensions(*DIMS)
    image.SetOrigin(*scene.rest[0, 0, 0])
    image.SetSpacing(*(1 / (n - 3) for n in DIMS))
    displaced = numpy.ascontiguousarray((scene.moved - scene.rest).transpose(2, 1, 0, 3))
    image.GetPointData().SetScalars(numpy_to_vtk(displaced.reshape(-1, 3), deep=True))
    transform = vtkBSplineTransform()
    transform.SetCoefficientData(image)
    transform.Update()

    def deform():
        places, moved = vtkPoints(), vtkPoints()
        for points in (places, moved):
            points.SetDataTypeToDouble()
        places.SetData(numpy_to_vtk(scene.points, deep=False))
        transform.TransformPoints(places, moved)
        return vtk_to_numpy(moved.GetData())
    return deform


@dataclass(frozen=True)
class Library:
    """A library, the way it is called, and how exact it has to be."""

    name: str  # of its package, too
    call: str
    prepare: object  # (scene, threads) -> what is timed, which returns the moved points
    bound: float

    @property
    def version(self):
        if self.name == "hwffd":  # of the build, where it is no package that was installed
            import hwffd
            return hwffd.__version__
        return importlib.metadata.version(self.name)


LIBRARIES = (
    Library("hwffd", "device reference", hwffd_reference, 1e-12),
    Library("hwffd", "device reference, embedding kept", hwffd_kept, 1e-12),
    Library("hwffd", "device model, factored, fx18", hwffd_model, 5e-4),
    Library("scipy", "map_coordinates", scipy, 1e-12),
    Library("interpolation", "eval_cubic", interpolation, 1e-12),
    Library("vtk", "vtkBSplineTransform", vtk, 1e-12),
)
