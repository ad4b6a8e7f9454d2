"""The study, and a campaign on one of its cores.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib

import pytest

from lab.upsets import counted

ROW = "basic-fx18-overlapped"


@pytest.fixture
def campaign(arguments, tmp_path):
    """What a campaign writes: that of some flips, or of those that are named."""
    program, design = map(pathlib.Path, arguments)

    def run(number=0, kind="registers", seed=1, only=()):
        return counted.flips(counted.Run(program, ROW, design, kind, tmp_path / "flips.csv"), number, seed,
                             2, only)

    return run
