"""make -C lab soak: random traffic with seeds that no test has had, for so many hours.

    python3 -m lab.soak [--build FOLDER] [--hours H] [--only NAME ...] [--corpus FILE] [-j JOBS]
    python3 -m lab.soak [--build FOLDER] --seed N --part FILE [--only NAME ...] [-j JOBS]
    python3 -m lab.soak [--build FOLDER] --join FILE ... [--corpus FILE]

Runs tests that take their traffic from a seed (traffic.csv), one seed after the other, each with all
kinds, to the end of the seed in which the time is over, or of several where the kinds are fewer than the
jobs; first the seeds of the corpus, those that once found a fault. A seed that finds one is added to
the corpus. The seeds go on where the last run ended, build/lab/soak/next.json, and a soak that was
interrupted goes on with the hours and counts that it had.
Writes FOLDER/reports/soak.json. The exit status is 1 where a test failed or nothing was run. A part is a
seed with all kinds, run anywhere; joined, parts are the report, and faults come into the corpus.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import dataclasses
import math
import pathlib
import sys
import time

from lab.soak import seeds
from lab.soak.corpus import Corpus, FaultySeed, traffic
from lab.soak.interrupted import Interrupted
from lab.soak.runs import Round, SoakError, Sums, run_round
from tools import command_line, job_pool
from tools.project_root import ROOT
from tools.synth import partial_reports

HERE = pathlib.Path(__file__).resolve().parent


def run(options, rounds, sums, keep):
    """Runs them; each test that fails is told, and kept by keep(it)."""
    folder = options.build / "soak"
    folder.mkdir(parents=True, exist_ok=True)

    def ended(_, future):
        outcome = future.result()
        sums.add(outcome)
        for test in outcome.failed:
            print(f"soak: {outcome.round.kind.name}: SEED={outcome.round.seed}: {test} fails: see {outcome.log}",
                  file=sys.stderr, flush=True)
            keep(FaultySeed(outcome.round.kind.name, outcome.round.seed, test))

    job_pool.run(lambda turn: run_round(turn, options.build, folder), rounds, options.jobs, ended,
                 name=lambda turn: f"{turn.kind.name}, seed {turn.seed}")


def soak(options, kinds, corpus, sums):
    """Runs the corpus, then each new seed with each kind of traffic until the time is over: how many
    hours it took."""
    interrupted = Interrupted(options.build / "soak", [options.build / kind.program for kind in kinds.values()])
    hours, counted = interrupted.read()
    for row in counted:
        sums.add_row(row)
    start = time.monotonic()
    if not counted:
        run(options, [Round(kinds[saved.traffic], saved.seed) for saved in corpus.seeds if saved.traffic in kinds],
            sums, corpus.add)
    while hours + hours_since(start) < options.hours:
        first = seeds.following(options.build)
        several = [first + seeds.STRIDE * turn for turn in range(math.ceil(options.jobs / len(kinds)))]
        run(options, [Round(kind, seed) for seed in several for kind in kinds.values()], sums, corpus.add)
        seeds.had(options.build, several[-1])
        interrupted.write(hours + hours_since(start), list(sums.rows.values()))
    interrupted.end()
    return round(hours + hours_since(start), 3)


def hours_since(start):
    return (time.monotonic() - start) / 3600


def write_part(options, kinds):
    """One seed. What fails is for who joins."""
    sums, faults, start = Sums(), [], time.monotonic()
    run(options, [Round(kind, options.seed) for kind in kinds.values()], sums, faults.append)
    partial_reports.write(options.part, {"seed": options.seed, "hours": round(hours_since(start), 3),
                                         "rows": list(sums.rows.values()),
                                         "found": [dataclasses.asdict(fault) for fault in faults]})
    return 0


def join(options, kinds, corpus, sums):
    """Adds up parts, which have a seed each: how many hours they took."""
    parts = partial_reports.read(options.join, ("seed", "hours", "rows", "found"))
    had = sorted(part["seed"] for part in parts)
    if len(set(had)) != len(had):
        raise partial_reports.PartError(f"a seed is in two parts: {' '.join(map(str, had))}")
    for row in partial_reports.rows(parts):
        sums.add_row(row)
    short = [name for name in kinds if sums.rows.get(name, {"seeds": 0})["seeds"] != len(had)]
    if short:
        raise partial_reports.PartError(f"not every part has {', '.join(short)}: measure parts with the same --only")
    for fault in partial_reports.rows(parts, "found"):
        corpus.add(FaultySeed(**fault))
    seeds.had(options.build, had[-1])
    return round(sum(part["hours"] for part in parts), 3)


def work_on(options):
    """How many tests failed."""
    kinds = traffic(HERE / "traffic.csv", options.only)
    if options.part:
        return write_part(options, kinds)
    corpus, sums = Corpus(options.corpus), Sums()
    hours = (join if options.join else soak)(options, kinds, corpus, sums)
    if not sums.rows:
        raise SoakError("nothing was run: --hours is 0 and the corpus is empty")
    report = {"hours": hours, "corpus": len(corpus.seeds), "faults": sums.faults,
              "rows": list(sums.rows.values())}
    path = options.output / "reports" / "soak.json"
    partial_reports.write(path, report)
    for row in report["rows"]:
        print(f"soak: {row['traffic']}: {row['seeds']} seeds, {row['tests']} tests, "
              f"{row['failed']} failed, {row['results']} results in {row['clocks']} clocks counted")
    print(f"wrote {path}")
    return sums.faults


def main():
    parser = argparse.ArgumentParser(prog="soak", description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "lab")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build", help="folder for reports")
    parser.add_argument("--hours", type=float, default=1.0, help="0: the corpus alone")
    parser.add_argument("--only", action="append", default=[], metavar="NAME", help="kinds of traffic; all unless given")
    parser.add_argument("--corpus", type=pathlib.Path, default=HERE / "corpus.csv", metavar="FILE")
    parser.add_argument("--seed", type=int, metavar="N", help="of a part")
    parser.add_argument("-j", "--jobs", type=int, default=1, help="runs side by side")
    partial_reports.add_options(parser)
    options = parser.parse_args()
    if (options.seed is None) != (options.part is None):
        parser.error("--seed and --part go together")
    options.build, options.output = options.build.resolve(), options.output.resolve()
    return command_line.ended(parser.prog, lambda: 1 if work_on(options) else 0, (SoakError, partial_reports.PartError))


if __name__ == "__main__":
    sys.exit(main())
