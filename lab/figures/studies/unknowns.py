"""make -C lab engines: what is X in Icarus Verilog.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import listing

ROWS = 15  # of a whole report: five of the table of configurations, each in three forms
FORMS = 3
_OF = {"sources": "sources", "gates": "gates", "buses": "sources, in a system"}


def _with_form(rows):
    return [{**row, "form": _OF[row["of"]]} for row in rows]


def tops(reports):
    return listing(_with_form(reports.rows("unknowns")), "top | `top`", "of | form", "row | `row`",
                   "cycles | clocks", "bits that must be known | checked", "X | unknown")


def faults(reports):
    """What the same finds where one register has no reset."""
    return listing(_with_form(reports.get("unknowns")["planted"]), "top | `top`", "of | form",
                   "bits that must be known | checked", "names that were X | unknown")


def missing(reports):
    report = reports.get("unknowns")
    if len(report["rows"]) < ROWS:
        return "rows"
    return "" if len(report["planted"]) == FORMS else "planted faults"


TABLES = {"tops": tops, "faults": faults}
FIGURES = {
    "unknown": lambda reports: sum(row["unknown"] for row in reports.rows("unknowns")),
}
