"""Parts of a report: each is measured by itself, on any machine, and a last call joins them.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib

from tools import whole_file


class PartError(Exception):
    """Parts that make no report, in one line."""


def add_options(parser):
    chosen = parser.add_mutually_exclusive_group()
    chosen.add_argument("--part", type=pathlib.Path, metavar="FILE",
                        help="write what is measured there, and judge nothing: --join does")
    chosen.add_argument("--join", type=pathlib.Path, nargs="+", metavar="FILE",
                        help="measure nothing and make the report of these parts")


def write(path, content):
    """A part or a report."""
    whole_file.write(path, json.dumps(content, indent=2) + "\n")


def read(paths, fields):
    """The parts, each a dictionary with these fields. Raises PartError."""
    parts = []
    for path in paths:
        try:
            part = json.loads(path.read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            raise PartError(f"{path}: no part: {error}: measure it anew with --part") from error
        absent = [field for field in fields if field not in part]
        if absent:
            raise PartError(f"{path}: a part without {', '.join(absent)}: measure it anew with --part")
        parts.append(part)
    return parts


def same(parts, field):
    """What all parts have in a field. Raises PartError."""
    values = list(dict.fromkeys(part[field] for part in parts))
    if len(values) != 1:
        raise PartError(f"parts differ in {field}: {', '.join(map(str, values))}")
    return values[0]


def rows(parts, field="rows"):
    """The rows of all parts, in their order."""
    return [row for part in parts for row in part[field]]
