"""make tangents: derivatives and det J out of the RTL.

SPDX-License-Identifier: Apache-2.0
"""

from figures.expressions import shown
from figures.table import Table

FORMATS = 4  # that a whole report has


def formats(reports):
    return Table(
        ["format", "mismatches", "max error dq", "max error det J", "wrong fold flags",
         "seam values that differ"],
        [[f"`{row['format']}`", shown(row["mismatches"]), shown(row["max_error"], ".2e"),
          shown(row["max_determinant_error"], ".1e"), shown(row["wrong_flags"]),
          f"{row['seam_differences']:,} of {row['seam_values']:,}"]
         for row in reports.rows("tangents")])


def printed(reports):
    table = Table(
        ["row", "vertices", "mismatches", "clocks/vertex", "dq error", "- differ.", "det error",
         "upright", "folded", "wrong", "seam values", "differ"],
        [[row["name"], str(row["vertices"]), str(row["mismatches"]),
          shown(row["clocks_per_vertex"], ".2f"),
          *(shown(row[field], ".2e")
            for field in ("max_error", "max_difference", "max_determinant_error")),
          *(str(row[field]) for field in ("upright", "folded", "wrong_flags", "seam_values",
                                          "seam_differences"))]
         for row in reports.rows("tangents")])
    return table.text() + ("\n\nerrors are in units of 2^k > half the lattice's size, of det J in "
                           "its cube")


def missing(reports):
    return "" if len(reports.rows("tangents")) >= FORMATS else "formats"


TABLES = {"formats": formats}
