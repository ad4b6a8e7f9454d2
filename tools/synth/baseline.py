"""synth/baseline.csv: area and depth as they were, and what has changed since.

SPDX-License-Identifier: Apache-2.0
"""

import csv

NAMED = ("name", "top", "target")
FIGURES = ("lut", "lutram", "ff", "dsp", "bram", "cells", "area_um2", "depth")
HEAD = ",".join((*NAMED, *FIGURES))
PERCENT = 3
CURE = "make synth-baseline"


class BaselineError(Exception):
    """A baseline that cannot be read, or rows that cannot be mapped, in one line."""


def key(subject):
    return (subject.row.name, subject.top, subject.target)


def read(path):
    """(version of yosys, {key: {figure: number or None}}). Raises BaselineError."""
    try:
        first, head, *lines = path.read_text().splitlines()
        if head != HEAD:
            raise ValueError("other columns")
        rows = list(csv.DictReader(lines, (*NAMED, *FIGURES)))
        return first.removeprefix("# "), {
            tuple(row[name] for name in NAMED):
                {figure: int(row[figure]) if row[figure] else None for figure in FIGURES}
            for row in rows}
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise BaselineError(f"{path.name} cannot be read ({error}): {CURE}") from error


def text(version, results):
    lines = [f"# {version}", HEAD]
    for subject, result in results:
        figures = ("" if result.get(f) is None else str(result[f]) for f in FIGURES)
        lines.append(",".join((*key(subject), *figures)))
    return "\n".join(lines) + "\n"


def changes(old, new):
    """[(figure, before, now, more than PERCENT above?)] of those outside the bounds."""
    differences = []
    for figure in FIGURES:
        before, now = old[figure], new.get(figure)
        if before is None or now is None:
            if before is not now:
                differences.append((figure, before, now, True))
        elif 100 * abs(now - before) > PERCENT * before:
            differences.append((figure, before, now, now > before))
    return differences


def percent(before, now):
    return f"{100 * (now - before) / before:+.1f} %" if before and now is not None else "new"


def compare(version, baseline, results, everything):
    """(lines that fail, lines that only tell, figures compared); `everything`: that it has all."""
    made_with, rows = baseline
    grown, notes, compared = [], [], 0
    for subject, result in results:
        if key(subject) not in rows:
            grown.append(f"{subject}: not in the baseline: {CURE}")
            continue
        compared += sum(1 for figure in FIGURES if result.get(figure) is not None)
        for figure, before, now, worse in changes(rows[key(subject)], result):
            line = f"{subject}: {figure} {before} -> {now} ({percent(before, now)})"
            (grown if worse else notes).append(line if worse else f"{line}: {CURE}")
    if everything:
        present = {key(subject) for subject, _ in results}
        grown += [f"{', '.join(gone)}: only in the baseline: {CURE}"
                  for gone in rows if gone not in present]
    if grown and made_with != version:
        notes.append(f"the baseline is of {made_with}, this is {version}")
    return grown, notes, compared
