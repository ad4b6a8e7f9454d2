"""make pnr: clocks after placement and routing.

SPDX-License-Identifier: Apache-2.0
"""

import csv

from tools.reports.text_table import listing


def listed(_, rows):
    remark = ["remark | remark"] if any(row.get("remark") for row in rows) else []
    return listing([{"remark": "", **row, "aim": _aim(row)} for row in rows], "row | `name`",
                   "module | `top`", "target | target", "MHz | fmax_mhz:.1f",
                   "least | fmax_min:.1f", "most | fmax_max:.1f", "share | fmax_share:.2f",
                   "to be reached | aim", "reached | reached", *remark)


def clocks(reports, *tops):
    """Of all rows, or of those with one of these tops."""
    return listed(reports, [row for row in reports.rows("pnr") if not tops or row["top"] in tops])


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
    sections = ["# Clocks after routing",
                "Median of the seeds routed, three when all are. Share: in parts of one registered "
                "multiplier in the same flow. What is routed and how is in synth/README.md.",
                "The multiplier: " + "; ".join(measures) + "." if measures else "",
                listed(reports, rows).markdown(),
                f"{absent} of {len(_wanted(reports))} rows have not been routed from the present "
                "sources." if absent else "",
                "Critical paths, of the slowest seed:",
                *(f"* `{row['name']}`, `{row['top']}`, {row['target']}: {row['critical_path']}"
                  for row in rows)]
    return "\n\n".join(part for part in sections if part) + "\n"


def _wanted(reports):
    lines = (reports.root / "synth" / "clocks.csv").read_text(encoding="utf-8").splitlines()
    return list(csv.DictReader(lines))


def missing(reports):
    absent = len(_wanted(reports)) - len(reports.rows("pnr"))
    return f"{absent} rows" if absent else ""


TABLES = {"clocks": clocks}
FIGURES = {"rows": lambda reports: len(reports.rows("pnr"))}
