"""make -C lab align: hwffd and programs of others align the same pairs of volumes, each with its truth.

    python3 -m lab.align [--runs N] [--minutes N] [--pair N ...] [--program N ...] [--output FOLDER]

Each run is a process of its own on one core; runs of the programs take turns, and the median counts. A program that
takes longer than a minute runs once, and one that can be stopped is, after --minutes. On the last pair, the smallest,
all run again with 1, 2 and 5 threads and their fields are compared bit by bit; those of hwffd also with the
module that clang has built, where that is. Writes FOLDER/reports/align.json. A program that is not installed stands there with the reason.
With --program some are measured, and what the report has of others stays.
The exit status is 1 where something was not measured or is worse than before. A missed aim is reported as missed.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import json
import os
import pathlib
import sys

from lab.align import core, from_source, pairs, programs, report, run
from lab.compare import joined
from tools import command_line, whole_file
from tools.project_root import ROOT
from tools.reports.results import RequestError, Results, released

# (makes a pair, the spacing of its control points), with two levels each; the last is for bits and slow programs.
PAIRS = ((lambda: pairs.phantom_pair(96), 16), (lambda: pairs.phantom_pair(96, pairs.NOISE), 16), (pairs.scan_pair, 8),
         (lambda: pairs.phantom_pair(48, pairs.NOISE), 8))
LEVELS, ITERATIONS = 2, 50
BITS_ITERATIONS = 10  # of the runs whose bits are compared: all programs end by themselves
THREADS = (1, 2, 5)
LONG = 60  # seconds of a run, after which it is the only one
MODULE, BY_CLANG = (ROOT / "build" / name / "product" / "api" / "python" for name in ("lab", "lab-clang"))


def show(what):
    print(f"align: {what}", file=sys.stderr, flush=True)


class Study:
    """Runs programs and collects what the report has."""

    def __init__(self, options):
        self.options = options
        self.folder = options.output / "align"
        self.programs = {program: report.of_program(program) for program in programs.PROGRAMS}
        self.report = {"processor": joined.processor(), "iterations": ITERATIONS, "budget_s": 60 * options.minutes,
                       "programs": list(self.programs.values()), "pairs": [], "rows": [], "bits": [], "failed": []}

    def run(self, program, pair, spacing, threads=1, module=MODULE, iterations=ITERATIONS):
        """(row, field), or None where the program is absent or fails, which the report then says."""
        entry = self.programs[program]
        if entry["absent"]:
            return None
        job = programs.Job(pair.fixed, pair.moving, spacing, LEVELS, iterations, threads, 60 * self.options.minutes,
                           self.folder / f"{programs.PROGRAMS.index(program)}")
        allowed = sorted(os.sched_getaffinity(0))
        processors = {allowed[-1]} if threads == 1 else set(allowed[-threads:])
        try:
            row, field = run.start(program, job, processors, module if program.hwffd else None)
        except programs.AlignError as error:
            show(f"{pair.name}: {error}")
            self.report["failed"].append({"program": program.name, "pair": pair.name, "why": str(error)})
            return None
        if field is None:
            entry["absent"] = row["absent"]
            show(f"{program.name} is left out: {row['absent']}")
            return None
        return row, field

    def wanted(self, pair):
        return [program for number, program in enumerate(programs.PROGRAMS) if number in self.options.program
                and (program.most_voxels is None or pair.fixed.size <= program.most_voxels)]

    def join(self, earlier):
        """Takes what an earlier report has of the programs that are not measured now."""
        names = {program.name for number, program in enumerate(programs.PROGRAMS) if number not in self.options.program}
        for rows in ("rows", "bits", "failed"):
            self.report[rows] += [row for row in earlier[rows] if row["program"] in names]
        for entry, before in ((entry, before) for entry in self.report["programs"] for before in earlier["programs"]):
            if entry["program"] == before["program"] and entry["program"] in names:
                entry.update(version=before["version"], absent=before["absent"])
        known = {pair["name"] for pair in self.report["pairs"]}
        self.report["pairs"] += [pair for pair in earlier["pairs"] if pair["name"] not in known]

    def measure(self, pair, spacing):
        """All programs on a pair, in turns."""
        self.report["pairs"].append(report.of_pair(pair, spacing, LEVELS))
        runs, fields = {}, {}
        for number in range(self.options.runs):
            for program in self.wanted(pair):
                earlier = runs.setdefault(program, [])
                if number and (len(earlier) < number or earlier[0]["all_s"] > LONG):
                    continue
                result = self.run(program, pair, spacing)
                if result:
                    show(f"{pair.name}, {program.name}: {result[0]['seconds']:.2f} s")
                    earlier.append(result[0])
                    fields[program] = result[1]
        for program, measured in runs.items():
            if measured:
                self.report["rows"].append(report.row(program, pair, measured, fields[program]))

    def compare_bits(self, pair, spacing):
        """Fields of 1, 2 and 5 threads, of one thread again, and of other builds."""
        for program in self.wanted(pair):
            fields = {}
            cases = [(f"{threads} threads" if threads > 1 else "1 thread", threads, MODULE) for threads in THREADS]
            cases.insert(1, ("again", 1, MODULE))
            if program.hwffd and any(BY_CLANG.glob("hwffd/_core.*")):
                cases.append(("built by clang", 1, BY_CLANG))
            for name, threads, module in cases:
                result = self.run(program, pair, spacing, threads, module, BITS_ITERATIONS)
                if result and not result[0]["stopped"]:
                    fields[name] = result[1]
            if "1 thread" in fields and len(fields) > 1:
                self.report["bits"].append(report.bits(program, pair, fields))
                show(f"bits of {program.name}: {self.report['bits'][-1]['differing']}")


def versions(study):
    """Those of the programs, and why one is absent; one that is only a source is tried to be compiled."""
    for program, entry in study.programs.items():
        why = from_source.installed(program.package, study.folder)
        try:
            entry["version"] = program.version
        except programs.Absent as error:
            entry["absent"] = why or str(error)


def routed_reports():
    """With clocks: of the release that is being measured, or of this checkout, or of the last release."""
    folder = os.environ.get("HWFFD_RESULTS")
    fresh = Results(ROOT, folder) if folder else Results(ROOT)
    return fresh if fresh.has("pnr") else released(ROOT)


def work_on(options):
    study = Study(options)
    study.folder.mkdir(parents=True, exist_ok=True)
    sys.path.insert(0, str(MODULE))
    versions(study)
    chosen = [PAIRS[number] for number in options.pair]
    for make, spacing in chosen:
        study.measure(make(), spacing)
    make, spacing = PAIRS[-1]
    study.compare_bits(make(), spacing)
    first = study.report["pairs"][0]
    study.report["core"] = core.estimate(routed_reports(), first["counts"],
                                         [round(n / first["spacing"]) for n in first["counts"]])
    path = options.output / "reports" / "align.json"
    if len(options.program) < len(programs.PROGRAMS) and path.is_file():
        study.join(json.loads(path.read_text(encoding="utf-8")))
    study.report["aims"] = report.aims(study.report)
    study.report["short"] = report.faults(study.report)
    whole_file.write(path, json.dumps(study.report, indent=2) + "\n")
    print(f"wrote {path}")
    return study.report["short"]


def main():
    parser = argparse.ArgumentParser(prog="align", description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--runs", type=int, default=3, help="of each program and pair")
    parser.add_argument("--minutes", type=float, default=10, help="of the processor, after which a program is stopped")
    parser.add_argument("--pair", type=int, nargs="+", default=range(len(PAIRS)), choices=range(len(PAIRS)))
    parser.add_argument("--program", type=int, nargs="+", default=range(len(programs.PROGRAMS)),
                        choices=range(len(programs.PROGRAMS)),
                        help="; ".join(f"{number}: {program.name}" for number, program in enumerate(programs.PROGRAMS)))
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build", help="folder for files and reports")
    options = parser.parse_args()
    options.output = options.output.resolve()
    return command_line.measured(parser.prog, lambda: work_on(options),
                                 (programs.AlignError, RequestError, ImportError))


if __name__ == "__main__":
    sys.exit(main())
