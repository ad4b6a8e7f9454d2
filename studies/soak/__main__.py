"""make soak: random traffic with seeds that no test has had, for so many hours.

    python studies/soak [--build FOLDER] [--hours H] [--only NAME ...] [--corpus FILE] [-j JOBS]

Runs tests that take their traffic from a seed (traffic.csv), one seed after the other, each with all
kinds, to the end of the seed in which the time is over; first the seeds of the corpus, those that once found a fault. A seed that finds one is added to
the corpus. The seeds go on where the last run ended, build/soak/next.json. Writes
FOLDER/reports/soak.json. The exit status is 1 where a test failed or nothing was run.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import json
import pathlib
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(1, str(ROOT / "scripts"))

import front  # noqa: E402  pylint: disable=wrong-import-position
import pool  # noqa: E402  pylint: disable=wrong-import-position
import synthesis  # noqa: E402  pylint: disable=wrong-import-position
from corpus import Corpus, Kept, traffic  # noqa: E402  pylint: disable=wrong-import-position
from runs import Round, SoakError, Sums, one  # noqa: E402  pylint: disable=wrong-import-position

HERE = pathlib.Path(__file__).resolve().parent
FIRST = 1000  # tests have smaller seeds
STRIDE = 16   # a test may take so many from the one that it is given


def soak(options, kinds, corpus, sums):
    """Runs the corpus, then each new seed with each kind of traffic until the time is over."""
    def ended(_, done):
        found = done.result()
        sums.add(found)
        for test in found.failed:
            print(f"soak: {found.round.kind.name}: SEED={found.round.seed}: {test} fails: see {found.log}",
                  file=sys.stderr, flush=True)
            corpus.keep(Kept(found.round.kind.name, found.round.seed, test))

    def run(rounds):
        pool.run(lambda turn: one(turn, options.build, folder), rounds, options.jobs, ended,
                 name=lambda turn: f"{turn.kind.name}, seed {turn.seed}")

    folder = options.build / "soak"
    folder.mkdir(parents=True, exist_ok=True)
    run([Round(kinds[kept.traffic], kept.seed) for kept in corpus.kept if kept.traffic in kinds])
    path = folder / "next.json"
    seed = json.loads(path.read_text()) if path.exists() else FIRST
    end = time.monotonic() + 3600 * options.hours
    while time.monotonic() < end:
        run([Round(kind, seed) for kind in kinds.values()])
        seed += STRIDE
        path.write_text(json.dumps(seed))


def work_on(options):
    """How many tests failed."""
    kinds = traffic(HERE / "traffic.csv", options.only)
    corpus = Corpus(options.corpus)
    sums, start = Sums(), time.monotonic()
    soak(options, kinds, corpus, sums)
    if not sums.rows:
        raise SoakError("nothing was run: --hours is 0 and the corpus is empty")
    report = {"hours": round((time.monotonic() - start) / 3600, 3), "corpus": len(corpus.kept),
              "faults": sums.faults, "rows": list(sums.rows.values())}
    path = options.build / "reports" / "soak.json"
    synthesis.write(path, json.dumps(report, indent=2) + "\n")
    for row in report["rows"]:
        print(f"soak: {row['traffic']}: {row['seeds']} seeds, {row['tests']} tests, "
              f"{row['failed']} failed, {row['results']} results in {row['clocks']} clocks counted")
    print(f"wrote {path}")
    return sums.faults


def main():
    parser = argparse.ArgumentParser(prog="soak", description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    parser.add_argument("--hours", type=float, default=1.0, help="0: the corpus alone")
    parser.add_argument("--only", action="append", default=[], metavar="NAME", help="kinds of traffic; all unless given")
    parser.add_argument("--corpus", type=pathlib.Path, default=HERE / "corpus.csv", metavar="FILE")
    parser.add_argument("-j", "--jobs", type=int, default=1, help="runs side by side")
    options = parser.parse_args()
    options.build = options.build.resolve()
    return front.ended(parser.prog, lambda: 1 if work_on(options) else 0, (SoakError,))


if __name__ == "__main__":
    sys.exit(main())
