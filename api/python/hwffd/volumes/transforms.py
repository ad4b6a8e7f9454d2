"""Transforms of ITK: what a lattice is as one, and affine maps in files.

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

import os
import pathlib
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hwffd import Error, Lattice, UsageError
from hwffd.volumes.itk import simple_itk
from hwffd.volumes.links import plain_link

if TYPE_CHECKING:
    import SimpleITK

#: Of files that write_transform() writes.
SUFFIXES = (".tfm", ".h5")


def to_itk_transform(lattice: Lattice) -> SimpleITK.BSplineTransform:
    """A lattice of B-splines whose cells at rest fill a box, as ITK's transform with the same map there;
    elsewhere that leaves points where they are."""
    rest = lattice.rest_points
    cells = np.array(lattice.cells)
    corner = rest[0, 0, 0]
    steps = np.stack([rest[1, 0, 0] - corner, rest[0, 1, 0] - corner, rest[0, 0, 1] - corner], -1)
    grid = np.stack(np.meshgrid(*map(np.arange, lattice.dims), indexing="ij"), -1)
    lengths = np.linalg.norm(steps, axis=0)
    even = corner + grid @ steps.T
    if lattice.family != "bspline" or np.abs(even - rest).max() > 1e-9 * np.abs(rest - corner).max():
        raise UsageError("lattice: no box of uniform B-splines at rest, as ITK has it; write a field")
    transform = simple_itk().BSplineTransform(3, 3)
    transform.SetTransformDomainOrigin((corner + steps @ np.ones(3)).tolist())
    transform.SetTransformDomainDirection((steps / lengths).ravel().tolist())
    transform.SetTransformDomainPhysicalDimensions((lengths * cells).tolist())
    transform.SetTransformDomainMeshSize(cells.tolist())
    # x of all control points, then y, then z, the first index fastest.
    moves = lattice.control_points - rest
    transform.SetParameters(np.concatenate([np.ravel(moves[..., axis], "F") for axis in range(3)]).tolist())
    return transform


def write_transform(path: os.PathLike[str] | str, lattice: Lattice) -> None:
    """Writes to_itk_transform() to a new file, .tfm or .h5."""
    transform = to_itk_transform(lattice)
    try:
        simple_itk().WriteTransform(transform, os.fspath(path))
    except RuntimeError as error:
        raise Error(f"{path}: cannot be written; give a name that ends with {' or '.join(SUFFIXES)}, in a "
                    "folder that is there and writable") from error


def read_affine(path: os.PathLike[str] | str) -> NDArray[np.float64]:
    """The affine transform in a file that ITK reads, as a matrix (4, 4)."""
    if not pathlib.Path(path).is_file():
        raise Error(f"{path}: is not there; name a file with an affine transform")
    with plain_link(path, f"transform{pathlib.PurePath(path).suffix}") as link:
        try:
            transform = simple_itk().ReadTransform(link)
        except RuntimeError as error:
            raise Error(f"{path}: no transform that ITK reads; write one by SimpleITK.WriteTransform") from error
    if pathlib.Path(path).read_bytes().count(b"\nTransform:") > 1:
        raise Error(f"{path}: several transforms; give one, such as their product")
    if transform.GetDimension() != 3 or not transform.IsLinear():
        raise Error(f"{path}: {transform.GetName()} of {transform.GetDimension()} dimensions; "
                    "give an affine one of three")
    zero = np.array(transform.TransformPoint((0.0, 0.0, 0.0)))
    matrix = np.eye(4)
    matrix[:3, :3] = np.stack([np.array(transform.TransformPoint(axis)) - zero
                               for axis in np.eye(3).tolist()], -1)
    matrix[:3, 3] = zero
    return matrix
