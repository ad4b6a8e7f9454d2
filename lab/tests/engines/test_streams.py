"""The recorded commands in every engine, and a fault in the sources.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from lab.engines import planted, streams

FEW = 600  # beats


@pytest.mark.parametrize("engine", streams.PROGRAMS)
def test_programs_answer_all_commands_as_the_model(programs, recording, engine):
    stream = recording()
    assert len(stream.wanted.results) > 400
    assert streams.simulate(programs, engine, stream)[0] == 0


def test_icarus_answers_all_commands_as_the_model_and_knows_every_bit(recording):
    mismatches, unknowns = streams.simulate_with_x(recording())
    assert (mismatches, unknowns.names) == (0, ())
    assert unknowns.clocks > 10_000 and unknowns.checked > 400


def test_a_wrong_bit_of_each_coefficient_is_found(recording):
    mismatches, unknowns = streams.simulate_with_x(recording(FEW), (planted.COEFFICIENT,))
    assert mismatches > 0 and not unknowns.names
