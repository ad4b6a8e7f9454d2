"""What `make lint` says of figures in texts: which differ from their reports, which reports are stale.

Needs nothing but Python's own library.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
from collections import Counter

from figures import markers, sources
from figures.catalogue import REPORTS, missing
from figures.measure import STAMP
from figures.reports import Reports, RequestError

PATTERNS = ("*.md", "docs/**/*.md", "synth/**/*.md", "examples/**/*.md", "tests/**/*.md")
CURE = "make figures"


def texts(root):
    """Every text that may have markers."""
    return sorted({path for pattern in PATTERNS for path in root.glob(pattern)
                   if path.name != "CHANGELOG.md"})


def examine(root, path, reports):
    """(the text, the text filled, what is wrong with its markers, what no report says yet), the last
    two a line each.
    """
    before, name = path.read_text(encoding="utf-8"), path.relative_to(root)
    after, faults = markers.fill(before, reports)
    wrong = [f"{name}:{fault.line}: {fault.message}" for fault in faults if not fault.unmeasured]
    unmeasured = Counter(fault.message for fault in faults if fault.unmeasured)
    return before, after, wrong, [f"{name}: {message}, in {count} places"
                                  for message, count in unmeasured.items()]


def check(root):
    """(texts looked at, what is wrong in them, what is to be measured again), a line each."""
    root, reports = pathlib.Path(root), Reports(root)
    names, wrong, unmeasured = texts(root), [], []
    for path in names:
        before, after, faults, missing = examine(root, path, reports)
        wrong += faults
        wrong += [f"{path.relative_to(root)}:{line}: not what the report says: "
                  f"'{old.strip()[:60]}', '{new.strip()[:60]}' wanted: {CURE}"
                  for line, old, new in markers.differences(before, after)]
        unmeasured += missing
    return len(names), wrong, unmeasured + _stale(root, reports)


def _stale(root, reports):
    """A line for each committed report that lacks rows or whose sources have changed since, with
    what renews it.
    """
    lines = []
    for path in sorted(reports.folder.glob("*.json")):
        name, where = path.stem, path.relative_to(root)
        if name not in REPORTS:
            lines.append(f"{where}: no study has a report of this name")
            continue
        try:
            measured = reports.get(name).get(STAMP, {}).get("sources")
            stale = measured != sources.key(root, REPORTS[name].sources)
            absent, kept = missing(reports, name), reports.older(name)
            states = [text for is_so, text in (
                (stale, "is stale"), (absent, f"lacks {absent}"),
                (kept, f"has {kept} rows of earlier sources")) if is_so]
            if states:
                lines.append(f"{where} {states[0]}: {REPORTS[name].command} && "
                             f"tools/figures adopt {name}")
        except (RequestError, sources.SourceError) as error:
            lines.append(f"{where}: {error}")
    return lines
