"""make -C lab tangents: derivatives and det J out of the RTL.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import listing

FORMATS = {"fp32", "fx17", "fx18", "fx32", "bfp32"}  # that a whole report has


def formats(reports):
    rows = [{**row, "seams": f"{row['seam_differences']:,} of {row['seam_values']:,}"}
            for row in reports.rows("tangents")]
    return listing(rows, "organization | `org`", "format | `format`", "mismatches | mismatches",
                   "max error dq | max_error:.2e", "max error det J | max_determinant_error:.1e",
                   "wrong fold flags | wrong_flags", "seam values that differ | seams")


def printed(reports):
    return listing(
        reports.rows("tangents"), "row | name", "vertices | vertices", "mismatches | mismatches",
        "clocks/vertex | clocks_per_vertex:.2f", "dq error | max_error:.2e",
        "- differ. | max_difference:.2e", "det error | max_determinant_error:.2e",
        "upright | upright", "folded | folded", "wrong | wrong_flags", "seam values | seam_values",
        "differ | seam_differences",
    ).text() + "\n\nerrors are in units of 2^k > half the lattice's size, of det J in its cube"


def missing(reports):
    return ", ".join(sorted(FORMATS - {row["format"] for row in reports.rows("tangents")}))


TABLES = {"formats": formats}
