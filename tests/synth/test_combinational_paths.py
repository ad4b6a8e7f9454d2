"""tools/rtl/combinational_paths.py finds a combinational path wherever it hides, and none where a register cuts it;
the modules behind AXI4-Lite have none, nor has the DMA engine on its buses.

SPDX-License-Identifier: Apache-2.0
"""

import re

import pytest

from tools.project_root import ROOT
from tools.rtl import combinational_paths

MODULE = """\
`default_nettype none

module ffd_path_sample #(
  parameter WIDTH = 4
) (
  input  wire             clk,
  input  wire             rst,
  input  wire [WIDTH-1:0] d_i,
  output wire [WIDTH-1:0] q_o
);
{body}
endmodule

`default_nettype wire
"""
INNER = """\
module ffd_path_inner (
  input  wire [3:0] d_i,
  output wire [3:0] q_o
);
  assign q_o = d_i + 4'd1;
endmodule
"""
STATE = "  reg [WIDTH-1:0] r;\n"
CLOCKED = STATE + "  always @(posedge clk) if (rst) r <= 0; else r <= d_i;\n"
MEMORY = "  reg [3:0] m [0:15];\n  always @(posedge clk) m[r] <= d_i;\n"

CUT = {
    "a register": CLOCKED + "  assign q_o = r;",
    "logic behind a register": CLOCKED + "  assign q_o = r ^ (r + 3);",
    "a register with an enable": STATE + "  always @(posedge clk) if (rst) r <= d_i;\n"
                                 "  assign q_o = r;",
    "a memory at a registered address": CLOCKED + MEMORY + "  assign q_o = m[r];",
    "a memory read on a clock": CLOCKED + MEMORY +
                                "  reg [3:0] s;\n  always @(posedge clk) s <= m[d_i];\n"
                                "  assign q_o = s;",
    "a module below, behind a register": CLOCKED +
                                         "  ffd_path_inner u (\n    .d_i(r),\n    .q_o(q_o)\n  );",
}
# what -> (body, an output bit that must be named)
THROUGH = {
    "a wire": ("  assign q_o = d_i;", "q_o[0] depends on d_i[0]"),
    "one bit of many": (CLOCKED + "  assign q_o = {r[3:1], r[0] ^ d_i[2]};",
                        "q_o[0] depends on d_i[2]"),
    "a condition": (CLOCKED + "  assign q_o = rst ? r : ~r;", "q_o[0] depends on rst"),
    "a case": (CLOCKED + "  reg [3:0] c;\n  always @* case (d_i) 4'd1: c = r; default: c = 4'd0;"
               " endcase\n  assign q_o = c;", "depends on d_i"),
    "a module below": ("  ffd_path_inner u (\n    .d_i(d_i),\n    .q_o(q_o)\n  );",
                       "depends on d_i"),
    "the address of a memory": (CLOCKED + MEMORY + "  assign q_o = m[d_i];", "depends on d_i"),
    "a latch": (STATE + "  always @* if (clk) r = d_i;\n  assign q_o = r;", "depends on"),
    "an asynchronous reset": (STATE + "  always @(posedge clk, posedge rst) if (rst) r <= 0;"
                              " else r <= d_i;\n  assign q_o = r;", "depends on rst"),
    "a parameter's value": ("  generate if (WIDTH == 4) begin : gen_x\n" + CLOCKED +
                            "  assign q_o = r;\n  end else begin : gen_y\n"
                            "  assign q_o = d_i;\n  end endgenerate", None),
}


@pytest.fixture
def look(call):
    """(exit status, lines that it printed, complaints among them)"""
    def run(*words, root=ROOT):
        status, out, errors = call(combinational_paths.main, "--root", root, *words)
        return status, out + errors
    return run


@pytest.fixture
def sample(checkout, look):
    def run(body, *more):
        checkout.put({"rtl/hwffd.f": "path/ffd_path_sample.v\npath/ffd_path_inner.v\n",
                      "rtl/path/ffd_path_inner.v": INNER,
                      "rtl/path/ffd_path_sample.v": MODULE.replace("{body}", body)})
        return look(*(more or ("ffd_path_sample",)), root=checkout.root)
    return run


@pytest.mark.parametrize("body", CUT.values(), ids=CUT)
def test_paths_that_are_cut(sample, body):
    assert sample(body) == (0, ["ffd_path_sample: 4 output bits, 0 reached from an input"])


@pytest.mark.parametrize("body, words", THROUGH.values(), ids=THROUGH)
def test_paths_that_are_not(sample, body, words):
    status, lines = sample(body, "ffd_path_sample", *([] if words else ["WIDTH=5"]))
    assert status == 1
    assert (words or "depends on d_i") in "\n".join(lines)


@pytest.mark.parametrize("words", (
    ("no_such_module",), ("ffd_path_inner", "WIDTH"), ("ffd_path_sample",)))
def test_faults_are_one_line(sample, words):
    status, lines = sample("  assign q_o = ;", *words)
    assert (status, len(lines)) == (2, 1)


@pytest.mark.parametrize("words", (
    ("hwffd_stream",), ("hwffd_axi",), ("ffd_dma_engine",),
    *(pytest.param(words, marks=pytest.mark.whole)
      for words in (("hwffd_stream_bus",), ("hwffd_wishbone",), ("hwffd_adjoint",), ("hwffd_stream", "HARDENED=1"),
                    ("hwffd_axi", "HARDENED=1")))), ids="-".join)
def test_tops_have_none(look, words):
    status, (line,) = look(*words)
    assert status == 0
    assert re.search(r"\b[1-6]\d\d output bits, 0 reached", line)


@pytest.mark.parametrize("module, wanted", (
    ("ffd_bus_registers", ["s_clearing", *sorted(f"s_read_data[{bit}]" for bit in range(32))]),
    ("ffd_axil_slave", ["m_awake"]), ("ffd_wb_slave", ["m_awake"])))
def test_what_follows_inside_is_found_and_nothing_else(look, module, wanted):
    """Answers of the register block follow what the hardware says, whether a bus is awake its
    requests, as their heads say: all are inside."""
    status, lines = look(module)
    assert status == 1
    assert sorted(line.split()[1] for line in lines[:-1]) == wanted
