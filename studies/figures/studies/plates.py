"""make plates: the plates of the paper, their vertices out of the simulated RTL.

SPDX-License-Identifier: Apache-2.0
"""

from figures.expressions import shown
from figures.table import Table


def plates(reports):
    return Table(["plate", "vertices", "mismatches"],
                 [[row["file"], shown(row["vertices"]), shown(row["mismatches"])]
                  for row in reports.rows("plates")])


def printed(reports):
    return plates(reports).text()


def missing(reports):
    return "" if len(reports.rows("plates")) == 10 else "plates"


TABLES = {"plates": plates}
FIGURES = {
    "vertices": lambda reports: sum(row["vertices"] for row in reports.rows("plates")),
    "mismatches": lambda reports: sum(row["mismatches"] for row in reports.rows("plates")),
}
