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
    return [{"name": one.name, "label": one.label, "format": formats[one.name], "size": one.size,
             "multipliers": one.multipliers, "clock_mhz": one.clock_mhz, "interval": one.interval,
             "per_second": one.per_second}
            for one in throughputs(results, CORE) if one.target == TARGET]
