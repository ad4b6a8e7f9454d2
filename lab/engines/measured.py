"""The rows of both reports, and what of them does not hold.

SPDX-License-Identifier: Apache-2.0
"""

import sys
from dataclasses import dataclass, field

from lab.engines import planted, streams

ICARUS = "icarus"
# What Icarus simulates besides the sources of hwffd_stream: what of a core, and how.
OTHERS = {"gates": (streams.TOP, streams.simulate_gates),
          "buses": (streams.AXI_TOP, streams.simulate_in_memory)}
ECP5 = "ecp5"
LUT = "lut"  # the fault of its netlist, tools/synth/netlist_fault.py


def show(what):
    print(f"engines: {what}", file=sys.stderr, flush=True)


def _engine(engine, stream, mismatches, seconds):
    return {"engine": engine, "row": stream.row.name, "streams": 1, "beats": stream.beats,
            "results": len(stream.wanted.results), "mismatches": mismatches,
            "seconds": round(seconds, 1)}


def _unknown(what, top, stream, mismatches, unknowns):
    return {"top": top, "of": what, "row": stream.row.name, "clocks": unknowns.clocks,
            "checked": unknowns.checked, "unknown": len(unknowns.names), "mismatches": mismatches,
            "names": list(unknowns.names)}


def _report():
    return {"rows": [], "planted": []}


@dataclass
class Reports:
    """engines.json and unknowns.json, as far as they are measured."""

    engines: dict = field(default_factory=_report)
    unknowns: dict = field(default_factory=_report)

    def measure(self, programs, stream):
        """All engines, and what Icarus simulates but for gates."""
        for engine in streams.PROGRAMS:
            show(f"{stream.row.name}: {engine}")
            self.engines["rows"].append(
                _engine(engine, stream, *streams.simulate(programs, engine, stream)))
        show(f"{stream.row.name}: {ICARUS}")
        mismatches, unknowns = streams.simulate_with_x(stream)
        self.engines["rows"].append(_engine(ICARUS, stream, mismatches, unknowns.seconds))
        self.unknowns["rows"].append(_unknown("sources", streams.TOP, stream, mismatches, unknowns))
        self._measure_other("buses", stream)

    def measure_gates(self, stream):
        """The core as gates, which are slow."""
        self._measure_other("gates", stream)

    def _measure_other(self, what, stream):
        show(f"{stream.row.name}: X in {what}")
        top, simulate = OTHERS[what]
        self.unknowns["rows"].append(_unknown(what, top, stream, *simulate(stream)))

    def plant(self, programs, stream):
        """A fault in the answers of each engine, and a register that nothing resets."""
        for engine in streams.PROGRAMS:
            show(f"planted: {engine}")
            self.engines["planted"].append({
                **_engine(engine, stream, *streams.simulate(programs, engine, stream, streams.PLANTED)),
                "fault": LUT if engine == ECP5 else planted.COEFFICIENT})
        for what, fault, simulate in ((ICARUS, planted.COEFFICIENT, streams.simulate_with_x),
                                      ("sources", planted.RESET, streams.simulate_with_x),
                                      ("gates", planted.RESET, streams.simulate_gates),
                                      ("buses", planted.RESET, streams.simulate_in_memory)):
            show(f"planted: {what}")
            mismatches, unknowns = simulate(stream, (fault,), f"{streams.PLANTED}-{fault}")
            if fault == planted.COEFFICIENT:
                self.engines["planted"].append(
                    {**_engine(what, stream, mismatches, unknowns.seconds), "fault": fault})
            else:
                top = OTHERS[what][0] if what in OTHERS else streams.TOP
                self.unknowns["planted"].append(
                    {**_unknown(what, top, stream, mismatches, unknowns), "fault": fault})


def faults(engines, unknowns):
    """What does not hold, a line each."""
    violations = [f"{row['engine']}, {row['row']}: {row['mismatches']} of {row['results']} results and the "
                  "counts of events differ from the model's" for row in engines["rows"] if row["mismatches"]]
    violations += [f"{row['top']} ({row['of']}), {row['row']}: {name}"
                   for row in unknowns["rows"] for name in row["names"]]
    violations += [f"{row['top']} ({row['of']}), {row['row']}: {row['mismatches']} results differ from the "
                   "model's" for row in unknowns["rows"] if row["mismatches"]]
    violations += [f"{row['engine']}: the planted fault in '{row['fault']}' was not found"
                   for row in engines["planted"] if not row["mismatches"]]
    violations += [f"{row['top']} ({row['of']}): the planted fault in '{row['fault']}' was not found"
                   for row in unknowns["planted"] if not row["unknown"]]
    return violations
