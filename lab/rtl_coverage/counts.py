"""What models have counted of their lines, branches and toggles, module by module.

A model writes a line with tabs for each place of a source (tb/coverage/coverage_counters.cpp): page,
line, column, comment, further lines, count. A page is v_KIND/MODULE, with __ and letters behind it
where the module has other parameters than its own. A place counts as run if any model of any program
has run it, whatever its parameters; a bit, if it has risen and fallen.

SPDX-License-Identifier: Apache-2.0
"""

import collections
import dataclasses
import re

BOTH = 3  # bits of a bit's count: it has risen, it has fallen
KINDS = ("line", "branch", "toggle")
_PAGE = re.compile(r"v_(line|branch|toggle)/(\w+?)(?:__\w+)?$")


class CoverageError(Exception):
    """Counts that cannot be read, or were never made."""


@dataclasses.dataclass(frozen=True, order=True)
class Place:
    """A line, a branch of a statement, or a bit of a signal."""

    module: str
    kind: str
    line: int
    what: str  # of a branch: if, else, ...; of a toggle: the signal's bit; of a line nothing


def _lines(text, first):
    """The numbers in '137-139,141'."""
    numbers = set() if text else {first}
    for part in filter(None, text.split(",")):
        start, _, end = part.partition("-")
        numbers.update(range(int(start), int(end or start) + 1))
    return numbers


def read(paths):
    """{place: how often it was run}, of all files together; of a bit 1 if it was run, else 0."""
    counts = collections.Counter()
    for path in paths:
        for row in path.read_text(encoding="utf-8").splitlines():
            _add(counts, path, row)
    for place in counts:
        if place.kind == "toggle":
            counts[place] = int(counts[place] == BOTH)
    if not counts:
        raise CoverageError("nothing was counted: no model of these programs counts; "
                            "build them with -DHWFFD_COVERAGE=ON")
    return counts


def _add(counts, path, row):
    fields = row.split("\t")
    page = _PAGE.match(fields[0])
    if len(fields) != 6 or not page:
        raise CoverageError(f"{path}: not a count: {row}")
    (kind, module), line, count = page.groups(), int(fields[1]), int(fields[5])
    if kind == "toggle":
        counts[Place(module, kind, line, fields[3])] |= count & BOTH
    if kind == "branch":
        counts[Place(module, kind, line, f"{fields[3]} {fields[2]}")] += count
    if kind != "toggle":
        for number in _lines(fields[4], line):
            counts[Place(module, "line", number, "")] += count


def modules(counts):
    """{module: {kind: [places]}}, places in order."""
    by_module = collections.defaultdict(lambda: {kind: [] for kind in KINDS})
    for place in sorted(counts):
        by_module[place.module][place.kind].append(place)
    return by_module
