"""Counting of operators: the text of yosys' statistics, and known organizations.

SPDX-License-Identifier: Apache-2.0
"""

import json
import re

from tools.synth import operators

import pytest

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


def test_instances_multiply_down_the_hierarchy():
    design = operators.Design(STATISTICS, fused=False)
    assert design.instances("ffd_org_select")["ffd_num_step"] == 12
    assert design.operators("ffd_org_select") == {"mul": 12, "add": 14}


def test_a_fused_step_is_one_operator():
    design = operators.Design(STATISTICS, fused=True)
    assert design.operators("ffd_org_select") == {"fma": 12, "add": 2}


# organization, row, (multipliers, adders) as built, as drawn, evaluators
COUNTED = (
    # Three evaluators of a multiplier and an adder each, B B B P, three accumulators.
    ("basic", "basic-fx18-paper", (8, 6), (8, 6), 3),
    # As built, 12 evaluators, 16 + 64 weight products, 192 terms; as drawn, 64 units of
    # (3 x 1 + 2 + 3) multipliers; trees of 63 adders a component.
    ("parallel", "parallel-fx18-paper", (12 + 16 + 64 + 192, 12 + 189), (64 * 8, 64 * 3 + 3 * 63),
     12),
    # 12 evaluators of three steps; 64 + 16 + 4 products and 48 + 12 + 3 additions a component.
    ("factored", "factored-fx18-overlapped", (36 + 3 * 84, 36 + 3 * 63),
     (36 + 3 * 84, 36 + 3 * 63), 12),
    ("factored/3", "factored3-fx18-overlapped", (12 + 84, 12 + 63), (12 + 84, 12 + 63), 4),
    # Nine evaluators; 48 + 12 + 3 products, and of differences and sums each as many additions.
    ("affine", "affine-fx17-overlapped", (27 + 3 * 63, 27 + 3 * 2 * 63),
     (27 + 3 * 63, 27 + 3 * 2 * 63), 9),
    ("affine/3", "affine3-fx17-overlapped", (9 + 63, 9 + 2 * 63), (9 + 63, 9 + 2 * 63), 3),
    ("affine/3x2", "affine3x2-fx17-overlapped", (2 * 72, 2 * (9 + 2 * 63)),
     (2 * 72, 2 * (9 + 2 * 63)), 6),
    # Half of the products along u and t, two along s; the nine evaluators of an unfolded one.
    ("affine/2", "affine2-fx17-overlapped", (27 + 3 * 32, 27 + 3 * 64), (27 + 3 * 32, 27 + 3 * 64), 9),
    ("affine/6", "affine6-fx17-overlapped", (9 + 32, 9 + 64), (9 + 32, 9 + 64), 3),
    # A quarter of the products along u and t, one along s; the weights as folded by three.
    ("affine/4", "affine4-fx17-overlapped", (9 + 3 * 16, 9 + 3 * 2 * 16 + 3),
     (9 + 3 * 16, 9 + 3 * 2 * 16 + 3), 3),
    # Three evaluators for u and t and three for s; three products along u and s, one along t, and of
    # differences and sums each as many additions, along t one more of each.
    ("walk", "walk-fx17-overlapped", (18 + 3 * 7, 18 + 3 * 15), (18 + 3 * 7, 18 + 3 * 15), 6),
    # Three evaluators of s more, and another contraction along it.
    ("walk/2", "walk2-fx17-overlapped", (27 + 3 * 10, 27 + 3 * 21), (27 + 3 * 10, 27 + 3 * 21), 9),
    ("affine/4x3", "affine4x3-fx17-overlapped", (3 * 57, 3 * 108), (3 * 57, 3 * 108), 9),
    # Three evaluators of the functions, three of their derivatives; sums of four of 2 x 16 along u,
    # 3 x 4 along t, 4 along s, and differences for 16, 2 x 4 and 3 of them.
    ("jacobian/3", "jacobian3-fx17-overlapped", (18 + 3 * 48, 18 + 3 * 27 + 3 * 48),
     (18 + 3 * 48, 18 + 3 * 27 + 3 * 48), 6),
    # The same with four products and no differences, and four evaluators of each kind.
    ("jet/3", "jet3-fx18-overlapped", (24 + 4 * 48, 24 + 3 * 48), (24 + 4 * 48, 24 + 3 * 48), 8),
    # A polynomial evaluator; a product a component, which every unit above shares.
    ("affine/64", "affine64-fx17-overlapped", (1 + 3, 1 + 2 * 3), (1 + 3, 1 + 2 * 3), 1),
)


# One of each form in make test-synth; test-all counts every organization.
FEW = ("basic", "factored/3", "walk", "jet/3")


@pytest.mark.parametrize("org, name, built, drawn, evaluators", [row if row[0] in FEW else pytest.param(
    *row, marks=pytest.mark.whole) for row in COUNTED])
def test_known_organizations(checkout, org, name, built, drawn, evaluators):
    status, _, errors = checkout.module("tools.synth.operators", "out", "--org", org, "--format", name.split("-")[1])
    assert (status, errors) == (0, "")
    assert json.loads(checkout.text("out"))[name] == {
        "operators": dict(zip(operators.KINDS, (*built, 0))),
        "drawn": dict(zip(operators.KINDS, (*drawn, 0))), "evaluators": evaluators}


def test_unknown_rows_are_one_line(checkout):
    status, _, errors = checkout.module("tools.synth.operators", "unused", "--org", "none")
    assert status == 1
    assert re.search(r"^operators: ORG=none: unknown here: one of basic, .*\n$", errors)
