"""Flips in a hardened hwffd_axi whose outcome is known: those that a plain one writes outside of its
window or hangs for good by (test_axi.py), and one in a copy.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

DMA = "u_core.u_dma"


@pytest.mark.parametrize("bit, outcome", (
    # The address of the next burst, behind its check; how many bursts have been sent; a copy of the
    # window.
    (f"{DMA}.u_write.u_address.next_q[45]@400", "flagged"),
    (f"{DMA}.u_write.u_outstanding.write_q[3]@1308", "hang_cleared"),
    (f"{DMA}.u_guard.gen_guard.u_write.other[66]@400", "no_effect")))
def test_a_planted_flip_is_what_it_is(campaign, bit, outcome):
    (line,) = campaign(only=(bit,)).lines
    assert (line["outcome"], line["recovered"], line["outside_read"]) == (outcome, "1", "0")
