"""make boards: bitstreams.

SPDX-License-Identifier: Apache-2.0
"""

from figures.expressions import shown
from figures.table import Table


def boards(reports):
    rows = reports.rows("boards")
    return Table(["board", "row", "MHz, median", "MHz needed", "most used of the chip"],
                 [[row["board"], f"`{row['row']}`", shown(row["median_mhz"], ".1f"),
                   shown(row["clock_mhz"], "g"), _fullest(row["used"])] for row in rows])


def _fullest(used):
    name, (count, available) = max(used.items(), key=lambda item: item[1][0] / item[1][1])
    return f"{name}: {count:,} of {available:,}"


def printed(reports):
    return boards(reports).text()


def missing(reports):
    return "" if len(reports.rows("boards")) >= 2 else "boards"


TABLES = {"boards": boards}
