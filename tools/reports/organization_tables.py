"""The table of results of README: what several reports say of each organization.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table, shown
from tools.tables.organizations import is_second_name, known, label

EVALUATOR, CORE = "ffd_org_select", "hwffd_stream"


def _by_name(reports, name, top):
    return {row["name"]: row for row in reports.rows(name, target="ecp5", top=top)}


def rows(reports, **wanted):
    """Rows as measured: without the tree of 64 units, which is `parallel`, under its second name."""
    return [row for row in reports.rows("organizations", **wanted) if not is_second_name(row)]


def is_plain(row):
    """A row that differs from the others of its format by organization, N and schedule only."""
    return len(row["name"].split("-")) == 3


def _bounds(reports):
    """(form, format) -> the smallest bound that is proved."""
    bounds = {}
    for row in reports.rows("bounds") if reports.has("bounds") else ():
        key = row["form"], row["format"]
        bounds[key] = min(row["bound"], bounds.get(key, row["bound"]))
    return bounds


def _luts(area):
    return shown(area["lut"] + area["lutram"]) if area else "-"


def organizations(reports, *names):
    """Organizations in fx18, overlapped, on ECP5, all or those named: the whole core, its clock where
    it has been routed, what the evaluator is of it, and the bound that is proved of its errors beside the
    largest of a sample.
    """
    bounds = _bounds(reports)
    cores, clocks = (_by_name(reports, name, CORE) for name in ("synth", "pnr"))
    evaluators, lines = _by_name(reports, "synth", EVALUATOR), []
    for row in rows(reports, format="fx18", schedule="overlapped"):
        name = label(row)
        own = known().get(row["org"])  # none: it went since
        if not is_plain(row) or own is None or names and name.replace(" ", "") not in names:
            continue
        core, evaluator = (operators.get(row["name"], {}) for operators in (cores, evaluators))
        routed = clocks.get(row["name"], {})
        clock, interval = routed.get("fmax_mhz"), row["interval_overlapped"]
        lines.append([
            f"`{name}`", shown(interval, "g"), shown(core.get("dsp")), _luts(core),
            _luts(evaluator), shown(clock, ".1f"),
            shown(clock / interval if clock else None, ".2f"),
            shown(bounds.get((own.form, row["format"])), ".1e"),
            shown(row["max_error"], ".1e")])
    return Table(["organization", "cycles per vertex", "multipliers", "LUT", "of these, evaluator",
                  "MHz", "million vertices per second", "error, proved bound", "error, sample"], lines)


TABLES = {"organizations": organizations}
