"""Values between voxels: cubic B-splines that go through them, straight lines, or the nearest one.

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

from types import ModuleType

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hwffd import Error, UsageError
from hwffd.volumes.missing import missing
from hwffd.volumes.volume import array_of

ORDERS = (0, 1, 3)
_MODES = {1: "nearest", 3: "mirror"}  # how values go on beyond the outermost voxels, as in ITK


def ndimage() -> ModuleType:
    """SciPy's module, which is wanted here only."""
    try:
        import scipy.ndimage  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        raise missing("scipy") from error
    return scipy.ndimage


def coefficients(values: ArrayLike) -> NDArray[np.float64]:
    """The coefficients (nz, ny, nx) of the tricubic B-spline that goes through such values: those of
    scipy.ndimage.spline_filter(values, 3, numpy.float64, "mirror")."""
    values = array_of(values, "values")
    if values.dtype.kind not in "iuf" or values.ndim != 3:
        raise UsageError(f"values: {values.ndim} dimensions of {values.dtype}; give three, of numbers")
    values = _of_scipy(values)
    wrong = values.size - np.count_nonzero(np.isfinite(values))
    if wrong:
        raise Error(f"{wrong} voxels are not finite, and a spline would spread them; fill them, or "
                    "take order 1")
    return ndimage().spline_filter(values, 3, np.float64, "mirror")


def _of_scipy(values: NDArray[np.generic]) -> NDArray[np.generic]:
    """Values in a type that SciPy interpolates, of which halves and long doubles are none."""
    known = values.dtype.kind != "f" or values.dtype.itemsize in (4, 8)
    return values if known else values.astype(np.float64)


class Sampler:
    """What an array (nz, ny, nx) has at places between its voxels."""

    def __init__(self, values: NDArray[np.generic], order: int) -> None:
        if order not in ORDERS:
            raise UsageError(f"order {order!r}; one of 0 (nearest), 1 (linear), 3 (cubic)")
        self._order = order
        self._values = coefficients(values) if order == 3 else _of_scipy(values) if order == 1 else values

    def at(self, indices: NDArray[np.float64]) -> NDArray[np.generic]:
        """At indices (n, 3) along z, y and x, less than half a voxel beyond the outermost ones."""
        if self._order == 0:
            last = np.array(self._values.shape) - 1
            nearest = np.clip(np.floor(indices + 0.5).astype(np.int64), 0, last)
            return self._values[tuple(nearest.T)]
        return ndimage().map_coordinates(self._values, indices.T, np.float64, self._order,
                                         _MODES[self._order], prefilter=False)
