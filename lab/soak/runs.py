"""Runs of test programs with a seed, and what they say of themselves.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import re
import subprocess
from dataclasses import dataclass, field

LIMIT = 1800  # seconds of a run: one that hangs has failed


class SoakError(Exception):
    """What cannot be run."""


@dataclass(frozen=True)
class Kind:
    """A kind of traffic: the program of a build that makes it, and which of its tests do."""

    name: str
    program: str
    tests: str


@dataclass(frozen=True)
class Round:
    """A kind of traffic from a seed."""

    kind: Kind
    seed: int


@dataclass(frozen=True)
class Outcome:
    """How a round went: tests that ran and those that failed; what was counted in them."""

    round: Round
    log: pathlib.Path
    tests: int
    failed: tuple
    results: int
    clocks: int


def run_round(turn, build, folder):
    """Runs a round. A program that ends without its report, or badly, has failed, whatever it was at."""
    stem = folder / f"{turn.kind.name}-{turn.seed}"
    log, report = stem.with_suffix(".log"), stem.with_suffix(".json")
    report.unlink(missing_ok=True)
    settings = {"SEED": str(turn.seed), "HWFFD_SOAK": "1", "GTEST_OUTPUT": f"json:{report}"}
    program = build / turn.kind.program
    if not program.is_file():
        raise SoakError(f"{program} is not there: make -C lab soak builds it")
    with log.open("w", encoding="utf-8") as output:
        try:
            status = subprocess.run([program, f"--gtest_filter={turn.kind.tests}"], stdout=output,
                                    stderr=output, cwd=program.parent, check=False, timeout=LIMIT,
                                    env={**os.environ, **settings}).returncode
        except subprocess.TimeoutExpired:
            status = None
    return _outcome(turn, log, report, status)


def _outcome(turn, log, report, status):
    text = log.read_text(encoding="utf-8", errors="replace")
    suites = json.loads(report.read_text())["testsuites"] if report.exists() else []
    cases = [case for suite in suites for case in suite["testsuite"] if case["status"] == "RUN"]
    failed = tuple(f"{case['classname']}.{case['name']}" for case in cases if case.get("failures"))
    if not failed and (not cases or status != 0):  # what fails outside of its tests
        failed = ("no end" if status is None else f"{'' if cases else 'no report, '}exit status {status}",)
    results, clocks = (sum(int(number) for number in re.findall(rf"(\d+) {unit}\b", text))
                       for unit in ("results", "clocks"))
    report.unlink(missing_ok=True)
    if not failed:
        log.unlink()
    return Outcome(turn, log, len(cases), failed, results, clocks)


@dataclass
class Sums:
    """What was run, by kind of traffic."""

    rows: dict = field(default_factory=dict)

    def add(self, outcome):
        self.add_row({"traffic": outcome.round.kind.name, "seeds": 1, "tests": outcome.tests,
                      "failed": len(outcome.failed), "results": outcome.results, "clocks": outcome.clocks})

    def add_row(self, counted):
        """Of a kind of traffic: what was counted elsewhere."""
        row = self.rows.setdefault(counted["traffic"], dict.fromkeys(counted, 0) | {"traffic": counted["traffic"]})
        for name, number in counted.items():
            if name != "traffic":
                row[name] += number

    @property
    def faults(self):
        return sum(row["failed"] for row in self.rows.values())
