"""The key of what a report has measured, so that lint sees when that has changed.

tools/digest.py says what counts: of Verilog and C++ the tokens, of other texts the lines; and here,
of the table of configurations, each row's name and parameters. Where a file lies does not count.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib

import configurations
import digest

_TABLE = "configurations.csv"


class SourceError(Exception):
    """Why sources have no key, in one line."""


def files_of(root, patterns):
    """Those that the patterns name. Raises SourceError where one names none."""
    found = set()
    for pattern in patterns:
        matched = {path for path in pathlib.Path(root).glob(pattern) if path.is_file()}
        if not matched:
            raise SourceError(f"no sources are {pattern}")
        found |= matched
    return sorted(found)


def _verilog(root, files):
    """Modules in the order of their names, as one text."""
    folders = sorted({str(path.parent) for folder in ("rtl", "lab/formal")
                      for path in (root / folder).rglob("*.vh")})
    names = (str(path) for path in sorted(files, key=lambda path: path.name))
    return digest.tokens(tuple(names), tuple(folders))


def _other(path):
    if path.suffix in (".cpp", ".hpp"):
        return digest.cpp(path)
    if path.name == _TABLE:
        return digest.of(*(f"{row.name} {' '.join(row.assignments())}"
                           for row in configurations.read(path)))
    return digest.of(path.name, digest.lines(path))


def key(root, patterns):
    """Sixteen digits for what the patterns name. Raises SourceError."""
    root = pathlib.Path(root)
    files = files_of(root, patterns)
    verilog = [path for path in files if path.suffix == ".v"]
    try:
        parts = [_verilog(root, verilog)] if verilog else []
        parts += [_other(path) for path in files if path.suffix != ".v"]
    except FileNotFoundError as error:
        raise SourceError(f"{error.filename} not found: run tools/install build") from error
    return digest.of(*sorted(parts))
