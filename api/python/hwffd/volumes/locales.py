"""Numbers with a point, whatever the locale of the process.

SPDX-License-Identifier: Apache-2.0
"""

import contextlib
import ctypes
from collections.abc import Iterator

_EVERYTHING = 0x1FBF  # LC_ALL_MASK of the C library of GNU


@contextlib.contextmanager
def plain_numbers() -> Iterator[None]:
    """While it lasts, this thread has the locale "C", by which ITK's readers and writers go; others
    keep theirs."""
    library = ctypes.CDLL(None)
    library.newlocale.argtypes = ctypes.c_int, ctypes.c_char_p, ctypes.c_void_p
    for function in library.newlocale, library.uselocale:
        function.restype = ctypes.c_void_p
    library.uselocale.argtypes = library.freelocale.argtypes = (ctypes.c_void_p,)
    plain = library.newlocale(_EVERYTHING, b"C", None)
    before = library.uselocale(plain)
    try:
        yield
    finally:
        library.uselocale(before)
        library.freelocale(plain)
