"""make boards: bitstreams.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import listing


def boards(reports):
    return listing([{**row, "fullest": _fullest(row["used"])} for row in reports.rows("boards")],
                   "board | board", "row | `row`", "MHz, median | median_mhz:.1f",
                   "MHz needed | clock_mhz:g", "most used of the chip | fullest")


def _fullest(used):
    name, (count, available) = max(used.items(), key=lambda item: item[1][0] / item[1][1])
    return f"{name}: {count:,} of {available:,}"


def missing(reports):
    return "" if len(reports.rows("boards")) >= 2 else "boards"


TABLES = {"boards": boards}
