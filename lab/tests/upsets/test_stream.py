"""A short campaign on hwffd_stream, and flips whose outcome is known.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from lab.upsets import counted

FLIPS = 50


def test_the_same_seed_gives_the_same_counts(campaign):
    first, second, other = (campaign(FLIPS, seed=seed).lines for seed in (3, 3, 4))
    assert first == second != other
    row = counted.row(first)
    assert row["flips"] == FLIPS and 0 < row["no_effect"] < FLIPS
    assert row["restart_does_not_help"] == 0


def test_memories_are_struck_too(campaign):
    lines = campaign(FLIPS, kind="memories").lines
    assert len(lines) == FLIPS and {line["outcome"] for line in lines} > {"no_effect"}


@pytest.mark.parametrize("bit, outcome", (
    # The count of vertices inside, which never comes back to 0; how many vertices a packet still has; a
    # coordinate, while it is a vertex's and while it is nobody's.
    ("u_evaluator.inside_q[3]@400", "hang_cleared"),
    ("u_ingress.u_framer.count_q[27]@421", "flagged"),
    ("u_decoder.u_vertex.coordinates_q[8]@372", "silent"),
    ("u_decoder.u_vertex.coordinates_q[8]@0", "no_effect")))
def test_a_planted_flip_is_what_it_is(campaign, bit, outcome):
    lines = campaign(only=(bit,)).lines
    assert [line["outcome"] for line in lines] == [outcome]


def test_what_cannot_be_flipped_is_an_error(campaign):
    with pytest.raises(counted.UpsetError, match="no such bit"):
        campaign(only=("u_ingress.nothing_q@3",))
    with pytest.raises(counted.UpsetError, match="0 flips"):
        campaign(0)
    with pytest.raises(counted.UpsetError, match="was not made"):
        campaign(only=("u_evaluator.inside_q[0]@99999999",))
