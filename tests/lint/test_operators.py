#!/usr/bin/env python3
"""Counting of operators: the text of yosys' statistics, and known organizations.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from workspace import ROOT

import operators

STATISTICS = """
=== $paramod$00\\ffd_eval_poly ===

   Number of cells:                  3
     $add                            1
     $paramod$11\\ffd_num_step        3

=== $paramod$11\\ffd_num_step ===

   Number of cells:                  1
     $paramod$22\\ffd_fx_product      1

=== $paramod$22\\ffd_fx_product ===

=== ffd_org_select ===

     $paramod$00\\ffd_eval_poly       4
     ffd_num_add                     2

=== ffd_num_add ===

=== design hierarchy ===

   ffd_org_select                    1
     $paramod$00\\ffd_eval_poly       4
"""


class Operators(unittest.TestCase):
    def test_instances_multiply_down_the_hierarchy(self):
        design = operators.Design(STATISTICS, fused=False)
        self.assertEqual(design.instances("ffd_org_select")["ffd_num_step"], 12)
        self.assertEqual(dict(design.operators("ffd_org_select")), {"mul": 12, "add": 14})

    def test_a_fused_step_is_one_operator(self):
        design = operators.Design(STATISTICS, fused=True)
        self.assertEqual(dict(design.operators("ffd_org_select")), {"fma": 12, "add": 2})

    def count(self, *selection):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "operators.json"
            done = subprocess.run(
                [sys.executable, "-B", ROOT / "scripts" / "operators.py", out, *selection],
                capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            return json.loads(out.read_text())

    def test_basic_is_drawn_as_built(self):
        row = self.count("--org", "basic", "--format", "fx18")["basic-fx18-paper"]
        # Three evaluators of a multiplier and an adder each, B B B P, three accumulators.
        self.assertEqual(row["operators"], {"mul": 8, "add": 6, "fma": 0})
        self.assertEqual(row["drawn"], row["operators"])
        self.assertEqual(row["evaluators"], 3)

    def test_units_share_what_is_drawn_apart(self):
        row = self.count("--org", "parallel", "--format", "fx18")["parallel-fx18-paper"]
        # As drawn, 64 units of (3 x 1 + 2 + 3) multipliers; trees of 63 adders a component.
        self.assertEqual(row["drawn"], {"mul": 64 * 8, "add": 64 * 3 + 3 * 63, "fma": 0})
        # As built, 12 evaluators, 16 + 64 weight products, 192 terms.
        self.assertEqual(row["operators"], {"mul": 12 + 16 + 64 + 192, "add": 12 + 189, "fma": 0})

    def test_one_axis_at_a_time(self):
        row = self.count("--org", "factored", "--format", "fx18")["factored-fx18-overlapped"]
        # 12 evaluators of three steps; 64 + 16 + 4 products and 48 + 12 + 3 additions a component.
        self.assertEqual(row["operators"], {"mul": 36 + 3 * 84, "add": 36 + 3 * 63, "fma": 0})
        self.assertEqual((row["drawn"], row["evaluators"]), (row["operators"], 12))
        folded = self.count("--org", "factored/3", "--format", "fx18")["factored3-fx18-overlapped"]
        self.assertEqual(folded["operators"], {"mul": 12 + 84, "add": 12 + 63, "fma": 0})
        self.assertEqual((folded["drawn"], folded["evaluators"]), (folded["operators"], 4))

    def test_nested(self):
        row = self.count("--org", "nested", "--format", "fx18")["nested-fx18-overlapped"]
        # 63 steps a component; the former's 4 products and 3 additions a component; 3 centred.
        self.assertEqual(row["operators"], {"mul": 3 * 67, "add": 3 * 67, "fma": 0})
        self.assertEqual((row["drawn"], row["evaluators"]), (row["operators"], 0))
        folded = self.count("--org", "nested/3", "--format", "fx18")["nested3-fx18-overlapped"]
        self.assertEqual(folded["operators"], {"mul": 63 + 12, "add": 63 + 12, "fma": 0})

    def test_unknown_rows_are_one_line(self):
        done = subprocess.run(
            [sys.executable, "-B", ROOT / "scripts" / "operators.py", "unused", "--org", "none"],
            capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"^operators.py: ORG=none: unknown here: one of basic, .*\n$")


if __name__ == "__main__":
    unittest.main(verbosity=2)
