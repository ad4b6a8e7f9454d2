"""What calls take beyond their results: float32 no more than float64, and no copy of weights for SciPy.

SPDX-License-Identifier: Apache-2.0
"""

import subprocess
import sys

import hwffd
import numpy as np
import pytest

CORNERS = np.array([[-1.0, -1, -1], [1, 1, 1]])
COUNT = 2_000_000
SCENE = """
import resource, sys, time
import hwffd
import numpy as np
count, number = int(sys.argv[1]), np.dtype(sys.argv[2])
lattice = hwffd.Lattice.around("box", [[-1, -1, -1], [1, 1, 1]])
lattice.set_device("reference")
lattice.deform("twist:40")
points = np.random.default_rng(1).random((count, 3), dtype=number)
"""
MEMORY = SCENE + """
hwffd.deform(lattice, points[:100_000])
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
moved = hwffd.deform(lattice, points)
print(moved.nbytes, 1024 * (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before))
"""
TIME = SCENE + """
kinds = [points.astype(np.float32), points]
seconds = [[], []]
for _ in range(9):
    for kind, taken in zip(kinds, seconds):
        start = time.process_time()
        hwffd.deform(lattice, kind)
        taken.append(time.process_time() - start)
print(*map(min, seconds))
"""
PARTS = 16 << 20  # what the threads have in double at a time


def measured(program, number="float64"):
    result = subprocess.run([sys.executable, "-B", "-c", program, str(COUNT), number], text=True, check=True,
                            capture_output=True)
    return map(float, result.stdout.split())


@pytest.mark.parametrize("number, size", [("float32", 4), ("float64", 8)])
def test_deform_takes_no_more_than_its_results(number, size):
    results, more = measured(MEMORY, number)
    assert results == COUNT * 3 * size
    assert results * 0.5 < more < results + PARTS


def test_float32_takes_no_longer_than_float64():
    seconds, at_most = measured(TIME)
    assert seconds < 1.2 * at_most  # of processor time, on a machine that does other things


def test_floats_are_rounded_where_doubles_are_exact():
    """Parts, and what is no float32 in the memory of the caller."""
    lattice = hwffd.Lattice.around("sphere", CORNERS)
    lattice.set_device("reference")
    lattice.deform("twist:40")
    points = np.random.default_rng(1).uniform(-0.5, 0.5, (30_000, 3)).astype(np.float32)
    moved = hwffd.deform(lattice, points.astype(float)).astype(np.float32)
    wide = np.zeros((30_000, 8), np.float32)
    wide[:, 1:7:2] = points
    for same in points, points.astype(">f4"), np.asfortranarray(points), wide[:, 1:7:2]:
        np.testing.assert_array_equal(hwffd.deform(lattice, same), moved)
    points[20_000] = np.nan
    with pytest.raises(hwffd.Error, match="^point 20000 is not finite"):
        hwffd.deform(lattice, points)
    out = np.full((30_000, 3), 7, np.float32)
    points = points.astype(float)
    points[20_000] = 1e39
    with pytest.raises(hwffd.Error, match="^point 20000 is beyond what float32 holds"):
        hwffd.deform(lattice, points, out=out)
    assert (out == 7).all()


def test_scipy_keeps_the_arrays_of_weights():
    lattice = hwffd.Lattice.around("box", CORNERS)
    embedding = lattice.embed(np.random.default_rng(1).uniform(-1, 1, (50, 3)))
    weights = embedding.weights()
    assert weights.indices.dtype == weights.indptr.dtype == np.int32
    for array in weights.data, weights.indices, weights.indptr:
        assert array.base is not None and not array.flags.owndata  # what the library has made, not a copy
    assert [array.dtype for array in embedding.csr()] == [np.float64, np.int32, np.int32]
