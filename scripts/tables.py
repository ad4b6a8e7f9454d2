"""Tables of the project, CSV with a first line that names the columns.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import pathlib
import re


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


def word(cells, column, where, words):
    """A cell that must be one of these words. Raises TableError."""
    if cells[column] not in words:
        raise TableError(f"{where}: unknown {column} '{cells[column]}': one of {', '.join(words)}")
    return cells[column]


def number(cells, column, where, allowed):
    """A cell that must be a number of that range. Raises TableError."""
    text = cells[column]
    if not re.fullmatch(r"[0-9]{1,4}", text) or int(text) not in allowed:
        raise TableError(f"{where}: {column} is '{text}', {allowed[0]} to {allowed[-1]} wanted")
    return int(text)


def unique(found, name, column, where):
    """Raises TableError where the rows found before have one of that name."""
    if name in found:
        raise TableError(f"{where}: {column} '{name}' is there twice")
