"""What a lattice does to space: displacements, the inverse, derivatives outside, the bending energy.

SPDX-License-Identifier: Apache-2.0
"""

import warnings

import hwffd
import numpy as np
import pytest

CORNERS = np.array([[-1.0, -1, -1], [1, 1, 1]])
RANDOM = np.random.default_rng(6)
POINTS = RANDOM.uniform(-1.3, 1.3, (300, 3))
OUTSIDE = ("keep", "clamp", "fade:1.5")


def lattice_of(shape="box", dims=None, deformation="twist:30", outside="keep", family="bspline"):
    lattice = hwffd.Lattice.around(shape, CORNERS, dims, family=family)
    lattice.set_device("reference")
    lattice.deform(deformation)
    lattice.set_outside(outside)
    return lattice


@pytest.mark.parametrize("outside", OUTSIDE)
def test_displacements_are_what_deform_adds(outside):
    lattice = lattice_of("sphere", outside=outside)
    moved = lattice.displacements(POINTS.reshape(10, 30, 3))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        np.testing.assert_allclose(moved.reshape(-1, 3), hwffd.deform(lattice, POINTS) - POINTS, atol=1e-15)
    single = lattice.displacements(POINTS.astype(np.float32))
    assert single.dtype == np.float32
    np.testing.assert_allclose(single, moved.reshape(-1, 3), atol=1e-6)
    out = np.empty((300, 3))
    assert lattice.displacements(POINTS, out=out) is out
    np.testing.assert_array_equal(out, moved.reshape(-1, 3))


def test_displacements_of_a_regular_grid():
    lattice = lattice_of(outside="clamp")
    field = lattice.displacement_grid((-1, -1, -2), (1, 1, 2), (2, 3, 40))
    assert field.shape == (40, 3, 2, 3)
    z, y, x = np.meshgrid(np.linspace(-2, 2, 40), (-1, 0, 1), (-1, 1), indexing="ij")
    np.testing.assert_allclose(field, lattice.displacements(np.stack([x, y, z], axis=-1)), atol=1e-14)
    grid = lattice.displacement_grid((0.5, 0, 0), (9, 9, 9), (1, 1, 1))
    np.testing.assert_allclose(grid[0, 0, 0], lattice.displacements([0.5, 0, 0]), atol=1e-15)
    with pytest.raises(hwffd.UsageError, match="^counts: 0; give 1 or more each$"):
        lattice.displacement_grid((0, 0, 0), (1, 1, 1), (2, 0, 2))
    with pytest.raises(hwffd.UsageError, match="^counts: 2.56 places or more; give fewer$"):
        lattice.displacement_grid((0, 0, 0), (1, 1, 1), (2 ** 31 - 1,) * 3)
    many = lattice.displacement_grid((-1, -1, -1), (1, 1, 1), (40, 41, 42))
    assert np.abs(many[-1, -1, -1] - lattice.displacements([1.0, 1, 1])).max() < 1e-14


@pytest.mark.parametrize("outside", OUTSIDE)
@pytest.mark.parametrize("shape, family", [("box", "bspline"), ("sphere", "bspline"), ("box", "clamped"),
                                           ("box", "bernstein"), ("cylinder", "bspline")])
def test_the_inverse_comes_back(shape, family, outside):
    lattice = lattice_of(shape, deformation="bend:25", outside=outside, family=family)
    inside = lattice.embed(POINTS).inside
    points = POINTS[inside] if outside == "keep" else POINTS
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        moved = hwffd.deform(lattice, points)
        back = lattice.inverse(moved)
        known = np.isfinite(back).all(axis=1)
        assert known.mean() > 0.97 and known[lattice.embed(points).inside].all()
        again = hwffd.deform(lattice, back[known])
    np.testing.assert_allclose(again, moved[known], atol=1e-11)
    # Where the deformation is one to one, those are the points.
    assert (np.abs(back - points).max(axis=1) < 1e-9).mean() > 0.9


def test_the_inverse_of_points_that_come_from_nowhere():
    lattice = lattice_of(deformation="scale:0.5")
    lattice.set_outside("keep")
    # The cells have shrunk: what lies between their old and new faces is not reached.
    with pytest.warns(UserWarning, match="^1 of 3 points come from nowhere"):
        back = lattice.inverse([[0.2, 0.1, 0.3], [0.9, 0, 0], [3, 0, 0]])
    np.testing.assert_allclose(back[0], [0.4, 0.2, 0.6], atol=1e-12)
    assert np.isnan(back[1]).all()
    np.testing.assert_array_equal(back[2], [3, 0, 0])
    assert lattice.inverse(np.zeros((2, 2, 3), np.float32)).dtype == np.float32
    assert lattice.inverse(np.zeros((0, 3))).shape == (0, 3)
    with pytest.raises(hwffd.Error, match="^point 0 is not finite"):
        lattice.inverse([[np.nan, 0, 0]])


