"""The table of results of README: what several reports say of each organization.

SPDX-License-Identifier: Apache-2.0
"""

from figures.expressions import shown
from figures.studies.bounds import sharpest
from figures.studies.organizations import is_plain, rows
from figures.table import Table
from organizations import known, label

OLDER = " \u2020"
EVALUATOR, CORE = "ffd_org_select", "hwffd_stream"


def _by_name(reports, name, top):
    return {row["name"]: row for row in reports.rows(name, target="ecp5", top=top)}


def _luts(area):
    return shown(area["lut"] + area["lutram"]) if area else "-"


def organizations(reports, *names):
    """Organizations in fx18, overlapped, on ECP5, all or those named: the whole core, its clock where
    it has been routed, what the evaluator is of it, and the bound that is proved of its errors beside the
    largest of a sample. A dagger marks a row measured with older RTL.
    """
    bounds = sharpest(reports) if reports.has("bounds") else {}
    cores, clocks = (_by_name(reports, name, CORE) for name in ("synth", "pnr"))
    evaluators, lines = _by_name(reports, "synth", EVALUATOR), []
    for row in rows(reports, format="fx18", schedule="overlapped"):
        name = label(row)
        if not is_plain(row) or names and name.replace(" ", "") not in names:
            continue
        core, evaluator = (found.get(row["name"], {}) for found in (cores, evaluators))
        routed = clocks.get(row["name"], {})
        clock, interval = routed.get("fmax_mhz"), row["interval_overlapped"]
        older = any(found.get("older") for found in (core, evaluator, routed))
        lines.append([
            f"`{name}`" + OLDER * older, shown(interval, "g"), shown(core.get("dsp")), _luts(core),
            _luts(evaluator), shown(clock, ".1f"),
            shown(clock / interval if clock else None, ".2f"),
            shown(bounds.get((known()[row["org"]].form, row["format"]), {}).get("bound"), ".1e"),
            shown(row["max_error"], ".1e")])
    return Table(["organization", "cycles per vertex", "multipliers", "LUT", "of these, evaluator",
                  "MHz", "million vertices per second", "error, proved bound", "error, sample"], lines)


TABLES = {"organizations": organizations}
