"""Points in chunks: hwffd.deform of an array of Dask, chunk by chunk where Dask runs it (docs/cluster.md).

SPDX-License-Identifier: Apache-2.0
"""

import copy
import sys

import dask
import dask.array
import hwffd
import numpy as np


def deform(lattice, points, out):
    """What hwffd.deform gives of points of Dask: an array of Dask, by the lattice as it is now."""
    if not isinstance(points, dask.array.Array):
        raise hwffd.UsageError("points: of Dask, but no array; give a dask.array.Array")
    if out is not None:
        raise hwffd.UsageError("out: points are of Dask; store the result with dask.array.store")
    if points.shape[-1:] != (3,):
        raise hwffd.UsageError(f"points: shape {points.shape}; give (..., 3), x, y and z last")
    nothing = hwffd.deform(lattice, np.empty((0,) * (points.ndim - 1) + (3,), points.dtype))
    # A task of its own, so that a worker gets the lattice once, and not with each chunk.
    shared = dask.delayed(copy.copy(lattice), traverse=False)
    return dask.array.map_blocks(_deform_chunk, points.rechunk({-1: 3}), lattice=shared, dtype=nothing.dtype,
                                 meta=nothing, name=f"hwffd-deform-{dask.base.tokenize(lattice, points)}")


def _deform_chunk(chunk, lattice):
    _take_threads()
    return hwffd.deform(lattice, chunk)


def _take_threads():
    """As many threads as the worker has that runs this, if one does: it may share its machine."""
    distributed = sys.modules.get("distributed")
    try:
        worker = distributed.get_worker() if distributed else None
    except ValueError:
        worker = None
    if worker is not None:
        hwffd.set_threads(worker.state.nthreads)
