"""Gradients pulled back from places of a lattice, or from a grid, to its control points.

SPDX-License-Identifier: Apache-2.0
"""

import hwffd
import numpy as np
import pytest

RANDOM = np.random.default_rng(5)


@pytest.fixture(params=hwffd.families())
def lattice(request):
    lattice = hwffd.Lattice.around("box", [[-1, -1, -1], [1, 2, 3]], (7, 4, 10), family=request.param)
    lattice.deform("random:2")
    return lattice


def evaluated(lattice, places):
    cells = np.minimum(places.astype(int), np.array(lattice.cells) - 1)
    return lattice.evaluate(cells, places - cells)


@pytest.mark.parametrize("device, limit", [("reference", 1e-10), ("model", 5e-2), ("rtl", 5e-2), (None, 1e-10)])
def test_it_is_the_transpose_of_evaluation(lattice, device, limit):
    places = RANDOM.uniform(0, 1, (200, 3)) * lattice.cells
    places[:2] = (0, 0, 0), lattice.cells
    gradient = RANDOM.uniform(-1, 1, (200, 3))
    pulled = lattice.pull_back(places, gradient, device=device)
    assert pulled.shape == lattice.control_points.shape
    forward = (evaluated(lattice, places) * gradient).sum()
    assert (lattice.control_points * pulled).sum() == pytest.approx(forward, abs=limit)
    shaped = lattice.pull_back(places.reshape(20, 10, 3), gradient.reshape(20, 10, 3), device=device)
    np.testing.assert_array_equal(shaped, pulled)
    order = RANDOM.permutation(200)
    np.testing.assert_array_equal(lattice.pull_back(places[order], gradient[order], device=device), pulled)


@pytest.mark.parametrize("device", ["reference", "model"])
def test_a_grid_has_the_bits_of_its_places(lattice, device):
    counts = (5, 3, 9)
    ends = np.array(lattice.cells, float)
    gradient = RANDOM.uniform(-1, 1, (*counts[::-1], 3)).astype(np.float32)
    pulled = lattice.pull_back(((0, 0, 0), tuple(ends), counts), gradient, device=device)
    axes = [np.linspace(0, end, count) for end, count in zip(ends, counts)]
    u, t, s = np.meshgrid(*axes[::-1], indexing="ij")
    places = np.stack([s, t, u], -1)
    if (ends * 2**20 % (np.array(counts) - 1) == 0).all():  # such places have 24 bits
        np.testing.assert_array_equal(lattice.pull_back(places, gradient, device=device), pulled)
    np.testing.assert_allclose(lattice.pull_back(places, gradient, device=device), pulled, atol=2e-3)


def test_the_model_conserves_gradients_and_needs_no_affine_lattice():
    lattice = hwffd.Lattice.around("box", [[0, 0, 0], [1, 1, 1]], (5, 6, 7))
    gradient = RANDOM.integers(-2**15, 2**15, (1000, 3)) / 2**15
    places = RANDOM.uniform(0, 1, (1000, 3)) * lattice.cells
    pulled = lattice.pull_back(places, gradient, device="model")
    np.testing.assert_array_equal(pulled.sum(axis=(0, 1, 2)), gradient.sum(axis=0))
    lattice.set_device("model", "affine", "fx17")
    np.testing.assert_array_equal(lattice.pull_back(places, gradient), pulled)
    np.testing.assert_array_equal(lattice.pull_back(places, gradient, device="rtl"), pulled)


def test_threads_change_no_bit():
    lattice = hwffd.Lattice.around("box", [[0, 0, 0], [1, 1, 1]], (5, 6, 7))
    places = RANDOM.uniform(0, 1, (40000, 3)) * lattice.cells
    gradient = RANDOM.normal(size=(40000, 3))
    for device in "reference", "model":
        results = []
        for threads in 1, 2, 5:
            hwffd.set_threads(threads)
            results.append(lattice.pull_back(places, gradient, device=device))
        hwffd.set_threads(0)
        for result in results[1:]:
            np.testing.assert_array_equal(result, results[0])


def test_what_is_refused():
    lattice = hwffd.Lattice.around("box", [[0, 0, 0], [1, 1, 1]], (4, 5, 6))
    one = [[0.5, 0.5, 0.5]]
    for places, gradient, device, text in (
            (one, [[1, 2, 3]] * 2, None, "^gradient: 2 rows; give 1, one for each point$"),
            (one, [[1, np.inf, 3]], None, "^gradient 0"),
            ([[0.5, 2.5, 0.5]], one, None, r"^places: row 0 is not in the lattice; give 0 to \(1, 2, 3\), in cells$"),
            ([[0.5, np.nan, 0.5]], one, None, "^places: row 0 is not in the lattice"),
            ((1, 2), one, None, r"^places: a tuple of 2; give an array \(..., 3\), or \(first, last, counts\)"),
            (((0, 0, 0), (1, 2, 4), (1, 1, 2)), one * 2, None, "not within the 1 x 2 x 3 cells"),
            (((0, 0, 0), (1, 2, 3), (2, 2, 2)), one, None, "^gradient: 1 rows; give 8, one for each point$"),
            (one, one, "fpga", "^device 'fpga' is unknown"),
            (one, one, "", "^device: ''; give model, rtl or reference$"),
            (one, one, 3, "^pull_back: arguments")):
        with pytest.raises(hwffd.Error, match=text) as caught:
            lattice.pull_back(places, gradient, device=device)
        assert "\n" not in str(caught.value)
    lattice.set_device("model")
    with pytest.raises(hwffd.Error, match="^model basic-fp32-overlapped: has no transpose; take organization affine"):
        lattice.pull_back(one, one)
