"""make sim STREAM=dma: a mesh from memory to memory.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import listing


def runs(reports):
    rows = [{**row, "row": f"{row['org']}-{row['format']}-{row['schedule']}"}
            for row in reports.rows("dma")]
    return listing(rows, "row | `row`", "deform | deform", "checked | checked",
                   "mismatches | mismatches", "cycles per vertex | clocks_per_vertex:.2f",
                   "use of the bus | bus_utilisation:.1%")


def missing(reports):
    return "" if all(row["stream"] == "dma" for row in reports.rows("dma")) else "runs with DMA"


TABLES = {"runs": runs}
