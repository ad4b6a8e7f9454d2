"""make -C lab energy: what a vertex costs in evaluators of standard cells.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.results import RequestError
from tools.reports.text_table import Table, shown

ROWS = 3  # of a report that is whole


def _share(row, field):
    return shown(row[field] / row["energy_nj_per_vertex"], ".0%")


def evaluators(reports):
    """Energies of each evaluator, in the order of the report."""
    return Table(
        ["evaluator", "cells", "cycles per vertex", "nJ per vertex", "clock", "glitches",
         "changes of a net per cycle", "results compared"],
        [[f"`{row['name']}`", shown(row["cells"], ","), shown(row["clocks_per_vertex"], "g"),
          shown(row["energy_nj_per_vertex"], ".1f"), _share(row, "clock_nj"),
          _share(row, "glitches_nj"), shown(row["toggles_per_clock"], ".2f"),
          shown(row["compared"], ",")] for row in reports.rows("energy")])


def printed(reports):
    report = reports.get("energy")
    return (f"{report['volts']} V, a clock of {report['period_ns']} ns; {report['rows'][0]['device']}\n\n"
            + evaluators(reports).text())


def missing(reports):
    return "" if len(reports.rows("energy")) >= ROWS else "rows"


def _of(choice, field):
    def figure(reports):
        measured = reports.rows("energy")
        if not measured:
            raise RequestError("energy has no rows")
        return choice(measured, key=lambda row: row["energy_nj_per_vertex"])[field]
    return figure


def _share_of(choice, field):
    return lambda reports: choice(
        row[field] / row["energy_nj_per_vertex"] for row in reports.rows("energy"))


TABLES = {"evaluators": evaluators}
FIGURES = {
    "least_name": _of(min, "name"), "least_nj": _of(min, "energy_nj_per_vertex"),
    "most_name": _of(max, "name"), "most_nj": _of(max, "energy_nj_per_vertex"),
    "clock_least": _share_of(min, "clock_nj"), "clock_most": _share_of(max, "clock_nj"),
    "glitches_least": _share_of(min, "glitches_nj"), "glitches_most": _share_of(max, "glitches_nj"),
    "leakage_most": _share_of(max, "leakage_nj"),
}
