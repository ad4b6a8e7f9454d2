"""X in gates, which hand it on.

SPDX-License-Identifier: Apache-2.0
"""

from lab.engines import planted, streams


def test_no_x_comes_out_of_gates(recording):
    mismatches, unknowns = streams.simulate_gates(recording())
    assert (mismatches, unknowns.names) == (0, ()) and unknowns.clocks > 10_000


def test_x_of_a_register_without_reset_comes_out(recording):
    unknowns = streams.simulate_gates(recording(600), (planted.RESET,))[1]
    assert any("tready" in name for name in unknowns.names)
