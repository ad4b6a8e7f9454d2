"""A volume made by code, in which no axis can be taken for another, and the lattice and ITK's transform
of one deformation.

SPDX-License-Identifier: Apache-2.0
"""

import hwffd
import numpy as np
import SimpleITK as sitk
from hwffd import volumes

COUNTS = (41, 29, 19)  # along i, j and k
MESH = (5, 3, 2)       # cells of the lattice
ELLIPSOIDS = (((0.45, 0.5, 0.55), (0.4, 0.45, 0.42), 100), ((0.3, 0.6, 0.5), (0.12, 0.2, 0.3), 60),
              ((0.6, 0.35, 0.7), (0.2, 0.1, 0.15), -40), ((0.7, 0.7, 0.3), (0.05, 0.2, 0.1), 80))


def turned():
    """Directions of i, j and k: z, x and y, turned about two axes."""
    a, b = 0.4, -0.3
    about_z = [[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]]
    about_x = [[1, 0, 0], [0, np.cos(b), -np.sin(b)], [0, np.sin(b), np.cos(b)]]
    return np.array(about_z) @ about_x @ [[0, 1, 0], [0, 0, 1], [1, 0, 0]]


def phantom(kind=np.float32):
    """Ellipsoids with soft edges in voxels that are longer along j and k, somewhere in space."""
    k, j, i = np.meshgrid(*(np.linspace(0, 1, n) for n in COUNTS[::-1]), indexing="ij")
    values = np.full(k.shape, 7.0)
    for centre, radii, height in ELLIPSOIDS:
        distance = sum(((x - c) / r) ** 2 for x, c, r in zip((i, j, k), centre, radii))
        values += height * (1 - np.tanh(6 * (distance - 1))) / 2
    return volumes.Volume(values.astype(kind), (12, -34, 56), (0.7, 1.1, 2.3), turned())


def deformed(volume, first=(-0.5, -0.5, -0.5), counts=None, size=1.2):
    """A lattice over voxels `first` to first + counts, bent at random, and the same as ITK has it."""
    counts = np.array(counts or volume.counts)
    part = volumes.Volume(np.empty(counts[::-1], np.uint8),
                          volume.points(np.array(first) + 0.5), volume.spacing, volume.direction)
    lattice = volumes.lattice_over(part, [n + 3 for n in MESH])
    lattice.set_device("reference")
    moves = np.random.default_rng(3).normal(0, size, lattice.rest_points.shape) * [1, 2, 3]
    lattice.control_points = lattice.rest_points + moves
    transform = sitk.BSplineTransform(3, 3)
    transform.SetTransformDomainOrigin(volume.points(np.array(first)).tolist())
    transform.SetTransformDomainDirection(volume.direction.ravel().tolist())
    transform.SetTransformDomainPhysicalDimensions((counts * volume.spacing).tolist())
    transform.SetTransformDomainMeshSize(MESH)
    # Its parameters are x of all control points, then y, then z, the first index fastest.
    transform.SetParameters(np.concatenate([moves[..., axis].ravel("F") for axis in range(3)]).tolist())
    return lattice, transform


def itk_field(volume, transform):
    """ITK's displacements of the voxels of a volume, (nz, ny, nx, 3)."""
    image = sitk.TransformToDisplacementField(
        transform, sitk.sitkVectorFloat64, volume.counts, volume.origin.tolist(),
        volume.spacing.tolist(), volume.direction.ravel().tolist())
    return sitk.GetArrayFromImage(image)


def in_voxels(volume, differences):
    """How long vectors in space are, counted in voxels along each axis."""
    return np.abs(differences @ np.linalg.inv(volume.steps).T)


def around(volume):
    """A lattice of the library about the corners of a volume, along x, y and z."""
    ends = [(-0.5, n - 0.5) for n in volume.counts]
    corners = [[x, y, z] for x in ends[0] for y in ends[1] for z in ends[2]]
    return hwffd.Lattice.around("box", volume.points(np.array(corners)), (5, 4, 6))
