"""Flips in hwffd_axi whose outcome is known.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

DMA = "u_core.u_dma"


@pytest.mark.parametrize("bit, outcome, recovered", (
    # The address of the next burst, behind its check; a window, which is locked; the next descriptor;
    # beats that a burst still has.
    (f"{DMA}.u_write.u_address.next_q[39]@189", "outside_window", "1"),
    ("u_core.write_first[44]@10", "flagged", "0"),
    (f"{DMA}.u_ring.tail_q[9]@818", "hang_cleared", "1"),
    (f"{DMA}.u_write.left_q[7]@784", "hang_stuck", "0")))
def test_a_planted_flip_is_what_it_is(campaign, bit, outcome, recovered):
    (line,) = campaign(only=(bit,)).lines
    assert (line["outcome"], line["recovered"], line["restarted"]) == (outcome, recovered, "1")


def test_the_same_seed_gives_the_same_flips(campaign):
    assert campaign(20, seed=3).lines == campaign(20, seed=3).lines
