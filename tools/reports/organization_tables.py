"""The table of results of README: what several reports say of each organization.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table, shown
from tools.tables.organizations import is_second_name, known, label

EVALUATOR, CORE, TRANSPOSE = "ffd_org_select", "hwffd_stream", "hwffd_scatter"


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


def _bound_of(row, bounds):
    """What is proved of a core that evaluates; '-' of the transpose."""
    own = known().get(row["org"])
    form = "powers" if row["name"].split("+")[0].endswith("-powers") else own.form if own else ""
    return shown(None if row["top"] == TRANSPOSE else bounds.get((form, row["format"])), ".1e")


def routed_cores(reports, *names):
    """Whole cores that have been routed on ECP5, all or those named ROW or ROW/TOP, as they are built: clocks and
    vertices, or gradients, a second in any order and along rows of a grid; of `hwffd_adjoint` those of its evaluator.
    """
    bounds, lines = _bounds(reports), []
    for row in reports.rows("synth", target="ecp5"):
        own = {row["name"], f"{row['name']}/{row['top']}"}
        if not row.get("routed") or row["top"] == EVALUATOR or names and not own & set(names):
            continue
        clocks = [row["fmax_mhz"] * 1e6 / row[field] for field in ("vertices_per_s", "row_vertices_per_s")]
        lines.append([
            f"`{row['name']}`", f"`{row['top']}`", row["meaning"] or "positions, derivatives, det J",
            *(shown(clock, ".3g") for clock in clocks),
            shown(row["dsp"]), _luts(row), shown(row["bram"]), shown(row["fmax_mhz"], ".1f"),
            *(shown(row[field] / 1e6, ".1f") for field in ("vertices_per_s", "row_vertices_per_s")), _bound_of(row, bounds)])
    return Table(["core", "module", "built with", "cycles per vertex", "in rows of grids", "multipliers", "LUT",
                  "block memories", "MHz", "million vertices per second", "in rows of grids", "error, proved bound"], lines)


TABLES = {"organizations": organizations, "cores": routed_cores}
