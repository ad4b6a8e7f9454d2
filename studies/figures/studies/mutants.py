"""make mutants: single changes of the RTL, and whether the tests see them.

SPDX-License-Identifier: Apache-2.0
"""

import collections

from figures.expressions import shown
from figures.table import Table

VERDICTS = ("total", "killed", "equivalent", "survived")


def _percent(row):
    asked = row["killed"] + row["survived"]
    return shown(100 * row["killed"] / asked, ".1f") if asked else "-"


def modules(reports):
    """Each module, of all subjects together."""
    sums = collections.defaultdict(collections.Counter)
    for row in reports.rows("mutants"):
        sums[row["module"]].update({verdict: row[verdict] for verdict in VERDICTS})
    return Table(["module", "mutants", "killed", "equivalent", "survived", "killed, %"],
                 [[f"`{module}`", *(shown(found[verdict], ",") for verdict in VERDICTS), _percent(found)]
                  for module, found in sorted(sums.items())])


def missing(reports):
    wanted = {"dma", "number", "stream"} - {row["subject"] for row in reports.rows("mutants")}
    return ", ".join(sorted(wanted))


def _of(verdict):
    return lambda reports: reports.get("mutants")[verdict]


TABLES = {"modules": modules}
FIGURES = {**{verdict: _of(verdict) for verdict in VERDICTS}, "percent": _of("killed_percent")}
