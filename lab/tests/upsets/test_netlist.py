"""A small design with bits that flip: each flip is seen in its register, at its clock, and nowhere else.

SPDX-License-Identifier: Apache-2.0
"""

import json
import shutil
import subprocess

import pytest

from lab.upsets import netlist

pytestmark = pytest.mark.skipif(not shutil.which("yosys"), reason="no yosys")
# Two registers, one of them in a module below, and the other loaded only once.
MODULES = {
    "top": {"cells": {"u_a": {"type": "$paramod\\ffd_a\\W=s32'00000000000000000000000000000010"},
                      "gen_x[0].u_b": {"type": "ffd_mem_sdp"}}},
    "$paramod\\ffd_a\\W=s32'00000000000000000000000000000010": {"cells": {}},
    "ffd_mem_sdp": {"cells": {}}}
DESIGN = """module top(input aclk, input d, output [1:0] q);
  reg [1:0] state_q;
  always @(posedge aclk) state_q <= {state_q[0], d};
  assign q = state_q;
endmodule
"""
BENCH = """module bench;
  reg aclk = 0;
  reg [95:0] flip = 96'd0;
  wire [1:0] q;
  top u_top(.aclk(aclk), .d(1'b0), .q(q), .upset_register(flip));
  integer i;
  initial begin
    for (i = 0; i < 6; i = i + 1) begin
      flip = i == 3 ? 96'd1 << BIT : 96'd0;
      #1 aclk = 1; #1 aclk = 0;
      $write("%b ", q);
    end
  end
endmodule
"""


def test_modules_are_those_of_the_hierarchy():
    tree = netlist.Tree(MODULES, "top")
    assert tree.module("$flatten\\u_a.$procdff$3") == "ffd_a"
    assert tree.module("gen_x[0].u_b.gen_registered.read_q") == "top"  # a part, so its user's
    assert tree.module("$procdff$4") == "top"


@pytest.mark.parametrize("bit, seen", ((0, "00 00 00 01 10 00"), (1, "00 00 00 10 00 00")))
def test_a_flip_is_of_one_bit_at_one_clock(tmp_path, bit, seen):
    (tmp_path / "top.v").write_text(DESIGN)
    flat = tmp_path / "flat.json"
    subprocess.run(["yosys", "-qq", "-p", f"read_verilog {tmp_path / 'top.v'}; proc; write_json {flat}"],
                   check=True)
    design = json.loads(flat.read_text())
    module = netlist.Design(design["modules"]["top"], netlist.Tree({"top": {"cells": {}}}, "top"))
    assert module.flip_registers() == [["state_q[0]", "top"], ["state_q[1]", "top"]]
    flat.write_text(json.dumps(design))
    subprocess.run(["yosys", "-qq", "-p", f"read_json {flat}; write_verilog {tmp_path / 'out.v'}"], check=True)
    (tmp_path / "bench.v").write_text(BENCH.replace("BIT", str(bit)))
    subprocess.run(["iverilog", "-o", tmp_path / "run", tmp_path / "out.v", tmp_path / "bench.v"], check=True)
    output = subprocess.run([tmp_path / "run"], check=True, capture_output=True, text=True).stdout
    assert output.split()[2:] == seen.split()[2:]
