"""Two volumes aligned: the lattice that takes one to the other (docs/register.md).

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

import dataclasses
import operator
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hwffd import Lattice, UsageError, _core
from hwffd.volumes.itk import from_itk
from hwffd.volumes.volume import Volume, array_of

if TYPE_CHECKING:
    import SimpleITK

    Image = Volume | SimpleITK.Image | NDArray[np.generic]
    Progress = Callable[[dict[str, Any]], bool | None]

METRICS = tuple(_core.metrics())
UNITS = ("voxels", "length")
_MOST = 1_000_000_000  # of a whole number
_SPACING = 16          # voxels, unless told otherwise


@dataclasses.dataclass
class Registration:
    """What register() gives."""

    lattice: Lattice             #: takes points of the fixed volume to those of the moving one
    history: list[dict[str, Any]]  #: of each iteration its level, metric, penalties and evaluations
    metric_start: float          #: of the finest level
    metric_end: float
    jacobian: tuple[float, float]  #: least and largest det J at eight places of each half cell
    folds: str                   #: "proved" not to fold, or where it does
    evaluations: int             #: of the metric
    voxels: int                  #: walked for these, in all levels
    seconds: float               #: that they took
    overlap: float               #: part of the fixed volume's voxels that counted at the end
    stopped: bool                #: by what was given as progress
    warnings: list[str]


def volume_of(image: Image, name: str = "image") -> Volume:
    """A Volume of one component: itself, of an image of SimpleITK, or of an array (nz, ny, nx)."""
    if hasattr(image, "GetDimension"):
        image = from_itk(image)
    if not isinstance(image, Volume):
        array = array_of(image, name)
        image = Volume(array.view(np.uint8) if array.dtype == bool else array)
    volume = image
    if volume.values.ndim == 4 and volume.values.shape[3] == 1:
        volume = dataclasses.replace(volume, values=volume.values[..., 0])
    if volume.values.ndim != 3:
        raise UsageError(f"{name}: {volume.values.shape[3]} components; give one, such as their mean")
    return volume


def _matrix(volume: Volume) -> NDArray[np.float64]:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = volume.steps, volume.origin
    return matrix


def _mask(mask: Image | None, volume: Volume, name: str) -> NDArray[np.uint8] | None:
    if mask is None:
        return None
    given = volume_of(mask, name)
    values = given.values
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]) * np.array(volume.counts)
    off = np.abs(volume.indices(given.points(corners)) - corners).max()
    if not isinstance(mask, np.ndarray) and values.shape == volume.values.shape and off > 0.01:
        raise UsageError(f"{name}: its voxels lie elsewhere than the volume's; resample it to that grid")
    if values.shape != volume.values.shape:
        raise UsageError(f"{name}: {values.shape} voxels; give {volume.values.shape}, as the volume has")
    if np.isnan(values).any():
        raise UsageError(f"{name}: {np.count_nonzero(np.isnan(values))} voxels are NaN; give 0 where voxels are to "
                         "count for nothing")
    return np.ascontiguousarray(values != 0, np.uint8)


def _values(volume: Volume) -> NDArray[np.float32]:
    with np.errstate(over="ignore"):  # what is beyond binary32 is refused as infinite
        return np.ascontiguousarray(volume.values, np.float32)


def _whole(name: str, number: int) -> int:
    try:
        whole = operator.index(number)
    except TypeError as error:
        raise UsageError(f"{name}: {number!r}; give a whole number") from error
    if abs(whole) > _MOST:
        raise UsageError(f"{name}: {whole}; give a number up to {_MOST}")
    return whole


def _number(name: str, number: float) -> float:
    try:
        return float(number)
    except (TypeError, ValueError) as error:
        raise UsageError(f"{name}: {number!r}; give a number") from error


def _spacing(spacing: float | Sequence[float] | None, unit: str, volume: Volume) -> list[float]:
    if spacing is None:
        voxels = np.minimum(_SPACING, volume.counts)
        return (voxels * (1 if unit == "voxels" else volume.spacing)).tolist()
    try:
        numbers = np.array(np.broadcast_to(np.asarray(spacing, np.float64), 3))
    except (TypeError, ValueError) as error:
        raise UsageError(f"spacing: {spacing!r}; give a number, or one for each axis") from error
    return numbers.tolist()


def register(fixed: Image, moving: Image, *, spacing: float | Sequence[float] | None = None,
             unit: str = "voxels", levels: int = 0, smooth: bool = True, metric: str = "mean-squares", bins: int = 32,
             penalty: float = 0.0, no_folds: bool = False, mask: Image | None = None,
             moving_mask: Image | None = None, start: ArrayLike | Lattice | None = None,
             iterations: int = 50, tolerance: float = 1e-4, device: str = "reference", org: str = "",
             format: str = "",  # noqa: A002  # as Lattice.set_device has it
             progress: Progress | None = None) -> Registration:
    """Finds the lattice of B-splines over a fixed volume that takes each of its points to the point of a
    moving one with the same content. warp(moving, result.lattice, like=fixed) is then the moving volume
    as the fixed one has it.

    fixed, moving: volumes, images of SimpleITK or arrays (nz, ny, nx), of one component; with any
      directions and spacings. An image of two dimensions is given as one slice. Voxels become binary32.
    spacing: of control points along i, j and k of the finest level, in voxels of the fixed volume, or with
      unit="length" in its unit of length; None: 16 voxels, or as many as there are. It is rounded so that
      cells fill the volume, and can be halved with it.
    levels: of the image pyramid; 0: as many as the volume can have, up to 3.
    smooth: whether the volumes of the finest level are smoothed by (1 2 1)/4 along each axis, as those of the
      others are more, so that noise draws nothing.
    metric: mean-squares, correlation or mutual-information, this of so many bins a side.
    penalty: the weight of the bending energy, in units of length squared.
    no_folds: det J keeps its sign everywhere, which is proved.
    mask, moving_mask: volumes whose voxels that are not 0 count; others do not.
    start: an affine map, 4 x 4, from points of the fixed volume to those of the moving one, or a lattice
      of an earlier registration.
    iterations: most for each level. tolerance: of the decrease in 5 iterations, which ends a level.
    device: reference, model or rtl, with org and format as Lattice.set_device has them, or walk in fx17;
      model and rtl give the same bits.
    progress: is called after each evaluation with a dictionary, its level, iteration, metric, voxels,
      seconds and more; False ends the registration, which returns the best lattice so far.

    The result is the same, bit for bit, for any number of threads."""
    if progress is not None and not callable(progress):
        raise UsageError(f"progress: a {type(progress).__name__}; give a function")
    if unit not in UNITS:
        raise UsageError(f"unit: '{unit}'; give {' or '.join(UNITS)}")
    fixed, moving = volume_of(fixed, "fixed"), volume_of(moving, "moving")
    lattice = start if isinstance(start, Lattice) else None
    affine = None
    if start is not None and lattice is None:
        try:
            affine = np.asarray(start, np.float64)
        except (TypeError, ValueError) as error:
            raise UsageError("start: no numbers; give a matrix (4, 4), or a lattice") from error
        if affine.shape != (4, 4):
            raise UsageError(f"start: shape {affine.shape}; give a matrix (4, 4), or a lattice")
    if device != "reference" and not org:
        org, format = "walk", format or "fx17"
    for name, value in ("metric", metric), ("device", device), ("org", org), ("format", format):
        if not isinstance(value, str):
            raise UsageError(f"{name}: a {type(value).__name__}; give a text")
    return Registration(**_core.register_arrays(
        _values(fixed), _matrix(fixed), _mask(mask, fixed, "mask"), _values(moving), _matrix(moving),
        _mask(moving_mask, moving, "moving_mask"), _spacing(spacing, unit, fixed), unit == "voxels",
        _whole("levels", levels), bool(smooth), metric, _whole("bins", bins), _number("penalty", penalty), bool(no_folds), affine,
        lattice, _whole("iterations", iterations), _number("tolerance", tolerance), device, org or "basic", format,
        progress))
