"""Places that need not be run, each with its reason: exclusions.csv.

`what` is a branch's or line's source text without blanks at its ends, or a pattern of a signal's bits.
A line that fits no place, or only places that were run, is an error: reasons must not outlive what they
were written for.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import fnmatch

from counts import KINDS, CoverageError

FIELDS = ["module", "kind", "what", "reason"]


def read(path):
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    for number, row in enumerate(rows, 2):
        if list(row) != FIELDS or row["kind"] not in KINDS or not all(row.values()):
            raise CoverageError(f"{path.name}:{number}: need {','.join(FIELDS)}, "
                                f"the kind one of {', '.join(KINDS)}")
    return rows


def _fits(row, place, source):
    if (row["module"], row["kind"]) != (place.module, place.kind):
        return False
    if place.kind == "toggle":
        return fnmatch.fnmatchcase(place.what.replace("[", "("), row["what"].replace("[", "("))
    return source[place.line - 1].strip() == row["what"]


def excluded(rows, counts, sources):
    """The places that were not run and need not be. Raises CoverageError for a row that is idle."""
    missed = [place for place, count in counts.items() if count == 0]
    left_out = set()
    for row in rows:
        fitting = {place for place in missed if _fits(row, place, sources.get(place.module, ()))}
        if not fitting:
            raise CoverageError(f"exclusions.csv: {row['module']}, {row['kind']} {row['what']}: "
                                "no such place is missed: take the row out")
        left_out |= fitting
    return left_out
