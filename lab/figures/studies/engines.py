"""make -C lab engines: the recorded commands through other simulators.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table, listing, shown

NAMES = {"verilator": "Verilator", "icarus": "Icarus Verilog", "cxxrtl": "CXXRTL of yosys",
         "ecp5": "Verilator, netlist for ECP5"}
ROWS = 5  # of the table of configurations, each in every engine


def simulators(reports):
    """An engine a line: what it has answered, and what the fault planted in it changes."""
    rows, planted = (reports.get("engines")[name] for name in ("rows", "planted"))
    lines = []
    for engine, name in NAMES.items():
        own = [row for row in rows if row["engine"] == engine]
        bad = [row for row in planted if row["engine"] == engine]
        lines.append([name, *(shown(sum(row[field] for row in own), ",")
                              for field in ("streams", "beats", "results", "mismatches")),
                      shown(sum(row["mismatches"] for row in bad), ",") if bad else "-"])
    return Table(["simulator", "streams", "beats", "results", "mismatches",
                  "mismatches with a planted fault"], lines)


def printed(reports):
    return listing(reports.rows("engines"), "simulator | engine", "row | row", "beats | beats",
                   "results | results", "mismatches | mismatches", "seconds | seconds").text()


def missing(reports):
    report = reports.get("engines")
    if len(report["rows"]) < ROWS * len(NAMES):
        return "rows"
    return "" if {row["engine"] for row in report["planted"]} == set(NAMES) else "planted faults"


TABLES = {"simulators": simulators}
FIGURES = {}
