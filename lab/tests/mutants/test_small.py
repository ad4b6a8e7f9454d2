"""Mutants of a counter: what is listed, chosen and proved of them, and what is refused.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import re
import subprocess

import pytest

from lab.mutants import __main__ as study
from lab.mutants import aiger, built, campaign, equivalence, netlist

ROOT = pathlib.Path(__file__).resolve().parents[3]


COUNTER = """module counter #(parameter WIDTH = 4) (
  input wire clk, input wire rst, input wire up_i, output reg [WIDTH-1:0] count_o);
  wire never = count_o == 3'd7 && count_o == 3'd0;
  always @(posedge clk) begin
    if (rst) count_o <= {WIDTH{1'b0}};
    else if (up_i || never) count_o <= count_o + 1'b1;
  end
endmodule
"""
# Counts up and down the number of the mutant, and prints what comes out.
PROGRAM = """#include <cstdio>
#include <cstdlib>
#include "Vcounter.h"
extern "C" int hwffd_mutant() { return std::atoi(std::getenv("HWFFD_MUTANT")); }
int main() {
  Vcounter dut;
  for (int clock = 0; clock < 40; ++clock) {
    dut.rst = clock < 2;
    dut.up_i = clock % 3 != 0;
    dut.clk = 0;
    dut.eval();
    dut.clk = 1;
    dut.eval();
    std::printf("%d ", dut.count_o);
  }
}
"""


@pytest.fixture(name="root")
def _root(tmp_path):
    (tmp_path / "rtl" / "small").mkdir(parents=True)
    (tmp_path / "rtl" / "small" / "counter.v").write_text(COUNTER)
    return tmp_path


MODEL = built.Model("Vcounter", "counter", (("WIDTH", "3"),), (), (), ())


def read_and_listed(root, number):
    netlist.read(root, MODEL, root)
    return netlist.listed(root, root, number, 1)


def outputs(root, mutants):
    """What each mutant counts, number 0 first."""
    source = netlist.write(root, MODEL, mutants, root)
    (root / "main.cpp").write_text(PROGRAM)
    subprocess.run(["verilator", "--cc", "--exe", "--build", "-Wno-lint", "-Wno-fatal", "--top-module",
                    "counter", "--prefix", "Vcounter", "-o", root / "run", "--Mdir", root / "made",
                    source, root / "main.cpp"], check=True, capture_output=True)
    return [subprocess.run([root / "run"], env={"HWFFD_MUTANT": str(number)}, check=True,
                           capture_output=True, text=True).stdout
            for number in range(len(mutants) + 1)]


def test_what_looks_the_same_is_proved_the_same_and_nothing_else(root):
    mutants = read_and_listed(root, 40)
    shown = outputs(root, mutants)
    same = [number for number in range(1, len(shown)) if shown[number] == shown[0]]
    proved = [number for number in range(1, len(shown))
              if equivalence.verdict(root, MODEL, mutants[number - 1], root / str(number), 20) == "equivalent"]
    assert 0 < len(same) < len(mutants)
    assert proved and set(proved) <= set(same)


def test_modules_are_named_as_their_files(root):
    mutants = read_and_listed(root, 3)
    assert {netlist.module(mutant) for mutant in mutants} == {"counter"}


def test_another_design_has_other_mutants(root):
    first = netlist.read(root, MODEL, root)
    assert netlist.read(root, MODEL, root) == first
    (root / "rtl" / "small" / "counter.v").write_text(COUNTER.replace("count_o + 1", "count_o - 1"))
    assert netlist.read(root, MODEL, root) != first


def test_a_design_with_nothing_to_change_is_an_error(root):
    (root / "rtl" / "small" / "counter.v").write_text("module counter #(parameter WIDTH = 4) ();\nendmodule\n")
    with pytest.raises(built.MutantError, match="no mutants|0 mutants"):
        read_and_listed(root, 3)


def test_a_build_that_is_not_there_is_an_error(tmp_path):
    with pytest.raises(built.MutantError, match="make -C lab mutants builds it"):
        built.model(tmp_path, "libdma_small.a")


def test_late_tests_run_with_what_is_left_alone(tmp_path, monkeypatch):
    asked = []
    program = tmp_path / "late"
    program.write_text("")
    monkeypatch.setattr(campaign, "late", lambda build, subject, folder: program)
    monkeypatch.setattr(campaign, "unseen", lambda path, tests, numbers, tested, jobs: asked.append(numbers) or [7])
    options = argparse.Namespace(build=tmp_path, jobs=1)
    verdicts = {3: "equivalent", 5: "undecided", 7: "survived"}
    assert study.after_late_tests(options, {}, tmp_path, verdicts) == {3: "equivalent", 7: "survived"}
    assert asked == [[5, 7]]
    assert study.after_late_tests(options, {}, tmp_path, {3: "equivalent"}) == {3: "equivalent"}
    assert len(asked) == 1


HOT = """module hot (input wire clk, input wire rst, input wire turn_i, output wire [1:0] state_o);
  reg  [1:0] state_q;
  wire       never = state_q[0] && state_q[1];
  always @(posedge clk) begin
    if (rst) state_q <= 2'b01;
    else if (turn_i) state_q <= {state_q[0], state_q[1] || never};
  end
  assign state_o = state_q;
endmodule
"""


@pytest.mark.parametrize("mode, alike", [("const0", True), ("const1", False), ("inv", False)])
def test_a_step_is_compared_from_states_that_are_reached(tmp_path, mode, alike):
    (tmp_path / "rtl" / "small").mkdir(parents=True)
    (tmp_path / "rtl" / "small" / "hot.v").write_text(HOT)
    model = built.Model("Vhot", "hot", (), (), (), ())
    netlist.read(tmp_path, model, tmp_path)
    cell = re.search(r"cell \$logic_and (\S+)", netlist.base(tmp_path).read_text())[1]
    design = equivalence.step(tmp_path, f"mutate -mode {mode} -module hot -cell {cell} -port Y -portbit 0", "hot",
                              tmp_path / "1.ys", 20)
    assert design and equivalence.proved(design, 10) == alike


def test_registers_that_cannot_be_matched_are_no_step(tmp_path):
    graph = aiger.Graph([{"a"}], [{"r_q", "out"}], [2], {"out": 4}, [])
    assert aiger.step(graph, graph, tmp_path / "same.aig")
    assert aiger.read(tmp_path / "same.aig").outputs == {}
    other = aiger.Graph([{"a"}], [{"s_q"}], [2], {"out": 4}, [])
    assert not aiger.step(graph, other, tmp_path / "no.aig")
    assert not (tmp_path / "no.aig").exists()
