"""Free-form deformation on the bit-true model of a hardware evaluator, on the simulated hardware or in
double precision (docs/python.md).

    lattice = hwffd.Lattice.around("sphere", points)
    lattice.deform("twist:90")
    moved = hwffd.deform(lattice, points)

SPDX-License-Identifier: Apache-2.0
"""

from hwffd import _main_interpreter  # noqa: F401  pylint: disable=unused-import  # before the others
from hwffd import _copies, _core, _refusals, _rtl  # noqa: F401  pylint: disable=unused-import
from hwffd._core import Embedding, Error, Lattice, UsageError, __version__

deform, devices, families, fit, set_threads, shapes, threads = map(
    _refusals.refusing, (_core.deform, _core.devices, _core.families, _core.fit, _core.set_threads,
                         _core.shapes, _core.threads))

__all__ = ["Embedding", "Error", "Lattice", "UsageError", "__version__", "deform", "devices",
           "families", "fit", "set_threads", "shapes", "threads"]

for _public in (Embedding, Error, Lattice, UsageError, deform, devices, families, fit,
                set_threads, shapes, threads):
    _public.__module__ = __name__
for _public in Embedding, Lattice:
    _copies.keep(_public)
    _refusals.refuse_in(_public)
del _public


def __getattr__(name):
    """register() is there when it is asked for: it wants SciPy and, of files, SimpleITK."""
    if name == "register":
        from hwffd.volumes.registration import register  # pylint: disable=import-outside-toplevel
        return register
    raise AttributeError(f"module 'hwffd' has no attribute '{name}'")
