"""scripts/formal on a small copy of the tree: what it proves, refutes, refuses, keeps and reports.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import io
import json
import re
import shutil
import subprocess
import sys
import unittest

from workspace import ROOT, Workspace

import proofs
import rtl

COUNTER = """\
`default_nettype none
module ffd_stream_count (
  input  wire       clk,
  input  wire       rst,
  input  wire       step_i,
  output reg  [3:0] count_o
);
  always @(posedge clk) begin
    if (rst) count_o <= 4'd0;
    else if (step_i && count_o != 4'd13) count_o <= count_o + 4'd1;
  end
endmodule
`default_nettype wire
"""
HARNESS = """\
`default_nettype none
module formal_count #(
  parameter MOST = 13
) (
  input wire clk,
  input wire rst,
  input wire step
);
  wire [3:0] count;
  ffd_stream_count u_dut (.clk(clk), .rst(rst), .step_i(step), .count_o(count));
  reg first_q = 1'b1;
  always @(posedge clk) first_q <= 1'b0;
  always @* if (first_q) assume (rst);
  always @* if (!first_q) begin
    bound: assert (count <= MOST);
    narrow: assert (count[3:1] != 3'd7);
    loose: assert (count < 15);
  end
endmodule
`default_nettype wire
"""
GOOD = ("ffd_stream_count", "bound", "formal_count", "MOST=13", "pdr", "", "ffd_stream_count",
        "!= 4'd13", "!= 4'd12 || step_i", "The count is at most MOST.")


def row(**changes):
    return tuple({**dict(zip(proofs.COLUMNS, GOOD)), **changes}.values())


class Checkout(Workspace):
    def setUp(self):
        super().setUp()
        self.put("rtl/hwffd.f", "stream/ffd_stream_count.v\n")
        self.put("rtl/stream/ffd_stream_count.v", COUNTER)
        self.put("tests/formal/formal_count.v", HARNESS)
        self.table(GOOD)

    def table(self, *rows):
        text = io.StringIO()
        csv.writer(text, lineterminator="\n").writerows([proofs.COLUMNS, *rows])
        self.put("tests/formal/properties.csv", text.getvalue())

    def formal(self, *words):
        done = subprocess.run(
            [sys.executable, "-B", str(ROOT / "scripts" / "formal"), "--root", str(self.root),
             "-j1", "--limit", "10", *words], check=False, text=True, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE)
        return done.returncode, done.stdout.splitlines(), done.stderr.splitlines()

    def report(self):
        return json.loads((self.root / "build/reports/formal.json").read_text())["properties"]

    def refused(self, word):
        status, _, errors = self.formal()
        self.assertEqual((status, len(errors)), (1, 1), errors)
        self.assertIn(word, errors[0])


class Verdicts(Checkout):
    def test_proved_by_either_method_and_kept(self):
        self.table(GOOD, row(name="narrow", method="induction", mutant="!= 4'd13 || 1'b1"),
                   row(name="loose", lemmas="bound"))
        # Twelve clocks are too few to count to 14: this planted bug is not found by induction.
        status, lines, errors = self.formal()
        self.assertEqual((status, len(errors)), (1, 1), lines)
        self.assertIn("narrow: the planted bug is not found", errors[0])
        self.table(GOOD, row(name="narrow", method="induction", original="count_o <= 4'd0;",
                             mutant="count_o <= 4'd14;"), row(name="loose", lemmas="bound"))
        status, lines, errors = self.formal()
        self.assertEqual((status, errors), (0, []), lines)
        self.assertEqual([(one["name"], one["result"], one["negative_control"])
                          for one in self.report()],
                         [(name, "proved", "refuted") for name in ("bound", "narrow", "loose")])
        self.assertIn("3 of 3 properties", (self.root / "build/reports/formal.md").read_text())
        self.assertIn("formal: 3 properties, 3 of them unchanged", self.formal()[1])
        for name, text, unchanged in (
                ("rtl/stream/ffd_stream_count.v", COUNTER + "// a comment\n", 1),
                ("rtl/stream/ffd_stream_count.v", COUNTER + "`default_nettype wire\n", 0),
                ("tests/formal/formal_count.v", HARNESS + "`default_nettype wire\n", 0)):
            self.put(name, text)
            self.assertIn(f"formal: 1 properties, {unchanged} of them unchanged",
                          self.formal("--only", "*.bound")[1])
        left = {path.suffix for path in (self.root / "build/formal").iterdir()}
        self.assertEqual(left, {".said", ".seconds", ".log"})

    def test_wrong_property_is_refuted(self):
        self.table(row(parameters="MOST=12"))
        self.refused("ffd_stream_count, bound: refuted")
        self.assertEqual(self.report()[0]["result"], "refuted")
        self.assertEqual(self.report()[0]["broken_at_clock"], 14)

    def test_induction_does_not_prove_what_breaks_after_its_base(self):
        self.table(row(parameters="MOST=12", method="induction"))
        self.refused("ffd_stream_count, bound: undecided")

    def test_lemma_that_does_not_hold(self):
        self.table(row(name="narrow", parameters="MOST=12", lemmas="bound"),
                   row(parameters="MOST=12"))
        status, _, errors = self.formal()
        self.assertEqual((status, len(errors)), (1, 2), errors)
        self.assertIn("narrow: lemma bound is not proved", errors[0])

    def test_harmless_bug_is_not_found(self):
        self.table(row(mutant="!= 4'd12"))
        self.refused("the planted bug is not found (proved)")


class Refusals(Checkout):
    def test_planted_bugs(self):
        for change, word in (({"original": "!= 4'd7"}, "0 times in ffd_stream_count.v, not once"),
                             ({"original": "count_o"}, "5 times in ffd_stream_count.v, not once"),
                             ({"mutant": "!="}, "syntax error"),
                             ({"original": "count_o <= 4'd0", "mutant": "count_o <= none"},
                              "none")):
            with self.subTest(change):
                self.table(row(**change))
                self.refused(word)
                self.assertEqual(self.report()[0]["result"], "error")

    def test_harnesses(self):
        self.table(row(name="other"))
        self.refused("the harness has not exactly one assertion of this name")
        self.table(row(harness="formal_other"))
        self.refused("no harness tests/formal/formal_other.v")
        self.table(GOOD)
        self.put("tests/formal/formal_count.v", HARNESS.replace(
            "wire [3:0] count;", "wire [3:0] count;\n  (* hierconn *) wire \\u_dut.none_q ;"
        ).replace("count <= MOST", "\\u_dut.none_q "))
        self.refused("no driver")

    def test_tables(self):
        for rows, word in (
                ((GOOD[:-1],), "row 2: 9 columns, not 10"), ((GOOD, GOOD), "bound is there twice"),
                ((row(method="luck"),), "neither pdr nor induction"),
                ((row(mutant="!= 4'd13"),), "the planted bug changes nothing"),
                ((row(parameters="MOST=a"),), "are not NAME=NUMBER"),
                ((row(lemmas="bound"),), "lemma 'bound' is no property"),
                ((row(statement=""),), "no statement"),
                ((row(module="ffd_stream_other"),), "ffd_stream_other is not in rtl/hwffd.f")):
            with self.subTest(word):
                self.table(*rows)
                self.refused(word)
        self.put("tests/formal/properties.csv", "module,name\n")
        self.refused("the first line must be module,name,harness")
        self.table(GOOD)
        self.assertEqual(self.formal("--only", "x*")[0], 2)
        self.assertEqual(self.formal("--limit", "x")[0], 2)


class Table(unittest.TestCase):
    def test_rows_of_this_tree(self):
        found = proofs.read(ROOT / "tests/formal/properties.csv")
        self.assertGreater(len(found), 0)
        modules = rtl.Sources(ROOT)
        for one in found:
            with self.subTest(one.full_name):
                self.assertIn(one.module, modules.files)
                self.assertEqual(modules.files[one.file].read_text().count(one.original), 1)
                text = (ROOT / "tests/formal" / f"{one.harness}.v").read_text()
                label = one.name.split(".")[-1]
                shared = "".join(path.read_text()
                                 for path in (ROOT / "tests/formal").glob("properties_*.v"))
                self.assertRegex(text + shared, rf"\b{re.escape(label)}: assert")


if __name__ == "__main__":
    if not shutil.which("yosys-abc"):
        sys.exit("yosys-abc not found: run scripts/install")
    unittest.main(verbosity=2)
