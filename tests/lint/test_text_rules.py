"""Each text rule of tools.checks.lint catches what is planted in a small copy of the tree, and only
that; what it must let pass, passes.

SPDX-License-Identifier: Apache-2.0
"""

import re

import pytest

from tools.checks import text_rules

NAME = "ffd_org_sample"
FILE = f"rtl/evaluator/{NAME}.v"
CLEAN = """\
// ffd_org_sample: q_o = d_i, through every construct that a rule could mistake for another.
//
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_org_sample #(
  parameter FORMAT = 18,
  parameter N      = 2
) (
  input  wire       clk,
  input  wire [3:0] d_i,
  output reg  [3:0] q_o
);
  function [3:0] pick;
    input [3:0] value;
    begin
      if (value == 4'd3) begin
        pick = 4'd0;
      end else pick = value;
    end
  endfunction

  genvar i;
  generate
    for (i = 0; i < N; i = i + 1) begin : gen_lane
      if (i == 0) begin : gen_first
        wire [3:0] sum;
        ffd_num_delay #(
          .WIDTH(`FFD_WEIGHT_WIDTH(FORMAT))
        ) u_delay (
          .clk(clk)
        );
      end else if (i == 1) begin : gen_second
        wire [3:0] sum;
      end else begin : gen_rest
        wire [3:0] sum;
      end
    end
    case (N)
      1, 2: begin : gen_few
        wire x;
      end
      default: begin : gen_many
        wire x;
      end
    endcase
  endgenerate

  always @(posedge clk) begin
    case (d_i)
      4'd0: begin
        q_o <= 4'd1;
      end
      default: q_o <= pick(d_i);
    endcase
    if (d_i == 4'd1) begin
      q_o <= 4'd2;
    end else begin : named
      q_o <= 4'd3;
    end
  end

  initial begin
    for (;;) begin
    end
  end
endmodule

`default_nettype wire
"""
WAIVERS = "// None; lint_off is not for here.\n`verilator_config\n"
FORMAT_HEADER = "`define FFD_WORD(FORMAT) ((FORMAT) == 0 ? 32 : (FORMAT))\n"
SPDX = "// SPDX-License-Identifier: Apache-2.0\n"
MARK = "TO" "DO"
LIST = f"// list\nevaluator/{NAME}.v\n"


def replaced(old, new):
    assert old in CLEAN, old
    return {FILE: CLEAN.replace(old, new, 1)}


def inserted(line):
    """A line among the module's items."""
    return replaced("  genvar i;\n", f"{line}\n  genvar i;\n")


