"""Loads the library of the device rtl, if the package hwffd-rtl is installed.

SPDX-License-Identifier: Apache-2.0
"""

import contextlib

with contextlib.suppress(ImportError):
    __import__("hwffd_rtl")
