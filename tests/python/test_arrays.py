"""Arrays in and out: kinds of numbers, strides, shapes, out=, and what is refused.

SPDX-License-Identifier: Apache-2.0
"""

import hwffd
import numpy as np
import pytest

CORNERS = np.array([[-1.0, -1, -1], [1, 1, 1]])


@pytest.fixture
def lattice():
    lattice = hwffd.Lattice.around("sphere", CORNERS)
    lattice.set_device("reference")
    lattice.deform("twist:50")
    return lattice


@pytest.fixture
def points():
    return np.random.default_rng(1).uniform(-0.6, 0.6, (40, 3))


def refused(text, call, *arguments, **named):
    with pytest.raises(hwffd.UsageError) as caught:
        call(*arguments, **named)
    assert str(caught.value) == text


def test_results_have_the_type_and_shape_of_the_points(lattice, points):
    moved = hwffd.deform(lattice, points)
    assert moved.dtype == np.float64 and moved.shape == (40, 3)
    single = hwffd.deform(lattice, points.astype(np.float32))
    assert single.dtype == np.float32
    np.testing.assert_allclose(single, moved, atol=1e-6)
    for shape in (3,), (1, 3), (4, 10, 3), (2, 2, 2, 5, 3):
        some = points.reshape(-1)[:np.prod(shape)].reshape(shape)
        np.testing.assert_array_equal(hwffd.deform(lattice, some),
                                      moved.reshape(-1)[:np.prod(shape)].reshape(shape))
    assert hwffd.deform(lattice, np.zeros((0, 3))).shape == (0, 3)
    assert hwffd.deform(lattice, np.zeros((2, 0, 3))).shape == (2, 0, 3)
    for kind in np.int8, np.uint64, np.float16, np.longdouble:
        assert hwffd.deform(lattice, np.zeros((2, 3), kind)).dtype == np.float64
    np.testing.assert_array_equal(hwffd.deform(lattice, points.tolist()), moved)


def test_any_strides_are_read(lattice, points):
    moved = hwffd.deform(lattice, points)
    wide = np.zeros((80, 7))
    wide[::2, 1:7:2] = points
    record = np.zeros(40, dtype=[("flag", np.int8), ("at", np.float64, 3)])  # unaligned
    record["at"] = points
    for same in (np.asfortranarray(points), wide[::2, 1:7:2], record["at"],
                 points[::-1][::-1], points.astype(">f8")):
        np.testing.assert_array_equal(hwffd.deform(lattice, same), moved)
    np.testing.assert_array_equal(hwffd.deform(lattice, points[::-1, ::-1]),
                                  hwffd.deform(lattice, points[::-1, ::-1].copy()))
    repeated = np.broadcast_to(points[0], (5, 3))
    np.testing.assert_array_equal(hwffd.deform(lattice, repeated), np.broadcast_to(moved[0], (5, 3)))
    points.flags.writeable = False
    np.testing.assert_array_equal(hwffd.deform(lattice, points), moved)


def test_out_is_written_and_returned(lattice, points):
    moved = hwffd.deform(lattice, points)
    for out in (np.empty((40, 3)), np.empty((40, 3), order="F"), np.empty((40, 6))[:, ::2],
                np.empty((40, 3), np.float32)):
        assert hwffd.deform(lattice, points, out=out) is out
        np.testing.assert_array_equal(out, moved.astype(out.dtype))
    embedding = lattice.embed(points)
    same = points.copy()
    assert embedding.deform(lattice, out=same) is same
    np.testing.assert_array_equal(same, moved)
    hwffd.deform(lattice, points, out=points)
    np.testing.assert_array_equal(points, moved)


def test_out_that_has_no_room_is_refused(lattice, points):
    deform = hwffd.deform
    refused("out: shape (39, 3); give (40, 3)", deform, lattice, points, out=np.empty((39, 3)))
    refused("out: numbers of int64; give float32 or float64", deform, lattice, points,
            out=np.empty((40, 3), int))
    refused("out: no array of NumPy; give one of float32 or float64", deform, lattice, points,
            out=[[0.0] * 3] * 40)
    out = np.full((40, 3), 7.0)
    out.flags.writeable = False
    refused("out: a read-only array; give one to write to", deform, lattice, points, out=out)
    with pytest.raises(hwffd.Error, match="^point 0 is not finite; give finite coordinates$"):
        out = np.full((1, 3), 7.0)
        deform(lattice, [[np.nan, 0, 0]], out=out)
    assert (out == 7).all()
    with pytest.raises(hwffd.Error, match="^point 1 is beyond what float32 holds"):
        deform(lattice, [[0, 0, 0], [1e39, 0, 0]], out=np.empty((2, 3), np.float32))


def test_what_is_no_points_is_refused(lattice):
    for points, text in {
            "abc": "points: numbers of <U3; give float32, float64 or integers",
            (1 + 2j, 0, 0): "points: numbers of complex128; give float32, float64 or integers",
            (True, False, True): "points: numbers of bool; give float32, float64 or integers",
            (1.0, 2.0): "points: shape (2,); give (..., 3), x, y and z last",
            7: "points: shape (); give (..., 3), x, y and z last",
            ((1, 2), (3, 4)): "points: shape (2, 2); give (..., 3), x, y and z last"}.items():
        for call in (lambda p: hwffd.deform(lattice, p), lattice.embed,
                     lambda p: hwffd.Lattice.around("box", p)):
            refused(text, call, points)
    refused("points: no array; give one of NumPy, of float32 or float64", lattice.embed,
            [[1, 2], [3]])
    refused("points: numbers of object; give float32, float64 or integers", lattice.embed,
            np.array([[1, None, 2]]))


def test_local_coordinates_and_cells(lattice, points):
    cells, local, residual, inside = lattice.embed(points)
    moved = hwffd.deform(lattice, points)
    assert inside.all() and residual.max() < 1e-12
    np.testing.assert_array_equal(lattice.evaluate(cells, local), moved)
    out = np.empty((40, 3), np.float32)
    assert lattice.evaluate(cells, local, out=out) is out
    refused("local: 39 rows; give 40, one for each point", lattice.evaluate, cells, local[1:])
    refused("cells: no integers, n x 3; give them as embed() does", lattice.evaluate,
            cells + 0.5, local)
    with pytest.raises(hwffd.Error, match="^cells: 8589934592 in row 0; give 0 to 60$"):
        lattice.evaluate(np.full((1, 3), 2**33), local[:1])


def test_cells_are_whole_numbers():
    lattice = hwffd.Lattice.around("box", [[-1.0, -1, -1], [1, 1, 1]])
    local = np.full((1, 3), 0.5)
    for cells in ([[0.7, 0, 0]], [[True, False, False]]):
        with pytest.raises(hwffd.UsageError, match="integers"):
            lattice.evaluate(np.array(cells), local)
    for cell in (2**33, -2**33, 1, -1):
        with pytest.raises(hwffd.Error):
            lattice.evaluate(np.array([[cell, 0, 0]]), local)
    with pytest.raises(hwffd.Error):
        lattice.evaluate(np.array([[2**63, 0, 0]], dtype=np.uint64), local)
    for kind in (np.int8, np.uint16, np.int64, np.uint64):
        assert lattice.evaluate(np.zeros((1, 3), dtype=kind), local).shape == (1, 3)
    assert lattice.evaluate([[0, 0, 0]], local).shape == (1, 3)
