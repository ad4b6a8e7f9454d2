"""Pairs of volumes that differ by a known deformation.

A pair has voxels of size 1 at (i, j, k), so that a length is one in voxels. The truth takes each voxel x of the fixed
volume to the point x + u(x) of the moving one. The moving volume is a function of space, and the fixed one is that
function at x + u(x): nothing was interpolated twice, and u is exact at every voxel.

SPDX-License-Identifier: Apache-2.0
"""

import dataclasses
import pathlib

import numpy

from lab.compare.arrays.scene import weights

# Of the phantom: centre and radii in parts of its side, and by how much it is brighter inside. The first is the body.
ELLIPSOIDS = (
    ((0.50, 0.50, 0.50), (0.42, 0.44, 0.40), 100.0),
    ((0.36, 0.45, 0.52), (0.12, 0.20, 0.16), -60.0),
    ((0.66, 0.46, 0.48), (0.11, 0.17, 0.21), 70.0),
    ((0.50, 0.72, 0.42), (0.18, 0.09, 0.11), 50.0),
    ((0.52, 0.28, 0.60), (0.14, 0.08, 0.10), -45.0),
    ((0.48, 0.52, 0.26), (0.10, 0.12, 0.06), 80.0),
    ((0.45, 0.62, 0.72), (0.16, 0.10, 0.07), 60.0),
)
EDGE = 6.0            # how steep edges are: a soft edge is some five voxels wide
TEXTURE, WAVES = 0.2, (5.0, 4.0, 6.0)  # of the body: how much brighter and darker it gets, and waves along x, y and z
MEAN = 1.25           # voxels: the mean length of u in the body, of each pair
SPACING = 0.22        # of the truth's control points, in parts of the volume: no fit has it
NOISE = 5.0           # the standard deviation of noise; a phantom's values go from 0 to some 180
SCAN, SCAN_VOXEL = "anatomical.nii", 0.5  # a file of nibabel's test data, and its new voxel in parts of the old
SCAN_COUNTS = (64, 80, 48)
BODY = 0.25           # of a scan: what is brighter than this part of its 99th percentile


@dataclasses.dataclass
class Pair:
    """Two volumes and how they differ. Arrays are (nz, ny, nx), with x, y, z as the last axis of vectors."""

    name: str
    fixed: numpy.ndarray
    moving: numpy.ndarray
    truth: numpy.ndarray          # u at the voxels of the fixed volume
    body: numpy.ndarray           # voxels of the fixed volume where errors count
    labels: tuple | None = None   # of the fixed and the moving volume, 0 outside


def spread(control, counts):
    """The B-spline of control points (cx, cy, cz, 3), whose cells fill the volume, at its voxels."""
    field = control
    for axis, n in enumerate(counts):
        cells = control.shape[axis] - 3
        place = (numpy.arange(n) + 0.5) / n * cells
        cell = numpy.minimum(place.astype(int), cells - 1)
        matrix = numpy.zeros((n, cells + 3))
        for at in range(4):
            matrix[numpy.arange(n), cell + at] = weights(place - cell)[:, at]
        field = numpy.moveaxis(numpy.tensordot(matrix, field, (1, axis)), 0, axis)
    return field.transpose(2, 1, 0, 3)


def random_truth(counts, body, seed):
    """A smooth displacement whose mean length in the body is MEAN. It moves nothing by more than a few voxels."""
    cells = [max(1, round(1 / SPACING))] * 3
    random = numpy.random.default_rng(seed)
    field = spread(random.normal(size=[c + 3 for c in cells] + [3]), counts)
    return field * (MEAN / numpy.linalg.norm(field[body], axis=-1).mean())


def voxels(counts):
    """Places of all voxels, (nz, ny, nx, 3)."""
    return numpy.stack(numpy.meshgrid(*(numpy.arange(n, dtype=float) for n in counts), indexing="ij"),
                       -1).transpose(2, 1, 0, 3)


def _distances(places, counts):
    """For each ellipsoid 1 at its surface, less inside."""
    inside = (places + 0.5) / numpy.array(counts)
    return [(((inside - centre) / radii) ** 2).sum(-1) for centre, radii, _ in ELLIPSOIDS]


def phantom(places, counts):
    """(values, labels) of the phantom at places: ellipsoids with soft edges; a label is the innermost's number."""
    values, labels = numpy.zeros(places.shape[:-1]), numpy.zeros(places.shape[:-1], numpy.uint8)
    for number, (distance, (_, _, height)) in enumerate(zip(_distances(places, counts), ELLIPSOIDS), 1):
        values += height * (1 - numpy.tanh(EDGE * (distance - 1))) / 2
        labels[distance < 1] = number
    phases = 2 * numpy.pi * (places + 0.5) / numpy.array(counts) * WAVES
    return values * (1 + TEXTURE * numpy.cos(phases).prod(-1)), labels


def _noisy(values, sigma, seed):
    random = numpy.random.default_rng(seed)
    return (values + random.normal(0, sigma, values.shape)).astype(numpy.float32)


def phantom_pair(side, noise=0.0, seed=1):
    """A phantom of side^3 voxels, and itself deformed; with noise, of another draw in each."""
    counts = (side,) * 3
    places = voxels(counts)
    body = phantom(places, counts)[1] > 0
    truth = random_truth(counts, body, seed)
    (fixed, fixed_labels), (moving, moving_labels) = phantom(places + truth, counts), phantom(places, counts)
    return Pair(f"phantom {side}^3" + (", noise" if noise else ""), _noisy(fixed, noise, 2 * seed),
                _noisy(moving, noise, 2 * seed + 1), truth, fixed_labels > 0, (fixed_labels, moving_labels))


def scan():
    """A function that gives the values of a real scan at places of finer voxels, by cubic B-splines."""
    import nibabel
    from scipy.ndimage import map_coordinates, spline_filter
    loaded = nibabel.load(pathlib.Path(nibabel.__file__).parent / "tests" / "data" / SCAN)
    values = numpy.asarray(loaded.get_fdata())
    values *= 180 / numpy.percentile(values, 99)
    coefficients = spline_filter(values, order=3, mode="nearest")
    first = (numpy.array(values.shape) - 1 - (numpy.array(SCAN_COUNTS) - 1) * SCAN_VOXEL) / 2

    def at(places):
        old = numpy.moveaxis(places * SCAN_VOXEL + first, -1, 0)
        return map_coordinates(coefficients, old, order=3, mode="nearest", prefilter=False)
    return at


def scan_pair(noise=NOISE, seed=5):
    """A real scan, and itself deformed by a known deformation, with another noise."""
    at, places = scan(), voxels(SCAN_COUNTS)
    moving = at(places)
    body = moving > BODY * numpy.percentile(moving, 99)
    truth = random_truth(SCAN_COUNTS, body, seed)
    fixed = at(places + truth)
    return Pair("scan", _noisy(fixed, noise, 2 * seed), _noisy(moving, noise, 2 * seed + 1), truth,
                fixed > BODY * numpy.percentile(fixed, 99))
