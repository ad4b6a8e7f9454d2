"""make soak: random traffic with seeds that no test has had, for so many hours.

    python3 -m lab.soak [--build FOLDER] [--hours H] [--only NAME ...] [--corpus FILE] [-j JOBS]
    python3 -m lab.soak [--build FOLDER] --seed N --part FILE [--only NAME ...] [-j JOBS]
    python3 -m lab.soak [--build FOLDER] --join FILE ... [--corpus FILE]

Runs tests that take their traffic from a seed (traffic.csv), one seed after the other, each with all
kinds, to the end of the seed in which the time is over; first the seeds of the corpus, those that once found a fault. A seed that finds one is added to
the corpus. The seeds go on where the last run ended, build/soak/next.json. Writes
FOLDER/reports/soak.json. The exit status is 1 where a test failed or nothing was run. A part is a seed
with all kinds, run anywhere; joined, parts are the report, and faults come into the corpus.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import dataclasses
import pathlib
import sys
import time

from lab.soak import seeds
from lab.soak.corpus import Corpus, Kept, traffic
from lab.soak.runs import Round, SoakError, Sums, one
from tools import command_line, job_pool
from tools.synth import report_parts

ROOT = pathlib.Path(__file__).resolve().parents[2]

HERE = pathlib.Path(__file__).resolve().parent


def run(options, rounds, sums, keep):
    """Runs them; each test that fails is told, and kept by keep(it)."""
    folder = options.build / "soak"
    folder.mkdir(parents=True, exist_ok=True)

    def ended(_, future):
        found = future.result()
        sums.add(found)
        for test in found.failed:
            print(f"soak: {found.round.kind.name}: SEED={found.round.seed}: {test} fails: see {found.log}",
                  file=sys.stderr, flush=True)
            keep(Kept(found.round.kind.name, found.round.seed, test))

    job_pool.run(lambda turn: one(turn, options.build, folder), rounds, options.jobs, ended,
                 name=lambda turn: f"{turn.kind.name}, seed {turn.seed}")


def soak(options, kinds, corpus, sums):
    """Runs the corpus, then each new seed with each kind of traffic until the time is over: how many
    hours it took."""
    start = time.monotonic()
    run(options, [Round(kinds[kept.traffic], kept.seed) for kept in corpus.kept if kept.traffic in kinds],
        sums, corpus.keep)
    begun = time.monotonic()
    while time.monotonic() < begun + 3600 * options.hours:
        seed = seeds.following(options.build)
        run(options, [Round(kind, seed) for kind in kinds.values()], sums, corpus.keep)
        seeds.had(options.build, seed)
    return hours_since(start)


def hours_since(start):
    return round((time.monotonic() - start) / 3600, 3)


def write_part(options, kinds):
    """One seed. What fails is for who joins."""
    sums, found, start = Sums(), [], time.monotonic()
    run(options, [Round(kind, options.seed) for kind in kinds.values()], sums, found.append)
    report_parts.write(options.part, {"seed": options.seed, "hours": hours_since(start), "rows": list(sums.rows.values()),
                                      "found": [dataclasses.asdict(fault) for fault in found]})
    return 0


def join(options, kinds, corpus, sums):
    """Adds up parts, which have a seed each: how many hours they took."""
    found = report_parts.read(options.join, ("seed", "hours", "rows", "found"))
    had = sorted(part["seed"] for part in found)
    if len(set(had)) != len(had):
        raise report_parts.PartError(f"a seed is in two parts: {' '.join(map(str, had))}")
    for row in report_parts.rows(found):
        sums.add_row(row)
    short = [name for name in kinds if sums.rows.get(name, {"seeds": 0})["seeds"] != len(had)]
    if short:
        raise report_parts.PartError(f"not every part has {', '.join(short)}: measure parts with the same --only")
    for fault in report_parts.rows(found, "found"):
        corpus.keep(Kept(**fault))
    seeds.had(options.build, had[-1])
    return round(sum(part["hours"] for part in found), 3)


def work_on(options):
    """How many tests failed."""
    kinds = traffic(HERE / "traffic.csv", options.only)
    if options.part:
        return write_part(options, kinds)
    corpus, sums = Corpus(options.corpus), Sums()
    hours = (join if options.join else soak)(options, kinds, corpus, sums)
    if not sums.rows:
        raise SoakError("nothing was run: --hours is 0 and the corpus is empty")
    report = {"hours": hours, "corpus": len(corpus.kept), "faults": sums.faults,
              "rows": list(sums.rows.values())}
    path = options.output / "reports" / "soak.json"
    report_parts.write(path, report)
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
    report_parts.add_options(parser)
    options = parser.parse_args()
    if (options.seed is None) != (options.part is None):
        parser.error("--seed and --part go together")
    options.build, options.output = options.build.resolve(), options.output.resolve()
    return command_line.ended(parser.prog, lambda: 1 if work_on(options) else 0, (SoakError, report_parts.PartError))


if __name__ == "__main__":
    sys.exit(main())
