"""make formal: properties proved, and the planted bugs that the same proofs find.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table, listing, shown

PROVED, REFUTED = "proved", "refuted"


def is_good(row):
    return row["result"] == PROVED and row["negative_control"] == REFUTED


def modules(reports):
    rows = reports.rows("formal")
    by_module = {}
    for row in rows:
        by_module.setdefault(row["module"], []).append(row)
    return Table(["module", "properties", "proved, with the planted bug found"],
                 [[f"`{name}`", shown(len(of)), shown(sum(map(is_good, of)))]
                  for name, of in by_module.items()])


def properties(reports):
    rows = reports.rows("formal")
    timed = ["seconds | seconds"] if any("seconds" in row for row in rows) else []
    return listing([{**row, "parameters": row["parameters"] or "-"} for row in rows],
                   "module | `module`", "property | name", "parameters | parameters",
                   "method | method", "result | result", "planted bug | negative_control", *timed,
                   "statement | statement")


def complaint(row):
    """What is wrong with a property; '' if nothing."""
    if "complaint" in row:
        return row["complaint"]
    if row["result"] != PROVED:
        return row["result"]
    if row["negative_control"] != REFUTED:
        return f"the planted bug is not found ({row['negative_control']})"
    return ""


def document(reports):
    """build/reports/formal.md"""
    rows = reports.rows("formal")
    broken = [f"* Failed: {row['module']}, {row['name']}: {complaint(row)}"
              for row in rows if complaint(row)]
    return "\n\n".join(part for part in (
        "# Formal proofs",
        f"{sum(map(is_good, rows))} of {len(rows)} properties are proved for runs of any length, "
        "each with a planted bug that the same proof refutes.",
        properties(reports).markdown(), "\n".join(broken)) if part) + "\n"


def printed(reports):
    return modules(reports).text()


def missing(reports):
    bad = [row for row in reports.rows("formal") if complaint(row)]
    return f"{len(bad)} properties, the first {bad[0]['module']}.{bad[0]['name']}" if bad else ""


TABLES = {"modules": modules, "properties": properties}
FIGURES = {
    "properties_all": lambda reports: len(reports.rows("formal")),
    "properties_proved": lambda reports: sum(map(is_good, reports.rows("formal"))),
}
