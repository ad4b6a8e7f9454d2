"""make -C lab soak: random traffic by the hour.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import listing

COLUMNS = ("traffic | `traffic`", "seeds | seeds", "tests | tests", "failed | failed",
           "results counted | results", "clocks counted | clocks")


def traffic(reports):
    """Each kind of traffic."""
    return listing(reports.rows("soak"), *COLUMNS)


def printed(reports):
    return traffic(reports).text()


def _sum(field):
    return lambda reports: sum(row[field] for row in reports.rows("soak"))


TABLES = {"traffic": traffic}
FIGURES = {name: _sum(name) for name in ("seeds", "tests", "failed", "results", "clocks")}
