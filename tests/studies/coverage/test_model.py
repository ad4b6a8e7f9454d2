"""A model made by the build's own script counts what it runs, over all of its instances.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "studies" / "rtl_coverage"), str(ROOT / "scripts")]

import counts as counting  # noqa: E402  pylint: disable=wrong-import-position

SOURCE = """`default_nettype none
module ffd_small (input wire clk, input wire [1:0] a, output reg [1:0] y);
  always @(posedge clk) begin
    if (a == 2'd3) y <= 2'd0;
    else y <= a;
  end
endmodule
"""
# Two simulations, one after the other, of which each runs a branch.
PROGRAM = """#include "Vsmall.h"
int main() {
  for (int a = 1; a <= 3; a += 2) {
    VerilatedContext context;
    Vsmall dut{&context};
    for (int clock = 0; clock < 3; ++clock) {
      dut.a = a;
      dut.clk = 0;
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
                    "--coverage-toggle", "--top-module", "ffd_small", "--prefix", "Vsmall",
                    "ffd_small.v"], cwd=folder, check=True)
    runtime = pathlib.Path(subprocess.run(["verilator", "--getenv", "VERILATOR_ROOT"], check=True, text=True,
                                          capture_output=True).stdout.strip()) / "include"
    subprocess.run(["c++", "-std=c++17", "-w", f"-I{runtime}", f"-I{runtime}/vltstd", "-o", "small",
                    "main.cpp", "Vsmall.cpp", runtime / "verilated.cpp", runtime / "verilated_threads.cpp",
                    ROOT / "tb" / "coverage" / "coverage_counters.cpp", "-pthread"],
                   cwd=folder, check=True)
    return folder / "small"


def test_counts_of_all_simulations_together(tmp_path):
    program, path = built(tmp_path), tmp_path / "counts.tsv"
    subprocess.run([program], env={**os.environ, "HWFFD_COVERAGE": str(path)}, check=True)
    counts = counting.read([path])
    branches = {place.what.split()[0]: count for place, count in counts.items()
                if place.kind == "branch"}
    assert branches == {"if": 3, "else": 3}
    run = {place.what for place, count in counts.items() if place.kind == "toggle" and count}
    assert {"clk", "a[0]"} <= run and {place.module for place in counts} == {"ffd_small"}


def test_no_place_to_write_is_said(tmp_path):
    program = built(tmp_path)
    done = subprocess.run([program], env={**os.environ, "HWFFD_COVERAGE": str(tmp_path / "no" / "file")},
                          check=False, capture_output=True, text=True)
    assert done.returncode == 1 and done.stderr.startswith("coverage: cannot write")
