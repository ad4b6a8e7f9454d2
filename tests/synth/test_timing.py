"""tools/synth/timing.py: netlists as OpenSTA reads them, and what is taken from its output. Where
OpenSTA and the library are, a small design is timed and compared with sums by hand.

SPDX-License-Identifier: Apache-2.0
"""

import shutil

import pytest

from tools.project_root import ROOT
from tools.rtl import rtl_sources
from tools.synth import liberty, timing

CELLS = {"INVX1": ("logic", {}), "DFFPOSX1": ("register", {})}
REPORT = """\
Startpoint: u_a/sum_q_3 (rising edge-triggered flip-flop clocked by clk)
Endpoint: result_o[0] (output port clocked by clk)
             0.0000   10.0000   clock clk (rise edge)
                      5.7500   slack (MET)
Sequential             1.44e-01   5.94e-03   9.71e-07   1.50e-01  53.6%
Total                  2.490000e-01   3.090000e-02   4.060000e-06   2.799000e-01 100.0%
"""


def cell(cell_type, inputs, outputs):
    return {"type": cell_type, "parameters": {}, "connections": {**inputs, **outputs},
            "port_directions": {**dict.fromkeys(inputs, "input"),
                                **dict.fromkeys(outputs, "output")}}


def flip_flop(d, q):
    return cell("DFFPOSX1", {"CLK": [2], "D": [d]}, {"Q": [q]})


def module(cells, ports, nets=()):
    """`ports` and `nets`: name -> bits; a port's name ends in _i, _o or is clk."""
    return {"cells": cells,
            "ports": {name: {"direction": "output" if name.endswith("_o") else "input",
                             "bits": bits} for name, bits in ports.items()},
            "netnames": {name: {"hide_name": 0, "bits": bits} for name, bits in dict(nets).items()}}


def chain(inverters, kind="INVX1"):
    """Two registers with inverters in between, in a module of their own."""
    cells = {f"i{n}": cell(kind, {"A": [4 + n]}, {"Y": [5 + n]}) for n in range(inverters)}
    inner = module({"f": flip_flop(3, 4), "g": flip_flop(4 + inverters, 50), **cells},
                   {"clk": [2], "d_i": [3], "q_o": [50]}, {"first_q": [4], "sum_q": [50]})
    top = module({"\\u_inner": cell("$inner", {"clk": [2], "d_i": [5]}, {"q_o": [6]})},
                 {"clk": [2], "d_i": [4, 5], "q_o": [6, 6, "1", "x"]})
    return {"modules": {"$inner": inner, "top": top}}


OPEN_STA = pytest.mark.skipif(not (liberty.PATH.is_file() and shutil.which(timing.PROGRAM)),
                              reason="no OpenSTA or no library here")


def test_netlist(monkeypatch):
    monkeypatch.setattr(liberty, "cells", lambda: CELLS)
    assert timing.verilog(chain(1), "top").splitlines() == [
        "module m0 (clk, d_i, q_o);", "  input clk;", "  input d_i;", "  output q_o;",
        "  DFFPOSX1 \\first_q (.CLK(clk), .D(d_i), .Q(n4));",
        "  DFFPOSX1 \\sum_q (.CLK(clk), .D(n5), .Q(q_o));",
        "  INVX1 \\g2 (.A(n4), .Y(n5));", "endmodule",
        "module top (clk, d_i, q_o);", "  input clk;", "  input [1:0] d_i;",
        "  output [3:0] q_o;", "  m0 \\u_inner (.clk(clk), .d_i(d_i[1]), .q_o(q_o[0]));",
        "  assign q_o[1] = q_o[0];", "  assign q_o[2] = 1'b1;", "  assign q_o[3] = 1'b0;",
        "endmodule"]


def test_report():
    assert timing.parse(REPORT) == {"fmax_mhz": round(1000 / 4.25, 1), "power_mw": 279.9,
                                    "critical_path": "from u_a/sum_q_3 to result_o[0]"}


@pytest.mark.parametrize("output, message", (
    ("", "no path or no power"), (REPORT.replace("slack", "slick"), "no path or no power"),
    (REPORT + "Error: v.v, line 2 syntax error\n", "line 2 syntax")))
def test_faults_of_a_report(output, message):
    with pytest.raises(timing.TimingError, match=message):
        timing.parse(output)


def measure(folder, *inverters):
    netlist, steps = folder / "n.v", folder / "s.tcl"
    netlist.write_text(timing.verilog(chain(*inverters), "top"))
    steps.write_text(timing.script(netlist, "top", ROOT / "synth" / "osu018.tcl"))
    return timing.parse(rtl_sources.run([timing.PROGRAM, "-no_init", "-no_splash", "-exit", str(steps)])[1])


@OPEN_STA
def test_longer_paths_are_slower(tmp_path):
    reports = {number: measure(tmp_path, number) for number in (2, 10, 18)}
    periods = [1000 / report["fmax_mhz"] for report in reports.values()]
    assert periods[2] - periods[1] == pytest.approx(periods[1] - periods[0], abs=0.02)
    assert periods[1] - periods[0] > 8 * 0.02
    assert periods[0] < 2
    assert reports[18]["power_mw"] > reports[2]["power_mw"]
    assert reports[10]["critical_path"] == "from u_inner/first_q to u_inner/sum_q"


@OPEN_STA
def test_a_netlist_of_unknown_cells_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(liberty, "cells", lambda: {**CELLS, "$not": ("logic", {})})
    with pytest.raises(timing.TimingError):
        measure(tmp_path, 2, "$not")
