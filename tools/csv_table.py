"""Tables of the project, CSV with a first line that names the columns.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import csv
import pathlib
import re
import sys

from tools.project_root import ROOT


class TableError(Exception):
    """A fault of a table, in one line."""


def parse(text, path, columns):
    """[(file:line, {column: cell})]. Raises TableError."""
    lines = csv.reader(text.splitlines(), strict=True)
    rows = []
    try:
        if tuple(next(lines, [])) != tuple(columns):
            raise TableError(f"{path}:1: the first line must be {','.join(columns)}")
        filled = [(lines.line_num, cells) for cells in lines if cells]
    except csv.Error as error:  # a quote that is not closed would take the lines behind it into its cell
        raise TableError(f"{path}:{lines.line_num}: {error}: see to its quotes") from error
    for number, cells in filled:
        where = f"{path}:{number}"
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


def unique(known, name, column, where):
    """Raises TableError where the rows found before have one of that name."""
    if name in known:
        raise TableError(f"{where}: {column} '{name}' is there twice")


def span(cells, column, where, allowed):
    """range(2, 9) of "2-8". Raises TableError."""
    low, _, high = cells[column].partition("-")
    if not (low.isdecimal() and high.isdecimal() and int(low) <= int(high)
            and int(low) in allowed and int(high) in allowed):
        raise TableError(f"{where}: {column} is '{cells[column]}', two numbers of {allowed[0]} to "
                         f"{allowed[-1]} wanted, as in {allowed[0]}-{allowed[-1]}")
    return range(int(low), int(high) + 1)


def write_if_changed(path, text):
    """Leaves the file alone, time stamp and all, when it has this text already."""
    path = pathlib.Path(path)
    if path.is_file() and path.read_text(encoding="utf-8") == text:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def stale(root, makers, cure):
    """A line for each file that is not what these functions make, root -> {file below it: text}."""
    return [f"{name}: not what it is made from says: run python3 -m tools.tables.{cure} write"
            for make in makers for name, text in make(root).items()
            if not (root / name).is_file() or (root / name).read_text(encoding="utf-8") != text]


def command(name, makers, arguments=None, **others):
    """A program that writes such files or checks them, or does one of `others`; its exit status."""
    parser = argparse.ArgumentParser(
        prog=name, description="Writes files that are made, or checks them.")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="checkout to work on")
    parser.add_argument("command", choices=("write", "check", *others))
    options = parser.parse_args(arguments)
    try:
        faults = stale(options.root, makers, name) if options.command == "check" else []
        if options.command == "write":
            for make in makers:  # one after another: some read what those before have written
                for file, text in make(options.root).items():
                    write_if_changed(options.root / file, text)
        elif options.command in others:
            print(others[options.command](options.root))
    except (TableError, OSError) as error:
        faults = [str(error)]
    for line in faults:
        print(f"{name}: {line}", file=sys.stderr)
    return 1 if faults else 0
