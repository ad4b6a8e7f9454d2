"""make pnr: clocks after placement and routing.

SPDX-License-Identifier: Apache-2.0
"""

import csv

from figures.expressions import shown
from figures.table import Table


def listed(_, rows):
    return Table(
        ["row", "module", "target", "MHz", "least", "most", "share", "to be reached", "reached"],
        [[f"`{row['name']}`", f"`{row['top']}`", row["target"],
          *(shown(row[field], ".1f") for field in ("fmax_mhz", "fmax_min", "fmax_max")),
          shown(row["fmax_share"], ".2f"), _aim(row), shown(row["reached"])]
         for row in rows])


def clocks(reports):
    return listed(reports, reports.rows("pnr"))


def _aim(row):
    aims = [form.format(row[field]) for field, form in (("aim_share", "{:.2f}"),
                                                        ("aim_mhz", "{:.0f} MHz"))
            if row[field] is not None]
    return " and ".join(aims) or "-"


def document(reports):
    """build/reports/pnr.md"""
    report, rows = reports.get("pnr"), reports.get("pnr")["rows"]
    devices = {row["target"]: row["device"] for row in rows}
    measures = [f"{target} ({device}): {report['multiplier_mhz'][target]:.1f} MHz"
                for target, device in devices.items() if report["multiplier_mhz"].get(target)]
    absent = len(_wanted(reports)) - len(rows)
    parts = ["# Clocks after routing",
             "Median of the seeds routed, three when all are. Share: in parts of one registered "
             "multiplier in the same flow. What is routed and how is in synth/README.md.",
             "The multiplier: " + "; ".join(measures) + "." if measures else "",
             listed(reports, rows).markdown(),
             f"{absent} of {len(_wanted(reports))} rows have not been routed from the present "
             "sources." if absent else "",
             "Critical paths, of the slowest seed:",
             *(f"* `{row['name']}`, `{row['top']}`, {row['target']}: {row['critical_path']}"
               for row in rows)]
    return "\n\n".join(part for part in parts if part) + "\n"


def _wanted(reports):
    lines = (reports.root / "synth" / "clocks.csv").read_text(encoding="utf-8").splitlines()
    return list(csv.DictReader(lines))


def printed(reports):
    return clocks(reports).text()


def missing(reports):
    absent = len(_wanted(reports)) - len(reports.rows("pnr"))
    return f"{absent} rows" if absent else ""


TABLES = {"clocks": clocks}
