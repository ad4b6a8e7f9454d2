"""Places that need not be run, each with its reason: exclusions.csv.

`what` is a branch's or line's source text without blanks at its ends, or a signal's bit or bits, w[3] or
w[0-3]. Of the kind `module`, whose `what` is `all`, the module need not be in any program. A line that fits
no place, or only places that were run, is a fault: reasons must not outlive what they were written for.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import re

from lab.rtl_coverage.counts import KINDS, CoverageError

FIELDS = ["module", "kind", "what", "reason"]
MODULE = "module"
_BIT = re.compile(r"(.*)\[(\d+)\]")
_BITS = re.compile(r"(.*)\[(\d+)-(\d+)\]")


def read(path):
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    for number, row in enumerate(rows, 2):
        if list(row) != FIELDS or row["kind"] not in (*KINDS, MODULE) or not all(row.values()):
            raise CoverageError(f"{path.name}:{number}: need {','.join(FIELDS)}, "
                                f"the kind one of {', '.join((*KINDS, MODULE))}")
    return rows


def _is_bit_of(what, bits):
    """Whether a toggle's signal and bit are among those of a row."""
    several, bit = _BITS.fullmatch(bits), _BIT.fullmatch(what)
    if not several or not bit:
        return what == bits
    return bit[1] == several[1] and int(several[2]) <= int(bit[2]) <= int(several[3])


def _fits(row, place, source):
    if (row["module"], row["kind"]) != (place.module, place.kind):
        return False
    if place.kind == "toggle":
        return _is_bit_of(place.what, row["what"])
    return source[place.line - 1].strip() == row["what"]


def unneeded(rows, counts):
    """(modules that need not be in any program and are in none, a line for each that is in one)."""
    names = {row["module"] for row in rows if row["kind"] == MODULE}
    there = names & {place.module for place in counts}
    return names - there, [f"exclusions.csv: {name}, module: a program has it: take the row out" for name in sorted(there)]


def excluded(rows, counts, sources):
    """(the places that were not run and need not be, a line for each row that is idle)."""
    missed = [place for place, count in counts.items() if count == 0]
    left_out, idle = set(), []
    for row in rows:
        if row["kind"] == MODULE:
            continue
        fitting = {place for place in missed if _fits(row, place, sources.get(place.module, ()))}
        if not fitting:
            idle.append(f"exclusions.csv: {row['module']}, {row['kind']} {row['what']}: no such place is missed: "
                        "take the row out")
        left_out |= fitting
    return left_out, idle
