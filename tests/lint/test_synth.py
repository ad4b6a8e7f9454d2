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
import time
import unittest

from workspace import ROOT, Workspace

import configurations
import liberty
import selection
import synthesis
import timing

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
LIST = """
import pathlib, sys
sys.path.insert(0, sys.argv[1])
import selection, synthesis
root = pathlib.Path(sys.argv[2])
work = synthesis.Synthesis(root)
print(*(work.file(subject).name for subject in selection.subjects(root)))
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


class Checkout(Workspace):
    def setUp(self):
        super().setUp()
        self.path, self.library = os.environ["PATH"], str(liberty.PATH)
        self.log = self.root / "ran"
        self.copy("synth")
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
        found = self.log.read_text().splitlines() if self.log.exists() else []
        self.log.unlink(missing_ok=True)
        return found

    def report(self):
        return json.loads((self.root / "build/reports/synth.json").read_text())

    def drafts(self):
        return [p.name for p in (self.root / "build").rglob("*")
                if p.suffix in (".draft", ".netlist", ".v", ".tcl")]


class Yosys(Checkout):
    def test_counts_of_a_good_row(self):
        targets = ["generic", "ecp5", "xilinx7", *(["osu018"] if HAS_CELLS else [])]
        for words in ((),) if HAS_CELLS else [("--target", target) for target in targets]:
            status, lines, errors = self.synth("--org", "tree", *words)
            self.assertEqual((status, errors), (0, []), lines)
        rows = {row["target"]: row for row in self.report()["rows"]}
        self.assertEqual(list(rows), targets)
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
            self.assertEqual(row["ff"], 4)
            self.assertGreaterEqual(sum(row["kinds"].values()), 4)
            self.assertEqual((row["fmax_share"], row["routed"], row["seeds"]), (None, False, []))
            self.assertEqual((row["name"], row["org"], row["n"], row["format"], row["schedule"]),
                             ("tree2-fx18-overlapped", "tree", 2, "fx18", "overlapped"))
            self.assertIn(row["depth"], range(1, 5))
        self.assertEqual(self.drafts(), [])

    def test_bad_rows_are_refused_and_leave_the_others(self):
        """Each fault is in a tree of another size."""
        sizes = dict(zip(FAULTS, (2, 4, 8, 16, 32)))
        tree = next(line for line in TABLE.splitlines() if line.startswith("tree2"))
        self.put("rtl/configurations.csv", TABLE.replace(tree, "\n".join(
            tree.replace("tree2", f"tree{n}").replace(",2,fx18", f",{n},fx18")
            for n in sizes.values())))
        self.module("  generate\n" + "\n".join(
            f"  if (N == {sizes[what]}) begin : gen_fault\n{body}\n  end else"
            for what, (body, _) in FAULTS.items()) + " begin : gen_good\n" + GOOD
            + "\n  end endgenerate")
        status, _, errors = self.synth("--target", "ecp5", "--format", "fx18")
        self.assertEqual((status, len(errors)), (1, len(FAULTS)), errors)
        for what, (_, word) in FAULTS.items():
            with self.subTest(what):
                line, = (line for line in errors if line.startswith(
                    f"synth: tree{sizes[what]}-fx18-overlapped, ffd_org_select, ecp5: "))
                self.assertIn(word, line.lower() if word.islower() else line)
                self.assertTrue((self.root / line.split(": see ")[1]).is_file(), line)
        self.assertEqual(len(self.report()["failed"]), len(FAULTS))
        self.assertEqual([row["name"] for row in self.report()["rows"]],
                         ["basic-fx18-overlapped", "basic-fx18-overlapped-bspline"])
        self.assertIn("Failed: tree2-fx18-overlapped",
                      (self.root / "build/reports/synth.md").read_text())
        self.assertEqual(self.drafts(), [])
        print(f"synth: {len(errors)} of {len(FAULTS)} planted faults refused")

    def test_what_is_no_verilog_is_refused(self):
        self.module("  always @(posedge clk) q_o <= ;")
        status, _, errors = self.synth("--target", "ecp5", "--org", "tree")
        self.assertEqual((status, len(errors), "syntax" in errors[0]), (1, 1, True), errors)


class Bookkeeping(Checkout):
    def setUp(self):
        super().setUp()
        self.stand_in()

    def kept(self):
        return list((self.root / "build/synth").glob("*.json"))

    def keys(self):
        """The results that are wanted of the tree as it is."""
        command, how = self.command()
        list_ = [sys.executable, "-B", "-c", LIST, str(ROOT / "scripts"), str(self.root)]
        return set(subprocess.run(list_, check=True, **how).stdout.split())

    def test_only_what_changed_runs_again(self):
        everything = 4 * 4 + 2 + 8  # with two units on two targets
        for count in (everything, 0):
            self.assertEqual((self.synth()[0], len(self.ran())), (0, count))
        select, adder = (f"rtl/evaluator/{name}.v" for name in ("ffd_org_select", "ffd_fp_add"))
        before = self.keys()
        for name, old, new, count in (
                ("rtl/number/ffd_num.vh", "4'd1", "4'd2", everything),
                ("synth/verify.ys", "-noinit", "", everything),
                ("version", "1", "2", everything), (adder, "LATENCY = 1", "LATENCY = 2", 4),
                ("synth/up5k.ys", "-dsp", "", 2), ("synth/osu018.tcl", "report_checks", "report", 8),
                ("cells.lib", "16", "8", 8), ("sta_version", "2.0", "2.1", 8),
                ("rtl/configurations.csv", "tree,2,", "tree,4,", 4),
                (select, GOOD, GOOD.replace("+", "-"), everything - 8),
                ("rtl/evaluator/ffd_org_other.v", "[3:0]", "[4:0]", 0),
                (select, "  input ", "  // a comment\n\n  /* and */   input  ", 0),
                (select, "module", "`include \"moved.vh\"\nmodule", 0),
                ("synth/verify.ys", "hierarchy", "# a comment\n\nhierarchy", 0)):
            with self.subTest(name, new=new):
                self.put("rtl/number/moved.vh", "// nothing\n")
                text = (self.root / name).read_text()
                self.assertIn(old, text)
                self.put(name, text.replace(old, new, 1))
                after = self.keys()
                self.put(name, text)
                self.assertEqual(len(after - before), count)
        head, tail = (self.root / select).read_text().split(GOOD)
        self.put("rtl/number/moved.vh", GOOD)
        self.put(select, head + "`include \"moved.vh\"" + tail)
        self.assertEqual(self.keys(), before)
        self.assertEqual((self.synth()[0], self.ran()), (0, []))

    def test_stale_results_are_not_reported(self):
        self.synth("--target", "ecp5")
        self.module(GOOD.replace("+", "-"))
        self.assertEqual(self.synth("--org", "tree", "--target", "ecp5")[0], 0)
        report = self.report()
        self.assertEqual([row["org"] for row in report["rows"]], ["tree", *["unit"] * 4])
        self.assertEqual(report["wanted"], 26)
        self.assertIn("21 of 26 rows have not been mapped",
                      (self.root / "build/reports/synth.md").read_text())

    def test_selection(self):
        found = selection.subjects(self.root)
        for words, count in ((("--target", "up5k"), 2),
                             (("--org", "tree"), 4), (("--n", "2"), 4), (("--org", "unit"), 8),
                             (("--format", "fp32"), 12), (("--set", "ci"), 7),
                             (("--set", "ci", "--target", "generic"), 1),
                             (("--set", "baseline", "--target", "osu018"), 5)):
            with self.subTest(words):
                parser = selection.Parser()
                parser.add_argument("--set", default="all")
                options = parser.parse_args(words)
                self.assertEqual(len(selection.chosen(found, options.set, options)), count)
        status, _, _ = self.synth("--set", "ci", "--target", "generic")
        self.assertEqual((status, len(self.ran())), (0, 1))

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

    def test_interrupted_run_goes_on_where_it_stopped(self):
        self.stand_in(slow=True)
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number):
                self.ran()
                command, how = self.command("--target", "generic", "-j", "2")
                process = subprocess.Popen(command, **how)
                deadline = time.monotonic() + 60
                while time.monotonic() < deadline and (len(self.kept()) < 3 or not self.log.exists()):
                    time.sleep(0.1)
                time.sleep(0.3)
                process.send_signal(number)
                _, errors = process.communicate(timeout=30)
                self.assertEqual(process.returncode, 130, errors)
                self.assertEqual(errors.count("\n"), 1, errors)
                self.assertEqual(len(self.kept()), 3)
                self.assertEqual(self.drafts(), [])
                self.assertEqual(len(self.ran()), 4 if number == signal.SIGINT else 1)
        self.stand_in()
        self.assertEqual((self.synth("--target", "generic")[0], len(self.ran()), len(self.kept())),
                         (0, 1, 4))


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
        wired = [name for name in names if name.split(".")[0].endswith("-bspline")]
        self.assertGreater(len(wired), 0)
        self.assertLessEqual({name.replace("-bspline", "") for name in wired}, set(names))
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
