"""make plates: the plates of the paper, their vertices out of the simulated RTL.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import listing


def plates(reports):
    return listing(reports.rows("plates"), "plate | file", "vertices | vertices",
                   "mismatches | mismatches")


def total(field):
    return lambda reports: sum(row[field] for row in reports.rows("plates"))


def missing(reports):
    return "" if len(reports.rows("plates")) == 10 else "plates"


TABLES = {"plates": plates}
FIGURES = {field: total(field) for field in ("vertices", "mismatches")}
