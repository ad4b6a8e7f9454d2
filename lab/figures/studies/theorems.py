"""make -C lab theorems: arithmetic units against what they should compute.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table, shown

PROVED, REFUTED = "proved", "refuted"
# Proved by `make -C lab theorems NIGHTLY=1` only; a report without them is whole.
FIRST = ("product.parts", "fx.round", "num.step", "num.in", "num.out.block", "fp32.add", "fp32.mul")


def is_good(row):
    return row["result"] == PROVED and row["negative_control"] == REFUTED


def theorems(reports):
    """Each theorem: what it says, of what, and what became of its planted bug."""
    return Table(["theorem", "statement", "proved of", "cases", "result", "planted bug"],
                 [[f"`{row['name']}`", row["statement"], row["widths"], shown(row["cases"], ","), row["result"],
                   row["negative_control"]] for row in reports.rows("theorems")])


def bugs(reports):
    """The planted bugs: the module, its text and what replaces it."""
    return Table(["theorem", "module", "text", "planted bug"],
                 [[f"`{row['name']}`", f"`{row['planted_bug']['module']}`",
                   *(f"`{row['planted_bug'][key]}`".replace("|", "\\|") for key in ("original", "mutant"))]
                  for row in reports.rows("theorems") if row["planted_bug"]])


def printed(reports):
    return Table(["theorem", "cases", "questions", "result", "planted bug", "seconds"],
                 [[row["name"], shown(row["cases"], ","), shown(row["questions"], ","), row["result"],
                   row["negative_control"], shown(row.get("seconds", 0), ".1f")]
                  for row in reports.rows("theorems")]).text()


def missing(reports):
    rows = reports.rows("theorems")
    lacking = [name for name in FIRST if name not in {row["name"] for row in rows}]
    bad = [row["name"] for row in rows if not is_good(row)]
    return ", ".join([*lacking, *bad])


TABLES = {"theorems": theorems, "bugs": bugs}
FIGURES = {"good": lambda reports: sum(map(is_good, reports.rows("theorems")))}
