"""The clocks of synth.json, and the vertices a second that come of them.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from tools.project_root import ROOT
from tools.synth import nextpnr, synth_report, synthesis
from tools.tables import configurations

CLOCK = {"fmax_mhz": 90.0, "fmax_share": 0.6, "routed": True, "seeds": []}


class Place:
    """Stands for what has been routed: all, at one clock, or nothing."""

    def __init__(self, clock):
        self.clock = lambda _: clock


def clock(name, target, routed=None):
    row = configurations.find(configurations.read(), name)
    subject = synthesis.Subject(row, synthesis.CORE, target)
    return synth_report.clock(Place(routed), subject, {"fmax_mhz": 12.5})


@pytest.mark.parametrize("name, clocks", (
    ("basic-fx18-overlapped", 64), ("basic-fx18-overlapped-iterative", 192),
    ("factored3-fx18-overlapped", 3), ("affine3x2-fx17-overlapped", 1.5),
    ("affine-fx17-overlapped", 1), ("tree8-fx18-overlapped", 8)))
def test_vertices_a_second_are_the_clock_by_the_clocks_of_a_vertex(name, clocks):
    rate = round(90e6 / clocks)
    assert clock(name, "ecp5", CLOCK) == {**CLOCK, "vertices_per_s": rate, "row_vertices_per_s": rate}


@pytest.mark.parametrize("name, top, any_order, rows", (
    ("walk-fx17-overlapped+grids", synthesis.CORE, 16, 1), ("walk2-fx17-overlapped+pairs", synthesis.CORE, 16, 0.5),
    ("walk-fx17-overlapped-powers+adjoint", synthesis.ADJOINT, 16, 1),
    ("affine-fx17-overlapped+scatter", synthesis.SCATTER, 3, 3),
    ("affine-fx17-overlapped-powers+rows", synthesis.SCATTER, 12, 1)))
def test_rows_of_grids_may_be_faster(name, top, any_order, rows):
    (subject,) = (one for one in synthesis.of_checkout(ROOT) if one.row.name == name and one.top == top)
    found = synth_report.clock(Place(CLOCK), subject, {})
    assert (found["vertices_per_s"], found["row_vertices_per_s"]) == (round(90e6 / any_order), round(90e6 / rows))


@pytest.mark.parametrize("target", ("gowin", "gw5a"))
def test_what_the_router_does_not_know_stands_beside_the_clock(target):
    assert clock("affine-fx17-overlapped", target, CLOCK) == {
        **CLOCK, "vertices_per_s": 90_000_000, "row_vertices_per_s": 90_000_000, "remark": "multiplier delays not modelled"}


def test_what_is_not_routed_has_none():
    assert clock("cg1-fx18-overlapped", "ecp5") == {
        "fmax_mhz": 12.5, "fmax_share": None, "routed": False, "seeds": [], "vertices_per_s": None,
        "row_vertices_per_s": None}


@pytest.mark.parametrize("cell, place", (
    ("u_a.gen_x[0].u_b.sum_q_TRELLIS_FF_Q_3", "u_a.u_b.sum_q"),
    ("$flatten\\u_chain.\\u_block.$auto$ff.cc:266:slice$11605", "u_block"),
    ("u_chain.u_block.gen_y.u_memory.memory_q.0.0$full", "u_block.u_memory.memory_q")))
def test_ends_of_paths_are_named_as_in_the_sources(cell, place):
    assert nextpnr._place(cell) == place
