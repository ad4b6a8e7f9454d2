"""What `make pnr` places and routes: rows of synth/clocks.csv, several seeds each.

Every row's netlist is the one that `make synth` counts, flattened. The measure of a target is one
registered multiplier, routed by the same programs with the same seeds: a row's share is its median
clock in parts of the multiplier's. Results lie in build/pnr/, one file a seed, and stay good as
long as sources, steps and programs are the same.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import hashlib
import json
import os
import pathlib
import re
import statistics
import time
from dataclasses import dataclass

import nextpnr
import rtl
import synthesis

SEEDS = (1, 2, 3)
COLUMNS = ("name", "top", "target", "aim_share", "aim_mhz")
CLOCKS = ("clk", "aclk")
MULTIPLIER = "ffd_clock_multiplier"


@dataclass(frozen=True)
class Device:
    name: str
    options: tuple
    freq: int       # MHz that the router is asked for: more than it reaches
    width: int      # bits of the multiplier that is the measure; 0: the device has none


DEVICES = {
    "ecp5": Device("LFE5U-85F, grade 6", ("--85k", "--package", "CABGA381", "--speed", "6"), 150, 18),
    "up5k": Device("iCE40UP5K", ("--up5k", "--package", "sg48"), 60, 16),
    "hx8k": Device("iCE40HX8K", ("--hx8k", "--package", "ct256"), 150, 0),
}


class PlacementError(Exception):
    """Why something could not be placed, in one line."""


@dataclass(frozen=True)
class Aim:
    """A line of the table: what is placed, and the clock to be reached, if one is set."""

    subject: synthesis.Subject
    share: float
    mhz: float


def read(path, found):
    """The lines of synth/clocks.csv, as subjects among `found`. Raises PlacementError."""
    by_key = {(s.row.name, s.top, s.target): s for s in found}
    try:
        lines = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise PlacementError(f"{path}: cannot be read: {error}") from error
    table = csv.DictReader(lines)
    if tuple(table.fieldnames or ()) != COLUMNS:
        raise PlacementError(f"{path}:1: the first line must be {','.join(COLUMNS)}")
    aims = []
    for fields in table:
        where = f"{path}:{table.line_num}"
        if None in fields or None in fields.values():
            raise PlacementError(f"{where}: {len(COLUMNS)} columns wanted")
        subject = by_key.get((fields["name"], fields["top"], fields["target"]))
        if subject is None or subject.target not in DEVICES:
            raise PlacementError(f"{where}: {fields['name']}, {fields['top']}, {fields['target']} "
                                 "is not mapped by make synth, or has no router")
        try:
            share, mhz = (float(fields[c]) if fields[c] else None for c in COLUMNS[3:])
        except ValueError as error:
            raise PlacementError(f"{where}: aim_share and aim_mhz are numbers or empty") from error
        aims.append(Aim(subject, share, mhz))
    return aims


def multiplier(width):
    """A registered multiplier, the measure of clocks."""
    return (f"module {MULTIPLIER} (input clk, input signed [{width - 1}:0] a_i, b_i,\n"
            f"  output reg signed [{2 * width - 1}:0] product_o);\n"
            f"  reg signed [{width - 1}:0] a_q, b_q;\n"
            "  always @(posedge clk) begin\n"
            "    a_q <= a_i;\n    b_q <= b_i;\n    product_o <= a_q * b_q;\n  end\nendmodule\n")


def fold_pins(netlist, top):
    """Gives an iCE40 netlist few pins: a chain of flip-flops feeds the inputs, another, with the
    exclusive or of each output, takes the outputs. So all paths of a block are between registers.
    """
    module = netlist["modules"][top]
    fresh = 1 + max(bit for net in module["netnames"].values() for bit in net["bits"]
                    if isinstance(bit, int))
    clock = next(port["bits"][0] for name, port in module["ports"].items() if name in CLOCKS)
    cells, first = module["cells"], fresh

    def add(kind, number, parameters, connections):
        cells[f"fold_{kind}_{number}"] = {
            "hide_name": 0, "type": kind, "parameters": parameters, "attributes": {},
            "port_directions": {pin: "output" if pin in "QO" else "input" for pin in connections},
            "connections": {pin: [bit] for pin, bit in connections.items()}}

    def bits(direction):
        return [bit for name, port in module["ports"].items() if port["direction"] == direction
                and name not in CLOCKS for bit in port["bits"] if isinstance(bit, int)]

    before, number, fresh = fresh, 0, fresh + 1
    for bit in bits("input"):
        add("SB_DFF", number, {}, {"C": clock, "D": before, "Q": bit})
        before, number = bit, number + 1
    for bit in bits("output"):
        add("SB_LUT4", number, {"LUT_INIT": "0110" * 4},
            {"I0": bit, "I1": before, "I2": "0", "I3": "0", "O": fresh})
        add("SB_DFF", number, {}, {"C": clock, "D": fresh, "Q": fresh + 1})
        before, number, fresh = fresh + 1, number + 1, fresh + 2
    clock_name = next(name for name in module["ports"] if name in CLOCKS)
    module["ports"] = {clock_name: module["ports"][clock_name],
                       "fold_i": {"direction": "input", "bits": [first]},
                       "fold_o": {"direction": "output", "bits": [before]}}
    return netlist


def _place(cell):
    """The registers or the block that a cell belongs to, as named in the sources."""
    cell = re.sub(r"genblk\d+\.|gen_\w+(\[\d+\])?\.", "", cell)
    cell = re.sub(r"_(TRELLIS_FF|LUT4|CCU2C|PFUMX|L6MUX21|SB_\w+|MULT18X18D)_.*", "", cell)
    return re.sub(r"\.\d+(\.\d+)*(_\w+)?$|\$.*$", "", cell)


def path_in_words(report):
    """The critical path between registers: from, to, levels, and what logic and wires take."""
    for path in report["critical_paths"]:
        steps = path["path"]
        if "async" in path["from"] or "async" in path["to"] or not steps:
            continue
        logic = [step for step in steps if step["type"] == "logic"]
        wires = sum(step["delay"] for step in steps if step["type"] == "routing")
        total = sum(step["delay"] for step in steps)
        levels = sum(1 for step in logic if step["delay"] > 0.1)
        return (f"{_place(steps[0]['from']['cell'])} to {_place(steps[-1]['to']['cell'])}: "
                f"{levels} levels, {total - wires:.1f} ns of logic, {wires:.1f} ns of wires")
    return ""


class Placement:
    """Places and routes in one checkout; results lie in build/pnr/, one file a seed."""

    def __init__(self, work):
        self.work, self.root = work, work.root
        self.folder = self.root / "build" / "pnr"
        self._versions = {}

    def version(self, target):
        family = nextpnr.FAMILIES[target]
        if target not in self._versions:
            program = nextpnr.find(self.root, family.route, family)
            self._versions[target] = rtl.run([program, "--version"])[1].strip()
        return self._versions[target]

    def _name(self, path):
        return os.path.relpath(path, self.root)

    def key(self, subject, target):
        """Of a subject, or of the measure where there is none."""
        own = self.work.key(subject) if subject else multiplier(DEVICES[target].width)
        words = (own, self.version(target), DEVICES[target],
                 pathlib.Path(__file__).read_text(encoding="utf-8"))
        return hashlib.sha256(repr(words).encode()).hexdigest()

    def _file(self, name, suffix):
        return self.folder / f"{name}.{suffix}"

    @staticmethod
    def name(subject, target):
        return subject.name if subject else f"{MULTIPLIER}.{target}"

    def result(self, subject, target, seed):
        """A routed seed, if its sources and programs are the present ones; else None."""
        try:
            found = json.loads(self._file(self.name(subject, target), f"{seed}.json").read_text())
        except (OSError, ValueError):
            return None
        return found if found.get("key") == self.key(subject, target) else None

    def netlist(self, subject, target):
        """The flat netlist of a subject or of the measure, made if it is not there."""
        name, key = self.name(subject, target), self.key(subject, target)
        path, mark = self._file(name, "netlist"), self._file(name, "key")
        if path.is_file() and mark.is_file() and mark.read_text() == key:
            return path
        self.folder.mkdir(parents=True, exist_ok=True)
        if subject:
            top, steps = subject.top, self.work.script(subject)
        else:
            source = self._file(name, "v")
            source.write_text(multiplier(DEVICES[target].width), encoding="utf-8")
            top = MULTIPLIER
            steps = [f"read_verilog {self._name(source)}", f"hierarchy -check -top {top}",
                     f"script synth/{target}.ys"]
        steps = [*steps, "flatten", "opt_clean", f"write_json {self._name(path)}"]
        nextpnr.call(self.work.processes, [self.work.yosys, "-Q", "-T", "-p", "; ".join(steps)],
                     self._file(name, "yosys.log"))
        if not nextpnr.FAMILIES[target].block:
            path.write_text(json.dumps(fold_pins(json.loads(path.read_text()), top)))
        mark.write_text(key)
        return path

    def run(self, subject, target, seed):
        """Routes one seed, keeps its result and returns it. Raises NextpnrError."""
        device, start = DEVICES[target], time.monotonic()
        name = self.name(subject, target)
        report = nextpnr.route(
            self.work.processes, target, self._file(name, "netlist"),
            self._file(name, f"{seed}.report"), self._file(name, f"{seed}.log"),
            (*device.options, *nextpnr.FAMILIES[target].block, "--freq", str(device.freq),
             "--seed", str(seed)))
        result = {"key": self.key(subject, target), "seed": seed,
                  "fmax_mhz": round(nextpnr.clock(report), 2),
                  "critical_path": path_in_words(report),
                  "seconds": round(time.monotonic() - start, 1)}
        synthesis.write(self._file(name, f"{seed}.json"), json.dumps(result) + "\n")
        return result

    def results(self, subject, target):
        """All seeds that are there, in order."""
        try:
            found = [self.result(subject, target, seed) for seed in SEEDS]
        except nextpnr.NextpnrError:
            return []
        return [result for result in found if result]

    def median(self, subject, target):
        """MHz, or None."""
        found = self.results(subject, target)
        return statistics.median(result["fmax_mhz"] for result in found) if found else None

    def clock(self, subject):
        """What is known of a subject's clock after routing, as in synth.json; None if nothing."""
        if subject.target not in DEVICES:
            return None
        found = self.results(subject, subject.target)
        if not found:
            return None
        fmax = self.median(subject, subject.target)
        measure = DEVICES[subject.target].width and self.median(None, subject.target)
        return {"fmax_mhz": fmax, "fmax_share": round(fmax / measure, 3) if measure else None,
                "routed": True,
                "seeds": [{"seed": r["seed"], "fmax_mhz": r["fmax_mhz"]} for r in found]}
