"""Packages that this one can do without until it needs them.

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

import sys

from hwffd import Error


def missing(package: str) -> Error:
    """What to say of one, with a way to install it that works for this interpreter: that of a system takes
    packages in virtual environments only."""
    own = sys.prefix != sys.base_prefix
    cure = (f"{sys.executable} -m pip install {package}" if own else
            "python3 -m venv DIR && DIR/bin/pip install numpy scipy SimpleITK, then put DIR/bin first on PATH")
    return Error(f"volumes: {package} is missing in {sys.executable}: {cure}")
