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
import statistics
import time
from dataclasses import dataclass

import nextpnr
import rtl
import scan_chain
import synthesis

COLUMNS = ("name", "top", "target", "aim_share", "aim_mhz")
MULTIPLIER = "ffd_clock_multiplier"
CHAINED = "ffd_clock_chain"


@dataclass(frozen=True)
class Device:
    name: str
    options: tuple
    freq: int       # MHz that the router is asked for: more than it reaches
    width: int      # bits of the multiplier that is the measure
    chained: bool   # every port takes a pin, so the block's are on a chain (scan_chain.py)


DEVICES = {
    "ecp5": Device("LFE5U-85F, grade 6",
                   ("--85k", "--package", "CABGA381", "--speed", "6", "--out-of-context",
                    "--placer-heap-timingweight", "20"), 150, 18, False),
    "up5k": Device("iCE40 UP5K", ("--up5k", "--package", "sg48"), 60, 16, True),
}


class PlacementError(Exception):
    """Why something could not be placed, in one line."""


@dataclass(frozen=True)
class Aim:
    """A line of the table: what is placed, and the clock to be reached, if one is set."""

    subject: synthesis.Subject
    share: float  # of the multiplier's clock; None where none is set
    mhz: float    # by itself; None where none is set

    def reached(self, clock):
        """Whether a clock, as Placement.clock gives it, is the one to be reached; None if none is
        set or the measure has not been routed."""
        pairs = ((self.share, clock["fmax_share"]), (self.mhz, clock["fmax_mhz"]))
        judged = [is_ >= aim for aim, is_ in pairs if None not in (aim, is_)]
        return all(judged) if judged else None


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
            wanted = [float(fields[column]) if fields[column] else None for column in COLUMNS[3:]]
        except ValueError as error:
            raise PlacementError(f"{where}: {' and '.join(COLUMNS[3:])} are numbers or empty"
                                 ) from error
        aims.append(Aim(subject, *wanted))
    return aims


def multiplier(width):
    """A registered multiplier, the measure of clocks."""
    return (f"module {MULTIPLIER} (input clk, input signed [{width - 1}:0] a_i, b_i,\n"
            f"  output reg signed [{2 * width - 1}:0] product_o);\n"
            f"  reg signed [{width - 1}:0] a_q, b_q;\n"
            "  always @(posedge clk) begin\n"
            "    a_q <= a_i;\n    b_q <= b_i;\n    product_o <= a_q * b_q;\n  end\nendmodule\n")


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
        words = (own, self.version(target), DEVICES[target])
        if DEVICES[target].chained:
            words += (pathlib.Path(scan_chain.__file__).read_bytes(),)
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
        self._map(name, [*steps, "flatten", "opt_clean"], path, "yosys.log")
        if DEVICES[target].chained:
            self._chain(name, target, top, path)
        mark.write_text(key)
        return path

    def _map(self, name, steps, netlist, log):
        steps = "; ".join([*steps, f"write_json {self._name(netlist)}"])
        nextpnr.call(self.work.processes, [self.work.yosys, "-Q", "-T", "-p", steps],
                     self._file(name, log))

    def _chain(self, name, target, top, netlist):
        """Puts the chain around a netlist."""
        ports = json.loads(netlist.read_text())["modules"][top]["ports"]
        source = self._file(name, "chain.v")
        source.write_text(scan_chain.verilog(CHAINED, top, ports), encoding="utf-8")
        # The cells of the library are read again with their parameters by the target's script.
        self._map(name, [f"read_json {self._name(netlist)}", "delete =A:blackbox",
                         f"read_verilog {self._name(source)}", f"hierarchy -top {CHAINED}",
                         f"script synth/{target}.ys"], netlist, "chain.log")

    def run(self, subject, target, seed):
        """Routes one seed, keeps its result and returns it. Raises NextpnrError."""
        device, start = DEVICES[target], time.monotonic()
        name = self.name(subject, target)
        report = nextpnr.route(
            self.work.processes, target, self._file(name, "netlist"),
            self._file(name, f"{seed}.report"), self._file(name, f"{seed}.log"),
            (*device.options, "--freq", str(device.freq), "--seed", str(seed)))
        result = {"key": self.key(subject, target), "seed": seed,
                  "fmax_mhz": round(nextpnr.clock(report), 2),
                  "critical_path": nextpnr.path_in_words(report),
                  "seconds": round(time.monotonic() - start, 1)}
        synthesis.write(self._file(name, f"{seed}.json"), json.dumps(result) + "\n")
        return result

    def results(self, subject, target):
        """All seeds that are there, in order."""
        try:
            found = [self.result(subject, target, seed) for seed in nextpnr.SEEDS]
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
        measure = self.median(None, subject.target)
        return {"fmax_mhz": fmax, "fmax_share": round(fmax / measure, 3) if measure else None,
                "routed": True,
                "seeds": [{"seed": r["seed"], "fmax_mhz": r["fmax_mhz"]} for r in found]}
