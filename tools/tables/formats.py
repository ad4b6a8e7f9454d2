"""The table of number formats, rtl/formats.csv: their words, the number of the parameter FORMAT, the
class of the bit-true model; and the C++ that follows from it.

A row with `widths` is a family: its name is followed by a width, which is the number.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
from dataclasses import dataclass

from tools import csv_table
from tools.csv_table import TableError
from tools.project_root import ROOT

TABLE = "rtl/formats.csv"
HEADER = "golden/include/hwffd/stream/formats.hpp"
COLUMNS = ("format", "widths", "number", "words", "model", "fused", "header")
# What coordinates and points are on the stream: binary32, binary32 around a block, fixed point.
WORDS = ("float", "block", "fixed")
NUMBERS = range(256)  # what CONFIG.format has bits for
WIDTHS = range(8, 33)  # what rtl/number/ffd_num.vh has fixed point for


@dataclass(frozen=True)
class Format:
    name: str
    number: int
    words: str
    width: int  # of a word
    model: str  # C++ class
    fused: str  # the same with fused multiply-add; nothing: there is none
    header: str  # of both, in hwffd/numerics/


@dataclass(frozen=True)
class Formats:
    by_name: dict
    summary: str  # fp32, bfp32, or fx12 to fx32

    def find(self, name, where=None):
        """Raises TableError, which lists them."""
        if name in self.by_name:
            return self.by_name[name]
        raise TableError(f"{f'{where}: ' if where else ''}unknown format '{name}': {self.summary}")


def _members(cells, where):
    """[Format] of a row."""
    words = csv_table.word(cells, "words", where, WORDS)
    for column, form in (("format", r"[a-z]+[0-9]*"), ("model", r"[A-Z]\w*"),
                         ("fused", r"([A-Z]\w*)?"), ("header", r"[a-z]\w*")):
        if not re.fullmatch(form, cells[column]):
            raise TableError(f"{where}: bad {column} '{cells[column]}'")
    rest = (cells["fused"], cells["header"])
    if not cells["widths"]:
        number = csv_table.number(cells, "number", where, NUMBERS)
        return [Format(cells["format"], number, words, 32, cells["model"], *rest)]
    if cells["number"]:
        raise TableError(f"{where}: number is '{cells['number']}', nothing wanted: the width is it")
    return [Format(f"{cells['format']}{width}", width, words, width, f"{cells['model']}<{width}>",
                   *rest) for width in csv_table.span(cells, "widths", where, WIDTHS)]


def read(root=ROOT):
    """All of them. Raises TableError."""
    path = pathlib.Path(root) / TABLE
    by_name, numbers, ranges = {}, {}, []
    for where, cells in csv_table.read(path, COLUMNS):
        members = _members(cells, where)
        for member in members:
            csv_table.unique(by_name, member.name, "format", where)
            if member.number in numbers:
                raise TableError(f"{where}: number {member.number} is that of "
                                 f"'{numbers[member.number]}'")
            by_name[member.name] = member
            numbers[member.number] = member.name
        names = [members[0].name, members[-1].name]
        ranges.append(names[0] if len(members) == 1 else " to ".join(names))
    if not by_name:
        raise TableError(f"{path}: no formats")
    return Formats(by_name, ", ".join(ranges[:-1]) + f", or {ranges[-1]}" if ranges[1:] else ranges[0])


def header_text(formats):
    rows = "\n".join(f'    {{"{f.name}", {f.number}, Words::k{f.words.capitalize()}, {f.width}}},'
                     for f in formats.by_name.values())
    return f"""// Made from {TABLE} by tools/tables/generated_files.py; changes here are lost.
#pragma once

namespace hwffd {{

/// What coordinates and points are on the stream.
enum class Words {{
  kFloat,  ///< binary32
  kBlock,  ///< binary32, with one exponent for the points of a lattice inside
  kFixed   ///< fixed point
}};

/// A number format of the core.
struct Format {{
  const char* name;
  int number;  ///< the parameter FORMAT
  Words words;
  int width;  ///< bits of a word
}};

/// Every format.
// clang-format off
constexpr Format kFormats[] = {{
{rows}
}};
// clang-format on

/// The same in words, for messages.
constexpr const char* kFormatNames = "{formats.summary}";

}}  // namespace hwffd
"""
