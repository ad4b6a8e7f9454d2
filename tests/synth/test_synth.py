"""tools.synth on a small copy of the tree: what it runs, refuses, keeps and reports. Faults in
the RTL meet yosys itself; where only the bookkeeping is of interest, a stand-in takes its place.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time

import pytest

from tests.support import forked_snakemake
from tools import csv_table
from tools.synth import liberty, selection, synthesis, timing, variants
from tools.tables import configurations

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
basic-fx18-paper,basic,1,fx18,paper,iterative,1,1,0,0,evaluator,all,none
basic-fx18-overlapped,basic,1,fx18,overlapped,pipelined,2,1,0,1,evaluator,sim,none
tree2-fx18-overlapped,tree,2,fx18,overlapped,pipelined,2,1,0,1,evaluator,test,none
basic-fp32-overlapped,basic,1,fp32,overlapped,pipelined,4,4,0,1,evaluator,test,none
basic-fx18-overlapped-iterative,basic,1,fx18,overlapped,iterative,2,1,0,1,evaluator,test,none
"""
STAND_IN = """\
#!{python}
import json, re, sys, time
if sys.argv[1] == "-V":
    print(open("{root}/version").read())
    sys.exit()
script = sys.argv[-1]
if "write_rtlil" in script:
    sys.exit(1)  # not elaborated: keys are those of the sources
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
from tools.synth import synthesis
root = pathlib.Path(sys.argv[1])
work = synthesis.Synthesis(root)
print(*(work.file(subject).name for subject in synthesis.of_checkout(root)))
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
SELECT, ADDER = (f"rtl/evaluator/{name}.v" for name in ("ffd_org_select", "ffd_fp_add"))


def select(body):
    return {SELECT: MODULE.format(name="ffd_org_select", parameters=PARAMETERS, body=body)}


class Tree:
    """The small copy, and the programs that are found there."""

    def __init__(self, checkout):
        self.root, self.put, self.text = checkout.root, checkout.put, checkout.text
        self.run = checkout.run
        self.path, self.library = os.environ["PATH"], str(liberty.PATH)
        self.log = self.root / "ran"
        checkout.copy("synth")
        others = {**dict.fromkeys(synthesis.FLOAT_UNITS, "LATENCY = 1"), "ffd_org_other": "SIZE = 1"}
        self.put({
            "rtl/hwffd.f": "+incdir+number\nevaluator/ffd_org_select.v\n" + "".join(
                f"evaluator/{name}.v\n" for name in others),
            "rtl/number/ffd_num.vh": "`define ONE 4'd1\n", "rtl/configurations.csv": TABLE,
            "synth/variants.csv": ",".join(variants.COLUMNS) + "\n",
            **select(GOOD), **{
                f"rtl/evaluator/{name}.v": MODULE.format(name=name, parameters=own, body=GOOD)
                for name, own in others.items()}})

    def stand_in(self, slow=False):
        self.put({"version": "Yosys 1", "sta_version": "2.0", "timed": TIMED,
                  "cells.lib": "cell (INV) {\n  area : 16;\n}\n"})
        self.put({"bin/yosys": STAND_IN.format(python=sys.executable, root=self.root, slow=slow),
                  "bin/sta": STAND_IN_STA.format(root=self.root)}, 0o755)
        self.library = str(self.root / "cells.lib")
        self.path = f"{self.root}/bin:{self.path}"

    @property
    def environment(self):
        return {**os.environ, "PATH": self.path, "HWFFD_OSU018": self.library}

    def command(self, *words):
        return [sys.executable, "-B", "-m", "tools.synth", "--root", self.root, *words]

    def synth(self, *words):
        without_cells = "--target" in words and liberty.TARGET not in words
        if without_cells or self.library == str(liberty.PATH):
            status, out, errors = forked_snakemake.module(self.root, "tools.synth", "--root", self.root, *words, PATH=self.path)
        else:
            status, out, errors = self.run(*self.command(*words), env=self.environment)
        return status, out.splitlines(), errors.splitlines()

    def ran(self):
        """The scripts that the stand-in was given since the last call."""
        lines = self.log.read_text().splitlines() if self.log.exists() else []
        self.log.unlink(missing_ok=True)
        return lines

    def report(self):
        return json.loads(self.text("build/reports/synth.json"))

    def drafts(self):
        return [p.name for p in (self.root / "build").rglob("*")
                if p.suffix in (".draft", ".netlist", ".v", ".tcl")]

    def results(self):
        return list((self.root / "build/synth").glob("*.json"))

    def keys(self):
        """The results that are wanted of the tree as it is."""
        return set(self.run(sys.executable, "-B", "-c", LIST, self.root,
                            env=self.environment)[1].split())


@pytest.fixture
def real(checkout):
    return Tree(checkout)


@pytest.fixture
def tree(real):
    real.stand_in()
    return real


def test_counts_of_a_good_row(real):
    targets = ["generic", "ecp5", "xilinx7", *(["osu018"] if HAS_CELLS else [])]
    for words in ((),) if HAS_CELLS else [("--target", target) for target in targets]:
        status, lines, errors = real.synth("--org", "tree", *words)
        assert (status, errors) == (0, []), lines
    rows = {row["target"]: row for row in real.report()["rows"]}
    assert list(rows) == targets
    assert {rows["generic"][field] for field in ("lut", "dsp", "bram", "lutram")} == {None}
    assert rows["generic"]["cells"] > rows["generic"]["ff"]
    for target in ("ecp5", "xilinx7"):
        row = rows[target]
        assert row["lut"] in range(1, 7)
        assert (row["dsp"], row["bram"]) == (0, 0)
        assert {row[field] for field in ("cells", "area_um2", "power_mw", "fmax_mhz")} == {None}
    if HAS_CELLS:
        cells = rows["osu018"]
        assert cells["area_um2"] > 4 * 96
        assert cells["fmax_mhz"] > 100
        assert cells["power_mw"] > 0
        assert re.search(r"^from \S+ to q_o", cells["critical_path"])
    for row in rows.values():
        assert row["ff"] == 4
        assert sum(row["kinds"].values()) >= 4
        assert (row["fmax_share"], row["routed"], row["seeds"]) == (None, False, [])
        assert (row["name"], row["org"], row["n"], row["format"], row["schedule"]) == (
            "tree2-fx18-overlapped", "tree", 2, "fx18", "overlapped")
        assert row["depth"] in range(1, 5)
    assert real.drafts() == []


def test_bad_rows_are_refused_and_leave_the_others(real):
    """Each fault is in a tree of another size."""
    sizes = dict(zip(FAULTS, (2, 4, 8, 16, 32)))
    tree = next(line for line in TABLE.splitlines() if line.startswith("tree2"))
    real.put({"rtl/configurations.csv": TABLE.replace(tree, "\n".join(
        tree.replace("tree2", f"tree{n}").replace(",2,fx18", f",{n},fx18")
        for n in sizes.values()))})
    real.put(select("  generate\n" + "\n".join(
        f"  if (N == {sizes[what]}) begin : gen_fault\n{body}\n  end else"
        for what, (body, _) in FAULTS.items()) + " begin : gen_good\n" + GOOD
        + "\n  end endgenerate"))
    status, _, errors = real.synth("--target", "ecp5", "--format", "fx18")
    assert (status, len(errors)) == (1, len(FAULTS))
    for what, (_, word) in FAULTS.items():
        line, = (line for line in errors if line.startswith(
            f"synth: tree{sizes[what]}-fx18-overlapped, ffd_org_select, ecp5: "))
        assert word in (line.lower() if word.islower() else line)
        assert (real.root / line.split(": see ")[1]).is_file()
    assert len(real.report()["failed"]) == len(FAULTS)
    assert [row["name"] for row in real.report()["rows"]] == [
        "basic-fx18-overlapped", "basic-fx18-overlapped-iterative"]
    assert "Failed: tree2-fx18-overlapped" in real.text("build/reports/synth.md")
    assert real.drafts() == []


def test_what_is_no_verilog_is_refused(real):
    real.put(select("  always @(posedge clk) q_o <= ;"))
    status, _, (error,) = real.synth("--target", "ecp5", "--org", "tree")
    assert status == 1 and "syntax" in error


@pytest.mark.whole
def test_only_what_changed_runs_again(tree):
    everything = 4 * 4 + 2 + 8  # with two units on two targets
    for count in (everything, 0):
        assert (tree.synth()[0], len(tree.ran())) == (0, count)
    before = tree.keys()
    for name, old, new, count in (
            ("rtl/number/ffd_num.vh", "4'd1", "4'd2", everything),
            ("synth/verify.ys", "-noinit", "", everything),
            ("version", "1", "2", everything), (ADDER, "LATENCY = 1", "LATENCY = 2", 4),
            ("synth/up5k.ys", "-dsp", "", 2), ("synth/osu018.tcl", "report_checks", "report", 8),
            ("cells.lib", "16", "8", 8), ("sta_version", "2.0", "2.1", 8),
            ("rtl/configurations.csv", "tree,2,", "tree,4,", 4),
            (SELECT, GOOD, GOOD.replace("+", "-"), everything - 8),
            ("rtl/evaluator/ffd_org_other.v", "[3:0]", "[4:0]", 0),
            (SELECT, "  input ", "  // a comment\n\n  /* and */   input  ", 0),
            (SELECT, "module", "`include \"moved.vh\"\nmodule", 0),
            ("synth/verify.ys", "hierarchy", "# a comment\n\nhierarchy", 0)):
        text = tree.text(name)
        assert old in text
        tree.put({"rtl/number/moved.vh": "// nothing\n", name: text.replace(old, new, 1)})
        assert len(tree.keys() - before) == count, (name, new)
        tree.put({name: text})
    head, tail = tree.text(SELECT).split(GOOD)
    tree.put({"rtl/number/moved.vh": GOOD, SELECT: head + "`include \"moved.vh\"" + tail})
    assert tree.keys() == before
    assert (tree.synth()[0], tree.ran()) == (0, [])


@pytest.mark.whole
def test_stale_results_are_not_reported(tree):
    tree.synth("--target", "ecp5")
    tree.put(select(GOOD.replace("+", "-")))
    assert tree.synth("--org", "tree", "--target", "ecp5")[0] == 0
    report = tree.report()
    assert [row["org"] for row in report["rows"]] == ["tree", *["unit"] * 4]
    assert report["wanted"] == 26
    assert "21 of 26 rows have not been mapped" in tree.text("build/reports/synth.md")


def test_selection(tree):
    subjects = synthesis.of_checkout(tree.root)
    parser = selection.Parser()
    parser.add_argument("--set", default="all")
    for words, count in (("--target up5k", 2), ("--org tree", 4), ("--n 2", 4), ("--org unit", 8),
                         ("--format fp32", 12), ("--set ci", 7), ("--set ci --target generic", 1),
                         ("--set baseline --target osu018", 5)):
        options = parser.parse_args(words.split())
        assert len(selection.chosen(subjects, options.set, options)) == count, words
    assert (tree.synth("--set", "ci", "--target", "generic")[0], len(tree.ran())) == (0, 1)


@pytest.mark.parametrize("words, message", (
    ("--target ecp6", "unknown TARGET 'ecp6': one of generic, ecp5, up5k, hx8k"),
    ("--org x", "unknown ORG 'x': one of basic, tree, unit"),
    ("--n 3", "unknown N '3': one of 1, 2"),
    ("--format fx19", "unknown FORMAT 'fx19': one of fx18, fp32"),
    ("--set cd", "unknown SET 'cd': one of all, ci, baseline"),
    ("--org tree --format fp32", "no row is mapped for ORG=tree, FORMAT=fp"),
    ("--org -x", "argument --org: expected one argument"),
    ("-j x", "argument -j/--jobs: invalid int value: 'x'")))
def test_bad_requests(tree, words, message):
    status, lines, (error,) = tree.synth(*words.split())
    assert (status, lines) == (2, [])
    assert error.startswith(f"synth: {message}")
    assert not (tree.root / "build").exists()


def test_clock_and_power_are_those_of_opensta(tree):
    assert tree.synth("--target", "osu018", "--org", "tree")[0] == 0
    row = tree.report()["rows"][0]
    assert (row["fmax_mhz"], row["power_mw"], row["critical_path"]) == (
        250, 125, "from first_q to u_a/sum_q_3")
    assert "| 250.0 | from first_q to u_a/sum_q_3 |" in tree.text("build/reports/synth.md")
    tree.put({"timed": "Error: v, line 1 syntax error\n", "sta_version": "2.1"})
    status, _, (error,) = tree.synth("--target", "osu018", "--org", "tree")
    assert status == 1 and "OpenSTA: Error: v, line 1" in error


def test_missing_tools_are_one_line(tree):
    """Of standard cells only where rows of them are wanted."""
    tree.library = "/nowhere.lib"
    assert tree.synth("--target", "generic")[0] == 0
    assert tree.report()["wanted"] == 26
    for message in ("no /nowhere.lib: install Debian's qflow-tech-osu018",
                    "sta not found: install Debian's opensta", "yosys not found: run tools/"):
        status, lines, (error,) = tree.synth("--target", "osu018")
        assert (status, lines) == (1, [])
        assert error.startswith(f"synth: {message}")
        tree.path = f"{tree.root}/bin"
        tree.put({f"bin/{'sta' if 'nowhere' in message else 'yosys'}": None})


def test_bad_table_is_one_line(tree):
    tree.put({"rtl/configurations.csv": TABLE.replace("tree", "none")})
    status, _, (error,) = tree.synth()
    assert status == 1 and "unknown org 'none'" in error


@pytest.mark.whole
def test_interrupted_run_goes_on_where_it_stopped(tree):
    tree.stand_in(slow=True)
    for number, ran in ((signal.SIGINT, 4), (signal.SIGTERM, 1)):
        interrupt(tree, number)
        assert len(tree.results()) == 3
        assert tree.drafts() == []
        assert len(tree.ran()) == ran
    tree.stand_in()
    assert (tree.synth("--target", "generic")[0], len(tree.ran()), len(tree.results())) == (0, 1, 4)


def interrupt(tree, number):
    """A run that ends three rows; the fourth hangs."""
    tree.ran()
    process = subprocess.Popen(tree.command("--target", "generic", "-j", "2"), text=True,
                               env=tree.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline and (len(tree.results()) < 3 or not tree.log.exists()):
        time.sleep(0.1)
    time.sleep(0.3)
    process.send_signal(number)
    _, errors = process.communicate(timeout=30)
    assert (process.returncode, errors.count("\n")) == (130, 1), errors


@pytest.mark.parametrize("line, wrong", (
    ("basic,more,hwffd_stream,A=1,-", "unknown name 'basic'"),
    ("basic-fx18-overlapped,more,ffd_org_select,A=1,-", "unknown top 'ffd_org_select'"),
    ("basic-fx18-overlapped,more,hwffd_stream,A=x,-", "parameters 'A=x': NAME=NUMBER"),
    ("basic-fx18-overlapped,more,hwffd_stream,,-", "parameters '': NAME=NUMBER"),
    ("basic-fx18-overlapped,more,hwffd_stream,FEATURES=256,-", ":2: parameters 'FEATURES=256': NAME=NUMBER"),
    ("basic-fx18-overlapped,more,hwffd_stream,FEATURES=resident+page,-",
     "csv:2: parameters: FEATURES=resident.page: unknown feature 'page': some of pages, large, .*, halves wanted"),
    ("basic-fx18-overlapped,more,hwffd_stream,FEATURES=pages+pages,-", "FEATURES=pages.pages: twice 'pages'"),
    ("basic-fx18-overlapped,more,hwffd_stream,A=1,-\n" * 2, "is there twice")))
def test_variants_that_make_no_sense(tree, line, wrong):
    tree.put({"synth/variants.csv": ",".join(variants.COLUMNS) + "\n" + line + "\n"})
    with pytest.raises(csv_table.TableError, match=wrong):
        synthesis.of_checkout(tree.root)


def test_a_variant_has_the_parameters_of_its_row_and_its_own(tree):
    tree.put({"synth/variants.csv": ",".join(variants.COLUMNS) + "\n"
              "basic-fx18-overlapped,few,hwffd_stream,FORMAT=16 FEATURES=resident,only a few\n"})
    variant, = (subject for subject in synthesis.of_checkout(tree.root) if subject.variant[0])
    assert (variant.name, variant.variant) == ("basic-fx18-overlapped+few.hwffd_stream.ecp5",
                                               ("few", "only a few"))
    assert variant.row.parameters == {**variant.row.row.parameters, "FORMAT": 16, "FEATURES": 256}
