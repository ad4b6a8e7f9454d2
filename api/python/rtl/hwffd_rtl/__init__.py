"""The simulated hardware of hwffd, as a library that is loaded here, so that hwffd finds it by its name.

SPDX-License-Identifier: Apache-2.0
"""

import ctypes
import pathlib

_FOLDER = pathlib.Path(__file__).parent


def _load():
    paths = sorted(_FOLDER.glob("libhwffd_rtl.so*"))
    if len(paths) != 1:
        raise ImportError(f"{len(paths)} libraries libhwffd_rtl.so* in {_FOLDER}, not one; install hwffd-rtl again")
    return ctypes.CDLL(str(paths[0]))


library = _load()
library.hwffd_rtl_version.restype = ctypes.c_char_p
__version__ = library.hwffd_rtl_version().decode()
