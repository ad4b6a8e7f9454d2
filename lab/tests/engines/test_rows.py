"""The beginning of the recorded commands in seventeen rows through Icarus Verilog: the answers of the
bit-true model, and so those of Verilator, whose hashes tests/recorded has of the same rows. Inside the
evaluators of some rows a flag that nobody looks at is X while no vertex is there.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from lab.engines import streams
from tools.tables import configurations

FEW = 600  # beats
ROWS = (
    "basic-fp32-overlapped", "cg3-fp32-overlapped", "basic-fx18-paper", "cg1-fx18-paper", "cg1-fx18-overlapped",
    "cg3-fx18-overlapped", "tree2-fx18-paper", "tree4-fx18-overlapped", "tree8-fx18-overlapped",
    "basic-fx18-overlapped-iterative", "factored3-fx18-overlapped", "affine3-fx17-overlapped-powers",
    "basic-fx32-overlapped", "cg1-fx32-overlapped",
    "walk-fx17-overlapped", "affine64-fx17-overlapped", "basic-bfp32-overlapped")


@pytest.mark.parametrize("name", ROWS)
def test_icarus_answers_as_the_model(programs, tmp_path, name):
    row = configurations.find(configurations.read(), name)
    stream = streams.prepare(programs, row, tmp_path, FEW)
    assert len(stream.wanted.results) > 10
    mismatches, unknowns = streams.simulate_with_x(stream)
    assert mismatches == 0
    assert not [name for name in unknowns.names if "u_evaluator" not in name]
