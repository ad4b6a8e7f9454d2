"""The structure of the tops: instances and area of a hierarchy, what is folded.

SPDX-License-Identifier: Apache-2.0
"""

import json
import sys

import pytest

from tools.reports import structure_tables
from tools.synth import hierarchy, structure



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
ROOT_NODE = hierarchy.Design(NETLIST, "hwffd_top").tree()
NODES = {node.module: node for _, node in ROOT_NODE.walk()}


@pytest.mark.parametrize("name", (
    "ffd_a_b", "$paramod$0f\\ffd_a_b", "$paramod\\ffd_a_b\\W=s32'1\\N=32'0"))
def test_module_names(name):
    assert hierarchy.module_of(name) == "ffd_a_b"


def test_counts_multiply_down_the_hierarchy():
    assert ROOT_NODE.counts["lut"] == 1 + 2 * 50 + 1 + (40 + 50)
    assert ROOT_NODE.counts["ff"] == 2 * (3 + 7) + 3
    assert ROOT_NODE.counts["dsp"] == 1
    middle = NODES["ffd_mid_a"]
    assert (middle.instances, middle.counts["lut"], middle.own()["lut"]) == (2, 100, 0)


def test_variants_of_a_module_are_one_node():
    assert [(child.module, child.instances, child.counts["lut"])
            for child in NODES["ffd_mid_b"].children] == [("ffd_leaf_wide", 2, 90)]


def test_the_small_is_folded():
    assert [(depth, node.module) for depth, node in ROOT_NODE.walk()] == [
        (0, "hwffd_top"), (1, "ffd_mid_a"), (2, "ffd_leaf_wide"), (1, "ffd_mid_b"),
        (2, "ffd_leaf_wide")]
    assert ROOT_NODE.own()["lut"] == 2


def test_a_row_of_the_table(checkout, monkeypatch):
    checkout.link("rtl", "synth")
    monkeypatch.setattr(structure_tables, "DESIGNS", (("ffd_org_select", "basic-fx18-overlapped", True),))
    monkeypatch.setattr(sys, "argv", ["structure", "--root", str(checkout.root), "-j", "1"])
    assert structure.main() == 0
    (design,) = json.loads(checkout.text("build/reports/structure.json"))["designs"]
    assert (design["top"], design["shown"]) == ("ffd_org_select", True)
    modules = {module["module"]: module for module in design["modules"]}
    for module, number in (("ffd_eval_poly", 3), ("ffd_num_step", 9)):
        assert modules[module]["instances"] == number
    assert modules["ffd_num_step"]["folder"] == "number"
    # What tools/synth/operators.py counts: nine steps, two products of weights, three terms.
    assert modules["ffd_org_select"]["dsp"] == 14


def test_a_fault_is_one_line(checkout):
    status, _, errors = checkout.module("tools.synth.structure", "--root", checkout.root)
    assert (status, errors.count("\n")) == (1, 1)
