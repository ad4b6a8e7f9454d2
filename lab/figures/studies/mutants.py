"""make -C lab mutants: single changes of the RTL, and whether the tests see them.

SPDX-License-Identifier: Apache-2.0
"""

import collections
import csv
import re
import statistics

from tools.reports.text_table import Table, shown

VERDICTS = ("total", "killed", "equivalent", "undecided", "survived")
HEADS = ["mutants", "killed", "equivalent", "undecided", "survived", "killed, %"]


def _subjects(reports):
    lines = (reports.root / "lab" / "mutants" / "subjects.csv").read_text(encoding="utf-8").splitlines()
    return {row["name"]: row for row in csv.DictReader(lines)}


def _aim(aims, name):
    """In percent; of a subject that has gone since it was measured, that of most subjects."""
    return aims[name]["aim"] if name in aims else statistics.mode(row["aim"] for row in aims.values())


def _sums(reports, field):
    sums = collections.defaultdict(collections.Counter)
    for row in reports.rows("mutants"):
        sums[row[field]].update({verdict: row[verdict] for verdict in VERDICTS})
    return sums


def _cells(sums):
    asked = sums["total"] - sums["equivalent"]
    return [*(shown(sums[verdict], ",") for verdict in VERDICTS),
            shown(100 * sums["killed"] / asked, ".1f") if asked else "-"]


def subjects(reports):
    """Each subject and its aim."""
    aims = _subjects(reports)
    return Table(["subject", "aim, %", *HEADS],
                 [[f"`{name}`", _aim(aims, name), *_cells(sums)]
                  for name, sums in _sums(reports, "subject").items()])


def modules(reports):
    """Each module, of all subjects together."""
    return Table(["module", *HEADS], [[f"`{module}`", *_cells(sums)]
                                      for module, sums in sorted(_sums(reports, "module").items())])


def left(reports):
    """Each mutant that counts as survived."""
    lines = [[row["subject"], f"`{row['module']}`", survivor["verdict"],
              f"`{re.sub(r' -src .*', '', survivor['change'])}`"]
             for row in reports.rows("mutants") for survivor in row["survivors"]]
    return Table(["subject", "module", "verdict", "change"], lines or [["-", "-", "-", "none"]])


def missing(reports):
    wanted = set(_subjects(reports)) - {row["subject"] for row in reports.rows("mutants")}
    return ", ".join(sorted(wanted))


def _of(verdict):
    return lambda reports: reports.get("mutants")[verdict]


def _below(reports):
    """The subjects that are below their aim, with what they reach."""
    aims, sums = _subjects(reports), _sums(reports, "subject")
    return ", ".join(f"{name} {_cells(of)[-1]} %" for name, of in sums.items() if (asked := of["total"] - of["equivalent"])
                     and 100 * of["killed"] / asked < float(_aim(aims, name))) or "none"


TABLES = {"subjects": subjects, "modules": modules, "left": left}
FIGURES = {"below": _below, "subjects": lambda reports: len(_subjects(reports)), **{verdict: _of(verdict) for verdict in VERDICTS}, "percent": _of("killed_percent"),
           "modules": lambda reports: len({row["module"] for row in reports.rows("mutants")})}
