"""X in Icarus: the core behind its buses, and a register that nothing resets.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from lab.engines import icarus, planted, streams

FEW = 600  # beats
BITS = {streams.simulate_in_memory: 2000, streams.simulate_with_x: 400}


def test_in_a_system_every_bit_is_known(recording):
    mismatches, unknowns = streams.simulate_in_memory(recording(FEW))
    assert (mismatches, unknowns.names) == (0, ())
    assert unknowns.clocks > 1000 and unknowns.checked > BITS[streams.simulate_in_memory]


def test_what_has_ended_is_not_run_again(recording, monkeypatch):
    first = streams.simulate_with_x(recording(FEW))
    run = []
    real = icarus.command
    monkeypatch.setattr(icarus, "command", lambda line, *more: run.append(line[0]) or real(line, *more))
    assert streams.simulate_with_x(recording(FEW)) == first
    assert "vvp" not in run
    changed = streams.simulate_with_x(recording(FEW), (planted.COEFFICIENT,))
    assert "vvp" in run and changed[0] > 0


@pytest.mark.parametrize("simulate", BITS)
def test_a_register_without_reset_is_found(recording, simulate):
    unknowns = simulate(recording(FEW), (planted.RESET,))[1]
    assert any("used_q" in name for name in unknowns.names)
