"""A model made by the build's own script counts what it runs, over all of its instances.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import subprocess

from lab.rtl_coverage import counts as counting

ROOT = pathlib.Path(__file__).resolve().parents[3]

SOURCE = """`default_nettype none
module ffd_small (input wire clk, input wire [1:0] a, output reg [1:0] y, output reg [39:0] idle,
                  output reg [39:0] wide, output wire [7:0] part);
  reg once;
  wire fixed = 1'b1;
  assign part = {4'h9, wide[39], a, wide[0]};
  always @(posedge clk) begin
    if (a == 2'd3) y <= 2'd0;
    else y <= a;
    if (a == 2'd2) idle <= ~idle;
    wide <= wide == 40'hffff_ffff_ff ? 40'd0 : 40'hffff_ffff_ff;
    once <= fixed;
  end
endmodule
"""
# Two simulations, one after the other, of which each runs a branch; registers start at random.
PROGRAM = """#include "Vsmall.h"
int main() {
  for (int a = 1; a <= 3; a += 2) {
    VerilatedContext context;
    context.randReset(2);
    Vsmall dut{&context};
    for (int clock = 0; clock < 4; ++clock) {
      dut.a = a;
      dut.clk = 0;
      dut.eval();
      dut.a = 0;
      dut.eval();
      dut.a = a;
      dut.eval();
      dut.clk = 1;
      dut.eval();
    }
  }
}
"""


def built(folder):
    (folder / "ffd_small.v").write_text(SOURCE)
    (folder / "main.cpp").write_text(PROGRAM)
    subprocess.run([ROOT / "cmake" / "verilate.sh", "Vsmall", "verilator", "--cc", "--coverage-line",
                    "--coverage-toggle", "--x-initial", "unique", "--top-module", "ffd_small", "--prefix", "Vsmall",
                    "ffd_small.v"], cwd=folder, check=True)
    runtime = pathlib.Path(subprocess.run(["verilator", "--getenv", "VERILATOR_ROOT"], check=True, text=True,
                                          capture_output=True).stdout.strip()) / "include"
    subprocess.run(["c++", "-std=c++17", "-w", f"-I{runtime}", f"-I{runtime}/vltstd",
                    f"-I{ROOT / 'tb' / 'coverage'}", "-o", "small",
                    "main.cpp", "Vsmall.cpp", runtime / "verilated.cpp", runtime / "verilated_threads.cpp",
                    ROOT / "tb" / "coverage" / "coverage_counters.cpp", "-pthread"],
                   cwd=folder, check=True)
    return folder / "small"


def test_counts_of_all_simulations_together(tmp_path):
    program, path = built(tmp_path), tmp_path / "counts.tsv"
    subprocess.run([program], env={**os.environ, "HWFFD_COVERAGE": str(path)}, check=True)
    counts = counting.read([path])
    branches = {(place.line, place.what.split()[0]): count for place, count in counts.items()
                if place.kind == "branch"}
    assert branches == {(8, "if"): 4, (8, "else"): 4, (10, "if"): 0, (10, "else"): 8}
    assert {place.module for place in counts} == {"ffd_small"}


def test_a_bit_is_run_that_rises_and_falls_after_the_start(tmp_path):
    """Registers start at random: to leave that state is no proof that something was tried."""
    program, path = built(tmp_path), tmp_path / "counts.tsv"
    subprocess.run([program], env={**os.environ, "HWFFD_COVERAGE": str(path)}, check=True)
    bits = {place.what: count for place, count in counting.read([path]).items() if place.kind == "toggle"}
    run = {what for what, count in bits.items() if count}
    assert {"clk", "a[0]", "a[1]"} <= run
    assert {f"wide[{bit}]" for bit in range(40)} <= run
    assert not [what for what in run if what.startswith(("idle", "once"))]
    assert {f"idle[{bit}]" for bit in range(40)} <= set(bits)
    assert {f"part[{bit}]" for bit in range(4)} <= run and "fixed" not in bits


def test_no_place_to_write_is_said(tmp_path):
    program = built(tmp_path)
    result = subprocess.run([program], env={**os.environ, "HWFFD_COVERAGE": str(tmp_path / "no" / "file")},
                            check=False, capture_output=True, text=True)
    assert result.returncode == 1 and result.stderr.startswith("coverage: cannot write")
