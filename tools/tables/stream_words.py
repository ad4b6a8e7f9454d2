"""The table of the fields of the stream's inner words, rtl/stream/fields.csv, and the headers that
follow from it: macros of the RTL, and in C++ the status bits of a result and the opcodes of packets.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
from dataclasses import dataclass

from tools import csv_table
from tools.csv_table import TableError
from tools.project_root import ROOT

TABLE = "rtl/stream/fields.csv"
RTL = "rtl/stream/ffd_fields.vh"
HEADER = "golden/include/hwffd/stream/status.hpp"
OPCODES = "golden/include/hwffd/stream/opcodes.hpp"
COLUMNS = ("word", "field", "bits", "description")
# A vertex's way around the evaluator; what of it says that banks are free again; the status of a
# result, most of which is known before and comes in the first; the kind of a packet; what a beat is in it.
WORDS = ("user", "retire", "status", "packet", "frame")
GENERATED = f"Made from {TABLE} by tools/tables/generated_files.py; changes here are lost."


@dataclass(frozen=True)
class Field:
    word: str
    name: str
    high: int
    low: int
    description: str

    @property
    def bits(self):
        return f"{self.low}" if self.high == self.low else f"{self.high}:{self.low}"


def read(root=ROOT):
    """[Field], those of a word without gaps from bit 0 on. Raises TableError."""
    path = pathlib.Path(root) / TABLE
    fields, free = {}, dict.fromkeys(WORDS, 0)
    for where, cells in csv_table.read(path, COLUMNS):
        word = csv_table.word(cells, "word", where, WORDS)
        if not re.fullmatch(r"[a-z]+(_[a-z]+)*", cells["field"]):
            raise TableError(f"{where}: bad field '{cells['field']}': lower case letters, _ between words")
        csv_table.unique(fields, (word, cells["field"]), "field", where)
        bits = re.fullmatch(r"(?:([0-9]{1,2}):)?([0-9]{1,2})", cells["bits"])
        high, low = (int(bits.group(1) or bits.group(2)), int(bits.group(2))) if bits else (-1, -1)
        if low != free[word] or high < low:
            raise TableError(f"{where}: bits is '{cells['bits']}', HIGH:LOW or BIT from bit "
                             f"{free[word]} on wanted")
        if not cells["description"]:
            raise TableError(f"{where}: no description")
        free[word] = high + 1
        fields[word, cells["field"]] = Field(word, cells["field"], high, low, cells["description"])
    missing = [word for word in WORDS if not free[word]]
    if missing or ("user", "status") not in fields:
        raise TableError(f"{path}: no {missing[0] if missing else 'status in user'}")
    return list(fields.values())


def _of(fields, word):
    return [field for field in fields if field.word == word]


def _status(fields):
    """Where the status lies in the user word, and in word 3 of a result."""
    return next(field for field in _of(fields, "user") if field.name == "status")


def rtl_text(fields):
    carried = _status(fields)
    macros = [(f"{field.word}_{field.name}", field.bits, field.description) for field in fields]
    macros += [(f"user_{field.name}", str(carried.low + field.low), "of user's status")
               for field in _of(fields, "status") if carried.low + field.low <= carried.high]
    macros += [(f"{word}_w", str(_of(fields, word)[-1].high + 1), "width") for word in WORDS]
    lines = [f"`define FFD_{name.upper():<16} {bits:<5} // {text}" for name, bits, text in macros]
    return "\n".join([f"// {GENERATED}", "// Fields of the stream's inner words, bit or range of bits.",
                      "// SPDX-License-Identifier: Apache-2.0", "`ifndef FFD_FIELDS_VH",
                      "`define FFD_FIELDS_VH", *lines, "`endif"]) + "\n"


def _aligned(lines):
    """Their comments below each other."""
    width = max(len(line.split("///<")[0]) for line in lines)
    return ["///<".join([left.ljust(width), right]) for left, right in (line.split("///<") for line in lines)]


def _header(*lines):
    return "\n".join([f"// {GENERATED}", "#pragma once", "", "#include <cstdint>", "", "namespace hwffd {", "",
                      *lines, "", "}  // namespace hwffd"]) + "\n"


def opcodes_text(fields):
    """Bit n of the kind of a packet is opcode n + 1."""
    packets = _of(fields, "packet")

    def constant(field):
        return "k" + "".join(word.capitalize() for word in field.name.split("_"))

    return _header(
        "/// Packet opcodes, in the low byte of a header's word 0. docs/interface.md section 2.",
        "enum class Opcode : std::uint8_t {",
        *_aligned([f"  {constant(field)} = {field.low + 1}{',' if field is not packets[-1] else ''}"
                   f"  ///< {field.description.partition(': ')[2]}" for field in packets]),
        "};", "", "/// The last of them; the first is 1.",
        f"constexpr unsigned kOpcodes = {packets[-1].low + 1};")


def header_text(fields):
    low = _status(fields).low
    bits = [f"constexpr std::uint32_t kStatus{field.name.capitalize()} = 1U << {low + field.low};"
            f"  ///< {field.description}" for field in _of(fields, "status")]
    return _header("// Status bits of a result, in its word 3.", *_aligned(bits))
