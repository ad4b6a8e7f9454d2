"""Every program that is installed aligns a small pair, and its field is that of the fixed volume.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from lab.align import measures, pairs, programs, run


@pytest.mark.parametrize("program", programs.PROGRAMS, ids=lambda program: program.name)
def test_it_comes_nearer_to_the_truth(program, tmp_path):
    pair = pairs.phantom_pair(24)
    still = 0 * pair.truth
    row, field = run.start(program, programs.Job(pair.fixed, pair.moving, 6, 2, 8, 1, 60.0, tmp_path), {0})
    if field is None:
        pytest.skip(row["absent"])
    assert field.shape == (24, 24, 24, 3)
    assert measures.error(field, pair) < 0.75 * measures.error(still, pair)
    assert measures.overlap(field, pair) > measures.overlap(still, pair)
    assert row["evaluations"] >= 8 and row["voxel_evaluations"] > 8 * 1000 and row["seconds"] > 0 and row["peak_mb"] > 10
