"""Embeddings that are kept: counts, weights, gradients with respect to control points, normals.

SPDX-License-Identifier: Apache-2.0
"""

import warnings

import hwffd
import numpy as np
import pytest

CORNERS = np.array([[-1.0, -1, -1], [1, 1, 1]])
POINTS = np.random.default_rng(3).uniform(-1.4, 1.4, (60, 3))


@pytest.fixture(params=hwffd.families())
def lattice(request):
    dims = (4, 7, 7) if request.param == "bernstein" else (4, 6, 8)
    lattice = hwffd.Lattice.around("box", CORNERS, dims, family=request.param)
    lattice.set_device("reference")
    lattice.set_outside("clamp")
    lattice.deform("random:4")
    return lattice


def test_an_embedding_is_used_again(lattice):
    embedding = lattice.embed(POINTS)
    for deformation in "twist:20", "bend:30":
        lattice.deform(deformation)
        np.testing.assert_array_equal(embedding.deform(lattice), hwffd.deform(lattice, POINTS))
        np.testing.assert_array_equal(hwffd.deform(lattice, embedding),
                                      hwffd.deform(lattice, POINTS))


def test_places_have_the_shape_of_the_points():
    lattice = hwffd.Lattice.around("sphere", CORNERS)
    embedding = lattice.embed(POINTS.reshape(6, 10, 3))
    assert len(embedding) == 60 and embedding.shape == [6, 10, 3]
    assert embedding.cells.shape == embedding.local.shape == (6, 10, 3)
    assert embedding.cells.dtype == np.int32 and embedding.inside.dtype == bool
    assert embedding.inside.shape == embedding.residual.shape == (6, 10)
    assert embedding.outside == (~embedding.inside).sum() > 0
    assert embedding.not_converged == 0
    assert embedding.jacobians(lattice).shape == (6, 10, 3, 3)
    assert embedding.determinants(lattice).shape == (6, 10)
    with pytest.raises(ValueError, match="read-only"):
        embedding.cells[0] = 1
    single = lattice.embed([0.1, 0.2, 0.3])
    assert single.inside.shape == () and single.jacobians(lattice).shape == (3, 3)


def test_points_that_stay_are_told():
    lattice = hwffd.Lattice.around("box", CORNERS)
    lattice.deform("scale:2")
    inside_in_float = hwffd.deform(lattice, CORNERS.astype(np.float32))
    assert lattice.outside == 0
    assert not (inside_in_float == CORNERS).any()
    points = np.array([[0.5, 0.5, 0.5], [7, 7, 7], [-4, 0, 0]])
    with pytest.warns(UserWarning, match="2 of 3 points are outside the lattice and stayed"):
        moved = hwffd.deform(lattice, points)
    assert lattice.outside == 2
    np.testing.assert_array_equal(moved[1:], points[1:])
    lattice.set_outside("clamp")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        hwffd.deform(lattice, points)


def test_weights_times_control_points_are_the_points(lattice):
    embedding = lattice.embed(POINTS)
    weights = embedding.weights()
    assert weights.shape == (60, lattice.points.shape[0])
    np.testing.assert_allclose(weights @ lattice.points + embedding.unmoved(),
                               hwffd.deform(lattice, embedding), atol=1e-12)
    sums = weights.sum(axis=1)
    np.testing.assert_allclose(sums, 1, atol=1e-12)
    values, columns, starts = embedding.csr()
    assert values.size == columns.size == starts[-1] == 64 * 60


def test_pull_back_is_the_transpose_and_the_gradient(lattice):
    embedding = lattice.embed(POINTS)
    target = POINTS[::-1]

    def cost(control):
        lattice.control_points = control
        return ((embedding.deform(lattice) - target) ** 2).sum()

    control = lattice.control_points.copy()
    cost(control)
    slope = 2 * (embedding.deform(lattice) - target)
    gradient = embedding.pull_back(slope)
    assert gradient.shape == control.shape
    np.testing.assert_allclose(gradient.reshape(-1, 3), embedding.weights().T @ slope, atol=1e-12)
    for place in (0, 0, 0, 0), (2, 3, 4, 1), (1, 2, 5, 2), (3, 5, 6, 0):
        step = np.zeros_like(control)
        step[place] = 1e-3
        difference = (cost(control + step) - cost(control - step)) / 2e-3
        assert difference == pytest.approx(gradient[place], abs=1e-8)
    with pytest.raises(hwffd.UsageError, match="^gradient: 59 rows; give 60, one for each point$"):
        embedding.pull_back(slope[1:])


def test_jacobians_and_determinants_are_those_of_differences(lattice):
    points = 0.5 * POINTS
    embedding = lattice.embed(points)
    jacobians = embedding.jacobians(lattice)
    for axis in range(3):
        step = np.eye(3)[axis] * 1e-6
        slope = (hwffd.deform(lattice, points + step) - hwffd.deform(lattice, points - step)) / 2e-6
        np.testing.assert_allclose(jacobians[:, :, axis], slope, atol=1e-5)
    np.testing.assert_allclose(embedding.determinants(lattice), np.linalg.det(jacobians))


def test_normals_are_turned():
    lattice = hwffd.Lattice.around("box", CORNERS)
    lattice.deform("scale:2,1,1")
    embedding = lattice.embed(np.zeros((2, 3), np.float32))
    normals = embedding.normals(lattice, [[3, 0, 0], [1, 1, 0]])
    assert normals.dtype == np.float32
    np.testing.assert_allclose(normals, [[1, 0, 0], np.array([1, 2, 0]) / 5**0.5], atol=1e-6)
    out = np.empty((2, 3))
    assert embedding.normals(lattice, normals=normals, out=out) is out
    with pytest.raises(hwffd.Error, match="normals 1 is not finite"):
        embedding.normals(lattice, [[1, 0, 0], [np.nan, 0, 0]])


def test_another_lattice_is_refused():
    lattice = hwffd.Lattice.around("box", CORNERS)
    embedding = lattice.embed([[0, 0, 0]])
    for other in (hwffd.Lattice.around("box", 2 * CORNERS), hwffd.Lattice.around("sphere", CORNERS),
                  hwffd.Lattice.of(lattice.rest_points, family="linear")):
        for call in embedding.deform, embedding.jacobians:
            with pytest.raises(hwffd.Error, match="attached to another lattice"):
                call(other)
