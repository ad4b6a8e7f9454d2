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
import liberty  # noqa: E402
import synthesis  # noqa: E402
import timing  # noqa: E402

HAS_CELLS = liberty.PATH.is_file() and shutil.which(timing.PROGRAM)

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
basic-fx18-paper,basic,1,fx18,paper,iterative,1,1,0,0,evaluator,all
basic-fx18-overlapped,basic,1,fx18,overlapped,pipelined,2,1,0,1,evaluator,sim
tree2-fx18-overlapped,tree,2,fx18,overlapped,pipelined,2,1,0,1,evaluator,test
basic-fp32-overlapped,basic,1,fp32,overlapped,pipelined,4,4,0,1,evaluator,test
basic-fx18-overlapped-bspline,basic,1,fx18,overlapped,bspline,2,1,0,1,evaluator,test
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
    re.search(r"-top (\\w+)", script).group(1): {{"ports": {{}}, "netnames": {{}},
        "cells": cells if "generic" in script else {{}}}}}}}}))
"""
STAND_IN_STA = """\
#!/bin/sh
[ "$1" != -version ] || {{ cat {root}/sta_version; exit; }}
cat {root}/timed
"""
TIMED = """\
Startpoint: first_q (rising edge-triggered flip-flop clocked by clk)
Endpoint: u_a/sum_q_3 (rising edge-triggered flip-flop clocked by clk)
    6.0000   slack (MET)
