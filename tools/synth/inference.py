"""What yosys makes of the memories and products of a whole core on the families of several vendors.

    python3 -m tools.synth.inference [-j N] [ROW [NAME=NUMBER...]]

Each family is mapped by the command that yosys has for it, as an integrator would without a script of ours, but Gowin:
yosys 0.23 has no multipliers of it, and makes a lattice of flip-flops. `make synth` counts more, by scripts of this
project. Of hwffd_stream in a row of rtl/configurations.csv, with a lattice of up
to 16 points an axis, unless told otherwise. Writes build/reports/inference.json and prints the table.

SPDX-License-Identifier: Apache-2.0
"""

import concurrent.futures
import json
import re
import shutil
import sys
from dataclasses import dataclass

from tools import command_line, whole_file
from tools.progress import Progress
from tools.reports.text_table import Table
from tools.rtl import rtl_sources
from tools.synth import engine
from tools.tables import configurations, features

TOP = "hwffd_stream"
ROW = "cg1-fx18-overlapped"


@dataclass(frozen=True)
class Family:
    """How it is mapped, and which of its cells are multipliers, block memories and memories of logic."""

    name: str
    command: str
    multipliers: str
    blocks: str
    small: str


FAMILIES = (
    Family("Xilinx 7", "synth_xilinx -family xc7 -noiopad -noclkbuf -top", "DSP48E1", "RAMB(18|36)E1", r"RAM\d+\w+"),
    Family("Intel Cyclone V", "synth_intel_alm -family cyclonev -top", r"MISTRAL_MUL\w+", "MISTRAL_M10K", "MISTRAL_MLAB"),
    Family("Gowin GW2A", "script synth/gowin.ys", r"MULT\w+", r"(SDPX?9?B|SDPB|DPB|SPX?9?)", r"RAM16S\w+"),
    Family("Lattice ECP5", "synth_ecp5 -top", "MULT18X18D", r"(DP16KD|PDPW16KD)", "TRELLIS_DPR16X4"),
    Family("Lattice iCE40 UP5K", "synth_ice40 -dsp -top", "SB_MAC16", r"SB_RAM40_4K\w*", "no such cell"),
)
_CELL = re.compile(r"^ +(\w+) +(\d+)$", re.MULTILINE)


class InferenceError(Exception):
    """What could not be mapped, in one line."""


def counted(family, printed):
    """{kind of cell: how many} of multipliers, blocks and small memories, of what yosys' `stat` printed of the whole."""
    whole = printed.rpartition("=== design hierarchy ===")[2] or printed
    cells = {name: int(count) for name, count in _CELL.findall(whole)}
    return {kind: {name: count for name, count in cells.items() if re.fullmatch(getattr(family, kind), name)}
            for kind in ("multipliers", "blocks", "small")}


def mapped(root, family, top, parameters):
    """The counts of a top on a family. Raises InferenceError."""
    sources = rtl_sources.Sources(root)
    status, printed = rtl_sources.run(["yosys", "-Q", "-T", "-p", "; ".join((
        *rtl_sources.elaboration(sources, top, parameters), "flatten",
        family.command + (f" {top}" if family.command.endswith("-top") else ""), "stat"))], root)
    if status:
        last = next((line for line in printed.splitlines() if "ERROR" in line), "yosys failed")
        raise InferenceError(f"{top} for {family.name}: {last}")
    return counted(family, printed[printed.rindex("=== "):])


def table(rows):
    def cell(cells):
        return ", ".join(f"{count} {name}" for name, count in sorted(cells.items())) or "-"

    return Table(["family", "multipliers", "block memories", "memories of logic"],
                 [[row["family"], cell(row["multipliers"]), cell(row["blocks"]), cell(row["small"])] for row in rows])


def work(options, root):
    if not shutil.which("yosys"):
        raise engine.EngineError("yosys not found: run tools/install engine")
    row = configurations.find(configurations.read(root / "rtl" / "configurations.csv"), options.row)
    parameters = {**features.of_top(TOP, row.parameters), **command_line.assignments(options.parameters)}
    progress, rows = Progress(), []
    with concurrent.futures.ThreadPoolExecutor(max(1, options.jobs)) as pool:
        results = pool.map(lambda family: mapped(root, family, TOP, parameters), FAMILIES)
        for family, counts in zip(FAMILIES, results):
            rows.append({"family": family.name, "command": family.command, **counts})
            progress.step(len(rows), len(FAMILIES), "mapped")
    progress.end()
    reports = root / "build" / "reports"
    reports.mkdir(parents=True, exist_ok=True)
    whole_file.write(reports / "inference.json", json.dumps(
        {"top": TOP, "row": row.name, "parameters": parameters, "rows": rows}, indent=2) + "\n")
    print(table(rows).text())
    return 0


def main():
    parser = command_line.Parser(prog="inference")
    parser.add_argument("row", nargs="?", default=ROW, help=f"row of rtl/configurations.csv; {ROW} if none")
    parser.add_argument("parameters", nargs="*", metavar="NAME=NUMBER", help="other parameters of the top")
    return command_line.run(parser, work, (InferenceError, engine.EngineError, configurations.TableError))


if __name__ == "__main__":
    sys.exit(main())