@pytest.mark.parametrize("outside", ["clamp", "fade:1.5"])
@pytest.mark.parametrize("shape", ["box", "sphere", "cylinder"])
def test_jacobians_outside_are_those_of_differences(shape, outside):
    lattice = lattice_of(shape, deformation="bend:25", outside=outside)
    points = POINTS if shape == "box" else 1.9 * POINTS
    embedding = lattice.embed(points)
    beyond = ~embedding.inside
    jacobians = embedding.jacobians(lattice)[beyond]
    assert beyond.sum() > 50 and np.isfinite(jacobians).all()
    differences = np.empty_like(jacobians)
    for axis in range(3):
        step = np.eye(3)[axis] * 1e-5
        differences[:, :, axis] = (hwffd.deform(lattice, points[beyond] + step)
                                   - hwffd.deform(lattice, points[beyond] - step)) / 2e-5
    off = np.abs(jacobians - differences).max(axis=(1, 2))
    # Few lie where the nearest place turns a corner.
    assert np.median(off) < 1e-5 and (off < 1e-3).mean() > 0.95
    np.testing.assert_allclose(embedding.determinants(lattice)[beyond], np.linalg.det(jacobians))
    normals = embedding.normals(lattice, np.tile([0.0, 0, 1], (len(points), 1)))
    assert np.isfinite(normals[beyond]).all()


def quadratic(coefficients, spacing, dims=(6, 7, 8)):
    """A box lattice with even cells, whose points move along x by a quadratic function of their numbers."""
    places = np.stack(np.meshgrid(*map(np.arange, dims), indexing="ij"), axis=-1).astype(float)
    lattice = hwffd.Lattice.of(places * spacing)
    moved = np.einsum("...i,ij,...j->...", places, coefficients, places)
    lattice.control_points = lattice.rest_points + moved[..., None] * [1, 0, 0]
    return lattice


def test_the_bending_energy_of_quadratic_functions():
    """B-splines have a quadratic function's second derivatives exactly, everywhere."""
    spacing = np.array([0.5, 2.0, 1.25])
    for coefficients in (np.diag([1.0, 0, 0]), np.diag([0, 0.5, -2.0]), [[0, 3, 0], [0, 0, 0], [0, 0, 0]],
                         [[0.1, 1, -2], [0.5, 0.2, 0.7], [0, -1, 0.3]]):
        coefficients = np.array(coefficients)
        second = (coefficients + coefficients.T) / np.outer(spacing, spacing)
        energy = quadratic(coefficients, spacing).bending_energy()
        assert energy == pytest.approx((second**2).sum(), rel=1e-9)


@pytest.mark.parametrize("family", hwffd.families())
def test_the_bending_energy_is_the_mean_of_second_derivatives(family):
    dims = {"bernstein": (4, 7, 7)}.get(family, (4, 5, 6))
    lattice = hwffd.Lattice.around("box", [[0, 0, 0], [1, 2, 3]], dims, family=family,
                                   rotation=[[1, 0.3, 0], [0, 1, 0], [0.2, 0, 1]])
    lattice.set_device("reference")
    assert lattice.bending_energy() == pytest.approx(0, abs=1e-15)
    lattice.deform("random:3")
    rest = hwffd.Lattice.of(lattice.rest_points, family=family)
    rest.set_device("reference")
    cells = np.stack(np.meshgrid(*map(np.arange, lattice.cells), indexing="ij"), axis=-1).reshape(-1, 3)
    # A cubic along each axis is known from four places, and squares of it from four places of Gauss.
    nodes = np.linspace(0, 1, 4)
    local = np.stack(np.meshgrid(*[nodes] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    to_powers = np.linalg.inv(np.vander(nodes, increasing=True))
    at, weights = np.polynomial.legendre.leggauss(4)
    at, weights = (at + 1) / 2, weights / 2
    powers = np.stack([np.vander(at, 4, increasing=True),
                       np.vander(at, 4, increasing=True)[:, [0, 0, 1, 2]] * [0, 1, 2, 3],
                       np.vander(at, 4, increasing=True)[:, [0, 0, 0, 1]] * [0, 0, 2, 6]])
    corner, *ends = rest.evaluate([cells[0]] * 4, np.vstack([np.zeros(3), np.eye(3)]))
    inverse = np.linalg.inv(np.array(ends).T - corner[:, None])
    total = 0
    for cell in cells:
        cell = np.tile(cell, (64, 1))
        moved = (lattice.evaluate(cell, local) - rest.evaluate(cell, local)).reshape(4, 4, 4, 3)
        polynomial = np.einsum("ai,bj,ck,ijkx->abcx", to_powers, to_powers, to_powers, moved)
        second = np.empty((3, 3, 4, 4, 4, 3))
        for i in range(3):
            for j in range(3):
                along = [powers[(i == axis) + (j == axis)] for axis in range(3)]
                second[i, j] = np.einsum("pa,qb,rc,abcx->pqrx", *along, polynomial)
        second = np.einsum("ijpqrx,ia,jb->abpqrx", second, inverse, inverse)
        total += np.einsum("abpqrx,p,q,r->", second**2, weights, weights, weights)
    assert lattice.bending_energy() == pytest.approx(total / len(cells), rel=1e-9)


def test_the_bending_energy_of_no_box_is_refused():
    for lattice in lattice_of("sphere"), lattice_of("cylinder"):
        with pytest.raises(hwffd.Error, match="^bending energy: the lattice at rest is no box of even cells; "):
            lattice.bending_energy()
    for deformation in "none", "scale:2", "move:1,1,1:0,0,0":
        assert lattice_of(deformation=deformation).bending_energy() < 1e-20
