"""The reports of build/reports/ as documents and tables, by lab/figures.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "lab"))

from figures.catalogue import module  # noqa: E402
from figures.reports import FRESH, Reports  # noqa: E402


def document(root, name):
    """What NAME.md says of NAME.json."""
    return module(name).document(Reports(root, FRESH))


def table(root, name, rows):
    """These of its rows, for a terminal."""
    return module(name).listed(Reports(root, FRESH), rows).text()
