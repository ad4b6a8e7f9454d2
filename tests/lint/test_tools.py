"""scripts/lint hands every module and every configuration to each tool, and hears what it says:
faults planted in a small copy of the tree are reported under the right tool and subject.

SPDX-License-Identifier: Apache-2.0
"""

import json
import shutil
import subprocess
import sys
import unittest

from workspace import ROOT, Workspace

import configurations
import tidy

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
NAMES = [*configurations.read()[0].parameters, "AXIS"]
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
ROW = "good-row,basic,1,fx18,overlapped,pipelined,2,1,0,1,stream,test"
TABLE = ",".join(configurations.COLUMNS) + f"\n{ROW}\n"


def module(name, body):
    body += "\n  wire unused_size = &{1'b0, 32'd0 + SIZE};"
    return MODULE.format(name=name, parameters="SIZE = 4", body=body)


def sample(body):
    return {"rtl/evaluator/ffd_org_sample.v": module("ffd_org_sample", body)}


CLEAN = {
    "rtl/hwffd.f": "evaluator/ffd_org_sample.v\nevaluator/ffd_org_other.v\ntop/hwffd_stream.v\n",
    "rtl/evaluator/ffd_org_other.v": module("ffd_org_other", SAMPLE),
    "rtl/top/hwffd_stream.v":
        MODULE.format(name="hwffd_stream", parameters=TOP_PARAMETERS, body=TOP_BODY),
    "rtl/lint/hwffd.vlt": "`verilator_config\n",
    "rtl/configurations.csv": TABLE,
    "golden/src/x.cpp": "int x;\n",
    **sample(SAMPLE),
}
# what -> (files, how a report begins, a word in it)
PLANTED = {
    "a width that does not fit":
        (sample("  assign q_o = d_i[2:0];"), "verilator ffd_org_sample:", "WIDTH"),
    "an unused bit":
        (sample("  assign q_o = {4{d_i[0]}};"), "verilator ffd_org_sample:", "UNUSEDSIGNAL"),
    "SystemVerilog, by Verilator":
        (sample("  logic x;\n  assign q_o = d_i;"), "verilator ffd_org_sample:", "logic"),
    "SystemVerilog, by Icarus":
        (sample("  assign q_o = '0;"), "icarus ffd_org_sample:", "SystemVerilog"),
    "an undeclared wire, by Icarus":
        (sample("  assign q_o = e;"), "icarus ffd_org_sample:", "bind"),
    "a bit out of bounds, by Icarus":
        (sample("  assign q_o = {d_i[4], d_i[2:0]};"), "icarus ffd_org_sample:", "[4]"),
    "no driver, by yosys":
        (sample("  wire [3:0] e;\n  assign q_o = e & d_i;"), "yosys ffd_org_sample:", "no driver"),
    "two drivers, by yosys":
        (sample("  assign q_o = d_i;\n  assign q_o = ~d_i;"), "yosys ffd_org_sample:", "driver"),
    "a latch":
        (sample("  reg [3:0] r;\n  always @* if (d_i[0]) r = d_i;\n  assign q_o = r;"),
         "verilator ffd_org_sample:", "LATCH"),
    "an unknown module, by yosys":
        (sample("  ffd_org_none u_none (\n    .d_i(d_i),\n    .q_o(q_o)\n  );"),
         "yosys ffd_org_sample:", "ffd_org_none"),
    **{
        f"a bad configuration, by {tool}":
            ({"rtl/configurations.csv": TABLE + ROW.replace("good", "bad").replace(",2,", ",8,")},
             f"{tool} hwffd_stream (bad-row):", "ERROR_hwffd_stream_latency")
        for tool in ("verilator", "icarus", "yosys")
    },
    **{
        f"a word of SystemVerilog as a name, by {tool}":
            (sample("  wire [3:0] final = d_i;\n  assign q_o = final;"),
             f"{tool} SystemVerilog hwffd_stream (good-row):", complaint)
        for tool, complaint in (("verilator", "keyword"), ("icarus", "error: invalid"),
                                ("yosys", "TOK_FINAL"))
    },
    "such a word below no configuration":
        ({"rtl/evaluator/ffd_org_other.v":
            module("ffd_org_other", "  wire [3:0] cross = d_i;\n  assign q_o = cross;")},
         "verilator -F hwffd.f hwffd_stream:", "cross"),
    "a parameter that must not be given":
        ({"rtl/top/hwffd_stream.v": MODULE.format(
            name="hwffd_stream", parameters=TOP_PARAMETERS,
            body=f"{TOP_BODY}\n  localparam [7:0] MOST = AXIS;\n  wire unused_most = &{{1'b0, MOST}};")},
         "verilator hwffd_stream (all parameters given, AXIS=4):", "WIDTH"),
    "unformatted C++":
        ({"golden/src/x.cpp": "int  x;\n"}, "clang-format:", "x.cpp:1"),
    "a pointer that is 0, by clang-tidy":
        ({"golden/src/x.cpp": "int* x = 0;\n"}, "clang-tidy:", "modernize-use-nullptr"),
}


class Tools(Workspace):
    def setUp(self):
        super().setUp()

    def write(self, files):
        for name, text in files.items():
            self.put(name, text)

    def compile_commands(self):
        entry = {"directory": str(self.root), "file": str(self.root / "golden/src/x.cpp"),
                 "command": "c++ -c golden/src/x.cpp"}
        return {tidy.COMMANDS: json.dumps([entry])}

    def git(self, *words):
        subprocess.run(["git", "-C", self.root, "-c", "user.name=x", "-c", "user.email=x@x.example",
                        *words], check=True)

    def lint(self, files):
        """(exit status, lines) of scripts/lint, these files changed since the last commit."""
        shutil.rmtree(self.root)
        self.write({**CLEAN, **self.compile_commands()})
        for name in (".clang-format", ".clang-tidy"):
            self.copy(name)
        self.git("init", "--quiet")
        for message in ("parent", "empty"):
            self.git("add", "--all")
            self.git("commit", "--quiet", "--allow-empty", "--message", message)
        self.write(files)
        done = subprocess.run(
            [sys.executable, "-B", str(ROOT / "scripts" / "lint"), "--root", str(self.root)],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        return done.returncode, done.stdout.splitlines()

    def test_clean_tree_passes(self):
        status, lines = self.lint({})
        self.assertEqual(status, 0, lines)
        self.assertRegex(lines[-1], r"^lint: \d+ checks, 0 warnings$")

    def test_planted_faults_are_heard(self):
        caught = 0
        for what, (files, begins, word) in PLANTED.items():
            with self.subTest(what):
                status, lines = self.lint(files)
                self.assertEqual(status, 1)
                self.assertRegex(lines[-1], r"^lint: \d+ checks, [1-9]\d* warnings?$")
                self.assertTrue(
                    any(line.startswith(begins) and word in line for line in lines), lines)
                caught += 1
        print(f"tools: {caught} of {len(PLANTED)} planted faults heard")

    def test_bad_table_is_one_line(self):
        status, lines = self.lint({"rtl/configurations.csv": TABLE.replace("basic", "none")})
        self.assertEqual(status, 1)
        self.assertIn("unknown org 'none'", lines[-1])


if __name__ == "__main__":
    unittest.main(verbosity=2)