Total    1.0e-01   2.0e-02   4.0e-06   1.25e-01 100.0%
"""


class Checkout(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.path, self.library = os.environ["PATH"], str(liberty.PATH)
        shutil.copytree(ROOT / "synth", self.root / "synth")
        self.put("rtl/hwffd.f", "+incdir+number\nevaluator/ffd_org_select.v\nevaluator/ffd_org_other.v\n"
                 + "".join(f"evaluator/{unit}.v\n" for unit in synthesis.FLOAT_UNITS))
        for unit in synthesis.FLOAT_UNITS:
            self.put(f"rtl/evaluator/{unit}.v",
                     MODULE.format(name=unit, parameters="LATENCY = 1", body=GOOD))
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
        self.put("bin/sta", STAND_IN_STA.format(root=self.root))
        self.put("sta_version", "2.0")
        self.put("timed", TIMED)
        self.put("cells.lib", "cell (INV) {\n  area : 16;\n}\n")
        self.library = str(self.root / "cells.lib")
        for program in ("yosys", "sta"):
            (self.root / "bin" / program).chmod(0o755)
        self.path = f"{self.root}/bin:{self.path}"

    def command(self, *words):
        return ([sys.executable, "-B", str(ROOT / "scripts" / "synth"), "--root", str(self.root),
                 *words], {"env": {**os.environ, "PATH": self.path, "HWFFD_OSU018": self.library}, "text": True,
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
                if p.suffix in (".draft", ".netlist", ".v", ".tcl")]


class Yosys(Checkout):
    def test_counts_of_a_good_row(self):
        targets = ["generic", "ecp5", "xilinx7", *(["osu018"] if HAS_CELLS else [])]
        for target in targets:
            status, lines, errors = self.synth("--org", "tree", "--target", target)
            self.assertEqual((status, errors), (0, []), lines)
        rows = {row["target"]: row for row in self.report()["rows"]}
        self.assertEqual(list(rows), targets)
        for row in rows.values():
            self.assertEqual(row["ff"], 4)
            self.assertGreaterEqual(sum(row["kinds"].values()), 4)
        self.assertEqual([rows["generic"][field] for field in ("lut", "dsp", "bram", "lutram")],
                         [None] * 4)
        self.assertGreater(rows["generic"]["cells"], rows["generic"]["ff"])
        for target in ("ecp5", "xilinx7"):
            self.assertIsNone(rows[target]["cells"])
            self.assertIn(rows[target]["lut"], range(1, 7))
            self.assertEqual((rows[target]["dsp"], rows[target]["bram"]), (0, 0))
            self.assertEqual([rows[target][field] for field in ("area_um2", "power_mw", "fmax_mhz")],
                             [None] * 3)
        if HAS_CELLS:
            cells = rows["osu018"]
            self.assertGreater(cells["area_um2"], 4 * 96)
            self.assertGreater(cells["fmax_mhz"], 100)
            self.assertGreater(cells["power_mw"], 0)
            self.assertRegex(cells["critical_path"], r"^from \S+ to q_o")
        for row in rows.values():
            self.assertEqual((row["fmax_share"], row["routed"], row["seeds"]), (None, False, []))
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
        self.assertEqual(everything, 4 * 4 + 2 + 8)  # with two units on two targets
        self.assertEqual(again(), 0)
        source = self.root / "rtl/evaluator/ffd_org_select.v"
        changes = {
            "header": lambda: self.put("rtl/number/ffd_num.vh", "`define ONE 4'd2\n"),
            "checks": lambda: self.put("synth/verify.ys", "check -assert\n"),
            "version": lambda: self.put("version", "Yosys 2"),
        }
        for what, change in changes.items():
            with self.subTest(what):
                change()
                self.assertEqual(again(), everything)
                self.assertEqual(again(), 0)
        for name, text, count in (
                ("rtl/evaluator/ffd_fp_add.v", MODULE.format(
                    name="ffd_fp_add", parameters="LATENCY = 2", body=GOOD), 4),
                ("synth/up5k.ys", "synth_ice40\n", 2), ("synth/osu018.tcl", "report_checks\n", 8),
                ("cells.lib", "cell (INV) {\n  area : 8;\n}\n", 8), ("sta_version", "2.1", 8),
                ("rtl/configurations.csv", TABLE.replace("tree,2,", "tree,4,"), 4)):
            with self.subTest(name):
                self.put(name, text)
                self.assertEqual(again(), count)
        self.module(GOOD + " ")
        self.assertEqual(again(), everything - 8)
        self.put("rtl/evaluator/ffd_org_other.v", "module ffd_org_other; endmodule\n")
        source.touch()
        self.assertEqual(again(), 0)

    def test_stale_results_are_not_reported(self):
        self.synth()
        self.module(GOOD + " ")
        self.assertEqual(self.synth("--org", "tree")[0], 0)
        report = self.report()
        self.assertEqual({row["org"] for row in report["rows"]}, {"tree", "unit"})
        self.assertEqual(report["wanted"], 26)
        self.assertIn("14 of 26 rows have not been mapped",
                      (self.root / "build/reports/synth.md").read_text())

    def test_selection(self):
        for words, count in ((("--target", "up5k"), 2),
                             (("--org", "tree"), 4), (("--n", "2"), 4), (("--org", "unit"), 8),
                             (("--format", "fp32"), 4), (("--set", "ci"), 7),
                             (("--set", "ci", "--target", "generic"), 1),
                             (("--set", "baseline", "--target", "osu018"), 1)):
            with self.subTest(words):
                self.module(GOOD + f" // {words}")
                self.assertEqual(self.synth(*words)[0], 0)
                self.assertEqual(len(self.ran()), count)

    def test_bad_requests(self):
        for words, message in (
                (("--target", "ecp6"), "unknown TARGET 'ecp6': one of generic, ecp5, up5k, hx8k"),
                (("--org", "x"), "unknown ORG 'x': one of basic, tree, unit"),
                (("--n", "3"), "unknown N '3': one of 1, 2"),
                (("--format", "fx19"), "unknown FORMAT 'fx19': one of fx18, fp32"),
                (("--set", "cd"), "unknown SET 'cd': one of all, ci, baseline"),
                (("--org", "tree", "--format", "fp32"), "no row is mapped for ORG=tree, FORMAT=fp"),
                (("--org", "-x"), "argument --org: expected one argument"),
                (("-j", "x"), "argument -j/--jobs: invalid int value: 'x'")):
            with self.subTest(words):
                status, lines, errors = self.synth(*words)
                self.assertEqual((status, lines, len(errors)), (2, [], 1), errors)
                self.assertTrue(errors[0].startswith(f"synth: {message}"), errors)
                self.assertFalse((self.root / "build").exists())

    def test_clock_and_power_are_those_of_opensta(self):
        self.assertEqual(self.synth("--target", "osu018", "--org", "tree")[0], 0)
        row = self.report()["rows"][0]
        self.assertEqual((row["fmax_mhz"], row["power_mw"], row["critical_path"]),
                         (250, 125, "from first_q to u_a/sum_q_3"))
        self.assertIn("| 250.0 | from first_q to u_a/sum_q_3 |",
                      (self.root / "build/reports/synth.md").read_text())
        self.put("timed", "Error: v, line 1 syntax error\n")
        self.put("sta_version", "2.1")
        status, _, errors = self.synth("--target", "osu018", "--org", "tree")
        self.assertEqual((status, len(errors)), (1, 1), errors)
        self.assertIn("OpenSTA: Error: v, line 1", errors[0])
        self.assertEqual(self.drafts(), [])

    def test_missing_tools_are_one_line(self):
        """Of standard cells only where rows of them are wanted."""
        self.library = "/nowhere.lib"
        self.assertEqual(self.synth("--target", "generic")[0], 0)
        self.assertEqual(self.report()["wanted"], 26)
        for message in ("no /nowhere.lib: install Debian's qflow-tech-osu018",
                        "sta not found: install Debian's opensta", "yosys not found: run scripts/"):
            with self.subTest(message):
                status, lines, errors = self.synth("--target", "osu018")
                self.assertEqual((status, lines, len(errors)), (1, [], 1), errors)
                self.assertTrue(errors[0].startswith(f"synth: {message}"), errors)
            name = "sta" if "nowhere" in message else "yosys"
            self.path = f"{self.root}/bin"
            (self.root / "bin" / name).unlink(missing_ok=True)

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
        self.assertEqual({subject.top for subject in found}, {
            synthesis.ORGANIZATION, synthesis.CORE, synthesis.SYSTEM, *synthesis.FLOAT_UNITS})
        self.assertEqual({subject.row.name for subject in found if subject.top == synthesis.SYSTEM},
                         {row.name for row in configurations.read() if row.top == "axi"})
        wired = [subject for subject in found if subject.name.split(".")[0].endswith("-bspline")]
        for subject in wired:
            general = subject.name.replace("-bspline", "")
            self.assertIn(general, names)
        self.assertGreater(len(wired), 0)
        few = synthesis.of_set(found, "ci")
        self.assertEqual({subject.target for subject in few}, set(synthesis.TARGETS) - {"hx8k"})
        self.assertEqual({subject.row.org for subject in few},
                         {subject.row.org for subject in found} - {"unit"})
        guarded = synthesis.of_set(found, "baseline")
        self.assertEqual([subject for subject in guarded if subject in few], few)
        self.assertEqual({(subject.top, subject.target) for subject in guarded
                          if subject not in few},
                         {(top, target) for top in synthesis.FLOAT_UNITS
                          for target in synthesis.UNIT_TARGETS})


if __name__ == "__main__":
    unittest.main(verbosity=2)
