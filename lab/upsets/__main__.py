"""make -C lab upsets: single bits of registers and memories flip while traffic runs, and what becomes of each.

    python3 -m lab.upsets [--programs FOLDER] [--designs FOLDER] [--output FOLDER] [--core NAME ...]
                          [--flips N] [--seed N] [-j JOBS] [--part FILE | --join FILE ...]

Each core of CORES runs N times with a flip in a register and N times with one in a memory, at a bit and
a clock that are as likely as any other. Writes FOLDER/reports/upsets.json. The exit status is 1 where
nothing was flipped, a run failed, or a hardened core hangs for good or writes where it may not. What
HARDENED costs in LUTs stands in the report, too. A part is both cores of a top; joined, the parts of all
tops are the report.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import sys

from lab.upsets import cost, counted
from lab.upsets.cores import CORES, KINDS
from tools import command_line
from tools.project_root import ROOT
from tools.synth import partial_reports

ROW = "basic-fx18-overlapped"
FLIPS = 9604  # a share is known to 1 % with a confidence of 95 %, whatever it is


def flipped(options):
    """(rows, modules) of the report."""
    rows, modules = [], []
    for name in options.core:
        top, hardened = CORES[name]
        for kind in KINDS:
            print(f"upsets: {name}: {options.flips} flips in {kind}", file=sys.stderr, flush=True)
            run = counted.Run(options.programs / f"hwffd-upsets-{name}", ROW,
                              options.designs / f"{name}.json", kind,
                              options.output / "upsets" / f"{name}-{kind}.csv")
            flips = counted.flips(run, options.flips, options.seed, options.jobs)
            what = {"top": top, "hardened": hardened, "bits": kind}
            rows.append({**what, "of": flips.bits(kind), "clocks": flips.clocks,
                         **counted.row(flips.lines)})
            modules += [{**what, "module": module, **counted.row(lines)}
                        for module, lines in counted.by_module(flips.lines)]
    return rows, modules


def faults(rows):
    """What does not hold, a line each."""
    return [f"{row['top']}, hardened, {row['bits']}: {row[outcome]} flips end in {outcome}"
            for row in rows if row["hardened"] for outcome in counted.FORBIDDEN if row[outcome]]


def measured(options):
    """The report of the cores that are asked for."""
    rows, modules = flipped(options)
    print("upsets: what HARDENED costs", file=sys.stderr, flush=True)
    prices = cost.rows(ROW, list(dict.fromkeys(CORES[name][0] for name in options.core)), options.jobs)
    return {"row": ROW, "seed": options.seed, "rows": rows, "modules": modules, "cost": prices}


def joined(paths):
    """The report of parts that have every core once. Raises PartError."""
    parts = partial_reports.read(paths, ("row", "seed", "rows", "modules", "cost"))
    rows = partial_reports.rows(parts)
    have = [(row["top"], row["hardened"], row["bits"]) for row in rows]
    if sorted(have) != sorted((*core, kind) for core in CORES.values() for kind in KINDS):
        raise partial_reports.PartError(f"parts have {len(have)} rows, not each kind of bits of each core once: "
                                        f"measure a part of each top, {' and '.join(CORES)}")
    partial_reports.same(rows, "flips")
    return {"row": partial_reports.same(parts, "row"), "seed": partial_reports.same(parts, "seed"), "rows": rows,
            "modules": partial_reports.rows(parts, "modules"), "cost": partial_reports.rows(parts, "cost")}


def work_on(options):
    report = joined(options.join) if options.join else measured(options)
    path = options.part or options.output / "reports" / "upsets.json"
    partial_reports.write(path, report)
    print(f"wrote {path}")
    return [] if options.part else faults(report["rows"])


def main():
    parser = argparse.ArgumentParser(prog="upsets", description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build" / "lab" / "upsets")
    parser.add_argument("--designs", type=pathlib.Path, default=ROOT / "build" / "lab" / "product" / "upsets")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build")
    parser.add_argument("--core", action="append", choices=CORES, help="one or several; all unless given")
    parser.add_argument("--flips", type=int, default=FLIPS, help="of each core and kind of bits")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-j", "--jobs", type=int, default=1, help="runs side by side")
    partial_reports.add_options(parser)
    options = parser.parse_args()
    options.core = options.core or list(CORES)
    for name in ("programs", "designs", "output"):
        setattr(options, name, getattr(options, name).resolve())
    return command_line.measured(parser.prog, lambda: work_on(options), (counted.UpsetError, partial_reports.PartError))


if __name__ == "__main__":
    sys.exit(main())
