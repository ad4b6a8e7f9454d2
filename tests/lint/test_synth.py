"""scripts/synth on a small copy of the tree: what it runs, refuses, keeps and reports. Faults in
the RTL meet yosys itself; where only the bookkeeping is of interest, a stand-in takes its place.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "scripts"))

import configurations  # noqa: E402
import synthesis  # noqa: E402

MODULE = """\
`default_nettype none
`include "ffd_num.vh"
module {name} #(
  parameter {parameters}
) (
  input  wire       clk,
  input  wire [3:0] d_i,
  output reg  [3:0] q_o
);
{body}
endmodule
`default_nettype wire
"""
PARAMETERS = ", ".join(f"{name} = 1" for name in configurations.read()[0].parameters)
GOOD = "  always @(posedge clk) q_o <= d_i + `ONE;"
FAULTS = {
    "latch": ("  always @* if (clk) q_o = d_i;", "latch"),
    "two drivers": ("  wire [3:0] w;\n  assign w = d_i;\n  assign w = ~d_i;\n"
                    "  always @(posedge clk) q_o <= w;", "drivers"),
    "no driver": ("  wire [3:0] w;\n  always @(posedge clk) q_o <= w;", "no driver"),
    "loop": ("  wire [3:0] w = w[2:0] ^ d_i ^ (w >> 1);\n  always @(posedge clk) q_o <= w;",
             "loop"),
    "not Verilog": ("  always @(posedge clk) q_o <= ;", "syntax"),
    "foreign cell": ("  wire z;\n  DCCA u_gate (.CLKI(clk), .CE(d_i[0]), .CLKO(z));\n"
                     "  always @(posedge z) q_o <= d_i;", "DCCA"),
}
TABLE = ",".join(configurations.COLUMNS) + """
basic-fx18-paper,basic,1,fx18,paper,iterative,1,1,0,0,0,all
basic-fx18-overlapped,basic,1,fx18,overlapped,pipelined,2,1,0,1,0,sim
tree2-fx18-overlapped,tree,2,fx18,overlapped,pipelined,2,1,0,1,0,test
basic-fp32-overlapped,basic,1,fp32,overlapped,pipelined,4,4,0,1,0,test
basic-fx18-overlapped-bspline,basic,1,fx18,overlapped,bspline,2,1,0,1,0,test
"""
STAND_IN = """\
#!{python}
import json, re, sys, time
if sys.argv[1] == "-V":
    print(open("{root}/version").read())
    sys.exit()
script = sys.argv[-1]
open("{root}/ran", "a").write(script + "\\n")
if "generic" in script and "N 2" in script and {slow}:
    time.sleep(60)
cells = {{"a": {{"type": "$_NOT_", "parameters": {{}}, "port_directions": {{"A": "input",
         "Y": "output"}}, "connections": {{"A": [2], "Y": [3]}}}}}}
open(re.search(r"json -o (\\S+)", script).group(1), "w").write(json.dumps({{"modules": {{
    "ffd_org_select": {{"ports": {{}}, "cells": cells if "generic" in script else {{}}}}}}}}))
"""


