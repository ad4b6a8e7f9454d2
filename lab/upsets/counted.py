"""The lines of a program that flips bits, counted.

SPDX-License-Identifier: Apache-2.0
"""

import collections
import csv
import math
import pathlib
import re
import subprocess
from dataclasses import dataclass

OUTCOMES = ("no_effect", "flagged", "silent", "hang_cleared", "hang_stuck", "outside_window", "other")
FORBIDDEN = ("hang_stuck", "outside_window")  # in a hardened core
LISTED = ("hang_stuck", "outside_window")     # whose bits are named
CONFIDENCE = 1.959964  # standard deviations: 95 %
_HEAD = re.compile(r"# clocks (\d+) registers (\d+) memory_bits (\d+)$")


class UpsetError(Exception):
    """A campaign that measured nothing, or failed, in one line."""


@dataclass(frozen=True)
class Run:
    """A program, and what it is told."""

    program: pathlib.Path
    row: str
    design: pathlib.Path
    kind: str
    out: pathlib.Path


@dataclass(frozen=True)
class Flips:
    """What a program has written: clocks of its traffic, bits of the core, a line for each flip."""

    clocks: int
    registers: int
    memory_bits: int
    lines: list

    def bits(self, kind):
        return self.registers if kind == "registers" else self.memory_bits


def read(path):
    """The Flips of a file. Raises UpsetError where there are none."""
    text = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    head = _HEAD.match(text[0]) if text else None
    lines = list(csv.DictReader(text[1:]))
    if not head or not lines:
        raise UpsetError(f"{path}: 0 flips were made")
    unknown = {line["outcome"] for line in lines} - set(OUTCOMES)
    if unknown:
        raise UpsetError(f"{path}: no outcome is called {', '.join(sorted(map(str, unknown)))}")
    return Flips(*map(int, head.groups()), lines)


def flips(run, number, seed, jobs, only=()):
    """Flips of a run, of which there are as many as were asked for. Raises UpsetError."""
    run.out.parent.mkdir(parents=True, exist_ok=True)
    run.out.unlink(missing_ok=True)
    command = [run.program, "--row", run.row, "--design", run.design, "--out", run.out, "--kind", run.kind,
               "--flips", number, "--seed", seed, "--jobs", jobs,
               *(word for text in only for word in ("--only", text))]
    result = subprocess.run([str(word) for word in command], check=False, capture_output=True, text=True)
    if result.returncode:
        raise UpsetError(f"{run.program.name}: {(result.stderr or 'ended with 1').strip().splitlines()[-1]}")
    report = read(run.out)
    if len(report.lines) != (len(only) or number):
        raise UpsetError(f"{run.out}: {len(report.lines)} flips, not {number}")
    return report


def interval(count, total):
    """Wilson's interval of a share, in percent."""
    share, square = count / total, CONFIDENCE ** 2
    middle = share + square / (2 * total)
    half = CONFIDENCE * math.sqrt(share * (1 - share) / total + square / (4 * total ** 2))
    return [round(100 * (middle + sign * half) / (1 + square / total), 3) + 0.0 for sign in (-1, 1)]


def _place(line):
    """The bit that a line is of: a register without its index."""
    return re.sub(r"\[\d+\]$", "", line["name"])


def row(lines):
    """The fields of a row: counts, intervals, and the registers behind what must not be."""
    counts = collections.Counter(line["outcome"] for line in lines)
    total = len(lines)
    struck = [line for line in lines if line["outcome"] != "no_effect"]
    return {
        "flips": total, **{outcome: counts[outcome] for outcome in OUTCOMES},
        "percent": {outcome: [round(100 * counts[outcome] / total, 3), *interval(counts[outcome], total)]
                    for outcome in OUTCOMES},
        "reset_does_not_help": sum(line["recovered"] == "0" for line in struck),
        "restart_does_not_help": sum(line["restarted"] == "0" for line in struck),
        "outside_read": sum(line["outside_read"] == "1" for line in lines),
        "places": {outcome: dict(sorted(collections.Counter(
            _place(line) for line in lines if line["outcome"] == outcome).items())) for outcome in LISTED}}


def by_module(lines):
    """(module, its lines), in the order of the modules' names."""
    lines_by_module = collections.defaultdict(list)
    for line in lines:
        lines_by_module[line["module"]].append(line)
    return sorted(lines_by_module.items())
