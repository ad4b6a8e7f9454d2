"""The study, and recorded commands for its tests.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib

import pytest

from lab.engines import streams
from tools.tables import configurations

ROW = "basic-fx18-overlapped"


@pytest.fixture
def programs(arguments):
    return pathlib.Path(arguments[0])


@pytest.fixture
def recording(programs, tmp_path):
    """Its beginning, as many beats as are asked for; all of it where no number is given."""
    row = configurations.find(configurations.read(), ROW)
    return lambda beats=None: streams.prepare(programs, row, tmp_path / "recording", beats)