class Checkout(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.path = os.environ["PATH"]
        shutil.copytree(ROOT / "synth", self.root / "synth")
        self.put("rtl/hwffd.f", "evaluator/ffd_org_select.v\nevaluator/ffd_org_other.v\n")
        self.put("rtl/number/ffd_num.vh", "`define ONE 4'd1\n")
        self.put("rtl/configurations.csv", TABLE)
        self.put("rtl/evaluator/ffd_org_other.v",
                 MODULE.format(name="ffd_org_other", parameters="SIZE = 1", body=GOOD))
        self.module(GOOD)

    def put(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def module(self, body):
        self.put("rtl/evaluator/ffd_org_select.v", MODULE.format(
            name="ffd_org_select", parameters=PARAMETERS, body=body))

    def stand_in(self, slow=False):
        self.put("version", "Yosys 1")
        self.put("bin/yosys", STAND_IN.format(python=sys.executable, root=self.root, slow=slow))
        (self.root / "bin/yosys").chmod(0o755)
        self.path = f"{self.root}/bin:{self.path}"

    def command(self, *words):
        return ([sys.executable, "-B", str(ROOT / "scripts" / "synth"), "--root", str(self.root),
                 *words], {"env": {**os.environ, "PATH": self.path}, "text": True,
                           "stdout": subprocess.PIPE, "stderr": subprocess.PIPE})

    def synth(self, *words):
        command, how = self.command(*words)
        done = subprocess.run(command, check=False, **how)
        return done.returncode, done.stdout.splitlines(), done.stderr.splitlines()

    def ran(self):
        """The scripts that the stand-in was given since the last call."""
        log = self.root / "ran"
        found = log.read_text().splitlines() if log.exists() else []
        log.unlink(missing_ok=True)
        return found

    def report(self):
        return json.loads((self.root / "build/reports/synth.json").read_text())

    def drafts(self):
        return [p.name for p in (self.root / "build").rglob("*")
                if p.suffix in (".draft", ".netlist")]


class Yosys(Checkout):
    def test_counts_of_a_good_row(self):
        status, lines, errors = self.synth("--org", "tree")
        self.assertEqual((status, errors), (0, []), lines)
        rows = {row["target"]: row for row in self.report()["rows"]}
        self.assertEqual(list(rows), ["generic", "ecp5", "xilinx7"])
        self.assertEqual({target: row["ff"] for target, row in rows.items()},
                         {"generic": 4, "ecp5": 4, "xilinx7": 4})
        self.assertEqual([rows["generic"][field] for field in ("lut", "dsp", "bram", "lutram")],
                         [None] * 4)
        self.assertGreater(rows["generic"]["cells"], rows["generic"]["ff"])
        for target in ("ecp5", "xilinx7"):
            self.assertIsNone(rows[target]["cells"])
            self.assertIn(rows[target]["lut"], range(1, 7))
            self.assertEqual((rows[target]["dsp"], rows[target]["bram"]), (0, 0))
        for row in rows.values():
            self.assertEqual((row["name"], row["org"], row["n"], row["format"], row["schedule"]),
                             ("tree2-fx18-overlapped", "tree", 2, "fx18", "overlapped"))
            self.assertIn(row["depth"], range(1, 5))

    def test_faults_are_refused(self):
        caught = 0
        for what, (body, word) in FAULTS.items():
            with self.subTest(what):
                self.module(body)
                status, _, errors = self.synth("--target", "ecp5", "--org", "tree")
                self.assertEqual((status, len(errors)), (1, 1), errors)
                self.assertTrue(errors[0].startswith(
                    "synth: tree2-fx18-overlapped, ffd_org_select, ecp5: "), errors)
                self.assertIn(word, errors[0].lower() if word.islower() else errors[0])
                log = errors[0].split(": see ")[1]
                self.assertTrue((self.root / log).is_file(), log)
                report = self.report()
                self.assertEqual((len(report["failed"]), report["rows"]), (1, []))
                caught += 1
        print(f"synth: {caught} of {len(FAULTS)} planted faults refused")

    def test_one_bad_row_leaves_the_others(self):
        self.module("  generate if (N == 2) begin : gen_latch\n  always @* if (clk) q_o = d_i;\n"
                    "  end else begin : gen_good\n" + GOOD + "\n  end endgenerate")
        status, _, errors = self.synth("--target", "generic")
        self.assertEqual((status, len(errors)), (1, 1), errors)
        self.assertEqual([row["name"] for row in self.report()["rows"]], [
            "basic-fx18-overlapped", "basic-fp32-overlapped", "basic-fx18-overlapped-bspline"])
        self.assertIn("Failed: tree2-fx18-overlapped",
                      (self.root / "build/reports/synth.md").read_text())
        self.assertEqual(self.drafts(), [])


class Bookkeeping(Checkout):
    def setUp(self):
        super().setUp()
        self.stand_in()

    def test_only_what_changed_runs_again(self):
        def again():
            self.assertEqual(self.synth()[0], 0)
            return len(self.ran())

        everything = again()
        self.assertEqual(everything, 4 + 4 + 4 + 2)
        self.assertEqual(again(), 0)
        source = self.root / "rtl/evaluator/ffd_org_select.v"
        changes = {
            "source": lambda: self.module(GOOD + " "),
            "header": lambda: self.put("rtl/number/ffd_num.vh", "`define ONE 4'd2\n"),
            "checks": lambda: self.put("synth/verify.ys", "check -assert\n"),
            "version": lambda: self.put("version", "Yosys 2"),
        }
        for what, change in changes.items():
            with self.subTest(what):
                change()
                self.assertEqual(again(), everything)
                self.assertEqual(again(), 0)
        self.put("synth/ice40.ys", "synth_ice40\n")
        self.assertEqual(again(), 2)
        self.put("rtl/configurations.csv", TABLE.replace("tree,2,", "tree,4,"))
        self.assertEqual(again(), 3)
        self.put("rtl/evaluator/ffd_org_other.v", "module ffd_org_other; endmodule\n")
        source.touch()
        self.assertEqual(again(), 0)

    def test_stale_results_are_not_reported(self):
        self.synth()
        self.module(GOOD + " ")
        self.assertEqual(self.synth("--org", "tree")[0], 0)
        report = self.report()
        self.assertEqual({row["org"] for row in report["rows"]}, {"tree"})
        self.assertEqual(report["wanted"], 14)
        self.assertIn("11 of 14 rows have not been mapped",
                      (self.root / "build/reports/synth.md").read_text())

    def test_selection(self):
        for words, count in ((("--target", "ice40"), 2), (("--org", "tree"), 3), (("--n", "2"), 3),
                             (("--format", "fp32"), 3), (("--set", "ci"), 6),
                             (("--set", "ci", "--target", "generic"), 1)):
            with self.subTest(words):
                self.module(GOOD + f" // {words}")
                self.assertEqual(self.synth(*words)[0], 0)
                self.assertEqual(len(self.ran()), count)

    def test_bad_requests(self):
        for words, message in (
                (("--target", "ecp6"), "unknown TARGET 'ecp6': one of generic, ecp5, ice40, xili"),
                (("--org", "x"), "unknown ORG 'x': one of basic, tree"),
                (("--n", "3"), "unknown N '3': one of 1, 2"),
                (("--format", "fx19"), "unknown FORMAT 'fx19': one of fx18, fp32"),
                (("--set", "cd"), "unknown SET 'cd': one of all, ci"),
                (("--org", "tree", "--format", "fp32"), "no row is mapped for ORG=tree, FORMAT=fp"),
                (("--org", "-x"), "argument --org: expected one argument"),
                (("-j", "x"), "argument -j/--jobs: invalid int value: 'x'")):
            with self.subTest(words):
                status, lines, errors = self.synth(*words)
                self.assertEqual((status, lines, len(errors)), (2, [], 1), errors)
                self.assertTrue(errors[0].startswith(f"synth: {message}"), errors)
                self.assertFalse((self.root / "build").exists())

    def test_bad_table_is_one_line(self):
        self.put("rtl/configurations.csv", TABLE.replace("tree", "none"))
        status, _, errors = self.synth()
        self.assertEqual((status, len(errors)), (1, 1))
        self.assertIn("unknown org 'none'", errors[0])

    def test_interrupted_run_keeps_what_was_finished(self):
        self.stand_in(slow=True)
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number):
                self.module(GOOD + f" // {number}")
                command, how = self.command("--target", "generic", "-j", "2")
                process = subprocess.Popen(command, **how)
                deadline = time.monotonic() + 30
                while time.monotonic() < deadline and len(self.kept()) < 3:
                    time.sleep(0.1)
                time.sleep(0.3)
                process.send_signal(number)
                _, errors = process.communicate(timeout=30)
                self.assertEqual(process.returncode, 130, errors)
                self.assertEqual(errors.count("\n"), 1, errors)
                self.assertEqual(len(self.kept()), 3)
                self.assertEqual(self.drafts(), [])
                shutil.rmtree(self.root / "build")

    def kept(self):
        return list((self.root / "build/synth").glob("*.json"))


class Table(unittest.TestCase):
    def test_rows_of_this_tree(self):
        found = synthesis.subjects(configurations.read())
        names = [subject.name for subject in found]
        self.assertEqual(len(names), len(set(names)))
        self.assertGreaterEqual(len(names), 40)
        self.assertEqual({subject.target for subject in found}, set(synthesis.TARGETS))
        self.assertEqual({subject.top for subject in found},
                         {synthesis.ORGANIZATION, synthesis.CORE})
        wired = [subject for subject in found if subject.row.evaluator == "bspline"]
        for subject in wired:
            general = subject.name.replace("-bspline", "")
            self.assertIn(general, names)
        self.assertGreater(len(wired), 0)
        few = synthesis.of_set(found, "ci")
        self.assertEqual({subject.target for subject in few}, set(synthesis.TARGETS))
        self.assertEqual({subject.row.org for subject in few},
                         {subject.row.org for subject in found})


if __name__ == "__main__":
    unittest.main(verbosity=2)
