"""Synthesizes, places and routes the boards of synth/boards/boards.csv, and packs their bitstreams.

Each board's files go to build/boards/<board>/. Prints what of the chip is used and the clock after
routing, and writes those of this run to build/reports/boards.json. The exit status is 1 if a step
fails or the clock of the board is not met, 2 if the request makes no sense.

SPDX-License-Identifier: Apache-2.0
"""

import json
import sys

from tools import command_line, csv_table, whole_file
from tools.synth import boards, engine, nextpnr
from tools.tables import configurations


def text(result):
    """A board's result in a line, and a line a resource."""
    met = "met" if result["met"] else "NOT MET"
    lines = [f"{result['board']}: {result['row']}: {result['fmax_mhz']:.1f} MHz after routing, "
             f"{result['clock_mhz']:g} wanted: {met}"]
    if len(result["seeds"]) > 1:
        lines.append(f"  seed {result['seed']} of {len(result['seeds'])}, whose median is "
                     f"{result['median_mhz']:.1f} MHz")
    lines.append(f"  {result['critical_path']}")
    for name, (used, available) in result["used"].items():
        lines.append(f"  {name:<14}{used:>7,} of {available:>6,}  {100 * used / available:5.1f} %")
    return "\n".join(lines)


def run(flow, wanted, jobs):
    """Builds what is not there: {board: complaint}. Raises EngineError."""
    files, complaints = {}, {}
    for board in wanted:
        try:
            files[board.name] = [flow.bitstream(board)]
        except nextpnr.NextpnrError as error:
            complaints[board.name] = str(error)
    return {**complaints, **engine.run(flow.root, "boards", files, jobs)}


def work(options, root):
    by_name = boards.read(root / "synth" / "boards" / "boards.csv",
                          configurations.read(root / "rtl" / "configurations.csv"))
    if options.board is not None and options.board not in by_name:
        raise command_line.Request(f"unknown BOARD '{options.board}': one of {', '.join(by_name)}")
    wanted = [by_name[options.board]] if options.board else list(by_name.values())
    flow, results = boards.Flow(root, (options.seed,) if options.seed else nextpnr.SEEDS), []
    complaints = run(flow, wanted, options.jobs)
    for board in wanted:
        if board.name in complaints:
            print(f"boards: {board.name}: {complaints[board.name]}", file=sys.stderr)
            continue
        results.append(flow.result(board))
        print(text(results[-1]), flush=True)
        print(f"  wrote {results[-1]['bitstream']}", flush=True)
    short = [f"{board}: {complaint}" for board, complaint in complaints.items()]
    short += [f"{result['board']}: the clock is not met" for result in results if not result["met"]]
    whole_file.write(root / "build" / "reports" / "boards.json",
                     json.dumps({"boards": results, "short": short}, indent=2) + "\n")
    print("wrote build/reports/boards.json")
    return 1 if short else 0


if __name__ == "__main__":
    parser = command_line.Parser(prog="boards", description="Builds the bitstreams of boards.")
    parser.add_argument("--board", help="this one only")
    parser.add_argument("--seed", type=int, help="of the placement; the fastest of several")
    sys.exit(command_line.run(parser, work, (csv_table.TableError, engine.EngineError)))
