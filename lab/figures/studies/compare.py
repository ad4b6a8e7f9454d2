"""make compare: programs on one core of a processor, and cores that have been routed.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.results import RequestError
from tools.reports.text_table import Table, shown

MILLION = 1e6
FLOAT, DOUBLE = "LatticeEvaluator<float>", "LatticeEvaluator<double>"
KINDS = ("own", "model", "peer", "core", "cells")


def pairs(reports):
    """(a row of vertices in any order, the same of sorted ones), as fast ones first in each kind."""
    by_order = {}
    for row in reports.rows("compare"):
        by_order.setdefault((row["kind"], row["what"], row["device"]), {})[row["sorted"]] = row
    both = [(by_sorted[False], by_sorted[True]) for by_sorted in by_order.values() if set(by_sorted) == {False, True}]
    return sorted(both, key=lambda pair: (KINDS.index(pair[0]["kind"]),
                                          -pair[0]["vertices_per_s"]))


def name(row):
    """What a line is called: the program, or the module and its row."""
    if row["kind"] == "peer":
        package, _, called = row["what"].partition(", ")
        return f"{package} `{called}`"
    if row["kind"] != "core":
        return f"`{row['what']}`"
    module, _, which = row["what"].partition(" ")
    return f"`{module}` {which}"


def _rate(row):
    return shown(row["vertices_per_s"] / MILLION, ".2f")


def _scaled(row, field, unit, form):
    return shown(None if row[field] is None else row[field] / unit, form)


def cells(reports):
    """Evaluators in standard cells, where make -C lab energy has been: they have an energy and no clock."""
    measured = reports.rows("energy") if reports.has("energy") else []
    return [[f"`ffd_org_select` {row['name']}", row["device"], *["-"] * 5,
             shown(row["energy_nj_per_vertex"], ".1f"), "-"] for row in measured]


def programs(reports):
    """Each with vertices in any order and sorted by cell."""
    lines = []
    for shuffled, in_order in pairs(reports):
        lines.append([
            name(shuffled), shuffled["device"] + (" (1)" if shuffled.get("remark") else ""), _rate(shuffled),
            _rate(in_order), _scaled(shuffled, "per_multiplier", MILLION, ".3f"),
            _scaled(shuffled, "latency_ns", 1, ",.0f"), _scaled(shuffled, "bytes_per_vertex", 1, ".0f"),
            _scaled(shuffled, "energy_nj_per_vertex", 1, ".2f"),
            shown(max(shuffled["error"], in_order["error"]), ".1e")])
    return Table(["what", "on", "million vertices per second", "sorted by cell",
                  "per multiplier", "latency, ns", "bytes per vertex", "nJ per vertex",
                  "max error"], lines + cells(reports))


def grids(reports):
    """The vertices of a regular grid: models that walk along its rows, and devices."""
    rows = sorted((row for row in reports.rows("compare") if row["kind"] == "grid"),
                  key=lambda row: -row["vertices_per_s"])
    if not rows:
        raise RequestError("compare has no rows of kind grid")
    return Table(["what", "on", "million vertices per second", "bytes per vertex", "max error"],
                 [[name(row), row["device"], _rate(row), _scaled(row, "bytes_per_vertex", 1, ".0f"),
                   shown(row["error"], ".1e")] for row in rows])


def printed(reports):
    report = reports.get("compare")
    remarks = sorted({row["remark"] for row in report["rows"] if row.get("remark")})
    return "\n\n".join([
        f"{report['vertices']:,} vertices in a lattice of 16 x 16 x 16 points; "
        f"{report['processor']}, {report['vector_units']}",
        programs(reports).text(),
        *([f"a regular grid over the same lattice\n\n{grids(reports).text()}"]
          if any(row["kind"] == "grid" for row in report["rows"]) else []),
        *(f"(1) {remark}" for remark in remarks)])


def _rows(reports, kind, is_sorted):
    selected = reports.rows("compare", kind=kind, sorted=str(is_sorted))
    if not selected:
        raise RequestError(f"compare has no rows of kind {kind}")
    return selected


def _fastest(kind, is_sorted, value=None):
    """A figure of the fastest row of a kind; its rate in millions unless another is wanted."""
    def figure(reports):
        # A clock without the delays of multipliers is no clock to compare with.
        selected = [row for row in _rows(reports, kind, is_sorted) if not row.get("remark")]
        best = max(selected, key=lambda row: row["vertices_per_s"])
        return value(best) if value else best["vertices_per_s"] / MILLION
    return figure


def _million(what, is_sorted):
    def figure(reports):
        selected = reports.rows("compare", what=what, sorted=str(is_sorted))
        if len(selected) != 1:
            raise RequestError(f"compare has {len(selected)} rows of {what}")
        return selected[0]["vertices_per_s"] / MILLION
    return figure


def _quotient(above, below):
    return lambda reports: above(reports) / below(reports)


def _words(row):
    return row["what"].split()[-1]


def _least_latency(kind):
    return lambda reports: min(row["latency_ns"] for row in _rows(reports, kind, False)
                               if row["latency_ns"] and not row.get("remark"))


def _most_per_multiplier(reports):
    return max(row["per_multiplier"] for row in _rows(reports, "core", False)
               if row["per_multiplier"] and not row.get("remark")) / MILLION


def missing(reports):
    """What is committed has every kind of row, and each core with streams that was routed; variants may have none."""
    measured = reports.rows("compare")
    absent = [f"rows of kind {kind}" for kind in KINDS[:4] if not any(row["kind"] == kind for row in measured)]
    named = {row["what"] for row in measured}
    routed = [f"{row['top']} {row['name']}" for row in reports.rows("pnr", top="hwffd_stream") if "+" not in row["name"]]
    return ", ".join(absent + [name for name in dict.fromkeys(routed) if name not in named])


TABLES = {"programs": programs, "grids": grids}
FIGURES = {
    "float_random": _million(FLOAT, False), "float_sorted": _million(FLOAT, True),
    "double_random": _million(DOUBLE, False), "double_sorted": _million(DOUBLE, True),
    "float_sorted_reached": lambda reports: _million(FLOAT, True)(reports) >= 100,
    "peer_random": _fastest("peer", False),
    "peer_name": _fastest("peer", False, lambda row: row["what"].split(",")[0]),
    "times_peer_random": _quotient(_million(DOUBLE, False), _fastest("peer", False)),
    "times_peer_sorted": _quotient(_million(DOUBLE, True), _fastest("peer", True)),
    "core_random": _fastest("core", False), "core_sorted": _fastest("core", True),
    "core_name": _fastest("core", False, _words),
    "core_sorted_name": _fastest("core", True, _words),
    "core_latency_ns": _least_latency("core"), "own_latency_ns": _least_latency("own"),
    "peer_latency_ns": _least_latency("peer"),
    "core_per_multiplier": _most_per_multiplier,
    "float_times_core_random": _quotient(_million(FLOAT, False), _fastest("core", False)),
    "float_times_core_sorted": _quotient(_million(FLOAT, True), _fastest("core", True)),
    "model_random": _fastest("model", False),
}
