"""What the page shows of the newest results in docs/results: the table of README and the dots of docs/pareto.svg.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports import organization_tables
from tools.reports.throughput import CORE, throughputs

TARGET = "ecp5"


def organizations(results):
    """The table of README with all organizations: {header, rows}."""
    table = organization_tables.organizations(results)
    return {"header": list(table.heads), "rows": [[cell.strip("`") for cell in row] for row in table.rows]}


def pareto(results):
    """A dot for each core: what docs/pareto.svg is drawn from."""
    formats = {row["name"]: row["format"] for row in results.rows("organizations")}
    return [{"name": entry.name, "label": entry.label, "format": formats[entry.name], "size": entry.size,
             "multipliers": entry.multipliers, "clock_mhz": entry.clock_mhz, "interval": entry.interval,
             "per_second": entry.per_second}
            for entry in throughputs(results, CORE) if entry.target == TARGET]
