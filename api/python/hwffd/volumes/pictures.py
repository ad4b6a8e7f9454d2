"""What a registration has done, as a picture and as a curve.

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hwffd import Lattice
from hwffd.volumes.itk import simple_itk
from hwffd.volumes.volume import Volume
from hwffd.volumes.warping import displacement_field, resample

_SIDE = 320      # pixels of a panel's longer side
_GAP = 8         # white, between panels
_SQUARES = 8     # of the checkerboard, along the longer side
_LINES = 16      # of the grid, along the longer side


def _slice_of(volume: Volume) -> Volume:
    """Where the pixels of a panel lie: in the slice in the middle, along k, which they fill."""
    lengths = volume.spacing[:2] * volume.counts[:2]
    counts = np.maximum(1, np.rint(_SIDE * lengths / lengths.max())).astype(int)
    steps = np.array(volume.counts[:2]) / counts  # in voxels
    first = volume.points(np.array([*(0.5 * steps - 0.5), volume.counts[2] // 2]))
    spacing = volume.spacing * [*steps, 1.0]
    return Volume(np.zeros((1, counts[1], counts[0]), np.float32), first, spacing, volume.direction)


def _gray(values: NDArray[np.floating], low: float, high: float) -> NDArray[np.uint8]:
    return np.clip(255 * (values - low) / max(high - low, 1e-30), 0, 255).astype(np.uint8)


def _grid_lines(place: Volume, lattice: Lattice) -> NDArray[np.uint8]:
    """The fixed volume's own grid as T sees it: a pixel is bright where T(x) lies on a line."""
    pixels = np.stack(np.meshgrid(0, *map(np.arange, place.values.shape[1:]), indexing="ij"), -1)
    moved = place.points(pixels[..., ::-1].astype(np.float64)) + displacement_field(place, lattice).values
    at = place.indices(moved)[0, ..., :2]
    step = _SIDE / _LINES
    off = np.abs((at / step + 0.5) % 1 - 0.5) * step
    return np.clip(255 * (1.5 - off.min(-1)), 30, 255).astype(np.uint8)


def panels(fixed: Volume, moving: Volume, lattice: Lattice) -> NDArray[np.uint8]:
    """Side by side, of the slice in the middle: the fixed volume, the moving one before and after, a
    checkerboard of fixed and after, and a grid as the deformation bends it."""
    place = _slice_of(fixed)
    rest = Lattice.of(lattice.rest_points)
    shown = []
    for volume, by in (fixed, rest), (moving, rest), (moving, lattice):
        low, high = (np.percentile(volume.values, part) for part in (0.5, 99.5))
        real = Volume(volume.values.astype(np.float32), volume.origin, volume.spacing, volume.direction)
        shown.append(_gray(resample(real, by, like=place, order=1).volume.values[0], low, high))
    j, i = np.indices(shown[0].shape)
    side = max(1, _SIDE // _SQUARES)
    shown.append(np.where((i // side + j // side) % 2 == 0, shown[0], shown[2]))
    shown.append(_grid_lines(place, lattice))
    gap = np.full((shown[0].shape[0], _GAP), 255, np.uint8)
    return np.hstack([part for panel in shown for part in (panel, gap)][:-1])


def write_picture(path: os.PathLike[str] | str, fixed: Volume, moving: Volume, lattice: Lattice) -> None:
    """Writes panels() to a new file, .png."""
    itk = simple_itk()
    itk.WriteImage(itk.GetImageFromArray(panels(fixed, moving, lattice)), os.fspath(path))


def write_curve(path: os.PathLike[str] | str, history: Sequence[dict[str, Any]]) -> None:
    """Writes the history of a registration to a new file, .csv, a line an iteration."""
    names = list(history[0])
    with open(path, "w", encoding="utf-8") as file:
        print(*names, sep=",", file=file)
        for step in history:
            print(*(step[name] for name in names), sep=",", file=file)
