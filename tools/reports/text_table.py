"""A table of words, for Markdown and for a terminal.

SPDX-License-Identifier: Apache-2.0
"""

import re
from dataclasses import dataclass

from tools.reports.results import RequestError, lookup

_NUMBER = re.compile(r"[-+]?[\d,]*\.?\d+(?:e[-+]\d+)?(?: ?%|(?:[ /+]+| of )[\d,.]+)*")
_NOTHING = ("", "-")


def shown(value, form=""):
    """A figure as text."""
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    try:
        if form:
            return format(value, form)
    except ValueError as error:
        raise RequestError(f"'{form}' does not write {value!r}: {error}") from error
    if isinstance(value, float):
        return f"{value:,.0f}" if abs(value) >= 100 else f"{value:.3g}"
    return f"{value:,}" if isinstance(value, int) else str(value)


@dataclass
class Table:
    """Headings, and cells as they are written; columns of numbers stand on the right."""

    heads: list
    rows: list

    def _numbers(self):
        """Of each column, whether it holds numbers."""
        return [all(_NUMBER.fullmatch(cell) or cell in _NOTHING for cell in column)
                and any(cell not in _NOTHING for cell in column)
                for column in zip(*self.rows)] or [False] * len(self.heads)

    def markdown(self):
        rules = ["--:" if number else "---" for number in self._numbers()]
        return "\n".join("| " + " | ".join(line) + " |"
                         for line in [self.heads, rules, *self.rows])

    def text(self):
        """Columns, without the marks of Markdown."""
        lines = [[cell.replace("`", "") for cell in line] for line in [self.heads, *self.rows]]
        widths = [max(map(len, column)) for column in zip(*lines)]
        numbers = self._numbers()
        return "\n".join("  ".join(
            cell.rjust(width) if number else cell.ljust(width)
            for cell, width, number in zip(line, widths, numbers)).rstrip() for line in lines)


def cell(row, what):
    """A row's field:FORMAT, in backticks where they are around it. Raises KeyError."""
    field, _, form = what.strip("`").partition(":")
    value = shown(lookup(row, field), form)
    return f"`{value}`" if what.startswith("`") else value


def listing(rows, *columns):
    """A Table of rows; each column is "heading | field:FORMAT"."""
    pairs = [column.split(" | ") for column in columns]
    return Table([head for head, _ in pairs],
                 [[cell(row, what) for _, what in pairs] for row in rows])


@dataclass
class Console:
    """Lines as a program prints them."""

    lines: list

    def markdown(self):
        return "\n".join(["```text", *self.lines, "```"])

    def text(self):
        return "\n".join(self.lines)
