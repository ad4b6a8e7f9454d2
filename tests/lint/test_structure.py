"""The structure of the tops: instances and area of a hierarchy, what is folded.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from unittest import mock

from workspace import ROOT

import hierarchy

LOADER = SourceFileLoader("structure", str(ROOT / "scripts" / "structure"))
structure = module_from_spec(spec_from_loader("structure", LOADER))
LOADER.exec_module(structure)


def cells(**numbers):
    """{name: cell} of a module with so many cells of each type."""
    return {"cells": {f"{kind}{i}": {"type": kind.replace("__", "\\")}
                      for kind, number in numbers.items() for i in range(number)}}


# 200 LUTs: 1 of the top's own, 2 x 60 + 40 in leaves with two widths, 39 in one, none in another.
NETLIST = {"modules": {
    "hwffd_top": cells(LUT4=1, ffd_mid_a=2, ffd_leaf_small=1, ffd_mid_b=1, ffd_leaf_free=1),
    "ffd_mid_a": {"cells": {"l": {"type": "$paramod$12\\ffd_leaf_wide"}, "m": {"type": "ffd_x_y"}}},
    "ffd_mid_b": {"cells": {"l": {"type": "$paramod\\ffd_leaf_wide\\W=s32'0"},
                            "k": {"type": "$paramod$12\\ffd_leaf_wide"}}},
    "$paramod$12\\ffd_leaf_wide": cells(LUT4=50, TRELLIS_FF=3),
    "$paramod\\ffd_leaf_wide\\W=s32'0": cells(CCU2C=10, TRELLIS_DPR16X4=5, MULT18X18D=1),
    "ffd_leaf_small": cells(LUT4=1),
    "ffd_x_y": cells(LUT4=0, TRELLIS_FF=7),
    "ffd_leaf_free": cells(),
}}


class Tree(unittest.TestCase):
    def setUp(self):
        self.root = hierarchy.Design(NETLIST, "hwffd_top").tree()
        self.nodes = {node.module: (depth, node) for depth, node in self.root.walk()}

    def test_module_names(self):
        for name in ("ffd_a_b", "$paramod$0f\\ffd_a_b", "$paramod\\ffd_a_b\\W=s32'1\\N=32'0"):
            self.assertEqual(hierarchy.module_of(name), "ffd_a_b")

    def test_counts_multiply_down_the_hierarchy(self):
        self.assertEqual(self.root.counts["lut"], 1 + 2 * 50 + 1 + (40 + 50))
        self.assertEqual(self.root.counts["ff"], 2 * (3 + 7) + 3)
        self.assertEqual(self.root.counts["dsp"], 1)
        _, middle = self.nodes["ffd_mid_a"]
        self.assertEqual((middle.instances, middle.counts["lut"], middle.own()["lut"]), (2, 100, 0))

    def test_variants_of_a_module_are_one_node(self):
        _, middle = self.nodes["ffd_mid_b"]
        self.assertEqual([(child.module, child.instances, child.counts["lut"])
                          for child in middle.children], [("ffd_leaf_wide", 2, 90)])

    def test_the_small_is_folded(self):
        self.assertEqual([(depth, node.module) for depth, node in self.root.walk()],
                         [(0, "hwffd_top"), (1, "ffd_mid_a"), (2, "ffd_leaf_wide"),
                          (1, "ffd_mid_b"), (2, "ffd_leaf_wide")])
        self.assertEqual(self.root.own()["lut"], 2)


class Measured(unittest.TestCase):
    def test_a_row_of_the_table(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in ("rtl", "synth"):
                (root / name).symlink_to(ROOT / name)
            designs = (("ffd_org_select", "basic-fx18-overlapped", True),)
            with mock.patch.object(structure, "DESIGNS", designs), \
                    mock.patch.object(sys, "argv", ["structure", "--root", folder, "-j", "1"]):
                self.assertEqual(structure.main(), 0)
            report = json.loads((root / "build/reports/structure.json").read_text())
        (design,) = report["designs"]
        self.assertEqual((design["top"], design["shown"]), ("ffd_org_select", True))
        modules = {module["module"]: module for module in design["modules"]}
        for module, number in (("ffd_eval_poly", 3), ("ffd_num_step", 9)):
            self.assertEqual(modules[module]["instances"], number)
        self.assertEqual(modules["ffd_num_step"]["folder"], "number")
        # What scripts/operators.py counts: nine steps, two products of weights, three terms.
        self.assertEqual(modules["ffd_org_select"]["dsp"], 14)

    def test_a_fault_is_one_line(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                [sys.executable, "-B", ROOT / "scripts" / "structure", "--root", folder],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
