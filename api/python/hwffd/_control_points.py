"""Control points of a lattice as an array: a copy, which says how they are changed where it is written to.

SPDX-License-Identifier: Apache-2.0
"""

import numpy as np

from hwffd._core import UsageError


class ControlPoints(np.ndarray):
    """An array that is read-only; what is made of it may be written to."""

    def _check_writeable(self):
        if not self.flags.writeable:
            raise UsageError("control points: read-only, a copy of those of the lattice; change one of your own, "
                             "points = lattice.control_points.copy(), and set lattice.control_points = points")

    def __setitem__(self, place, value):
        self._check_writeable()
        super().__setitem__(place, value)

    def __array_ufunc__(self, function, method, *inputs, out=(), **named):
        for array in out:
            if isinstance(array, ControlPoints):
                array._check_writeable()
        inputs, out = (tuple(array.view(np.ndarray) if isinstance(array, ControlPoints) else array
                             for array in arrays) for arrays in (inputs, out))
        return getattr(function, method)(*inputs, **named, **({"out": out} if out else {}))

    def copy(self, order="C"):
        return np.array(self, order=order)
