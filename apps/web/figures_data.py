"""What the page shows of the reports in docs/reports/: the table of README and the dots of docs/pareto.svg, by the
functions that make those.

SPDX-License-Identifier: Apache-2.0
"""

from figures.charts.pareto import TARGET
from figures.studies import results
from figures.studies.throughput import CORE, throughputs


def organizations(reports):
    """The table of README with all organizations: {header, rows}."""
    table = results.organizations(reports)
    return {"header": list(table.heads), "rows": [[cell.strip("`") for cell in row] for row in table.rows]}


def pareto(reports):
    """A dot for each core: what docs/pareto.svg is drawn from."""
    formats = {row["name"]: row["format"] for row in reports.rows("organizations")}
    return [{"name": one.name, "label": one.label, "format": formats[one.name], "size": one.size,
             "multipliers": one.multipliers, "clock_mhz": one.clock_mhz, "interval": one.interval,
             "per_second": one.per_second}
            for one in throughputs(reports, CORE) if one.target == TARGET]
