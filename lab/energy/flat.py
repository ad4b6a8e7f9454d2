"""An evaluator as a netlist of standard cells, in the form that the simulator and OpenSTA read.

It is what `make synth` maps, flat, each net of one bit, and all its names plain: cells c1, c2 and so
on, nets n1, n2. Only the ports keep their names. For OpenSTA each cell gets the input that
library.py adds, and that a port of its own.

SPDX-License-Identifier: Apache-2.0
"""

import re
from dataclasses import dataclass

from lab.energy import library
from tools.project_root import ROOT
from tools.rtl import digest, rtl_sources
from tools.synth import liberty, synthesis
from tools.tables import configurations

MODULE = "ffd_energy_netlist"  # its name, in place of that of the organization
SOURCE_W = 8  # of ffd_bench_evaluator

_CELL = re.compile(r"^  (\w+) (\w+) \(\n(.*?)^  \);$", re.MULTILINE | re.DOTALL)
_PIN = re.compile(r"\.(\w+)\(([^)]*)\)")
_PORTS = re.compile(r"^module (\w+)\(([^)]*)\);$", re.MULTILINE)
_INPUT = re.compile(r"^  input (?:\[(\d+):0\] )?(\w+);$", re.MULTILINE)


class NetlistError(Exception):
    """No netlist, or one that cannot be read, in one line."""


# The netlist of yosys -----------------------------------------------------------------------------


def subject(name):
    """A row's evaluator in standard cells. Raises TableError."""
    row = configurations.find(configurations.read(), name)
    return synthesis.Subject(row, synthesis.ORGANIZATION, synthesis.CELLS)


def steps(work, mapped, out):
    """The steps of yosys, to be run in the root."""
    script = [f"{step} -chparam SOURCE_W {SOURCE_W}" if step.startswith("hierarchy ") else step
              for step in work.script(mapped)]
    return [*script, *rtl_sources.FLATTEN, "splitnets",
            "opt_clean -purge", "rename -hide w:* c:*", "rename -enumerate -pattern n% w:*",
            "rename -enumerate -pattern c% c:*", f"rename -top {MODULE}", "check -assert",
            f'write_verilog -noattr "{out}"']


def key(work, mapped):
    """Of all that a netlist depends on."""
    return digest.of(work.netlist_key(mapped), *steps(work, mapped, ""), digest.lines(liberty.PATH))


def netlist_file(work, mapped, folder):
    """The file of the netlist, mapped unless it is there. Raises NetlistError."""
    path = folder / f"{mapped.row.name}.{key(work, mapped)}.v"
    if path.is_file():
        return path
    folder.mkdir(parents=True, exist_ok=True)
    draft, log = path.with_suffix(".draft"), path.with_suffix(".log")
    status, output = rtl_sources.run(["yosys", "-Q", "-T", "-p", "; ".join(steps(work, mapped, draft))],
                                     ROOT)
    log.write_text(output, encoding="utf-8")
    if status:
        raise NetlistError(f"yosys ended with {status}: see {log}")
    draft.rename(path)
    return path


# What is in it ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Instance:
    """A cell: its kind, its name, the net at each pin."""

    kind: str
    name: str
    pins: dict


@dataclass
class Netlist:
    """A netlist as it was read: its text, its cells and the bits of its inputs."""

    text: str
    cells: list
    inputs: list

    def output(self, cell, kinds):
        """(pin, net) of what a cell drives. Raises NetlistError."""
        driven = [(pin, cell.pins[pin]) for pin in kinds[cell.kind].outputs if cell.pins.get(pin)]
        if len(driven) != 1:
            raise NetlistError(f"cell {cell.name}, {cell.kind}, drives {len(driven)} nets")
        return driven[0]

    def load_pf(self, kinds):
        """net -> the capacitance of the pins that it goes to"""
        loads = {}
        for cell in self.cells:
            for pin, capacitance in kinds[cell.kind].inputs.items():
                net = cell.pins.get(pin)
                loads[net] = loads.get(net, 0) + capacitance
        return loads


def read(text, kinds):
    """A netlist as yosys writes it. Raises NetlistError where anything in it is not understood."""
    cells = [Instance(kind, name, dict(_PIN.findall(pins))) for kind, name, pins in _CELL.findall(text)]
    unknown = {cell.kind for cell in cells} - set(kinds)
    if unknown:
        raise NetlistError(f"cells that the library does not have: {', '.join(sorted(unknown))}")
    if len(_PORTS.findall(text)) != 1 or not cells or text.count(");\n") != len(cells) + 1:
        raise NetlistError("the netlist is not one module of cells")
    inputs = []
    for highest, name in _INPUT.findall(text):
        inputs += [f"{name}[{bit}]" for bit in range(int(highest) + 1)] if highest else [name]
    return Netlist(text, cells, inputs)


def port(cell):
    """What says how often a cell toggles."""
    return f"toggles_{cell.name}"


def with_toggles(netlist):
    """The netlist for OpenSTA."""
    names = [port(cell) for cell in netlist.cells]
    ports = _PORTS.search(netlist.text)
    start = (f"module {ports.group(1)}({', '.join([ports.group(2).strip(), *names])});\n"
             + "".join(f"  input {name};\n" for name in names))
    body = _CELL.sub(lambda cell: f"  {cell.group(1)} {cell.group(2)} (\n"
                     f"    .{library.PIN}(toggles_{cell.group(2)}),\n{cell.group(3)}  );",
                     netlist.text[ports.end() + 1:])
    return start + body