# (rule, what is planted, files to write; None removes one)
PLANTED = [
    ("default-nettype", "none missing", replaced("`default_nettype none\n", "")),
    ("default-nettype", "wire missing", replaced("`default_nettype wire\n", "")),
    ("default-nettype", "only in a comment",
     replaced("`default_nettype none\n", "// `default_nettype none\n")),
    ("columns", "101 columns", inserted("  // " + "x" * 96)),
    ("tabs", "tab before a comment", inserted("  wire y;\t// y")),
    ("indentation", "three spaces", inserted("   wire y;")),
    ("indentation", "one space in a list", replaced("  input  wire       clk", " input wire clk")),
    ("indentation", "after a concatenation", inserted("  wire y = &{d_i,\n    d_i};\n   wire z;")),
    ("module-name", "another name", replaced("module ffd_org_sample", "module ffd_org_other")),
    ("module-name", "two modules",
     replaced("endmodule\n", "endmodule\n\nmodule ffd_org_second;\nendmodule\n")),
    ("module-name", "no family",
     {FILE: None, "rtl/evaluator/sample.v": CLEAN.replace(NAME, "sample"),
      "rtl/hwffd.f": "evaluator/sample.v\n"}),
    ("licence", "no SPDX line", replaced(SPDX, "")),
    ("licence", "SPDX line after the module", {FILE: CLEAN.replace(SPDX, "") + SPDX}),
    ("vendor-primitive", "Xilinx", inserted("  DSP48E1 u_mul ();")),
    ("vendor-primitive", "Lattice", inserted("  MULT18X18D u_mul ();")),
    ("vendor-primitive", "Intel", inserted("  altsyncram u_ram ();")),
    ("format-test", "equal", inserted("  wire y = FORMAT == 0;")),
    ("format-test", "the other way round", inserted("  wire y = 0 != (FORMAT);")),
    ("format-test", "less", inserted("  wire y = FORMAT < 32;")),
    ("format-test", "a generate if", replaced("if (i == 0) begin", "if (FORMAT) begin")),
    ("format-test", "a case", replaced("case (N)", "case (FORMAT)")),
    ("format-test", "behind a macro",
     replaced("if (i == 0) begin", "if (`FFD_IS_FLOAT(FORMAT)) begin")),
    ("format-test", "a constant's macro", inserted("  wire y = N == `FFD_FORMAT_FP32;")),
    ("format-test", "a conditional expression", inserted("  localparam Y = FORMAT ? 1 : 2;")),
    ("format-test", "a local name", inserted("  wire y = POINT_FORMAT == 0;")),
    ("format-test", "a directive", inserted("`ifdef FFD_FORMAT_FLOAT\n`endif")),
    ("lint-pragma", "lint_off in a source", inserted("  // verilator lint_off WIDTH")),
    ("generate-arm", "no name", replaced("begin : gen_first", "begin")),
    ("generate-arm", "another name", replaced("begin : gen_first", "begin : first")),
    ("generate-arm", "else without a name", replaced("begin : gen_rest", "begin")),
    ("generate-arm", "else if without a name", replaced("begin : gen_second", "begin")),
    ("generate-arm", "for without a name", replaced("begin : gen_lane", "begin")),
    ("generate-arm", "case item without a name", replaced("begin : gen_few", "begin")),
    ("generate-arm", "default without a name", replaced("begin : gen_many", "begin")),
    ("generate-arm", "no begin", inserted("  generate if (N > 1) wire y; endgenerate")),
    ("generate-arm", "no generate keyword", inserted("  if (N > 1) begin\n    wire y;\n  end")),
    ("generate-arm", "after a procedural block",
     replaced("  initial begin", "  if (N > 1) begin : late\n    wire y;\n  end\n  initial begin")),
    ("reason", "bare", inserted(f"  // {MARK}")),
    ("reason", "one word", inserted(f"  // {MARK}: later")),
    ("reason", "in C++", {"golden/src/x.cpp": f"// {MARK} speed\n"}),
    ("reason", "in a script", {"tools/x": "# FIX" "ME\n"}),
    ("trailing-blank", "RTL", inserted("  wire y; ")),
    ("trailing-blank", "C++", {"tb/x.hpp": "#pragma once \n"}),
    ("trailing-blank", "no newline at the end", {"tests/x.cpp": "int x;"}),
    ("file-list", "source not listed", {"rtl/hwffd.f": "// nothing\n"}),
    ("file-list", "listed twice", {"rtl/hwffd.f": f"evaluator/{NAME}.v\nevaluator/{NAME}.v\n"}),
    ("file-list", "listed but absent", {"rtl/hwffd.f": f"evaluator/{NAME}.v\nevaluator/no.v\n"}),
    ("file-list", "no list", {"rtl/hwffd.f": None}),
    ("file-list", "folder of headers not listed",
     {"rtl/number/ffd_formats.vh": SPDX + FORMAT_HEADER, "rtl/hwffd.f": f"evaluator/{NAME}.v\n"}),
    ("file-list", "folder of headers absent", {"rtl/hwffd.f": f"{LIST}+incdir+no\n"}),
    ("empty-waivers", "a waiver",
     {"rtl/lint/hwffd.vlt": WAIVERS + 'lint_off -rule WIDTH -file "*.v"\n'}),
    ("empty-waivers", "no file", {"rtl/lint/hwffd.vlt": None}),
    ("link", "no such file", {"docs/x.md": "[y](y.md)\n"}),
    ("link", "no such picture", {"docs/a/x.md": "![y](../y.svg)\n"}),
    ("link", "no such heading", {"docs/x.md": "# X\n\n[y](#y)\n"}),
    ("link", "no such heading elsewhere",
     {"docs/x.md": "[y](a/y.md#2-x)\n", "docs/a/y.md": "# Y\n\n```\n# 2. X\n```\n"}),
    ("section", "in a comment", {"docs/x.md": "# X\n", "tb/x.hpp": "// docs/x.md section 1\n"}),
    ("section", "behind a link", {"docs/x.md": "# X\n", "docs/y.md": "[x](x.md) section 7\n"}),
    ("section", "the last of several",
     {"docs/x.md": "## 1. One\n", "golden/src/x.cpp": "// x.md sections 1 and 2\n"}),
    ("one-way", "the golden reference includes geometry",
     {"geometry/include/hwffd/mesh.hpp": "", "golden/src/x.cpp": '#include "hwffd/mesh.hpp"\n'}),
    ("one-way", "the library includes the bench",
     {"tb/include/hwffd/tb/bench.hpp": "", "api/src/x.cpp": '#include "hwffd/tb/bench.hpp"\n'}),
    ("one-way", "a folder without include/",
     {"apps/picture/png.hpp": "", "api/src/x.cpp": '#include "picture/png.hpp"\n'}),
    ("laboratory", "C++", {"tb/x.cpp": '#include "lab/words/study.hpp"\n'}),
    ("laboratory", "CMake", {"tests/CMakeLists.txt": "add_subdirectory(../lab/tests)\n"}),
    ("laboratory", "Python", {"tools/x.py": "from lab import figures\n"}),
    ("laboratory", "a path in Python", {"apps/x.py": 'ROOT / "lab"\n'}),
]

