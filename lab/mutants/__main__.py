"""make -C lab mutants: single changes of the RTL, and whether the tests see them.

    python3 -m lab.mutants [--build FOLDER] [--only NAME ...] [--mutants N | --sample] [--seed N]
                           [--report FILE] [-j JOBS]

Of each subject (subjects.csv) yosys changes the netlist in so many places, one at a time, and the tests
run that `make test` has. What they do not see is proved to change nothing; or SAT finds that it can
change something, and it has survived; or neither is known in time. Late tests, which take minutes, run
with those alone that are not proved. Writes the report. The exit status is 1 where a subject falls short of its aim, to
which what is undecided counts as survived. A sample is as small as the table says, proofs have less time,
and the aim is of all of it.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import collections
import csv
import json
import pathlib
import sys

from lab.mutants import aiger, built, campaign, equivalence, netlist
from lab.mutants.known import Known
from tools import command_line, whole_file

ROOT = pathlib.Path(__file__).resolve().parents[2]

TABLE = pathlib.Path(__file__).with_name("subjects.csv")
VERDICTS = ("killed", "equivalent", "undecided", "survived")
SURVIVORS = ("undecided", "survived")
SAMPLE_AIM = 95
LIMIT, SAMPLE_LIMIT = 60, 6  # seconds of a proof


def subjects(only):
    with TABLE.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    unknown = set(only) - {row["name"] for row in rows}
    if unknown:
        raise built.MutantError(f"no subject is called {', '.join(sorted(unknown))}")
    return [row for row in rows if not only or row["name"] in only]


def numbers(chosen, column, total):
    """How many mutants of each subject: those of the table, or of `total` as large a part."""
    table = [int(subject[column]) for subject in chosen]
    return [max(1, round(number * total / sum(table))) for number in table] if total else table


def measure(options, subject, number):
    """The rows of a subject: so many mutants and their verdicts."""
    model = built.model(options.build, subject["library"])
    folder = options.build / "mutants" / f"{subject['name']}-{number}"
    folder.mkdir(parents=True, exist_ok=True)
    of_design = netlist.read(ROOT, model, folder)
    print(f"mutants: {subject['name']}: {model.top}", file=sys.stderr, flush=True)
    seed = of_design if options.seed is None else options.seed
    mutants = netlist.listed(ROOT, folder, number, seed, subject["modules"])
    program, mutants = campaign.program(options.build, subject, model, mutants, folder)
    netlisted = folder / f"{model.top}.sv"
    tested = Known(folder / "passed.json", netlisted, options.build / subject["program"], text=subject["tests"])
    unseen = campaign.unseen(program, subject["tests"], range(1, len(mutants) + 1), tested, options.jobs)
    how = [pathlib.Path(module.__file__) for module in (aiger, equivalence)]
    judged = Known(folder / "verdicts.json", netlisted, *how, *equivalence.domain(model.top))
    limit = SAMPLE_LIMIT if options.sample else LIMIT
    verdicts = judged.of(unseen, lambda place: equivalence.verdict(ROOT, model, mutants[place - 1],
                                                                   folder / str(place), limit),
                         options.jobs, "proof")
    if subject["late"] and not options.sample:
        verdicts = after_late_tests(options, subject, folder, verdicts)
    return rows({"subject": subject["name"], "seed": seed}, mutants,
                {place: verdicts.get(place, "killed") for place in range(1, len(mutants) + 1)})


def after_late_tests(options, subject, folder, verdicts):
    """The verdicts, without those of mutants that the late tests kill."""
    left = [place for place, verdict in verdicts.items() if verdict in SURVIVORS]
    if not left:
        return verdicts
    program = campaign.late(options.build, subject, folder)
    unseen = campaign.unseen(program, "*", left, Known(folder / "late.json", program), options.jobs)
    return {place: verdict for place, verdict in verdicts.items() if place not in left or place in unseen}


def rows(subject, mutants, verdicts):
    """A row for each module of the subject."""
    counts, names = collections.defaultdict(collections.Counter), collections.defaultdict(list)
    for number, verdict in verdicts.items():
        module = netlist.module(mutants[number - 1])
        counts[module][verdict] += 1
        if verdict in SURVIVORS:
            names[module].append({"number": number, "verdict": verdict,
                                  "change": mutants[number - 1]})
    return [{**subject, "module": module, "total": sum(verdicts.values()),
             **{verdict: verdicts[verdict] for verdict in VERDICTS},
             "survivors": names[module]} for module, verdicts in sorted(counts.items())]


def score(rows):
    """Percent of the mutants that are not equivalent."""
    asked = sum(row["total"] - row["equivalent"] for row in rows)
    return 100.0 * sum(row["killed"] for row in rows) / asked if asked else 0.0


def work_on(options):
    rows, faults = [], []
    column = "sample" if options.sample else "mutants"
    chosen = [subject for subject in subjects(options.only) if subject[column] != "0"]
    for subject, number in zip(chosen, numbers(chosen, column, options.mutants)):
        mine = measure(options, subject, number)
        rows += mine
        if score(mine) < float(subject["aim"]) and not options.sample:
            faults.append(f"{subject['name']}: {score(mine):.1f} % killed, need {subject['aim']}")
    if options.sample and score(rows) < SAMPLE_AIM:
        faults.append(f"{score(rows):.1f} % of the sample killed, need {SAMPLE_AIM}")
    total = {verdict: sum(row[verdict] for row in rows)
             for verdict in ("total", *VERDICTS)}
    report = {**total, "killed_percent": round(score(rows), 2), "short": faults, "rows": rows}
    path = options.report or ROOT / "build" / "reports" / "mutants.json"
    whole_file.write(path, json.dumps(report, indent=2) + "\n")
    print(f"mutants: {total['total']}, {total['killed']} killed, {total['equivalent']} equivalent, "
          f"{total['undecided']} undecided, {total['survived']} survived: "
          f"{score(rows):.1f} % of those that change something\nwrote {path}")
    return faults


def main():
    parser = argparse.ArgumentParser(prog="mutants", description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "lab")
    parser.add_argument("--only", action="append", default=[], metavar="NAME", help="subjects; all unless given")
    asked = parser.add_mutually_exclusive_group()
    asked.add_argument("--mutants", type=int, metavar="N", help="of all subjects together; as the table says")
    asked.add_argument("--sample", action="store_true", help="so few that make test has time for them")
    parser.add_argument("--seed", type=int, help="of their choice; from each design")
    parser.add_argument("--report", type=pathlib.Path, metavar="FILE", help="build/reports/mutants.json")
    parser.add_argument("-j", "--jobs", type=int, default=1, help="runs side by side")
    options = parser.parse_args()
    options.build = options.build.resolve()
    return command_line.measured(parser.prog, lambda: work_on(options), (built.MutantError,))


if __name__ == "__main__":
    sys.exit(main())
