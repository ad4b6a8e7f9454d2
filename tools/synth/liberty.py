"""The OSU 0.18 um standard cells: where their liberty file is, and what it says of each cell.

SPDX-License-Identifier: Apache-2.0
"""

import functools
import os
import pathlib
import re

TARGET, PACKAGE = "osu018", "qflow-tech-osu018"
PATH = pathlib.Path(os.environ.get(
    "HWFFD_OSU018", "/usr/share/qflow/tech/osu018/osu018_stdcells.lib"))

_CELL = re.compile(r"^cell \((\w+)\)", re.MULTILINE)
_AREA = re.compile(r"^\s*area\s*:\s*([\d.]+)", re.MULTILINE)
_GROUP = re.compile(r"^\s*(ff|latch)\s*\(", re.MULTILINE)
_FLOATING = re.compile(r"\bthree_state\b")


class LibertyError(Exception):
    """No library, or one that cannot be read, in one line."""


def path():
    """The liberty file. Raises LibertyError."""
    if not PATH.is_file():
        raise LibertyError(f"no {PATH}: install Debian's {PACKAGE}, name it by HWFFD_OSU018=, or "
                           "choose another TARGET=")
    return PATH


def parse(text):
    """cell -> (kind, what it adds to the counts), in the form of mapped.CELLS. Latches and drivers
    that can float are no cells of a design here."""
    names = list(_CELL.finditer(text))
    ends = [match.start() for match in names[1:]] + [len(text)]
    cells = {}
    for match, end in zip(names, ends):
        body = text[match.end():end]
        area, group = _AREA.search(body), _GROUP.search(body)
        if area is None:
            raise LibertyError(f"cell {match.group(1)} has no area")
        if _FLOATING.search(body) or (group and group.group(1) == "latch"):
            continue
        counts = {"area_um2": float(area.group(1)), "cells": 1}
        cells[match.group(1)] = (
            ("register", {**counts, "ff": 1}) if group else ("logic", counts))
    return cells


@functools.lru_cache(maxsize=None)
def cells():
    """The same of the installed library. Raises LibertyError."""
    found = parse(path().read_text(errors="replace"))
    if not found:
        raise LibertyError(f"{PATH} names no cells")
    return found
