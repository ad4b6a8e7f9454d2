"""Comparisons and differences of every target that is mapped, proved equal to what they say.

yosys' own map of sums for Gowin compared wrongly (synth/gowin/alu.map), which no test of a netlist on
another target can see.

SPDX-License-Identifier: Apache-2.0
"""

import subprocess

import pytest

from tools.project_root import ROOT

# Targets, and where yosys has their cells.
CELLS = {"ecp5": "ecp5", "gatemate": "gatemate", "gowin": "gowin", "gw5a": "gowin", "hx8k": "ice40",
         "nexus": "nexus", "up5k": "ice40", "xilinx7": "xilinx"}
DESIGN = """module {name} (input [4:0] a, b, input signed [4:0] c, d, output [9:0] y, output [4:0] s);
  assign y = {{a > b, a <= b, a < b, a >= b, a == b, c > d, c <= d, c < d, c >= d, c != d}};
  assign s = a - b;
endmodule
"""


def yosys(folder, name, steps):
    script = folder / name
    script.write_text("\n".join([*steps, ""]))
    return subprocess.run(["yosys", "-Q", "-T", "-q", "-s", script], cwd=ROOT, check=False,
                          capture_output=True, text=True)


def proved(folder, script, cells):
    """Whether the netlist that a script makes is the design."""
    (folder / "design.v").write_text(DESIGN.format(name="design"))
    (folder / "gold.v").write_text(DESIGN.format(name="gold"))
    mapped = yosys(folder, "map.ys", [
        f"read_verilog {folder}/design.v", "prep -top design", f"script {script}", "clean",
        f"write_verilog -noattr {folder}/mapped.v"])
    assert mapped.returncode == 0, mapped.stderr
    result = yosys(folder, "prove.ys", [
        f"read_verilog {folder}/gold.v {folder}/mapped.v",
        f"read_verilog -D NO_INCLUDES +/{cells}/cells_sim.v", "hierarchy -top design", "proc",
        "flatten design", f"read_verilog {folder}/gold.v", "proc",
        "miter -equiv -flatten gold design miter", "sat -verify -prove trigger 0 miter"])
    assert result.returncode == 0 or "proof did fail" in result.stderr, result.stderr
    return result.returncode == 0


@pytest.mark.parametrize("target", [target if target in ("ecp5", "gowin") else pytest.param(
    target, marks=pytest.mark.whole) for target in CELLS])
def test_comparisons_are_what_they_say(tmp_path, target):
    assert proved(tmp_path, ROOT / "synth" / f"{target}.ys", CELLS[target])


def test_a_wrong_map_is_found(tmp_path):
    """That of yosys itself."""
    text = (ROOT / "synth" / "gowin.ys").read_text()
    wrong = tmp_path / "gowin.ys"
    wrong.write_text(text.replace("techmap -map synth/gowin/alu.map\n", ""))
    assert wrong.read_text() != text
    assert not proved(tmp_path, wrong, "gowin")
