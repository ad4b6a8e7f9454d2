"""make -C lab testfloat: the binary32 units on operands by TestFloat's scheme.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table, shown

UNITS = {"add": "`ffd_fp_add`", "mul": "`ffd_fp_mul`", "fma": "`ffd_fp_fma`"}


def units(reports):
    """A unit at a latency a line; last what a reference shows that rounds towards zero."""
    return Table(["unit", "latency", "cases", "mismatches", "pairs or triples of corners", "mismatches with a wrong reference"],
                 [[UNITS[row["unit"]], shown(row["latency"]), shown(row["cases"], ","), shown(row["mismatches"], ","),
                   f"{shown(row['combinations'], ',')} of {shown(row['all_combinations'], ',')}",
                   f"{shown(row['control_mismatches'], ',')} of {shown(row['control_cases'], ',')}"]
                  for row in reports.rows("testfloat")])


def missing(reports):
    rows = reports.rows("testfloat")
    lacking = set(UNITS) - {row["unit"] for row in rows}
    return ", ".join(sorted(lacking)) or ("mismatches" if any(row["mismatches"] for row in rows) else "")


TABLES = {"units": units}
FIGURES = {}
