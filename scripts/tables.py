"""Tables of the project, CSV with a first line that names the columns.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import pathlib


class TableError(Exception):
    """A fault of a table, in one line."""


def parse(text, path, columns):
    """[(file:line, {column: cell})]. Raises TableError."""
    lines = csv.reader(text.splitlines())
    if tuple(next(lines, [])) != tuple(columns):
        raise TableError(f"{path}:1: the first line must be {','.join(columns)}")
    rows = []
    for cells in lines:
        if not cells:
            continue
        where = f"{path}:{lines.line_num}"
        if len(cells) != len(columns):
            raise TableError(f"{where}: {len(cells)} columns, {len(columns)} wanted")
        rows.append((where, dict(zip(columns, cells))))
    return rows


def read_text(path):
    """Raises TableError."""
    try:
        return pathlib.Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise TableError(f"{path}: cannot be read: {error}") from error


def read(path, columns):
    """The same of a file. Raises TableError."""
    return parse(read_text(path), path, columns)
