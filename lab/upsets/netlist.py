#!/usr/bin/env python3
"""A core of which every bit of state can be flipped: its flat netlist with an input a bit.

    python3 -m lab.upsets.netlist TOP ROW OUT.v [--parameter NAME=VALUE ...]

yosys reads and flattens the sources. Each bit of a register is then an exclusive or with its bit of
`upset_register`; a bit of `upset_memory` chooses the memory whose word `upset_address` has its bit
`upset_bit` inverted. OUT.json says what the bits are.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

from tools.project_root import ROOT, without_blanks
from tools.rtl import rtl_sources
from tools.tables import configurations, features

REGISTERS, MEMORIES, ADDRESS, BIT = "upset_register", "upset_memory", "upset_address", "upset_bit"
HERE = "upset_here"  # of a memory
# Verilator gives inputs of more bits than that as words, whatever there is: as C++ wants them.
WIDE = 96
PARTS = {path.stem for path in (ROOT / "rtl" / "common").glob("*.v")}  # modules that others are made of


class NetlistError(Exception):
    """A design that cannot be prepared, in one line."""


def _yosys(steps):
    result = subprocess.run(["yosys", "-Q", "-T", "-qq", "-p", "; ".join(steps)], cwd=ROOT, check=False,
                            capture_output=True, text=True)
    if result.returncode:
        raise NetlistError(f"yosys: {(result.stderr or result.stdout).strip().splitlines()[-1]}")


def flat(top, parameters, out):
    """(The tree of modules, the flat design) as JSON has them: registers are $dff, memories $mem_v2, and
    nothing is optimized away but what nobody reads."""
    sources = rtl_sources.Sources()
    own = pathlib.Path("lab/upsets/ffd_mem_sdp.v")
    files = [own if pathlib.Path(path).name == own.name else pathlib.Path(path).relative_to(ROOT)
             for path in sources.needed(top)]
    folders = " ".join(f"-I {pathlib.Path(folder).relative_to(ROOT)}" for folder in sources.includes)
    given = "".join(f" -chparam {name} {value}" for name, value in parameters.items())
    tree = out.with_suffix(".tree")
    _yosys([f"read_verilog {folders} -D {rtl_sources.SIMULATION} {' '.join(map(str, files))}",
            f"hierarchy -check -top {top}{given}", f"rename -top {top}", "proc", f"write_json {tree}",
            *rtl_sources.FLATTEN, "opt_clean", "memory_collect", "opt_clean", f"write_json {out}"])
    netlists = [json.loads(path.read_text(encoding="utf-8")) for path in (tree, out)]
    tree.unlink()
    return netlists[0]["modules"], netlists[1]


class Tree:
    """Which module a cell of the flat design was in."""

    def __init__(self, modules, top):
        self.inside = {name: {cell: instance["type"] for cell, instance in module["cells"].items()
                              if instance["type"] in modules} for name, module in modules.items()}
        self.top = top

    def module(self, cell):
        """The module's name; that of its user, where it is one that others are made of."""
        path = cell.removeprefix("$flatten\\").replace(".\\", ".")
        owner, kind = self.top, self.top
        while True:
            inner = [name for name in self.inside[kind] if path.startswith(f"{name}.")]
            if not inner:
                return owner
            name = max(inner, key=len)
            path, kind = path[len(name) + 1:], self.inside[kind][name]
            plain = next(word for word in kind.split("\\") if word and not word.startswith("$"))
            if plain not in PARTS:
                owner = plain


def _names(module):
    """bit -> its name: that of a register where it has several, and then the shortest."""
    ranks = {}
    for name, wire in module["netnames"].items():
        if wire.get("hide_name"):
            continue
        for place, bit in enumerate(wire["bits"]):
            own = name if len(wire["bits"]) == 1 else f"{name}[{place + wire.get('offset', 0)}]"
            rank = (not re.search(r"_q$", name), len(name), own)
            if bit not in ranks or rank < ranks[bit]:
                ranks[bit] = rank
    return {bit: rank[2] for bit, rank in ranks.items()}


