"""The memories of a configuration: who replaces them by macros of a library needs to know which there are.

    python3 -m tools.rtl.memories hwffd_axi ORG=1 FORMAT=18

All memories of the core are instances of ffd_mem_sdp, with one write port and one read port. This prints how many there
are of each width, depth and kind of read, as yosys elaborates the top with these parameters, and where they lie.

SPDX-License-Identifier: Apache-2.0
"""

import re
import sys
import tempfile
from collections import Counter, defaultdict
from dataclasses import dataclass
from pathlib import Path

from tools import command_line
from tools.project_root import ROOT
from tools.rtl import rtl_sources

MEMORY = "ffd_mem_sdp"
READS = {0: "in the same clock", 1: "a clock later"}
_MODULE = re.compile(r"^module (\S+)$(.*?)^end$", re.MULTILINE | re.DOTALL)
_PARAMETER = re.compile(r"^  parameter \\(\w+) (?:(\d+)|32'([01]{32}))$", re.MULTILINE)
_CELL = re.compile(r"^  cell (\S+) \S+$", re.MULTILINE)


class MemoriesError(Exception):
    """What cannot be elaborated, in one line."""


@dataclass(frozen=True, order=True)
class Shape:
    width: int
    depth: int
    read_latency: int

    @property
    def bits(self):
        return self.width * self.depth


def shapes(circuit, top):
    """{Shape: Counter of the modules that hold such a memory, by instances} of an elaborated design in RTLIL."""
    cells, values = {}, {}
    for name, body in _MODULE.findall(circuit):
        cells[name] = Counter(_CELL.findall(body))
        values[name] = {key: int(word) if word else int(bits, 2) for key, word, bits in _PARAMETER.findall(body)}
    shaped = defaultdict(Counter)

    def visit(module, instances):
        for cell, count in cells[module].items():
            if cell not in cells:
                continue
            if rtl_sources.module_of(cell) == MEMORY:
                of = values[cell]
                shaped[Shape(of["WIDTH"], of["DEPTH"], of["READ_LATENCY"])][rtl_sources.module_of(module)] += instances * count
            visit(cell, instances * count)

    visit(next(name for name in cells if rtl_sources.module_of(name) == top), 1)
    return shaped


def of_top(root, top, given):
    """The shapes of a top with parameters, {name: number}. Raises MemoriesError."""
    sources = rtl_sources.Sources(root)
    if top not in sources.files:
        raise command_line.Request(f"unknown top '{top}': a module of rtl/hwffd.f wanted")
    with tempfile.TemporaryDirectory() as folder:
        circuit = Path(folder) / "circuit"
        status, printed = rtl_sources.run(["yosys", "-q", "-p", "; ".join((
            *rtl_sources.elaboration(sources, top, given), f"write_rtlil {circuit}"))], root)
        if status:
            guard = re.search(r"\\(ERROR_\w+)'", printed)
            raise MemoriesError(f"{top}: {guard[1] if guard else printed.strip()}")
        return shapes(circuit.read_text(encoding="utf-8"), top)


def lines(shaped):
    """A table of them, the largest first."""
    yield f"{'instances':>9} {'width':>5} {'depth':>6} {'bits':>8}  read               in"
    total = 0
    for shape, places in sorted(shaped.items(), key=lambda item: (-item[0].bits, item[0])):
        count = sum(places.values())
        total += count * shape.bits
        yield (f"{count:9,} {shape.width:5} {shape.depth:6,} {shape.bits:8,}  {READS[shape.read_latency]:<18} "
               + ", ".join(f"{name} {number}" if len(places) > 1 else name for name, number in sorted(places.items())))
    yield f"{sum(sum(places.values()) for places in shaped.values()):,} memories, {total:,} bits; one write port and one read port each"


def main(arguments):
    def work():
        if not arguments:
            raise command_line.Request("TOP [NAME=NUMBER...] wanted")
        print("\n".join(lines(of_top(ROOT, arguments[0], command_line.assignments(arguments[1:])))))
        return 0

    return command_line.ended("memories", work, (MemoriesError,))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
