"""The energy of three cells, in a library whose figures are few enough to add them by hand.

SPDX-License-Identifier: Apache-2.0
"""

import shutil

import pytest

from lab.energy import activity, flat, library, power, row_report, simulation

HEAD = """library(few) {
  delay_model : table_lookup;
  time_unit : "1ns";
  voltage_unit : "1V";
  current_unit : "1uA";
  pulling_resistance_unit : "1kohm";
  leakage_power_unit : "1nW";
  capacitive_load_unit (1,pf);
  slew_upper_threshold_pct_rise : 80;
  slew_lower_threshold_pct_rise : 20;
  slew_upper_threshold_pct_fall : 80;
  slew_lower_threshold_pct_fall : 20;
  input_threshold_pct_rise : 50;
  input_threshold_pct_fall : 50;
  output_threshold_pct_rise : 50;
  output_threshold_pct_fall : 50;
  nom_voltage : 1.8;
  operating_conditions ( typical ) {
     process : 1;
     voltage : 1.8;
     temperature : 25;
  }
  default_operating_conditions : typical;
  lu_table_template(delay) {
    variable_1 : total_output_net_capacitance;
    variable_2 : input_net_transition;
    index_1 ("0.005, 0.15");
    index_2 ("0.06, 1.2");
  }
  power_lut_template(energy) {
    variable_1 : total_output_net_capacitance;
    variable_2 : input_transition_time;
    index_1 ("0.005, 0.15");
    index_2 ("0.06, 1.2");
  }
  power_lut_template(passive) {
    variable_1 : input_transition_time;
    index_1 ("0.06, 1.2");
  }

"""


def table(name, template, value, rows=2):
    index = '        index_1 ("0.005, 0.15");\n        index_2 ("0.06, 1.2");\n' if rows == 2 else \
        '        index_1 ("0.06, 1.2");\n'
    row = f'"{value}, {value}"'
    return (f"      {name}({template}) {{\n{index}"
            f"        values ( \\\n          {', '.join([row] * rows)});\n      }}\n")


def energies(rise, fall, related=None):
    about = f'      related_pin : "{related}";\n' if related else ""
    template, rows = ("energy", 2) if related else ("passive", 1)
    return (f"    internal_power() {{\n{about}" + table("rise_power", template, rise, rows)
            + table("fall_power", template, fall, rows) + "    }\n")


def timing(related, edge=""):
    tables = "".join(table(f"{kind}_{way}" if kind == "cell" else f"{way}_transition", "delay", value)
                     for kind, value in (("cell", 0.1), ("transition", 0.05))
                     for way in ("rise", "fall"))
    return f'    timing() {{\n      related_pin : "{related}";\n{edge}{tables}    }}\n'


def pin(name, text, capacitance=0.01, direction="input"):
    return (f"  pin({name})  {{\n    direction : {direction};\n    capacitance : {capacitance};\n"
            f"{text}  }}\n")


def cell(name, *groups):
    return f"cell ({name}) {{\narea : 32;\n  cell_leakage_power : 10;\n{''.join(groups)}}}\n\n"


LIBRARY = HEAD + "".join((
    cell("INVX1", pin("A", ""), pin("Y", '    function : "(!A)";\n' + timing("A")
                                    + energies(0.02, 0.04, "A"), 0, "output")),
    cell("NAND2X1", pin("A", ""), pin("B", ""),
         pin("Y", '    function : "(!(A B))";\n' + timing("A") + timing("B")
             + energies(0.01, 0.03, "A") + energies(0.03, 0.05, "B"), 0, "output")),
    cell("DFFPOSX1", '  ff (DS0000,P0002) {\n    next_state : "D";\n    clocked_on : "CLK";\n  }\n',
         pin("CLK", "    clock : true;\n" + energies(0.01, 0.05), 0.02), pin("D", energies(0.02, 0.06)),
         pin("Q", '    function : "DS0000";\n' + timing("CLK", "      timing_type : rising_edge;\n")
             + energies(0.03, 0.05, "CLK"), 0, "output")),
    cell("LATCH", "  latch (DS0000,P0000) {\n  }\n"))) + "}\n"

NETLIST = """module ffd_energy_netlist(clk, d, q);
  input clk;
  wire clk;
  input [1:0] d;
  wire [1:0] d;
  wire n0;
  wire n1;
  output q;
  wire q;
  NAND2X1 c0 (
    .A(d[0]),
    .B(d[1]),
    .Y(n0)
  );
  DFFPOSX1 c1 (
    .CLK(clk),
    .D(n0),
    .Q(n1)
  );
  INVX1 c2 (
    .A(n1),
    .Y(q)
  );
endmodule
"""

