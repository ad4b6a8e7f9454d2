"""The recorded commands of twenty rows through Icarus Verilog: the answers of the bit-true model, and so
those of Verilator, whose hashes tests/recorded has of the same rows.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

import configurations
import streams

ROWS = (
    "basic-fp32-paper", "cg3-fp32-overlapped", "tree4-fp32-paper-fmac", "basic-fp32-overlapped-bspline",
    "cg1-fx18-paper", "cg2-fx18-overlapped", "tree2-fx18-paper", "tree8-fx18-overlapped",
    "parallel-fx18-overlapped", "basic-fx18-overlapped-iterative", "factored-fx18-overlapped",
    "factored-fx18-overlapped-powers", "jet3-fx18-overlapped", "nested3-fx18-overlapped",
    "cg1-fx32-overlapped", "affine3x2-fx17-overlapped", "scan4-fx17-overlapped",
    "affine64-fx17-overlapped", "jacobian3-fx17-overlapped", "basic-bfp32-overlapped")


@pytest.mark.parametrize("name", ROWS)
def test_icarus_answers_as_the_model(programs, tmp_path, name):
    row = configurations.find(configurations.read(), name)
    stream = streams.prepare(programs, row, tmp_path)
    assert len(stream.wanted.results) > 400
    mismatches, found = streams.simulate_with_x(stream)
    assert (mismatches, found.names) == (0, ())
