"""Loads the library of the device rtl, if the package hwffd-rtl is installed.

SPDX-License-Identifier: Apache-2.0
"""

import importlib.util

from hwffd._core import __version__


def _load():
    """Why the package that is installed cannot be used; "" where it can, or where none is installed."""
    try:
        if importlib.util.find_spec("hwffd_rtl") is None:
            return ""
        version = __import__("hwffd_rtl").__version__
    except Exception as error:  # pylint: disable=broad-except  # whatever a broken package raises
        return "the package hwffd-rtl is broken: " + " ".join(str(error).split())
    if version != __version__:
        return f"the package hwffd-rtl has version {version}, this one {__version__}; install both of the same"
    return ""


PROBLEM = _load()
