"""Whole cores that have been routed: clocks that were counted in their RTL, at the clock that they
reach after place and route.

SPDX-License-Identifier: Apache-2.0
"""

from tools.synth import netlist

CORE, SYSTEM = "hwffd_stream", "hwffd_axi"
# By how much clocks of vertices in any order may differ from those of sorted ones, in an
# organization that does not look at the order.
SAME = 1.01


def counted_as(name):
    """The row in whose RTL the clocks of a core are counted: its own. A variant with other features is
    as fast as its row, of one with other parameters nothing is counted: None. Raises TableError.
    """
    if "+" not in name:
        return name
    variant = netlist.find(name)
    return variant.row.name if set(dict(variant.more)) == {"FEATURES"} else None


def names(reports):
    """Rows whose core has been routed, as they are counted, each once."""
    names_counted = [counted_as(row["name"]) for row in reports.rows("pnr", top=CORE)]
    return list(dict.fromkeys(name for name in names_counted if name))


def _multipliers(reports, routed):
    mapped = reports.rows("synth", **{key: routed[key] for key in ("name", "top", "target")})
    return next((row["dsp"] for row in mapped if row.get("dsp")), None)


def _row(reports, routed, core, clocks, counted, latency):
    """The row of one core, as it is counted for one order of vertices."""
    hertz, multipliers = 1e6 * routed["fmax_mhz"], _multipliers(reports, routed)
    rate = hertz / clocks
    source = (f"{routed['fmax_mhz']:.1f} MHz by make pnr, median of {len(routed['seeds'])} seeds; "
              f"{clocks:.4g} clocks a vertex, {counted}")
    if routed.get("remark"):
        source += f"; {routed['remark']}"
    return {"what": f"{routed['top']} {routed['name']}", "kind": "core",
            "device": routed["device"], "vertices_per_s": rate,
            "per_multiplier": rate / multipliers if multipliers else None,
            "error": core["error"], "sorted": core["sorted"], "source": source,
            "latency_ns": 1e9 * latency / hertz if latency else None,
            "bytes_per_vertex": core["bytes_per_vertex"], "energy_nj_per_vertex": None,
            "multipliers": multipliers, "remark": routed.get("remark")}


def _clocks_by_dma(reports, routed, pair):
    """Clocks a vertex from memory to memory, where make sim STREAM=dma has counted them and the
    order of vertices plays no part."""
    org, word, *rest = routed["name"].split("-")
    intervals = [core["clocks_per_vertex"] for core in pair]
    if rest != ["overlapped"] or max(intervals) > SAME * min(intervals) or not reports.has("dma"):
        return None
    runs = reports.rows("dma", org=org, format=word, schedule="overlapped", stream="dma")
    return max((run["clocks_per_vertex"] for run in runs), default=None)


def rows(reports, counted):
    """Two rows for each routed core, of vertices in any order and of sorted ones.

    counted: what hwffd-compare found of each row, in both orders
    """
    measured = []
    for routed in reports.rows("pnr", top=f"{CORE},{SYSTEM}"):
        pair = [core for core in counted if core["name"] == counted_as(routed["name"])]
        if not pair:
            continue
        if routed["top"] == CORE:
            measured += [_row(reports, routed, core, core["clocks_per_vertex"], "counted in the RTL",
                              core["latency_clocks"]) for core in pair]
            continue
        clocks = _clocks_by_dma(reports, routed, pair)
        if clocks:
            measured += [_row(reports, routed, core, clocks, "by make sim STREAM=dma", None)
                         for core in pair]
    return measured
