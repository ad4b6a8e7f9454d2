"""The boards of synth/boards/boards.csv and the way from RTL to their bitstreams.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import shutil
import statistics
from dataclasses import dataclass

from tools import csv_table
from tools.rtl import digest
from tools.synth import nextpnr, synthesis
from tools.synth.nextpnr import FAMILIES
from tools.tables import configurations

COLUMNS = ("name", "row", "target", "device", "package", "clock_mhz", "baud")


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
    """name -> Board. Raises TableError."""
    by_name = {}
    for where, fields in csv_table.read(path, COLUMNS):
        if fields["target"] not in FAMILIES:
            raise csv_table.TableError(f"{where}: no tools for target '{fields['target']}': one of "
                                       f"{', '.join(FAMILIES)}")
        try:
            numbers = {"clock_mhz": float(fields["clock_mhz"]), "baud": int(fields["baud"])}
        except ValueError as error:
            raise csv_table.TableError(f"{where}: clock_mhz and baud are numbers") from error
        row = configurations.find(rows, fields["row"])
        by_name[fields["name"]] = Board(**{**fields, **numbers, "row": row})
    return by_name


class Flow:
    """From RTL to bitstreams, in build/boards/<board>/; names of files have the key of what they
    depend on."""

    def __init__(self, root, seeds=nextpnr.SEEDS):
        self.root, self.seeds = pathlib.Path(root), seeds
        self.work = synthesis.Synthesis(root)

    @staticmethod
    def _steps(board):
        parameters = "".join(f" -chparam {name} {value}"
                             for name, value in board.parameters.items())
        return [f"hierarchy -check -top {board.top}{parameters}", "script synth/prepare.ys",
                f"script synth/{board.target}.ys", "script synth/verify.ys"]

    def script(self, board):
        """The steps of yosys, with files named from the root. They end before the netlist."""
        return [self.work.read(board.top, board.target), *self._steps(board)]

    def pins(self, board):
        return (self.root / "synth" / "boards" / board.name
                / f"{board.name}.{FAMILIES[board.target].pins}")

    def options(self, board):
        """Of the router, which works in build/, but for the seed and the files that it writes. The path is
        relative: YoWASP's programs have a /tmp of their own."""
        pins = os.path.relpath(self.pins(board), self.root / "build")
        return (f"--{board.device}", "--package", board.package, "--freq", f"{board.clock_mhz:g}",
                FAMILIES[board.target].pins_option, pins)

    def pack(self, board):
        """The packer with its options. Raises NextpnrError."""
        family = FAMILIES[board.target]
        return [nextpnr.find(self.root, family.pack, family), *family.pack_options]

    def key(self, board):
        """Of sources, steps, pins and programs. Raises NextpnrError."""
        router, (packer, *packing) = nextpnr.version(self.root, board.target), self.pack(board)
        return digest.of(self.work.design(board.top, board.target, self._steps(board)), router,
                         digest.lines(self.pins(board)), pathlib.Path(packer).name, *packing,
                         board.device, board.package, str(board.clock_mhz))

    def stem(self, board):
        """What the names of all its files begin with. Raises NextpnrError."""
        return self.root / "build" / "boards" / board.name / f"{board.name}.{self.key(board)}"

    def bitstream(self, board):
        """Of the fastest of the seeds."""
        seeds = "-".join(map(str, self.seeds))
        return pathlib.Path(f"{self.stem(board)}.{seeds}.bitstream")

    def result(self, board):
        """What of the chip is used, and the clocks, once the bitstream is there; it is copied to where
        a user looks for it."""
        reports = {seed: json.loads(pathlib.Path(f"{self.stem(board)}.{seed}.report").read_text())
                   for seed in self.seeds}
        clocks = {seed: nextpnr.clock(report) for seed, report in reports.items()}
        best = fastest(clocks)
        suffix = FAMILIES[board.target].bitstream
        bitstream = self.root / "build" / "boards" / board.name / f"{board.name}.{suffix}"
        shutil.copyfile(self.bitstream(board), bitstream)
        return {
            "board": board.name, "row": board.row.name, "target": board.target,
            "clock_mhz": board.clock_mhz, "fmax_mhz": round(clocks[best], 2), "seed": best,
            "median_mhz": round(statistics.median(clocks.values()), 2),
            "seeds": [{"seed": seed, "fmax_mhz": round(clock, 2)}
                      for seed, clock in clocks.items()],
            "critical_path": nextpnr.path_in_words(reports[best]),
            "met": clocks[best] >= board.clock_mhz,
            "used": {name: [about["used"], about["available"]]
                     for name, about in reports[best]["utilization"].items() if about["used"]},
            "bitstream": os.path.relpath(bitstream, self.root), "bytes": bitstream.stat().st_size,
        }


def fastest(clocks):
    """The seed with the highest clock, the first of several."""
    return max(clocks, key=clocks.get)
