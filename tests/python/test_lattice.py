"""Lattices: how they are made, their control points, families, files, exceptions.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib

import hwffd
import numpy as np
import pytest

CORNERS = np.array([[-1.0, -1, -1], [1, 1, 1]])
POINTS = np.random.default_rng(2).uniform(-0.9, 0.9, (50, 3))
DIMS = {"bernstein": (4, 7, 10)}


def test_control_points_are_a_grid_that_is_set_whole():
    lattice = hwffd.Lattice.around("box", CORNERS, (4, 5, 6))
    assert lattice.dims == [4, 5, 6] and lattice.cells == [1, 2, 3]
    grid = lattice.control_points
    assert grid.shape == (4, 5, 6, 3)
    np.testing.assert_array_equal(grid.reshape(-1, 3), lattice.points)
    np.testing.assert_array_equal(grid, lattice.rest_points)
    for array in grid, lattice.points, lattice.rest, lattice.rest_points:
        with pytest.raises(ValueError, match="read-only"):
            array[0] += 5
    lattice.control_points = grid + [0, 3, 0]
    np.testing.assert_array_equal(lattice.points, lattice.rest + [0, 3, 0])
    lattice.points = lattice.rest
    np.testing.assert_array_equal(lattice.control_points, grid)
    with pytest.raises(hwffd.UsageError) as caught:
        lattice.control_points = grid[1:]
    assert str(caught.value) == ("control points: shape (3, 5, 6, 3); give (4, 5, 6, 3) or "
                                 "(120, 3)")
    with pytest.raises(hwffd.Error, match="lattice point 0 is not finite"):
        lattice.points = np.full((120, 3), np.nan)
    np.testing.assert_array_equal(lattice.control_points, grid)


def test_lattices_from_control_points():
    grid = hwffd.Lattice.around("sphere", CORNERS).control_points
    for lattice in (hwffd.Lattice.of(grid), hwffd.Lattice(grid.shape[:3], grid),
                    hwffd.Lattice(dims=grid.shape[:3], points=grid.reshape(-1, 3))):
        np.testing.assert_array_equal(lattice.rest_points, grid)
    for wrong, text in ((grid[:3], "3 x 6 x 9 points: each axis takes 4 to 64"),
                        (np.zeros((4, 4, 70, 3)), "4 x 4 x 70 points"),
                        (grid[0], "3 dimensions; give four"),
                        (grid * [1, 1, 0], "span no volume")):
        with pytest.raises(hwffd.Error, match=text):
            hwffd.Lattice.of(wrong)
    with pytest.raises(hwffd.Error, match="each axis takes 4 to 64"):
        hwffd.Lattice((2**31 - 1, 4, 4), grid)


@pytest.mark.parametrize("family", hwffd.families())
def test_families_carry_points_and_come_back(family):
    lattice = hwffd.Lattice.around("box", CORNERS, DIMS.get(family, (5, 6, 7)), family=family)
    assert lattice.family == family and family in repr(lattice)
    for device, close in ("reference", 1e-11), ("model", 1e-5):
        lattice.set_device(device)
        np.testing.assert_allclose(hwffd.deform(lattice, POINTS), POINTS, atol=close)
    assert lattice.folds() == "proved"
    lattice.deform("twist:40")
    moved = hwffd.deform(lattice, POINTS)
    assert np.abs(moved - POINTS).max() > 0.1
    again = hwffd.Lattice.of(lattice.rest_points, family=family)
    again.control_points = lattice.control_points
    again.set_device("model")
    np.testing.assert_array_equal(hwffd.deform(again, POINTS), moved)


def test_a_clamped_lattice_ends_at_its_control_points():
    lattice = hwffd.Lattice.around("box", CORNERS, (5, 5, 5), family="clamped")
    np.testing.assert_allclose(lattice.control_points[0, 0, 0], [-1, -1, -1], atol=1e-6)
    np.testing.assert_allclose(lattice.control_points[-1, -1, -1], [1, 1, 1], atol=1e-6)


def test_families_are_refused():
    with pytest.raises(hwffd.UsageError, match="one of bspline, clamped, bernstein"):
        hwffd.Lattice.around("box", CORNERS, family="bezier")
    with pytest.raises(hwffd.Error, match="bernstein takes 4, 7, 10, ... or 49 points"):
        hwffd.Lattice.around("box", CORNERS, (4, 5, 4), family="bernstein")
    assert {"box", "cylinder", "sphere"} <= set(hwffd.shapes())


def test_files_take_paths(tmp_path):
    lattice = hwffd.Lattice.around("sphere", CORNERS)
    lattice.deform("bend:30")
    for path in tmp_path / "moved.json", str(tmp_path / "again.json"):
        lattice.write(path)
        np.testing.assert_array_equal(hwffd.Lattice.read(path).points, lattice.points)
    lattice.write(path=tmp_path / "rest.json", rest=True)
    np.testing.assert_array_equal(hwffd.Lattice.read(tmp_path / "rest.json").rest, lattice.rest)
    for path in pathlib.Path("no-such-file.json"), tmp_path:
        with pytest.raises(hwffd.Error, match=path.name):
            hwffd.Lattice.read(path)


def test_exceptions_are_one_tree():
    assert issubclass(hwffd.UsageError, hwffd.Error)
    assert issubclass(hwffd.UsageError, ValueError) and issubclass(hwffd.UsageError, TypeError)
    assert issubclass(hwffd.Error, RuntimeError)
    assert hwffd.Error.__module__ == "hwffd"
    lattice = hwffd.Lattice.around("box", CORNERS)
    for call, text in ((lambda: lattice.deform("twirl"), "twirl"),
                       (lambda: lattice.set_device("fpga"), "'fpga' is unknown; one of model"),
                       (lambda: lattice.set_device("model", "cg7"), "organization 'cg7'"),
                       (lambda: lattice.set_outside("fade:-1"), "above 0"),
                       (lambda: hwffd.Lattice.around("cube", CORNERS), "sphere")):
        with pytest.raises(hwffd.UsageError, match=text) as caught:
            call()
        assert "\n" not in str(caught.value)


def test_devices():
    lattice = hwffd.Lattice.around("box", CORNERS)
    lattice.deform("twist:30")
    assert lattice.device == "reference"
    lattice.set_device("model")
    assert lattice.device == "model basic-fp32-overlapped"
    assert "basic-fp32-overlapped" in hwffd.devices("model")
    lattice.set_device(device="model", org="factored/3", format="fx18")
    fixed = hwffd.deform(lattice, points=POINTS)
    lattice.set_device("reference")
    assert lattice.device == "reference"
    assert 0 < np.abs(hwffd.deform(lattice, POINTS) - fixed).max() < 1e-3
    if not hwffd.devices("rtl"):
        with pytest.raises(hwffd.UsageError, match="no simulated hardware"):
            lattice.set_device("rtl")