# what must pass -> files
PASSES = {
    "the sample": {},
    "a test of the format in number/":
        {"rtl/number/ffd_formats.vh": SPDX + FORMAT_HEADER, "rtl/hwffd.f": f"{LIST}+incdir+number\n"},
    "100 columns": inserted("  // " + "x" * 95),
    "operators aligned":
        inserted("  wire y = d_i[0]\n         + d_i[1] ?\n           d_i[2] : d_i[3];"),
    "a concatenation aligned": inserted("  wire y = &{d_i,\n             d_i};"),
    "a reason": inserted(f"  // {MARK}: share the adder once the schedule is fixed"),
    "words inside words": inserted("  wire [3:0] INFORMATION_q = 4'd1 == 4'd2;"),
    "a comment about FORMAT == 0": inserted("  // FORMAT == 0, DSP48E1, begin"),
    "links and sections that are there":
        {"docs/x.md": "# An X, `y`\n\n## 2. Two\n\n[x](#an-x-y) [z](a/z.md) x.md section 2\n",
         "docs/a/z.md": "[x](../x.md#2-two) section 2, https://example.org/x.md\n"},
    "the bench includes a core's interface":
        {"cores/include/hwffd/cores/core.hpp": "",
         "tb/src/x.cpp": '#include "hwffd/cores/core.hpp"\n'},
    "an anonymous begin in always":
        inserted("  always @* begin\n    if (N > 1) begin\n    end\n  end"),
    "texts that link to the laboratory, and what is in it":
        {"docs/x.md": "[words](../lab/docs/words.md)\n", "lab/docs/words.md": "# Words\n", "lab/x.py": "import lab.words\n"},
    "words like it": {"tools/x.py": "label/ = collab/x\n"},
    "a waiver of time units": {"rtl/lint/hwffd.vlt": WAIVERS + 'lint_off -rule TIMESCALEMOD -file "*.v"\n'},
    "the same line many times": {"api/x.cpp": "x(y,\n" * 11},
}


@pytest.fixture
def tree(checkout):
    def plant(files):
        checkout.put({FILE: CLEAN, "rtl/hwffd.f": LIST, "rtl/lint/hwffd.vlt": WAIVERS, **files})
        return checkout
    return plant


@pytest.mark.parametrize("rule, files", [(rule, files) for rule, _, files in PLANTED],
                         ids=[f"{rule}: {what}" for rule, what, _ in PLANTED])
def test_planted_faults_are_caught(tree, rule, files):
    warnings = text_rules.check(tree(files).root)[1]
    assert {re.search(r"\[([a-z-]+)\]$", warning).group(1) for warning in warnings} == {rule}


def test_every_rule_has_a_case():
    assert {*text_rules.PER_FILE, *text_rules.WHOLE_TREE} == {rule for rule, _, _ in PLANTED}


@pytest.mark.parametrize("files", PASSES.values(), ids=PASSES)
def test_clean_sources_pass(tree, files):
    checks, warnings = text_rules.check(tree(files).root)
    assert warnings == []
    assert checks >= len(text_rules.PER_FILE)


@pytest.mark.parametrize("files, status, last", (
    ({}, 0, r"lint: \d+ checks, 0 warnings"),
    (inserted("\twire y;"), 1, r"lint: \d+ checks, 1 warning")))
def test_command(tree, files, status, last):
    """The command's last line and exit status."""
    exit_status, out, _ = tree(files).module("tools.checks.lint", "--text", "--root", ".")
    assert exit_status == status
    assert re.fullmatch(last, out.splitlines()[-1])
