"""tools.checks.lint hands every module and every configuration to each tool, and hears what it says:
faults planted in a small copy of the tree are reported under the right tool and subject.

SPDX-License-Identifier: Apache-2.0
"""

import re

import pytest

from tools.checks import clang_tidy
from tools.tables import configurations, features

MODULE = """\
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module {name} #(
  parameter {parameters}
) (
  input  wire [3:0] d_i,
  output wire [3:0] q_o
);
{body}
endmodule

`default_nettype wire
"""
NAMES = [*configurations.read()[0].parameters, "AXIS", "HARDENED", *features.PARAMETERS.values()]
TOP_PARAMETERS = ",\n  parameter ".join(f"{name} = 1" for name in NAMES)
USED_PARAMETERS = "\n    + ".join(name for name in NAMES if name != "MUL_LATENCY")
TOP_BODY = f"""\
  ffd_org_sample u_sample (
    .d_i(d_i),
    .q_o(q_o)
  );
  generate
    if (MUL_LATENCY > 7) begin : gen_bad_latency
      ERROR_hwffd_stream_latency u_error ();
    end
  endgenerate
  wire unused_ok = &{{1'b0, 32'd0 + {USED_PARAMETERS}}};"""
SAMPLE = "  assign q_o = d_i;"
ROW = "good-row,basic,1,fx18,overlapped,pipelined,2,1,0,1,stream,test,test"
TABLE = ",".join(configurations.COLUMNS) + f"\n{ROW}\n"


def module(name, body):
    body += "\n  wire unused_size = &{1'b0, 32'd0 + SIZE};"
    return MODULE.format(name=name, parameters="SIZE = 4", body=body)


CLEAN = {
    "rtl/hwffd.f": "evaluator/ffd_org_sample.v\nevaluator/ffd_org_other.v\ntop/hwffd_stream.v\n",
    "rtl/evaluator/ffd_org_other.v": module("ffd_org_other", SAMPLE),
    "rtl/top/hwffd_stream.v":
        MODULE.format(name="hwffd_stream", parameters=TOP_PARAMETERS, body=TOP_BODY),
    "rtl/lint/hwffd.vlt": "`verilator_config\n",
    "rtl/configurations.csv": TABLE,
    "golden/src/x.cpp": "int x;\n",
    "rtl/evaluator/ffd_org_sample.v": module("ffd_org_sample", SAMPLE),
}
# Faults in a module: what -> (its body, the tool that says so, a word in what it says). Each stands in
# a module of its own, all in one tree.
IN_MODULES = {
    "a width that does not fit": ("  assign q_o = d_i[2:0];", "verilator", "WIDTH"),
    "an unused bit": ("  assign q_o = {4{d_i[0]}};", "verilator", "UNUSEDSIGNAL"),
    "SystemVerilog, by Verilator": ("  logic x;\n  assign q_o = d_i;", "verilator", "logic"),
    "SystemVerilog, by Icarus": ("  assign q_o = '0;", "icarus", "SystemVerilog"),
    "an undeclared wire, by Icarus": ("  assign q_o = e;", "icarus", "bind"),
    "a bit out of bounds, by Icarus": ("  assign q_o = {d_i[4], d_i[2:0]};", "icarus", "[4]"),
    "no driver, by yosys": ("  wire [3:0] e;\n  assign q_o = e & d_i;", "yosys", "no driver"),
    "two drivers, by yosys": ("  assign q_o = d_i;\n  assign q_o = ~d_i;", "yosys", "driver"),
    "a latch": ("  reg [3:0] r;\n  always @* if (d_i[0]) r = d_i;\n  assign q_o = r;",
                "verilator", "LATCH"),
    "an unknown module, by yosys":
        ("  ffd_org_none u_none (\n    .d_i(d_i),\n    .q_o(q_o)\n  );", "yosys", "ffd_org_none"),
}
# Faults in a tree: what -> (files, [(how a line of the report begins, a word in it)]).
IN_TREES = {
    "a bad configuration":
        ({"rtl/configurations.csv": TABLE + ROW.replace("good", "bad").replace("fx18", "fx32").replace(",2,", ",8,") + "\n"},
         [(f"{tool} hwffd_stream (bad-row):", "ERROR_hwffd_stream_latency")
          for tool in ("verilator", "icarus", "yosys")]),
    "a word of SystemVerilog as a name":
        ({"rtl/evaluator/ffd_org_sample.v":
            module("ffd_org_sample", "  wire [3:0] final = d_i;\n  assign q_o = final;")},
         [(f"{tool} SystemVerilog ffd_org_sample:", complaint) for tool, complaint in
          (("verilator", "keyword"), ("icarus", "error: invalid"), ("yosys", "TOK_FINAL"))]),
    "such a word in a module of no configuration, and unformatted C++":
        ({"rtl/evaluator/ffd_org_other.v":
            module("ffd_org_other", "  wire [3:0] cross = d_i;\n  assign q_o = cross;"),
          "golden/src/x.cpp": "int  x;\n"},
         [("verilator SystemVerilog ffd_org_other:", "cross"), ("clang-format:", "x.cpp:1")]),
    "a parameter that must not be given, and a pointer that is 0":
        ({"rtl/top/hwffd_stream.v": MODULE.format(
            name="hwffd_stream", parameters=TOP_PARAMETERS,
            body=f"{TOP_BODY}\n  localparam [7:0] MOST = AXIS;\n  wire unused_most = &{{1'b0, MOST}};"),
          "golden/src/x.cpp": "int* x = 0;\n"},
         [("verilator hwffd_stream (all parameters given, AXIS=4):", "WIDTH"),
          ("clang-tidy:", "modernize-use-nullptr")]),
}


