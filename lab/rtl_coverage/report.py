"""The report of `make -C lab coverage`, and what in it falls short.

SPDX-License-Identifier: Apache-2.0
"""

from lab.rtl_coverage.counts import KINDS, modules

# Percent of each module; of C++ in each folder.
LEAST = {"line": 100.0, "branch": 100.0, "toggle": 99.0}
LEAST_CPP = {"line": 95.0, "branch": 90.0}
PLURALS = {"line": "lines", "branch": "branches", "toggle": "toggles"}
SHOWN = 20  # places of a module that are named


def _percent(run, places):
    return round(100.0 * run / places, 2) if places else None


def row(module, places, counts, left_out):
    """A module: percentages of what is not left out, and the places that were not run."""
    counted = {"module": module}
    missed = []
    for kind in KINDS:
        asked = [place for place in places[kind] if place not in left_out]
        run = [place for place in asked if counts[place]]
        counted[kind] = _percent(len(run), len(asked))
        counted[PLURALS[kind]] = len(asked)
        missed += [f"{kind} {place.line} {place.what}".rstrip() for place in asked
                   if not counts[place]]
    counted["excluded"] = sum(place in left_out for kind in KINDS for place in places[kind])
    counted["missed"] = len(missed)
    counted["missed_places"] = missed[:SHOWN]
    return counted


def rows(wanted, counts, left_out):
    """A row for each module of rtl/, also for one that no program has."""
    known = modules(counts)
    nothing = {kind: [] for kind in KINDS}
    return [row(module, known.get(module, nothing), counts, left_out) for module in wanted]


def faults(report):
    """What falls short, a line each."""
    violations = []
    for entry in report["rows"]:
        if not any(entry[PLURALS[kind]] for kind in KINDS):
            violations.append(f"{entry['module']}: no program has it")
        violations += [f"{entry['module']}: {kind} {entry[kind]} %, need {least:g}"
                       for kind, least in LEAST.items() if entry[kind] is not None and entry[kind] < least]
    for entry in report["cpp"]:
        violations += [f"{entry['folder']}/: {kind} {entry[kind]} %, need {least:g}"
                       for kind, least in LEAST_CPP.items() if entry[kind] < least]
    return violations
