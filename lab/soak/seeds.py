"""The seeds that no run has had yet.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib

FIRST = 1000  # tests have smaller seeds
STRIDE = 16   # a test may take so many from the one that it is given


def _file(build):
    return pathlib.Path(build) / "soak" / "next.json"


def following(build):
    """The first of them."""
    path = _file(build)
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else FIRST


def had(build, seed):
    """A run has had this one and all before."""
    path, first = _file(build), following(build)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(max(first, seed + STRIDE)), encoding="utf-8")
