"""Volumes resampled through a lattice, and displacement fields.

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

import collections
import dataclasses
import warnings
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, TypeVar, cast

import numpy as np
from numpy.typing import DTypeLike, NDArray

from hwffd import Lattice, UsageError, deform, threads
from hwffd.volumes.itk import from_itk, to_itk
from hwffd.volumes.regular import RegularVoxels
from hwffd.volumes.splines import Sampler
from hwffd.volumes.volume import Volume

if TYPE_CHECKING:
    import SimpleITK

Progress = Callable[[float], None]
Image = TypeVar("Image", Volume, "SimpleITK.Image")

_VOXELS_AT_ONCE = 1 << 18
_FEWEST_POINTS, _MOST_POINTS = 4, 64  # of a lattice, an axis


@dataclasses.dataclass
class Warped:
    """A volume that was resampled."""

    volume: Volume
    field: Volume | None      #: displacements, if they were asked for
    outside_lattice: int      #: voxels that the lattice does not hold
    outside_volume: int       #: voxels whose value would come from beyond the volume


def lattice_over(volume: Volume, dims: Sequence[int] = (4, 4, 4)) -> Lattice:
    """A lattice of uniform B-splines whose cells fill a volume to the outer faces of its voxels, with
    s, t and u along its i, j and k.

    dims: control points along i, j and k, 4 to 64 each."""
    counts = np.array(volume.counts)
    points = np.asarray(dims)
    if points.shape != (3,) or points.dtype.kind not in "iu" or not all(
            _FEWEST_POINTS <= n <= _MOST_POINTS for n in points):
        raise UsageError(f"dims {dims}; give three whole numbers, {_FEWEST_POINTS} to {_MOST_POINTS}")
    steps = counts / (np.array(dims) - 3)
    grid = np.stack(np.meshgrid(*map(np.arange, dims), indexing="ij"), -1)
    return Lattice.of(volume.points((grid - 1) * steps - 0.5))


def _blocks(counts: tuple[int, int, int]) -> Iterator[tuple[slice, slice]]:
    """The planes of a volume in turn, some at once, or some rows of one: slices of k and of j."""
    nx, ny, nz = counts
    planes = max(1, _VOXELS_AT_ONCE // (nx * ny))
    rows = ny if nx * ny <= _VOXELS_AT_ONCE else max(1, _VOXELS_AT_ONCE // nx)
    for k in range(0, nz, planes):
        for j in range(0, ny, rows):
            yield slice(k, min(nz, k + planes)), slice(j, min(ny, j + rows))


def _voxels(volume: Volume, block: tuple[slice, slice]) -> NDArray[np.float64]:
    """Where the voxels of a block lie, (planes, rows, nx, 3)."""
    k, j = (np.arange(part.start, part.stop) for part in block)
    grid = np.stack(np.meshgrid(k, j, np.arange(volume.counts[0]), indexing="ij"), -1)
    return volume.points(grid[..., ::-1].astype(np.float64))


def _deformed(lattice: Lattice, points: NDArray[np.float64]) -> tuple[NDArray[np.float64], int]:
    """Where the lattice takes points, and how many it does not hold, of which nobody is warned."""
    if points.size == 0:
        return points, 0
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", ".*points are outside the lattice.*", UserWarning)
        return deform(lattice, points), lattice.outside


def _walked(lattice: Lattice, voxels: RegularVoxels, block: tuple[slice, slice],
            points: NDArray[np.float64]) -> tuple[NDArray[np.float64], int]:
    """The same of a block of voxels as a grid, and one by one of those that are outside."""
    part, positions = voxels.moved((*block, slice(0, points.shape[2])))
    moved = np.empty_like(points)
    moved[part] = positions
    rest = np.ones(points.shape[:3], bool)
    rest[part] = False
    moved[rest], outside = _deformed(lattice, points[rest])
    return moved, outside


def _carried(lattice: Lattice, grid: Volume,
             progress: Progress | None) -> Iterator[tuple[tuple[slice, slice], NDArray, NDArray, int]]:
    """Of each block of a grid: its slices, its voxels, where the lattice takes them, and how many of
    them it does not hold."""
    voxels = None if lattice.device == "reference" else RegularVoxels.of(lattice, grid)
    finished = 0
    for block in _blocks(grid.counts):
        points = _voxels(grid, block)
        moved, outside = (_walked(lattice, voxels, block, points) if voxels
                          else _deformed(lattice, points))
        yield block, points, moved, outside
        finished += points.size // 3
        if progress:
            progress(finished / np.prod(grid.counts))


def _in_type(values: NDArray[np.generic], kind: np.dtype) -> NDArray[np.generic]:
    """Numbers as voxels of a type: integers are the nearest ones that it has."""
    if kind.kind == "f" or values.dtype == kind:
        return values.astype(kind)
    limits = np.iinfo(kind)
    result = np.empty(values.shape, kind)
    rounded = np.rint(values)
    below, above = rounded <= limits.min, rounded >= limits.max
    result[...] = np.where(below | above, 0, rounded)
    result[below], result[above] = limits.min, limits.max
    return result


def _sampled(samplers: list[Sampler], volume: Volume, moved: NDArray[np.float64], default: float,
             out: NDArray[np.generic]) -> int:
    """Writes what the volume has at moved points (..., 3) to out (..., c); how many are beyond it."""
    indices = volume.indices(moved)
    inside = ((indices >= -0.5) & (indices < np.array(volume.counts) - 0.5)).all(-1)
    at = indices[inside][:, ::-1]
    for component, sampler in enumerate(samplers):
        part = out[..., component]
        part[...] = _in_type(np.array(default, np.float64), out.dtype)
        part[inside] = _in_type(sampler.at(at), out.dtype)
    return inside.size - np.count_nonzero(inside)


def resample(volume: Volume, lattice: Lattice, *, like: Volume | None = None, order: int = 3,
             default: float = 0.0, with_field: bool = False,
             progress: Progress | None = None) -> Warped:
    """warp() with all that is known of it: the field, if wanted, and counts of voxels outside."""
    if not isinstance(default, (int, float, np.number)):
        raise UsageError(f"default {default!r}; give a number")
    try:
        default = float(default)
    except OverflowError as error:
        raise UsageError("default: beyond what a double holds; give a number that voxels can have") from error
    if volume.values.dtype.kind != "f" and not np.isfinite(default):
        raise UsageError(f"default {default}: no integer; give a number that voxels can have")
    grid = like or volume
    components = volume.values.reshape(*volume.values.shape[:3], -1)
    samplers = [Sampler(components[..., component], order) for component in range(components.shape[-1])]
    shape = grid.values.shape[:3]
    out = np.empty((*shape, len(samplers)), volume.values.dtype)
    field = np.empty((*shape, 3)) if with_field else None
    outside_lattice = outside_volume = 0
    with ThreadPoolExecutor(threads()) as pool:
        waiting = collections.deque()
        for block, points, moved, outside in _carried(lattice, grid, progress):
            outside_lattice += outside
            if field is not None:
                field[block] = moved - points
            waiting.append(pool.submit(_sampled, samplers, volume, moved, default, out[block]))
            if len(waiting) > threads():  # so that no more than these are kept
                outside_volume += waiting.popleft().result()
        outside_volume += sum(task.result() for task in waiting)
    where = grid.origin, grid.spacing, grid.direction
    warped = Volume(out.reshape(*shape, *volume.values.shape[3:]), *where, volume.metadata)
    return Warped(warped,
                  None if field is None else Volume(field, *where), outside_lattice, outside_volume)


def warp(image: Image, lattice: Lattice, *, like: Volume | SimpleITK.Image | None = None, order: int = 3,
         default: float = 0.0, progress: Progress | None = None) -> Image:
    """An image resampled through a lattice: voxel x of the result has the value of the image at T(x),
    where T is the deformation that takes the lattice at rest to what it is now.

    The lattice's device evaluates T. Voxels outside the lattice do what lattice.set_outside says.

    image: a Volume, or an image of SimpleITK with three dimensions; the result is the same.
    like: an image whose grid of voxels the result has; None: that of the image.
    order: 3, cubic B-splines through the voxels; 1, linear; 0, the nearest voxel, as for labels.
    default: the value where T(x) is more than half a voxel beyond the outermost voxels.
    progress: is called with the fraction done."""
    volume, back = _volume_of(image)
    grid = None if like is None else _volume_of(like)[0]
    return back(resample(volume, lattice, like=grid, order=order, default=default,
                         progress=progress).volume)


def _is_float(kind: DTypeLike) -> bool:
    try:
        return np.dtype(kind).kind == "f"
    except TypeError:
        return False


def displacement_field(grid: Image, lattice: Lattice, *, kind: DTypeLike = np.float64,
                       progress: Progress | None = None) -> Image:
    """T(x) - x for each voxel x of a grid, in its unit of length, as ITK's displacement fields have
    it: three components.

    grid: a Volume, or an image of SimpleITK, of which the values do not matter; so is the result.
    kind: of the numbers."""
    volume, back = _volume_of(grid)
    if not _is_float(kind):
        raise UsageError(f"kind {kind}: no floats, which displacements are; give float32 or float64")
    field = np.empty((*volume.values.shape[:3], 3), kind)
    for block, points, moved, _ in _carried(lattice, volume, progress):
        field[block] = moved - points
    return back(Volume(field, volume.origin, volume.spacing, volume.direction))


def determinants(grid: Image, lattice: Lattice) -> Image:
    """det J, by which T changes volumes, at each voxel of a grid, in binary32; 1 where the lattice does not reach. Below 0 the deformation folds.

    grid: a Volume, or an image of SimpleITK, of which the values do not matter; so is the result."""
    volume, back = _volume_of(grid)
    result = np.ones(volume.values.shape[:3], np.float32)
    for block in _blocks(volume.counts):
        result[block] = lattice.embed(_voxels(volume, block)).determinants(lattice)
    return back(Volume(result, volume.origin, volume.spacing, volume.direction))


def _volume_of(image: Image) -> tuple[Volume, Callable[[Volume], Image]]:
    """An image as a volume, and what makes an image of the same kind of a volume."""
    if isinstance(image, Volume):
        return image, lambda volume: cast("Image", volume)
    if hasattr(image, "GetDimension"):
        return from_itk(cast("SimpleITK.Image", image)), cast("Callable[[Volume], Image]", to_itk)
    raise UsageError(f"image: a {type(image).__name__}; give a Volume or an image of SimpleITK")