def tree_of_modules():
    """(files, what must be heard) of a tree with each of IN_MODULES in a module of its own."""
    files, heard = {"rtl/hwffd.f": CLEAN["rtl/hwffd.f"]}, []
    for number, (body, tool, word) in enumerate(IN_MODULES.values()):
        name = f"ffd_org_sample{number}"
        files[f"rtl/evaluator/{name}.v"] = module(name, body)
        files["rtl/hwffd.f"] += f"evaluator/{name}.v\n"
        heard.append((f"{tool} {name}:", word))
    return files, heard


@pytest.fixture
def lint(checkout):
    """(exit status, lines) of tools.checks.lint, these files changed since the last commit."""
    def linted(files):
        entry = {"directory": str(checkout.root), "file": str(checkout.root / "golden/src/x.cpp"),
                 "command": "c++ -c golden/src/x.cpp"}
        checkout.put({**CLEAN, clang_tidy.COMMANDS: [entry]})
        checkout.copy(".clang-format", ".clang-tidy")
        checkout.git("init", "--quiet")
        for _ in ("parent", "empty"):
            checkout.commit()
        checkout.put(files)
        status, out, errors = checkout.module("tools.checks.lint", "--root", ".")
        return status, (out + errors).splitlines()
    return linted


def test_clean_tree_passes(lint):
    status, lines = lint({})
    assert status == 0, lines
    assert re.search(r"^lint: \d+ checks, 0 warnings$", lines[-1])


@pytest.mark.parametrize("files, heard", (tree_of_modules(), *IN_TREES.values()),
                         ids=("modules", *IN_TREES))
def test_planted_faults_are_heard(lint, files, heard):
    status, lines = lint(files)
    assert status == 1
    assert re.search(r"^lint: \d+ checks, [1-9]\d* warnings?$", lines[-1])
    missed = [(begins, word) for begins, word in heard
              if not any(line.startswith(begins) and word in line for line in lines)]
    assert missed == [], lines


def test_bad_table_is_one_line(lint):
    status, lines = lint({"rtl/configurations.csv": TABLE.replace("basic", "none")})
    assert status == 1
    assert "unknown org 'none'" in lines[-1]
