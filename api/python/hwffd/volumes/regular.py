"""Voxels that are a regular grid in a lattice, for the grid packets of a core.

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hwffd import Lattice
from hwffd.volumes.volume import Volume

_CLOSE = 1e-9        # in cells, over a whole volume
_MOST_VERTICES = 65535  # of a grid, an axis


class RegularVoxels:
    """The voxels of a volume in a box of uniform B-splines whose axes are parallel to the volume's, in
    any order and direction: index n of axis `along[a]` lies at place start[a] + n * step[a] of axis a
    of the lattice, in cells from its first face on."""

    def __init__(self, lattice: Lattice, start: NDArray[np.float64], step: NDArray[np.float64],
                 along: list[int]) -> None:
        self._lattice = lattice
        self._start, self._step, self._along = start, step, along

    @classmethod
    def of(cls, lattice: Lattice, volume: Volume) -> RegularVoxels | None:
        """None, unless the lattice is such a box."""
        rest = lattice.rest_points
        last = np.array(lattice.dims) - 1
        if lattice.family != "bspline" or max(volume.counts) > _MOST_VERTICES:
            return None
        base = rest[0, 0, 0]
        ends = np.stack([rest[last[0], 0, 0], rest[0, last[1], 0], rest[0, 0, last[2]]], -1)
        edges = (ends - base[:, None]) / last
        grid = np.stack(np.meshgrid(*map(np.arange, lattice.dims), indexing="ij"), -1)
        to_cells = np.linalg.inv(edges)
        if np.abs((rest - base) @ to_cells.T - grid).max() > _CLOSE:
            return None
        steps = to_cells @ volume.steps
        along = np.abs(steps).argmax(1)
        others = np.abs(steps) * volume.counts
        others[range(3), along] = 0
        if len(set(along)) < 3 or others.max() > _CLOSE:
            return None
        return cls(lattice, to_cells @ (volume.origin - base) - 1, steps[range(3), along],
                   along.tolist())

    def moved(self, block: tuple[slice, slice, slice]
              ) -> tuple[tuple[slice, slice, slice], NDArray[np.float64]]:
        """Of a block of voxels, slices of k, j and i, the part that the lattice holds, as slices within
        the block, and where the deformed lattice has it, (k, j, i, 3)."""
        first, last, counts = [], [], []
        slices = [slice(0, 0)] * 3
        for axis, along in enumerate(self._along):
            of_axis = block[2 - along]
            places = self._start[axis] + self._step[axis] * np.arange(of_axis.start, of_axis.stop)
            (inside,) = np.nonzero((places >= 0) & (places <= self._lattice.cells[axis]))
            if inside.size == 0:
                return (slice(0, 0),) * 3, np.empty((0, 0, 0, 3))
            slices[2 - along] = slice(inside[0], inside[-1] + 1)
            first.append(places[inside[0]])
            last.append(places[inside[-1]])
            counts.append(inside.size)
        moved = self._lattice.evaluate_grid(first, last, counts)
        order = [2 - self._along.index(2 - axis) for axis in range(3)]
        return tuple(slices), moved.transpose(*order, 3)
