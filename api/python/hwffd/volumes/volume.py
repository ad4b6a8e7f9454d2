"""A grid of voxels and where it lies in space.

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hwffd import UsageError

_FARTHEST = 1e100  # coordinates of a lattice, beyond which the library has none


def array_of(given: ArrayLike, name: str) -> NDArray[np.generic]:
    """An array, without a copy where it is one. A masked one is refused, and a list of such: masks would be lost."""
    parts = given if isinstance(given, (list, tuple)) else (given,)
    if any(isinstance(part, np.ma.MaskedArray) for part in parts):
        raise UsageError(f"{name}: a masked array; give one without a mask, as filled(value) makes it")
    try:
        return np.asarray(given)
    except (TypeError, ValueError) as error:
        raise UsageError(f"{name}: no array; give one of NumPy") from error


def _numbers(name: str, given: ArrayLike, shape: tuple[int, ...]) -> NDArray[np.float64]:
    try:
        array = np.array(given, np.float64)
    except (TypeError, ValueError):
        array = np.empty(0)
    if array.shape != shape or not (np.abs(array) < _FARTHEST).all():
        text = str(given).replace("\n", "")
        raise UsageError(f"volume: {name} {text:.80}; give finite numbers of shape {shape}")
    return array


@dataclasses.dataclass(init=False)
class Volume:
    """Voxels with ITK's geometry: that of index (i, j, k) lies at

        origin + direction @ (spacing * (i, j, k)),

    in millimetres along left, posterior and superior where a file says no more.

    values: (nz, ny, nx), or (nz, ny, nx, c) of c components; voxel (i, j, k) is values[k, j, i].
    origin, spacing: x, y, z. direction: (3, 3), whose columns are the directions of i, j and k.
    metadata: what a file says besides, by the names that ITK gives it; write() carries it on.
    """

    values: NDArray[np.generic]
    origin: NDArray[np.float64]
    spacing: NDArray[np.float64]
    direction: NDArray[np.float64]
    metadata: dict[str, str]

    def __init__(self, values: ArrayLike, origin: ArrayLike = (0.0, 0.0, 0.0),
                 spacing: ArrayLike = (1.0, 1.0, 1.0),
                 direction: ArrayLike = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)),
                 metadata: Mapping[str, str] | None = None) -> None:
        self.values = array_of(values, "volume")
        if self.values.dtype.kind not in "iuf" or self.values.ndim not in (3, 4):
            raise UsageError(f"volume: {self.values.ndim} dimensions of {self.values.dtype}; give "
                             "numbers, (nz, ny, nx) or (nz, ny, nx, components)")
        if self.values.size == 0:
            raise UsageError(f"volume: shape {self.values.shape}; give one with voxels")
        self.origin = _numbers("origin", origin, (3,))
        self.spacing = _numbers("spacing", spacing, (3,))
        self.direction = _numbers("direction", direction, (3, 3))
        try:
            self.metadata = dict(metadata or {})
        except (TypeError, ValueError) as error:
            raise UsageError(f"volume: metadata {metadata!r:.80}; give names and values as texts") from error
        if not all(isinstance(text, str) for pair in self.metadata.items() for text in pair):
            raise UsageError("volume: metadata with what is no text; give names and values as texts")
        if not (self.spacing > 0).all():
            raise UsageError(f"volume: spacing {self.spacing.tolist()}; give numbers above 0")
        if abs(np.linalg.det(self.direction)) < 1e-6:
            raise UsageError("volume: direction spans no space; give three directions apart")

    @property
    def counts(self) -> tuple[int, int, int]:
        """Voxels along i, j and k."""
        nz, ny, nx = self.values.shape[:3]
        return nx, ny, nz

    @property
    def steps(self) -> NDArray[np.float64]:
        """(3, 3): column a leads from a voxel to the next along axis a."""
        return self.direction * self.spacing

    def points(self, indices: NDArray[np.float64]) -> NDArray[np.float64]:
        """Where indices (..., 3), which may be fractions, lie in space."""
        return self.origin + indices @ self.steps.T

    def indices(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """The indices (..., 3), with their fractions, of points in space."""
        return (points - self.origin) @ np.linalg.inv(self.steps).T
