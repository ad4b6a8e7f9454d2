"""The table of registers, rtl/bus/registers.csv, and what is made from it.

One row is one field. This module reads the table and refuses what is wrong with it;
register_rtl.py and register_texts.py make RTL, a C header and docs/registers.md from it. Reset
values "version" are the parts of the version, whose own header is made here too.

SPDX-License-Identifier: Apache-2.0
"""

import re
import sys
from dataclasses import dataclass

from tools import csv_table
from tools.csv_table import TableError
from tools.project_root import ROOT
from tools.tables import register_rtl, register_texts, version

TABLE = "rtl/bus/registers.csv"
PREAMBLE = "rtl/bus/registers_preamble.md"
COLUMNS = ("offset", "register", "field", "bits", "access", "reset", "link", "description")

# access -> the links that it may have
ACCESSES = {
    "const": ("if",), "ro": ("if",), "log": (), "counter": (),
    "rw": ("locked", "if"), "w1s": (), "w1": ("unless", "needs", "refused", "sets"),
    "w1c": ("with", "if"), "event": (),
}
WRITABLE = ("rw", "w1s", "w1", "w1c", "event")
RESETLESS = ("ro", "w1")


@dataclass(frozen=True)
class Field:
    register: str
    name: str
    low: int
    width: int
    access: str
    reset: int
    links: tuple  # of (kind, target)
    description: str

    def linked(self, kind):
        return [target for link, target in self.links if link == kind]

    @property
    def path(self):
        return f"{self.register}.{self.name}"

    @property
    def mask(self):
        return ((1 << self.width) - 1) << self.low


@dataclass(frozen=True)
class Register:
    name: str
    offset: int
    fields: tuple

    @property
    def writable(self):
        return any(field.access in WRITABLE for field in self.fields)

    @property
    def lock(self):
        """The field that locks it, or None."""
        return next((lock for field in self.fields for lock in field.linked("locked")), None)


def _read_bits(text, where):
    match = re.fullmatch(r"([0-9]{1,2})(?::([0-9]{1,2}))?", text)
    high, low = (int(match.group(1)), int(match.group(2) or match.group(1))) if match else (0, 1)
    if not 0 <= low <= high <= 31:
        raise TableError(f"{where}: bits '{text}': HIGH:LOW or one number, 31 to 0")
    return low, high - low + 1


def _read_links(text, access, where):
    links = []
    for word in text.split():
        kind, _, target = word.partition(":")
        if kind not in ACCESSES[access] or not target:
            raise TableError(f"{where}: link '{word}' is not one of a field of access {access}")
        links.append((kind, target))
    return tuple(links)


def _read_reset(text, access, width, where):
    if access in RESETLESS:
        if text:
            raise TableError(f"{where}: a field of access {access} has no reset value")
        return 0
    if not re.fullmatch(r"0x[0-9A-Fa-f]{1,8}|[0-9]{1,10}", text) or int(text, 0) >> width:
        raise TableError(f"{where}: reset '{text}' is not a number of {width} bits")
    return int(text, 0)


def _read_row(cells, where, release):
    """(offset, Field)"""
    if cells["reset"] == "version":
        if cells["field"] not in release._fields:
            raise TableError(f"{where}: reset 'version': of {', '.join(release._fields)} only")
        cells["reset"] = str(getattr(release, cells["field"]))
    if not re.fullmatch(r"0x[0-9A-F]{3}", cells["offset"]) or int(cells["offset"], 16) % 4:
        raise TableError(f"{where}: offset '{cells['offset']}': 0x and three digits, a multiple"
                         " of 4")
    for column, form in (("register", r"[A-Z][A-Z0-9]*(_[A-Z0-9]+)*"),
                         ("field", r"[a-z][a-z0-9]*(_[a-z0-9]+)*")):
        if not re.fullmatch(form, cells[column]):
            raise TableError(f"{where}: bad {column} '{cells[column]}'")
    access = cells["access"]
    if access not in ACCESSES:
        raise TableError(f"{where}: unknown access '{access}': one of {', '.join(ACCESSES)}")
    if not cells["description"]:
        raise TableError(f"{where}: no description")
    low, width = _read_bits(cells["bits"], where)
    if access in ("w1", "w1c", "w1s", "event") and width != 1:
        raise TableError(f"{where}: a field of access {access} has one bit")
    return int(cells["offset"], 16), Field(
        cells["register"], cells["field"], low, width, access,
        _read_reset(cells["reset"], access, width, where),
        _read_links(cells["link"], access, where), cells["description"])


