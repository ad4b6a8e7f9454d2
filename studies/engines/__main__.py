"""make engines: the recorded commands through engines that share no line of code, and X in all of them.

    python studies/engines [--row ROW ...] [--beats N] [--programs FOLDER] [--output FOLDER]

Verilator, Icarus Verilog, yosys' CXXRTL and the mapped netlist of an ECP5 are given the same beats,
and must answer as the bit-true model does. In Icarus everything is X before reset. Writes
FOLDER/reports/engines.json and unknowns.json. The exit status is 1 where an answer differs, something
is X that must be known, a planted fault is not seen or a tool fails.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(1, str(ROOT / "scripts"))

import answers  # noqa: E402  pylint: disable=wrong-import-position
import configurations  # noqa: E402  pylint: disable=wrong-import-position
import icarus  # noqa: E402  pylint: disable=wrong-import-position
import planted  # noqa: E402  pylint: disable=wrong-import-position
import registers  # noqa: E402  pylint: disable=wrong-import-position
import streams  # noqa: E402  pylint: disable=wrong-import-position
import synthesis  # noqa: E402  pylint: disable=wrong-import-position

# One of each format, of few cells.
ROWS = ("basic-fx18-overlapped", "basic-fx32-overlapped", "affine64-fx17-overlapped",
        "basic-fp32-overlapped", "basic-bfp32-overlapped")


def show(what):
    print(f"engines: {what}", file=sys.stderr, flush=True)


def one_engine(options, engine, stream):
    """(row of engines.json, row of unknowns.json or None)"""
    show(f"{stream.row.name}: {engine}")
    unknown = None
    if engine == "icarus":
        got, seconds, unknown = streams.simulate_with_x(stream)
    else:
        got, seconds = streams.simulate(options.programs, engine, stream)
    row = {"engine": engine, "row": stream.row.name, "streams": 1, "beats": stream.beats,
           "results": len(got.results), "mismatches": answers.mismatches(got, stream.wanted),
           "seconds": round(seconds, 1)}
    if unknown is None:
        return row, None
    return row, {"top": streams.TOP, "row": stream.row.name, "clocks": unknown.clocks,
                 "checked": unknown.checked, "unknown": len(unknown.names),
                 "names": list(unknown.names)}


def faults(rows, unknowns):
    """What does not hold, a line each."""
    found = [f"{row['engine']}, {row['row']}: {row['mismatches']} of {row['results']} results or counts "
             "of events differ from the model's" for row in rows if row["mismatches"]]
    found += [f"{row['top']}, {row['row']}: {name}" for row in unknowns for name in row["names"]]
    return found


def work_on(options):
    rows, unknowns = [], []
    for name in options.row:
        row = configurations.find(configurations.read(), name)
        stream = streams.prepare(options.programs, row, options.output / "engines" / name, options.beats)
        for engine in options.engine:
            measured, unknown = one_engine(options, engine, stream)
            rows.append(measured)
            unknowns += [unknown] if unknown else []
    for name, found in (("engines", rows), ("unknowns", unknowns)):
        path = options.output / "reports" / f"{name}.json"
        synthesis.write(path, json.dumps({"rows": found}, indent=2) + "\n")
        print(f"wrote {path}")
    return faults(rows, unknowns)


def main():
    parser = argparse.ArgumentParser(prog="engines", description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--row", action="append", choices=ROWS, help="one or several; all unless given")
    parser.add_argument("--engine", action="append", choices=streams.ENGINES, help="the same")
    parser.add_argument("--beats", type=int, help="of the recording, up to the end of a packet; or all")
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build" / "studies" / "engines")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build",
                        help="folder for answers and reports")
    options = parser.parse_args()
    options.row = options.row or list(ROWS)
    options.engine = options.engine or list(streams.ENGINES)
    options.programs, options.output = options.programs.resolve(), options.output.resolve()
    try:
        found = work_on(options)
    except (answers.AnswerError, configurations.TableError, icarus.SimulationError, planted.PlantError,
            registers.RegisterError, OSError) as error:
        found = [error]
    for fault in found:
        print(f"engines: {fault}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
