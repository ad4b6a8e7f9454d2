"""Keys of elaborated designs change with the circuit below a top and with nothing else.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from tools.rtl import elaboration

TOP = """\
module top #(parameter WIDE = 0) (input clk, input [3:0] a, output reg [3:0] q);
  wire [3:0] next;
  generate
    if (WIDE == 0) begin : gen_narrow
      assign next = a + `STEP;
    end else begin : gen_wide
      assign next = a - 4'd1;
    end
  endgenerate
  part u_part (.clk(clk), .d(next), .q(q));
endmodule
"""
PART = """\
module part (input clk, input [3:0] d, output reg [3:0] q);
  always @(posedge clk) q <= d ^ 4'd5;
endmodule
"""
MACROS = "`define STEP 4'd3\n"
OTHER = "module other (input a, output b);\n  assign b = !a;\nendmodule\n"
FILES = {"macros.v": MACROS, "top.v": TOP, "part.v": PART, "other.v": OTHER}


@pytest.fixture
def key(tmp_path):
    def of(files, top="top", sources="sources"):
        folder = tmp_path / str(len(list(tmp_path.iterdir())))
        folder.mkdir()
        for name, text in files.items():
            (folder / name).write_text(text)
        return elaboration.Elaborations(folder, "1").key(elaboration.Design(
            "read_verilog " + " ".join(files), f"hierarchy -check -top {top}", sources))
    return of


@pytest.mark.parametrize("changed", (
    {"other.v": OTHER.replace("!a", "a")}, {"other.v": "\n\n" + OTHER},
    {"top.v": TOP.replace("a - 4'd1", "a - 4'd2")}, {"top.v": "// a comment\n\n" + TOP},
    {"part.v": PART.replace("  always", "\n  // a comment\n  always")},
    {"macros.v": MACROS + "`define UNUSED 7\n"}))
def test_what_is_not_below_the_top_changes_nothing(key, changed):
    assert key({**FILES, **changed}) == key(FILES)


@pytest.mark.parametrize("changed", (
    {"part.v": PART.replace("4'd5", "4'd6")}, {"part.v": PART.replace("posedge", "negedge")},
    {"top.v": TOP.replace("WIDE = 0", "WIDE = 1")}, {"macros.v": MACROS.replace("3", "4")},
    {"top.v": TOP.replace("a + ", "a | ")}, {"part.v": "(* keep *)\n" + PART}))
def test_every_change_of_the_circuit_is_another_key(key, changed):
    assert key({**FILES, **changed}) != key(FILES)


def test_a_design_that_is_broken_has_the_key_of_its_sources(key):
    assert key({**FILES, "part.v": ""}) == "sources"
    assert key(FILES, top="nothing") == "sources"


def test_a_design_is_elaborated_once(tmp_path, monkeypatch):
    for name, text in FILES.items():
        (tmp_path / name).write_text(text)
    elaborations = elaboration.Elaborations(tmp_path, "1")
    design = elaboration.Design(f"read_verilog {' '.join(FILES)}", "hierarchy -top top", "sources")
    elaborations.prepare([design, design], 2)
    first = elaborations.key(design)
    monkeypatch.setattr(elaboration.rtl_sources, "run", None)
    assert elaborations.key(design) == first != "sources"
