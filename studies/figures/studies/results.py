"""The table of results of README: what several reports say of each organization.

SPDX-License-Identifier: Apache-2.0
"""

from figures.expressions import shown
from figures.studies.organizations import is_plain, rows
from figures.table import Table
from organizations import label

_PLACE = {"target": "ecp5", "top": "ffd_org_select"}


def _by_name(reports, name):
    return {row["name"]: row for row in reports.rows(name, **_PLACE)}


def organizations(reports, *names):
    """Organizations in fx18, overlapped, on ECP5, all or those named; the clock where they have
    been routed.
    """
    mapped, routed, lines = _by_name(reports, "synth"), _by_name(reports, "pnr"), []
    for row in rows(reports, format="fx18", schedule="overlapped"):
        name = label(row)
        if not is_plain(row) or names and name.replace(" ", "") not in names:
            continue
        area, clock = mapped.get(row["name"], {}), routed.get(row["name"], {}).get("fmax_mhz")
        interval = row["interval_overlapped"]
        lines.append([
            f"`{name}`", shown(interval, "g"), shown(area.get("dsp")),
            shown(area["lut"] + area["lutram"]) if area else "-", shown(clock, ".1f"),
            shown(clock / interval if clock else None, ".2f"), shown(row["max_error"], ".1e")])
    return Table(["organization", "cycles per vertex", "multipliers", "LUT", "MHz",
                  "million vertices per second", "max error"], lines)


TABLES = {"organizations": organizations}
