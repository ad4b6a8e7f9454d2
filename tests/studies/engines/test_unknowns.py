"""X in Icarus: the core behind its buses, and a register that nothing resets.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

import planted
import streams

FEW = 600  # beats
BITS = {streams.simulate_in_memory: 2000, streams.simulate_with_x: 400}


def test_in_a_system_every_bit_is_known(recording):
    mismatches, found = streams.simulate_in_memory(recording(FEW))
    assert (mismatches, found.names) == (0, ())
    assert found.clocks > 1000 and found.checked > BITS[streams.simulate_in_memory]


@pytest.mark.parametrize("simulate", BITS)
def test_a_register_without_reset_is_found(recording, simulate):
    found = simulate(recording(FEW), (planted.RESET,))[1]
    assert any("used_q" in name for name in found.names)
