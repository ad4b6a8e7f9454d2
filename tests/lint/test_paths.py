"""scripts/paths.py finds a combinational path wherever it hides, and none where a register cuts it;
the modules behind AXI4-Lite have none, nor has the DMA engine on its buses.

SPDX-License-Identifier: Apache-2.0
"""

import contextlib
import io
import unittest

from workspace import ROOT, Workspace

import paths

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


def look(root, module, *more):
    """(exit status, what it printed)"""
    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
        status = paths.main(["--root", str(root), module, *more])
    return status, out.getvalue()


class Paths(Workspace):
    def setUp(self):
        super().setUp()
        (self.root / "rtl" / "path").mkdir(parents=True)
        (self.root / "rtl" / "hwffd.f").write_text(
            "path/ffd_path_sample.v\npath/ffd_path_inner.v\n")
        (self.root / "rtl" / "path" / "ffd_path_inner.v").write_text(INNER)

    def sample(self, body, *more):
        path = self.root / "rtl" / "path" / "ffd_path_sample.v"
        path.write_text(MODULE.replace("{body}", body))
        return look(self.root, "ffd_path_sample", *more)

    def test_paths_that_are_cut(self):
        for what, body in CUT.items():
            with self.subTest(what):
                self.assertEqual(self.sample(body), (
                    0, "ffd_path_sample: 4 output bits, 0 reached from an input\n"))

    def test_paths_that_are_not(self):
        found = 0
        for what, (body, words) in THROUGH.items():
            with self.subTest(what):
                more = [] if words else ["WIDTH=5"]
                status, output = self.sample(body, *more)
                self.assertEqual(status, 1, output)
                self.assertIn(words or "depends on d_i", output)
                found += 1
        print(f"paths: {found} of {len(THROUGH)} planted paths found")

    def test_faults_are_one_line(self):
        for more in (["no_such_module"], ["ffd_path_inner", "WIDTH"]):
            status, output = look(self.root, *more)
            self.assertEqual((status, output.count("\n")), (2, 1), output)
        status, output = self.sample("  assign q_o = ;")
        self.assertEqual((status, output.count("\n")), (2, 1), output)

    def test_registers_and_tops_have_none(self):
        for module in ("ffd_axil_registers", "hwffd_stream", "hwffd_axi"):
            status, output = look(ROOT, module)
            self.assertEqual(status, 0, output)
            self.assertRegex(output, r"\b[234]\d\d output bits, 0 reached")

    def test_what_follows_inside_is_found_and_nothing_else(self):
        """The port of the slave follows ready, status of the DMA engine its bus, as their heads say:
        both are inside. What the engine gives to bus and streams follows nothing."""
        for module, wanted in {"ffd_axil_slave": ["read_o", "write_o"],
                               "ffd_dma_engine": ["fault_o", "idle_o"]}.items():
            status, output = look(ROOT, module)
            self.assertEqual(status, 1)
            self.assertEqual(sorted(line.split()[1] for line in output.splitlines()[:-1]), wanted)


if __name__ == "__main__":
    unittest.main(verbosity=2)
