"""The boards of synth/boards/boards.csv and the way from RTL to their bitstreams.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import os
import pathlib
import statistics
from dataclasses import dataclass

import configurations
import nextpnr
import rtl
from nextpnr import FAMILIES, NextpnrError
from processes import Processes

COLUMNS = ("name", "row", "target", "device", "package", "clock_mhz", "baud")


class BoardError(Exception):
    """Why a board could not be built, in one line."""


@dataclass(frozen=True)
class Board:
    name: str
    row: configurations.Configuration
    target: str
    device: str
    package: str
    clock_mhz: float
    baud: int

    @property
    def top(self):
        return f"ffd_board_{self.name}"

    @property
    def parameters(self):
        """Those of the row, and the clocks of a bit."""
        return {**self.row.parameters, "CLOCKS": round(self.clock_mhz * 1e6 / self.baud)}


def read(path, rows):
    """name -> Board. Raises BoardError, TableError."""
    try:
        lines = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise BoardError(f"{path}: cannot be read: {error}") from error
    table = csv.DictReader(lines)
    if tuple(table.fieldnames or ()) != COLUMNS:
        raise BoardError(f"{path}:1: the first line must be {','.join(COLUMNS)}")
    found = {}
    for fields in table:
        where = f"{path}:{table.line_num}"
        if None in fields.values() or None in fields:
            raise BoardError(f"{where}: {len(COLUMNS)} columns wanted")
        if fields["target"] not in FAMILIES:
            raise BoardError(f"{where}: no tools for target '{fields['target']}': one of "
                             f"{', '.join(FAMILIES)}")
        try:
            numbers = {"clock_mhz": float(fields["clock_mhz"]), "baud": int(fields["baud"])}
        except ValueError as error:
            raise BoardError(f"{where}: clock_mhz and baud are numbers") from error
        row = configurations.find(rows, fields["row"])
        found[fields["name"]] = Board(**{**fields, **numbers, "row": row})
    return found


class Flow:
    """From RTL to bitstreams, in build/boards/<board>/; each step has its log there."""

    def __init__(self, root, seeds=nextpnr.SEEDS):
        self.root, self.seeds = pathlib.Path(root), seeds
        self.sources = rtl.Sources(self.root)
        self.processes = Processes(self.root)

    def build(self, board):
        """All steps, the fastest seed packed; what of the chip is used, and the clocks. Raises
        NextpnrError.
        """
        folder = self.root / "build" / "boards" / board.name
        folder.mkdir(parents=True, exist_ok=True)
        family = FAMILIES[board.target]
        bitstream = folder / f"{board.name}.{family.bitstream}"
        netlist = self.synthesize(board, folder)
        reports = {seed: self.route(board, netlist, folder, seed) for seed in self.seeds}
        clocks = {seed: nextpnr.clock(report) for seed, report in reports.items()}
        best = max(clocks, key=clocks.get)
        nextpnr.call(self.processes, [
            nextpnr.find(self.root, family.pack, family), *family.pack_options,
            self._name(self._placed(board, folder, best)), self._name(bitstream)],
            folder / "pack.log")
        report = reports[best]
        return {
            "board": board.name, "row": board.row.name, "target": board.target,
            "clock_mhz": board.clock_mhz, "fmax_mhz": round(clocks[best], 2), "seed": best,
            "median_mhz": round(statistics.median(clocks.values()), 2),
            "seeds": [{"seed": seed, "fmax_mhz": round(clock, 2)}
                      for seed, clock in clocks.items()],
            "critical_path": nextpnr.path_in_words(report), "met": clocks[best] >= board.clock_mhz,
            "used": {name: [about["used"], about["available"]]
                     for name, about in report["utilization"].items() if about["used"]},
            "bitstream": self._name(bitstream), "bytes": bitstream.stat().st_size,
        }

    def synthesize(self, board, folder):
        """The netlist."""
        netlist = folder / "netlist.json"
        files = [self._name(path) for path in self.sources.needed(board.top)]
        folders = "".join(f"-I {self._name(path)} " for path in self.sources.includes)
        parameters = "".join(f" -chparam {name} {value}"
                             for name, value in board.parameters.items())
        steps = [
            f"read_verilog {folders}" + " ".join(files),
            f"hierarchy -check -top {board.top}{parameters}",
            "script synth/prepare.ys",
            f"script synth/{board.target}.ys",
            "script synth/verify.ys",
            f"write_json {self._name(netlist)}",
        ]
        nextpnr.call(self.processes, ["yosys", "-Q", "-T", "-p", "; ".join(steps)],
                     folder / "synthesis.log")
        return netlist

    @staticmethod
    def _placed(board, folder, seed):
        return folder / f"{board.name}.{seed}.{FAMILIES[board.target].placed}"

    def route(self, board, netlist, folder, seed):
        """Places and routes; what the router reports."""
        family = FAMILIES[board.target]
        pins = self.root / "synth" / "boards" / board.name / f"{board.name}.{family.pins}"
        return nextpnr.route(
            self.processes, board.target, netlist, folder / f"{seed}.report",
            folder / f"route.{seed}.log",
            (f"--{board.device}", "--package", board.package, family.pins_option,
             self._name(pins), family.placed_option,
             self._name(self._placed(board, folder, seed)), "--freq", f"{board.clock_mhz:g}",
             "--seed", str(seed)))

    def _name(self, path):
        return os.path.relpath(path, self.root)
