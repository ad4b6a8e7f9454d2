"""Shapes around points: which way they point, room, regions; few points an axis.

SPDX-License-Identifier: Apache-2.0
"""

import hwffd
import numpy as np
import pytest

CORNERS = np.array([[-1.0, -2, -3], [1, 2, 3]])
POINTS = np.random.default_rng(8).uniform(-1, 1, (400, 3)) * [1, 2, 3]
TURNED = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0], [0.48, 0.64, 0.6]])


def holds(lattice, points):
    return lattice.embed(points).inside.all()


def axis_of(lattice):
    """Of a cylinder: from the middle of its bottom to that of its top, in parts of its length."""
    lattice.set_device("reference")
    bottom, top = lattice.evaluate([[0, 0, 0], [0, lattice.cells[1] - 1, 0]], [[0, 0, 0], [0, 1, 0]])
    return (top - bottom) / np.linalg.norm(top - bottom)


@pytest.mark.parametrize("shape", hwffd.shapes())
@pytest.mark.parametrize("axis", ["x", "y", "z", (0, 0, 2), (1, -1, 0.5), (0, -1, 0)])
def test_the_axis_of_a_shape(shape, axis):
    lattice = hwffd.Lattice.around(shape, POINTS, axis=axis)
    assert holds(lattice, POINTS) and holds(lattice, POINTS.astype(np.float32)) and lattice.folds().startswith("proved")
    if shape == "cylinder":
        direction = np.eye(3)["xyz".index(axis)] if isinstance(axis, str) else axis / np.linalg.norm(axis)
        np.testing.assert_allclose(axis_of(lattice), direction, atol=1e-14)


def test_an_upright_shape_is_what_it_was():
    for shape in hwffd.shapes():
        np.testing.assert_array_equal(hwffd.Lattice.around(shape, POINTS, axis="y").rest,
                                      hwffd.Lattice.around(shape, POINTS).rest)
    along = hwffd.Lattice.around("cylinder", POINTS, axis="z").rest
    upright = hwffd.Lattice.around("cylinder", POINTS[:, [0, 2, 1]] * [1, 1, -1]).rest
    np.testing.assert_allclose(along, upright[:, [0, 2, 1]] * [1, -1, 1], atol=1e-5)


@pytest.mark.parametrize("shape", hwffd.shapes())
def test_a_rotation_turns_the_shape(shape):
    lattice = hwffd.Lattice.around(shape, POINTS @ TURNED.T, rotation=TURNED)
    np.testing.assert_allclose(lattice.rest @ TURNED, hwffd.Lattice.around(shape, POINTS).rest, atol=1e-5)
    sheared = hwffd.Lattice.around(shape, POINTS, rotation=[[1, 0.5, 0], [0, 1, 0], [0, 0, 2]], axis="z")
    assert holds(sheared, POINTS)


@pytest.mark.parametrize("shape", hwffd.shapes())
def test_padding_is_left_free(shape):
    wide = POINTS + np.sign(POINTS) * [0.1, 0.2, 0.3]
    assert not holds(hwffd.Lattice.around(shape, POINTS), wide)
    assert holds(hwffd.Lattice.around(shape, POINTS, padding=(0.1, 0.2, 0.3)), wide)
    box = hwffd.Lattice.around("box", CORNERS, padding=0.5)
    np.testing.assert_allclose(box.control_points[1, 1, 1], CORNERS[0] - 0.5, atol=1e-6)


def test_a_region_is_held_exactly():
    box = hwffd.Lattice.around("box", region=CORNERS)
    np.testing.assert_array_equal(box.control_points[1, 1, 1], CORNERS[0])
    np.testing.assert_array_equal(box.control_points[2, 2, 2], CORNERS[1])
    for shape in hwffd.shapes():
        assert holds(hwffd.Lattice.around(shape, region=CORNERS, rotation=TURNED), POINTS)


