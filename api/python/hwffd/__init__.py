"""Free-form deformation on the bit-true model of a hardware evaluator, on the simulated hardware or in
double precision (docs/python.md).

    lattice = hwffd.Lattice.around("sphere", points)
    lattice.deform("twist:90")
    moved = hwffd.deform(lattice, points)

SPDX-License-Identifier: Apache-2.0
"""

from hwffd import _rtl  # noqa: F401  pylint: disable=unused-import
from hwffd._core import (Embedding, Error, Lattice, UsageError, __version__, deform, devices,
                         families, set_threads, shapes, threads)

__all__ = ["Embedding", "Error", "Lattice", "UsageError", "__version__", "deform", "devices",
           "families", "set_threads", "shapes", "threads"]

for _public in (Embedding, Error, Lattice, UsageError, deform, devices, families, set_threads,
                shapes, threads):
    _public.__module__ = __name__
del _public