class Design:
    """A flat module, as JSON has it, to which inputs are added."""

    def __init__(self, module, tree):
        self.module, self.tree = module, tree
        used = [bit for wire in module["netnames"].values() for bit in wire["bits"] if isinstance(bit, int)]
        self.next = max(used) + 1

    def bits(self, count):
        self.next += count
        return list(range(self.next - count, self.next))

    def port(self, name, count):
        """An input, and its bits."""
        bits = self.bits(count)
        self.module["ports"][name] = {"direction": "input", "bits": bits}
        self.module["netnames"][name] = {"hide_name": 0, "bits": bits, "attributes": {}}
        return bits

    def flip_registers(self):
        """[name, module] of each bit of `upset_register`."""
        names = _names(self.module)
        cells = [(name, cell) for name, cell in self.module["cells"].items() if cell["type"] == "$dff"]
        places = [[names.get(bit, "?"), self.tree.module(name)]
                  for name, cell in cells for bit in cell["connections"]["Q"]]
        port = self.port(REGISTERS, max(len(places), WIDE))
        first = 0
        for name, cell in cells:
            data = cell["connections"]["D"]
            width, flipped = len(data), self.bits(len(data))
            self.module["netnames"][f"upset${first}"] = {"hide_name": 1, "bits": flipped, "attributes": {}}
            number = f"{width:032b}"
            self.module["cells"][f"{name}$upset"] = {
                "hide_name": 1, "type": "$xor", "attributes": {},
                "parameters": {"A_SIGNED": "0", "B_SIGNED": "0", "A_WIDTH": number, "B_WIDTH": number,
                               "Y_WIDTH": number},
                "port_directions": {"A": "input", "B": "input", "Y": "output"},
                "connections": {"A": data, "B": port[first:first + width], "Y": flipped}}
            cell["connections"]["D"] = flipped
            first += width
        return places

    def flip_memories(self):
        """Of each bit of `upset_memory` the memory that it chooses."""
        first_bits = {name.rsplit(".", 1)[0]: wire["bits"][0] for name, wire in self.module["netnames"].items()
                      if name.rsplit(".", 1)[-1] == HERE}
        port = self.port(MEMORIES, max(len(first_bits), WIDE))
        driven = dict(zip(first_bits.values(), port))
        for name, width in ((ADDRESS, 32), (BIT, 16)):
            bits = self.port(name, width)
            for own, wire in self.module["netnames"].items():
                if own.rsplit(".", 1)[-1] == name and own != name:
                    driven.update(zip(wire["bits"], bits))
        memories = []
        for memory in first_bits:
            cell = self.module["cells"][f"{memory}.memory_q"]
            memories.append({"name": memory, "module": self.tree.module(f"{memory}."),
                             **{key.lower(): int(cell["parameters"][field], 2)
                                for key, field in (("width", "WIDTH"), ("depth", "SIZE"))}})
        for cell in self.module["cells"].values():
            for pin, bits in cell["connections"].items():
                cell["connections"][pin] = [driven.get(bit, bit) for bit in bits]
        for own in [name for name in self.module["netnames"] if name.rsplit(".", 1)[-1].startswith("upset_")
                    and name not in self.module["ports"]]:
            del self.module["netnames"][own]
        return memories


def write(top, parameters, out):
    """Writes OUT.v and OUT.json. Raises NetlistError."""
    out = pathlib.Path(out).resolve()
    out = without_blanks(out.parent) / out.name
    scratch = out.with_suffix(".flat.json")
    modules, design = flat(top, parameters, scratch)
    module = Design(design["modules"][top], Tree(modules, top))
    table = {"top": top, "parameters": parameters, "memories": module.flip_memories()}
    table["registers"] = module.flip_registers()
    if not table["registers"] or not table["memories"]:
        raise NetlistError(f"{top}: no registers or no memories to flip")
    scratch.write_text(json.dumps(design), encoding="utf-8")
    _yosys([f"read_json {scratch}", "opt_clean -purge", f"write_verilog -noattr {out}"])
    scratch.unlink()
    out.with_suffix(".json").write_text(json.dumps(table) + "\n", encoding="utf-8")
    return table


def main():
    parser = argparse.ArgumentParser(description="Writes a core of which every bit of state can be flipped.")
    parser.add_argument("top")
    parser.add_argument("row", help="of rtl/configurations.csv")
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--parameter", nargs="*", default=[], metavar="NAME=VALUE")
    options = parser.parse_args()
    try:
        row = configurations.find(configurations.read(), options.row)
        more = dict(word.split("=", 1) for word in options.parameter)
        options.out.parent.mkdir(parents=True, exist_ok=True)
        write(options.top, {**features.of_top(options.top, row.parameters), **more}, options.out.resolve())
    except (NetlistError, configurations.TableError, OSError, ValueError) as error:
        print(f"netlist: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