@pytest.mark.parametrize("named, text", [
    ({"axis": "w"}, "axis: 'w'; give 'x', 'y' or 'z', or a direction, three finite numbers"),
    ({"axis": (0, 0, 0)}, "axis: no direction; give three finite numbers, not all of them 0"),
    ({"rotation": np.eye(2)}, "rotation: give an array of shape (3, 3)"),
    ({"rotation": np.zeros((3, 3))}, "rotation: spans no volume; give 3 x 3 finite numbers, columns in three"),
    ({"padding": -1}, "padding: "), ({"padding": (1, 2)}, "padding: (1, 2); give 0 or more, one or three"),
    ({"padding": "1"}, "padding: '1'; give 0 or more, one or three finite numbers"),
    ({"region": CORNERS}, "points: given beside a region; give one of the two"),
    ({"points": None, "region": CORNERS[:1]}, "region: give an array of shape (2, 3)"),
    ({"points": None, "region": CORNERS * [1, 0, 1]}, "region: spans no volume; give two corners"),
    ({"points": None}, "points: ")])
def test_what_is_no_placement_is_refused(named, text):
    with pytest.raises(hwffd.UsageError) as caught:
        hwffd.Lattice.around(**{"shape": "box", "points": POINTS, **named})
    assert str(caught.value).startswith(text)


@pytest.mark.parametrize("family", ["bernstein", "catmull-rom", "linear"])
@pytest.mark.parametrize("dims", [(2, 2, 2), (2, 3, 4), (3, 3, 7)])
def test_few_points_an_axis(family, dims, tmp_path):
    few = np.stack(np.meshgrid(*(np.linspace(-1, 1, n) for n in dims), indexing="ij"), axis=-1)
    few += 0.05 * np.random.default_rng(1).uniform(-1, 1, few.shape)
    lattice = hwffd.Lattice.of(few, family=family)
    lattice.set_device("reference")
    assert all(got >= max(4, wanted) for got, wanted in zip(lattice.dims, dims))
    np.testing.assert_array_equal(hwffd.Lattice(dims, few, family=family).rest, lattice.rest)
    file = tmp_path / "few.json"
    listed = few.reshape(-1, 3).tolist()
    file.write_text(f'{{"hwffd_lattice": 1, "dims": {list(dims)}, "points": {listed}, "family": "{family}"}}')
    np.testing.assert_array_equal(hwffd.Lattice.read(file).rest, lattice.rest)
    # Moved by an affine map, as few points or as many.
    moved = few @ np.diag([2.0, 1, 0.5]) + [1, 2, 3]
    lattice.control_points = moved
    points = np.random.default_rng(2).uniform(-0.25, 0.25, (50, 3))
    np.testing.assert_allclose(hwffd.deform(lattice, points), points * [2, 1, 0.5] + [1, 2, 3], atol=1e-12)
    around = hwffd.Lattice.around("box", CORNERS, dims, family=family)
    assert holds(around, CORNERS)
    if family == "bernstein" and dims == (2, 2, 2):  # trilinear: corners are the ends
        np.testing.assert_array_equal(lattice.control_points[::3, ::3, ::3], moved)
    for other in "bspline", "clamped":
        with pytest.raises(hwffd.Error, match="^[^/].*each axis takes 4 to 64"):
            hwffd.Lattice.of(few, family=other)
        with pytest.raises(hwffd.Error, match="few.json: .*each axis takes 4 to 64 .* from 2 on .*linear"):
            hwffd.Lattice.read(file, family=other)


@pytest.mark.parametrize("family", hwffd.families())
def test_files_keep_family_and_rest(family, tmp_path):
    lattice = hwffd.Lattice.around("box", CORNERS, (4, 7, 7), family=family)
    file = tmp_path / "lattice.json"
    lattice.write(file)
    assert ("family" in file.read_text()) == (family != "bspline") and '"rest"' not in file.read_text()
    lattice.deform("bend:30")
    lattice.write(file)
    again = hwffd.Lattice.read(file)
    assert again.family == family
    np.testing.assert_array_equal(again.control_points, lattice.control_points)
    np.testing.assert_array_equal(again.rest_points, lattice.rest_points)
    lattice.write(file, rest=True)
    at_rest = hwffd.Lattice.read(file)
    np.testing.assert_array_equal(at_rest.control_points, lattice.rest_points)
    assert at_rest.family == family and hwffd.Lattice.read(file, family="linear").family == "linear"
