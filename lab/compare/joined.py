"""compare.json: rows of programs and of cores, in one form.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re

FIELDS = ("what", "kind", "device", "vertices_per_s", "per_multiplier", "error", "sorted", "source",
          "latency_ns", "bytes_per_vertex", "energy_nj_per_vertex")
KINDS = ("own", "model", "grid", "peer", "core")
_POWERCAP = pathlib.Path("/sys/class/powercap")


class CompareError(Exception):
    """Why there is no comparison, in one line."""


def processor(cpuinfo=pathlib.Path("/proc/cpuinfo")):
    """Its name, as it calls itself."""
    try:
        match = re.search(r"^model name\s*: (.+)$", cpuinfo.read_text(encoding="utf-8"), re.MULTILINE)
    except OSError:
        match = None
    return match.group(1).strip() if match else "a processor without a name"


def watts():
    """What is known of a processor's watts: it says so itself, or nobody does."""
    if any(_POWERCAP.glob("*/energy_uj")):
        return "watts are not read from this processor's counters"
    return "this processor shows no counter of its energy"


def _kind(what):
    """Of a program of the project."""
    if what.startswith("GridWalker ") or what.endswith(", a grid"):
        return "grid"
    return "model" if " model " in what else "own"


def _program(row, kind, device, source):
    return {"what": row["what"], "kind": kind, "device": device,
            "vertices_per_s": row["vertices_per_s"], "per_multiplier": None, "error": row["error"],
            "sorted": row["sorted"], "source": f"{source}; {watts()}", "latency_ns": row["latency_ns"],
            "bytes_per_vertex": row["bytes_per_vertex"], "energy_nj_per_vertex": None}


def faults(rows):
    """What is missing or cannot be, a line each."""
    violations = [f"no {kind} was measured" for kind in KINDS
                  if not any(row["kind"] == kind for row in rows)]
    for row in rows:
        if set(FIELDS) - set(row):
            violations.append(f"{row['what']}: no {', '.join(sorted(set(FIELDS) - set(row)))}")
        elif not row["vertices_per_s"] > 0:
            violations.append(f"{row['what']}: {row['vertices_per_s']} vertices a second")
        elif not 0 < row["error"] < 1:
            violations.append(f"{row['what']}: an error of {row['error']}")
    return violations


def report(measured, peers, cores):
    """The whole report. Raises CompareError where it is not whole.

    measured: compare-own.json; peers, cores: rows
    """
    name = processor()
    device = f"{name}, one core"
    best = "the best of several runs on one core"
    own = [_program(row, kind, device, f"hwffd-compare, {best}"
                    + (f", {measured['vector_units']}" if kind == "own" else ""))
           for row in measured["software"] for kind in [_kind(row["what"])]]
    others = [_program(row, "peer", device, f"its package of the index, {best}") for row in peers]
    rows = [*own, *others, *cores]
    wrong = faults(rows)
    if wrong:
        raise CompareError("; ".join(wrong))
    return {"vertices": measured["vertices"], "processor": name,
            "vector_units": measured["vector_units"], "rows": rows}