# Four clocks from 14 ns on. d[1] changes in each, and twice more in the second.
BENCH = """`timescale 1ns/1ps
module bench;
  reg clk = 1'b0;
  reg [1:0] d = 2'b01;
  wire q;
  ffd_energy_netlist u_cells (.clk(clk), .d(d), .q(q));
  always #5 clk = !clk;
  initial begin
    $dumpfile("nets.vcd");
    $dumpvars(1, u_cells);
    $dumpoff;
    #14 $dumpon;
    #40 $dumpoff;
    #10 $finish;
  end
  initial begin
    #20 d[1] = 1'b1;
    #10 d[1] = 1'b0;
    #1  d[1] = 1'b1;
    #1  d[1] = 1'b0;
    #8  d[1] = 1'b1;
    #10 d[1] = 1'b0;
  end
endmodule
"""
CLOCKS = 4
CHARGE = 1.8 ** 2 / 2  # pJ for each pF and change


@pytest.fixture
def cells():
    return library.read(LIBRARY)


@pytest.fixture
def netlist(cells):
    return flat.read(NETLIST, cells[1])


@pytest.fixture
def nets(cells, tmp_path):
    """What the nets do in Icarus."""
    if not shutil.which("iverilog"):
        pytest.skip("no iverilog")
    for name, text in (("cells.v", library.models(cells[1])), ("netlist.v", NETLIST),
                       ("bench.v", BENCH)):
        (tmp_path / name).write_text(text)
    simulation.command(["iverilog", "-g2005", "-o", "bench.vvp", "-s", "bench", "bench.v",
                        "netlist.v", "cells.v"], tmp_path, "icarus.log")
    simulation.command(["vvp", "-n", "bench.vvp"], tmp_path, "bench.log")
    with (tmp_path / "nets.vcd").open() as lines:
        return activity.read(lines, simulation.PERIOD_PS)


def test_latches_are_no_cells(cells):
    assert list(cells[1]) == ["INVX1", "NAND2X1", "DFFPOSX1"]


def test_functions_and_delays_are_those_of_the_library(cells):
    text = library.models(cells[1])
    assert "assign #100 Y = (~(A&B));" in text and "assign #100 Y = (~A);" in text
    assert "always @(posedge CLK) if (Q !== D) Q <= #100 D;" in text
    assert library.expression("(!((A B)+C))") == "(~((A&B)|C))"
    assert library.expression("(!((S A) + (!S B)))") == "(~((S&A)|(~S&B)))"


@pytest.mark.parametrize("spoil, message", (
    (("NAND2X1 c0", "NAND9X1 c0"), "cells that the library does not have: NAND9X1"),
    (("NAND2X1 c0 (\n", "NAND2X1 \\c0 (\n"), "not one module of cells")))
def test_what_is_not_understood_is_refused(cells, spoil, message):
    with pytest.raises(flat.NetlistError, match=message):
        flat.read(NETLIST.replace(*spoil), cells[1])


def test_the_nets_change_as_counted_by_hand(nets):
    assert nets.clocks(simulation.PERIOD_PS) == CLOCKS and not nets.unknown()
    assert {name: (net.toggles, net.settled) for name, net in nets.nets.items()} == {
        "clk": (8, 0), "d[1]": (6, 4), "d[0]": (0, 0), "n0": (6, 4), "n1": (3, 3), "q": (3, 3)}


def test_the_energy_is_what_the_library_adds_up_to(cells, netlist, nets, tmp_path):
    if not shutil.which("sta"):
        pytest.skip("no sta")
    head, kinds = cells
    (tmp_path / "cells.lib").write_text(library.copy(head, kinds))
    (tmp_path / "toggles.v").write_text(flat.with_toggles(netlist))
    files = (tmp_path / "cells.lib", tmp_path / "toggles.v")
    for toggles, (nand, register) in zip(row_report.counts(netlist, kinds, nets), ((6, 3), (4, 3), (0, 0))):
        measured = power.run(netlist, toggles, files, tmp_path)
        inside = nand * (0.03 + 0.04) + register * (0.04 + 0.03) + CLOCKS * 0.06
        driven = CHARGE * (nand * 0.01 + register * (0.01 + 0.02))
        assert measured.internal == pytest.approx(1e-4 * inside / CLOCKS, rel=1e-4)
        assert measured.switching == pytest.approx(1e-4 * driven / CLOCKS, rel=1e-4)
        assert measured.leakage == pytest.approx(30e-9)
    assert power.charged_pj(netlist, kinds, {"clk": 2, "d[1]": 1.5, "d[0]": 0}) == pytest.approx(
        (CHARGE * 2 * 0.02, CHARGE * 1.5 * 0.01))


@pytest.mark.parametrize("output, why", (
    ("annotated 2 of 5\nTotal 1 2 3 4 100%\n", "the toggles of 2 of 5 nets"),
    ("annotated 5 of 5\n", "no power"), ("Error: no file\n", "no file")))
def test_power_of_a_part_is_none(output, why):
    with pytest.raises(power.PowerError, match=why):
        power.parse(output)


@pytest.mark.parametrize("output, why", (
    ("", "did not end"), ("compared 2 wrong 0\n", "2 results of 3 vertices"),
    ("compared 3 wrong 1\n", "1 of them wrong")))
def test_results_are_all_there_and_right(output, why):
    with pytest.raises(simulation.SimulationError, match=why):
        simulation.checked(output, simulation.Run(first=1, vertices=3))
    assert simulation.checked("compared 3 wrong 0\n", simulation.Run(first=1, vertices=3)) == 3
