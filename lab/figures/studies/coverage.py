"""make -C lab coverage: lines, branches and bits that the tests run.

SPDX-License-Identifier: Apache-2.0
"""

from lab.rtl_coverage.report import KINDS, PLURALS
from tools.reports.text_table import Table, shown


def _places(row, kind):
    """How many a module has; 0.2.0 has "branchs"."""
    return row[PLURALS[kind]] if PLURALS[kind] in row else row[f"{kind}s"]


def _percent(value):
    return "-" if value is None else shown(value, ".2f")


def modules(reports):
    """Each module; those without a place of a kind have a dash."""
    return Table(
        ["module", "lines", "line, %", "branches", "branch, %", "bits", "toggle, %", "excluded"],
        [[f"`{row['module']}`",
          *(text for kind in KINDS for text in (shown(_places(row, kind), ","), _percent(row[kind]))),
          shown(row["excluded"], ",")] for row in reports.rows("coverage")])


def cpp(reports):
    """The libraries."""
    return Table(
        ["folder", "lines", "line, %", "branches", "branch, %"],
        [[f"`{row['folder']}/`", shown(row["lines"], ","), shown(row["line"], ".2f"),
          shown(row["branches"], ","), shown(row["branch"], ".2f")]
         for row in reports.get("coverage")["cpp"]])


def printed(reports):
    return modules(reports).text() + "\n" + cpp(reports).text()


def missing(reports):
    return "" if reports.get("coverage")["share"] == 1 else "the other parts of the tests"


def _share(kind):
    """Of all places of a kind, those that were run."""
    def figure(reports):
        rows = [row for row in reports.rows("coverage") if row[kind] is not None]
        places = sum(_places(row, kind) for row in rows)
        return sum(row[kind] / 100 * _places(row, kind) for row in rows) / places
    return figure


def _of_all(reports):
    """Of all bits, those that were run: what is excluded counts as not run."""
    rows = reports.rows("coverage")
    places = sum(row["toggles"] + row["excluded"] for row in rows)
    return sum((row["toggle"] or 0) / 100 * row["toggles"] for row in rows) / places


def _full(reports):
    return sum(any(_places(row, kind) for kind in KINDS) and row["line"] in (100, None) and row["branch"] in (100, None)
               and (row["toggle"] is None or row["toggle"] >= 99) for row in reports.rows("coverage"))


TABLES = {"modules": modules, "cpp": cpp}
FIGURES = {
    "modules": lambda reports: len(reports.rows("coverage")), "modules_full": _full,
    **{kind: _share(kind) for kind in KINDS},
    "toggle_of_all": _of_all,
    "excluded": lambda reports: sum(row["excluded"] for row in reports.rows("coverage")),
    "programs": lambda reports: reports.get("coverage")["programs"],
}
