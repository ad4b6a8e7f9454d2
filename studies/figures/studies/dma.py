"""make sim STREAM=dma: a mesh from memory to memory.

SPDX-License-Identifier: Apache-2.0
"""

from figures.expressions import shown
from figures.table import Table


def runs(reports):
    return Table(["row", "deform", "checked", "mismatches", "cycles per vertex", "use of the bus"],
                 [[f"`{row['org']}-{row['format']}-{row['schedule']}`", row["deform"],
                   shown(row["checked"]), shown(row["mismatches"]),
                   shown(row["clocks_per_vertex"], ".2f"), shown(row["bus_utilisation"], ".1%")]
                  for row in reports.rows("dma")])


def printed(reports):
    return runs(reports).text()


def missing(reports):
    return "" if all(row["stream"] == "dma" for row in reports.rows("dma")) else "runs with DMA"


TABLES = {"runs": runs}
