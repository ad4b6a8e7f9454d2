"""make -C lab engines: the recorded commands through simulators of others, and what X does there.

    python3 -m lab.engines [--row ROW ...] [--beats N] [--programs FOLDER] [--output FOLDER]

Verilator, Icarus Verilog, yosys' CXXRTL and the mapped netlist of an ECP5 are given the same beats,
and must answer as the bit-true model does. In Icarus everything is X before reset: in hwffd_stream,
in its gates, and in hwffd_axi. Faults are planted in each of them. Writes FOLDER/reports/engines.json
and unknowns.json. The exit status is 1 where an answer differs, something is X that must be known, a
fault is not found or a tool fails.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import json
import pathlib
import sys

from lab.engines import answers, axi, icarus, measured, planted, registers, streams
from tools import command_line, whole_file
from tools.project_root import ROOT
from tools.tables import configurations

# One of each format, of few cells. Programs with a fault are built of the first.
ROWS = ("basic-fx18-overlapped", "basic-fx32-overlapped", "affine64-fx17-overlapped",
        "basic-fp32-overlapped", "basic-bfp32-overlapped")
PLANTED_BEATS = 600  # of the recording
GATE_BEATS = 1500  # all that a recording has before its packets in any order, and some of those
FAULTS = (answers.AnswerError, axi.AxiError, configurations.TableError, icarus.SimulationError,
          planted.PlantError, registers.RegisterError)


def reports(options):
    """What goes into each report."""
    collected = measured.Reports()
    table = configurations.read()
    for name in options.row:
        row = configurations.find(table, name)
        folder = options.output / "engines" / name
        collected.measure(options.programs, streams.prepare(options.programs, row, folder, options.beats))
        collected.measure_gates(streams.prepare(options.programs, row, folder.with_name(f"{name}-gates"),
                                                min(GATE_BEATS, options.beats or GATE_BEATS)))
        if name == ROWS[0]:
            collected.plant(options.programs, streams.prepare(
                options.programs, row, folder.with_name(f"{name}{streams.PLANTED}"), PLANTED_BEATS))
    return collected


def work_on(options):
    """What does not hold, a line each."""
    collected = reports(options)
    for name, report in (("engines", collected.engines), ("unknowns", collected.unknowns)):
        path = options.output / "reports" / f"{name}.json"
        whole_file.write(path, json.dumps(report, indent=2) + "\n")
        print(f"wrote {path}")
    return measured.faults(collected.engines, collected.unknowns)


def main():
    parser = argparse.ArgumentParser(prog="engines", description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--row", action="append", choices=ROWS, help="one or several; all unless given")
    parser.add_argument("--beats", type=int, help="of the recording, up to the end of a packet; or all")
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build" / "lab" / "engines")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build",
                        help="folder for answers and reports")
    options = parser.parse_args()
    options.row = options.row or list(ROWS)
    options.programs, options.output = options.programs.resolve(), options.output.resolve()
    return command_line.measured(parser.prog, lambda: work_on(options), FAULTS)


if __name__ == "__main__":
    sys.exit(main())
