"""make soak: random traffic with seeds that no test has had, for so many hours.

    python studies/soak [--build FOLDER] [--hours H] [--only NAME ...] [--corpus FILE] [-j JOBS]

Runs tests that take their traffic from a seed (traffic.csv), one seed after the other and each kind in
turn; first the seeds of the corpus, those that once found a fault. A seed that finds one is added to
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

import synthesis  # noqa: E402  pylint: disable=wrong-import-position
from corpus import Corpus, Kept, traffic  # noqa: E402  pylint: disable=wrong-import-position
from runs import Round, Sums, SoakError, run  # noqa: E402  pylint: disable=wrong-import-position

HERE = pathlib.Path(__file__).resolve().parent
FIRST = 1000  # tests have smaller seeds
STRIDE = 16   # a test may take so many from the one that it is given


def upwards(kinds, first):
    """Rounds without end: each seed with each kind of traffic."""
    seed = first
    while True:
        for kind in kinds:
            yield Round(kind, seed)
        seed += STRIDE


def soak(options, kinds, corpus, sums):
    """Runs the corpus, then new seeds until the time is over; the next seed."""
    def ended(done):
        sums.add(done)
        for test in done.failed:
            print(f"soak: {done.round.kind.name}: SEED={done.round.seed}: {test} fails: see {done.log}",
                  file=sys.stderr, flush=True)
            corpus.keep(Kept(done.round.kind.name, done.round.seed, test))

    folder = options.build / "soak"
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "next.json"
    first = json.loads(path.read_text()) if path.exists() else FIRST
    run([Round(kinds[kept.traffic], kept.seed) for kept in corpus.kept if kept.traffic in kinds],
        options, folder, None, ended)
    end = time.monotonic() + 3600 * options.hours
    last = run(upwards(kinds.values(), first), options, folder, end, ended) if options.hours else None
    if last:
        path.write_text(json.dumps(last.seed + STRIDE))


def work_on(options):
    """What does not hold, a line each."""
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
    try:
        return 1 if work_on(options) else 0
    except (SoakError, OSError) as error:
        print(f"soak: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
