"""make random: cores of random parameters on random packets.

    python3 -m tests.random --words PROGRAM [--folder FOLDER] [--seed S] [--count N] [--seconds T] [--parts P] [--regressions]
                                          [--keep]

Each number from S on is a configuration: most are legal, and each of these is read by Verilator without a
warning, built in Icarus, whose values may be X, and run on a stream of packets of every kind, good and bad,
with pauses on both sides; every bit of its results, its events, counts and waits are compared with the
model, and the model's with those of another organization that has the same bits. The others break one rule
of the space, and must be refused by their guard in Verilator, Icarus and yosys. The exit status is 1 where
one fails.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import random
import resource
import shutil
import sys
from functools import partial

from tests.random import run
from tools import csv_table
from tools.progress import Progress
from tools.rtl import digest, rtl_sources
from tools.tables import configuration_texts as texts, configurations, features, parameter_draws, parameter_space

ROOT = pathlib.Path(__file__).resolve().parents[2]

ILLEGAL = 0.2  # share of the configurations


class Campaign:
    """Configurations by number."""

    def __init__(self, options):
        self.options = options
        self.space, self.sources = parameter_space.Space(), rtl_sources.Sources()
        self.kinds = {texts.model_kind(row.organization, row.number_format, row.fma_latency, row.evaluator)
                      for row in configurations.read()}
        self.formats = sorted({kind[1].number for kind in self.kinds})
        self.results = self.clocks = self.legal = self.illegal = 0

    def _modelled(self, draw):
        """A legal configuration of which there is a model, since some row of the table has its arithmetic."""
        while True:
            drawn = draw.legal()
            if self._has_model(drawn, self.space.organizations[drawn["ORG"]]):
                return drawn

    def _has_model(self, p, organization):
        return (organization.weighs_axes or p["EVALUATOR"] != parameter_space.POWERS) and texts.model_kind(
            organization, self.space.formats[p["FORMAT"]], p["FMA_LATENCY"],
            configurations.evaluator_of(p["EVALUATOR"])) in self.kinds

    def one(self, seed):
        """Runs a number. Raises run.Failure, with the configuration in front."""
        chosen = random.Random(seed)
        draw = parameter_draws.Draw(self.space, run.TOP, chosen, formats=self.formats)
        if chosen.random() < ILLEGAL:
            parameters = list(draw.parameters.values())
            rules = self.space.rules_of(run.TOP)
            bad = chosen.choice([*parameters, *rules])
            configuration = (draw.breaking(bad) if bad in rules
                             else draw.beyond(bad, chosen.choice(bad.beyond())))
            names = set(bad.names) if bad in rules else {bad.name}
            others = [rule.guard for rule in rules if names & set(rule.names)]
            self._report(configuration, seed, lambda folder: run.refused(self.sources, configuration, bad.guard, others,
                                                                       folder))
            self.illegal += 1
        else:
            self.legal_one(self._modelled(draw), seed)

    def legal_one(self, configuration, seed):
        """Runs a legal configuration on the stream of that number. Raises run.Failure as above."""
        self._report(configuration, seed, lambda folder: self._run(run.Legal(
            self.space, self.sources, configuration, folder,
            lambda organization: self._has_model(configuration, organization)), seed))
        self.legal += 1

    def _run(self, core, seed):
        # The larger a core, the slower it is simulated.
        shorter = parameter_draws.size(self.space, core.configuration) // 24
        core.words(run.Stream(self.options.words, seed, max(1, self.options.parts - int(shorter))))
        results, clocks = core.compare(core.simulate(seed))
        core.lint()
        self.results += results
        self.clocks += clocks

    def _report(self, configuration, seed, body):
        folder = self.options.folder / str(seed)
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        try:
            body(folder)
        except run.Failure as failure:
            raise run.Failure(f"{run.text(configuration)}: {failure}") from failure
        if not self.options.keep:
            shutil.rmtree(folder)


def known(parameters):
    """(seed, configuration) of each row of regressions.csv."""
    columns = [name for name in parameters if name not in features.PARAMETERS.values()]
    for where, cells in csv_table.read(pathlib.Path(__file__).with_name("regressions.csv"), ("SEED", *columns, "features", "shown")):
        yield int(cells["SEED"]), {**{name: int(cells[name]) for name in columns},
                                   **features.parameters_of(features.value(cells["features"], where))}


def seed_of_sources():
    """A first number that changes with the sources of the core."""
    sources = sorted(path for path in (ROOT / "rtl").rglob("*.v*"))
    return int(digest.of(*(path.read_text(encoding="utf-8") for path in sources))[:8], 16)


def processor_seconds():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


def main():
    parser = argparse.ArgumentParser(prog="random", description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--words", type=pathlib.Path, required=True, metavar="PROGRAM", help="hwffd-random-words")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "random")
    parser.add_argument("--seed", type=int, help="the first number; one of the sources unless given")
    parser.add_argument("--count", type=int, default=1, help="how many")
    parser.add_argument("--seconds", type=float, default=float("inf"), help="of processors, after which no more begin")
    parser.add_argument("--parts", type=int, default=3, help="of a stream, about")
    parser.add_argument("--regressions", action="store_true", help="those of regressions.csv, which have failed once, too")
    parser.add_argument("--keep", action="store_true", help="what was made of those that did not fail, too")
    options = parser.parse_args()
    options.words, options.folder = options.words.resolve(), options.folder.resolve()
    first = seed_of_sources() if options.seed is None else options.seed
    campaign, failed, progress = Campaign(options), 0, Progress()
    tried = []
    if options.regressions:
        again = f"tests/random --words {options.words} --regressions --count 0"
        tried += [(seed, partial(campaign.legal_one, configuration, seed), again)
                  for seed, configuration in known(campaign.space.parameters[run.TOP])]
    tried += [(seed, partial(campaign.one, seed), f"make random SEED={seed} N=1")
              for seed in range(first, first + options.count)]
    for finished, (seed, check, command) in enumerate(tried):
        if processor_seconds() > options.seconds:
            break
        progress.step(finished, len(tried), f"number {seed}, {failed} failed")
        try:
            check()
        except run.Failure as failure:
            failed += 1
            progress.end()
            print(f"random: {seed}: {failure}; again: {command}", flush=True)
    progress.end()
    print(f"random: {campaign.legal} configurations ran, {campaign.illegal} were refused, {failed} failed; "
          f"{campaign.results} results in {campaign.clocks} clocks compared, "
          f"{processor_seconds():.0f} processor seconds")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