def _check_register(register):
    """What the fields of one register must have in common."""
    taken = 0
    for field in register.fields:
        if taken & field.mask:
            raise TableError(f"{field.path}: its bits are those of another field")
        taken |= field.mask
    if len({tuple(field.linked("locked")) for field in register.fields}) > 1:
        raise TableError(f"{register.name}: one lock for all of its fields, or none")
    events = [field.low for field in register.fields if field.access == "event"]
    if events and events != list(range(len(register.fields))):
        raise TableError(f"{register.name}: events take the bits from 0 on, and nothing else does")


# Parameters of the RTL, 0 or 1, without which a register is not there, or a field of it is 0: link "if".
PARAMETERS = ("WAITS", "MARKS", "HARDENED")
# link -> accesses of what it names
TARGETS = {"locked": ("w1s",), "unless": ("ro",), "needs": ("w1s",), "refused": ("w1c",),
           "sets": ("w1c",), "with": ("w1c", "event")}


def _check_links(registers):
    fields = {field.path: field for register in registers for field in register.fields}
    events = {r.name: r.fields[0] for r in registers if r.fields[0].access == "event"}
    for field in fields.values():
        for kind, target in field.links:
            if kind == "if":
                if target not in PARAMETERS:
                    raise TableError(f"{field.path}: if:{target} is none of {', '.join(PARAMETERS)}")
                continue
            linked = fields.get(target) or (events.get(target) if kind == "with" else None)
            if linked is None or linked.access not in TARGETS[kind]:
                raise TableError(f"{field.path}: {kind}:{target} does not name a field of access"
                                 f" {' or '.join(TARGETS[kind])}")
        if (field.linked("unless") or field.linked("needs")) and not field.linked("refused"):
            raise TableError(f"{field.path}: unless and needs want refused")


def parse(text, path, release):
    """The registers of a version, in order of their offsets. Raises TableError."""
    grouped = []  # (offset, name, fields)
    for where, cells in csv_table.parse(text, path, COLUMNS):
        offset, field = _read_row(cells, where, release)
        if grouped and grouped[-1][:2] == (offset, field.register):
            if field.name in [other.name for other in grouped[-1][2]]:
                raise TableError(f"{where}: {field.path} is there twice")
            grouped[-1][2].append(field)
            continue
        if grouped and offset <= grouped[-1][0]:
            raise TableError(f"{where}: offset of {field.register} is not above the one before")
        if field.register in [name for _, name, _ in grouped]:
            raise TableError(f"{where}: {field.register} has another offset above")
        grouped.append((offset, field.register, [field]))
    registers = [Register(name, offset, tuple(fields)) for offset, name, fields in grouped]
    if not registers:
        raise TableError(f"{path}: no registers")
    for register in registers:
        _check_register(register)
    _check_links(registers)
    missing = register_rtl.missing_fields(registers)
    if missing:
        raise TableError(f"{path}: no {missing[0]}, which the RTL is built around")
    return registers


def read(root=ROOT):
    """Those of a checkout. Raises TableError."""
    return parse(csv_table.read_text(root / TABLE), root / TABLE, version.read(root))


def outputs(root=ROOT):
    """path below root -> the text that it must have"""
    registers = read(root)
    return {
        "rtl/bus/ffd_bus_registers.v": register_rtl.rtl_text(registers),
        "cores/include/hwffd/registers.h": register_texts.header_text(registers),
        "rtl/stream/ffd_events.vh": register_texts.events_rtl_text(registers),
        "golden/include/hwffd/stream/events.hpp": register_texts.events_header_text(registers),
        "rtl/stream/ffd_features.vh": register_texts.features_rtl_text(registers),
        "golden/include/hwffd/stream/features.hpp": register_texts.features_header_text(registers),
        "docs/registers.md": register_texts.docs_text(registers, csv_table.read_text(root / PREAMBLE)),
        version.HEADER: version.header_text(version.read(root)),
    }


def listing(root):
    """Offset, register, fields."""
    return "\n".join(" ".join([f"0x{register.offset:03X} {register.name}", *(
        f"{field.name}({field.access})" for field in register.fields)]) for register in read(root))


def main(arguments=None):
    return csv_table.command("registers", [outputs], arguments, list=listing)


if __name__ == "__main__":
    sys.exit(main())
