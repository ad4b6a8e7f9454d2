"""Devices of cores walk the voxels of a volume as a regular grid of the lattice, where they are one.

SPDX-License-Identifier: Apache-2.0
"""

import hwffd
import numpy as np
import pytest
from hwffd import volumes
from hwffd.volumes import warping
from hwffd.volumes.regular import RegularVoxels
from phantom import COUNTS, around, deformed, in_voxels, phantom

CELL = 1 << 40  # of a grid packet
UNIT = 1 << 16  # of the coordinate that is left of it


def places(first, last, count):
    """Cells and local coordinates along an axis, by the rule of docs/interface.md, in whole numbers."""
    start = round(first * CELL) + UNIT // 2
    step = round((last - first) * CELL / (count - 1)) if count > 1 else 0
    return [((start + step * n) // UNIT * UNIT) for n in range(count)]


def one_by_one(lattice, first, last, counts):
    """What evaluate() gives for the places of a grid, (cu, ct, cs, 3)."""
    axes = [np.array(places(*ends)) for ends in zip(first, last, counts)]
    u, t, s = np.meshgrid(*axes[::-1], indexing="ij")
    at = np.stack([s, t, u], -1).reshape(-1, 3)
    cells = np.minimum(at // CELL, np.array(lattice.cells) - 1)
    return lattice.evaluate(cells, (at - cells * CELL) / CELL).reshape(*counts[::-1], 3)


@pytest.mark.parametrize("device", [("reference",), ("model",), ("model", "cg1", "fx32"),
                                    ("model", "cg1", "fx18"), ("model", "walk", "fx17"),
                                    ("model", "factored", "fp32")])
def test_a_grid_has_the_bits_of_its_places(device):
    lattice = hwffd.Lattice.around("box", [[-1, -1, -1], [1, 2, 3]], (5, 6, 7))
    lattice.deform("random:2")
    lattice.set_device(*device)
    for first, last, counts in (((0, 0, 0), (2, 3, 4), (9, 4, 5)), ((2, 0.1, 3.7), (0, 2.9, 0), (7, 8, 9)),
                                ((0.3, 3, 1), (0.3, 3, 1), (1, 1, 1))):
        got = lattice.evaluate_grid(first, last, counts)
        assert got.shape == (*counts[::-1], 3)
        np.testing.assert_array_equal(got, one_by_one(lattice, first, last, counts))
        out = np.empty(got.shape)
        assert lattice.evaluate_grid(first, last, counts, out=out) is out
        np.testing.assert_array_equal(out, got)


def test_grids_that_are_refused():
    lattice = hwffd.Lattice.around("box", [[0, 0, 0], [1, 1, 1]], (4, 5, 6))
    for first, last, counts, text in (
            ((0, 0, 0), (1.01, 2, 3), (3, 3, 3), "not within the 1 x 2 x 3 cells"),
            ((-0.1, 0, 0), (1, 2, 3), (3, 3, 3), "in no lattice"),
            ((0, 0, np.nan), (1, 2, 3), (3, 3, 3), "three finite numbers"),
            ((0, 0, 0), (1, 2, 3), (3, 0, 3), "1 to 65535 vertices")):
        with pytest.raises(hwffd.Error, match=text) as caught:
            lattice.evaluate_grid(first, last, counts)
        assert "\n" not in str(caught.value)


@pytest.mark.parametrize("family", hwffd.families())
def test_families_have_grids(family):
    lattice = hwffd.Lattice.around("box", [[0, 0, 0], [1, 1, 1]], (7, 4, 7), family=family)
    lattice.deform("twist:30")
    s, t, u = lattice.cells
    got = lattice.evaluate_grid((0, 0, 0), (s, t, u), (5, 3, 9))
    np.testing.assert_array_equal(got, one_by_one(lattice, (0, 0, 0), (s, t, u), (5, 3, 9)))


def axes_box(volume):
    """A box along x, y and z about a volume whose axes are z, x and -y."""
    turned = volumes.Volume(volume.values, (1, 2, 3), volume.spacing,
                            [[0, 1, 0], [0, 0, -1], [1, 0, 0]])
    return turned, around(turned)


def scene(name):
    """A volume, and a lattice that is parallel to it."""
    if name == "other order":
        volume, lattice = axes_box(phantom())
        lattice.deform("twist:20")
        lattice.set_device("reference")
        return volume, lattice
    part = {"first": (6.3, 4.2, 3.1), "counts": (25, 20, 11)} if name == "part" else {}
    return phantom(), deformed(phantom(), **part)[0]


@pytest.mark.parametrize("org", ["cg1", "affine"])  # one by one, and row by row
@pytest.mark.parametrize("name", ["whole", "part", "other order"])
def test_voxels_are_walked_as_a_grid(name, org, monkeypatch):
    volume, lattice = scene(name)
    points = volume.points(np.argwhere(np.ones(COUNTS)).astype(float))
    points = points.reshape(*COUNTS, 3).transpose(2, 1, 0, 3)
    held = np.count_nonzero(lattice.embed(points).inside)
    exact = volumes.resample(volume, lattice, with_field=True)
    lattice.set_device("model", org, "fx32")
    part, positions = RegularVoxels.of(lattice, volume).moved(tuple(slice(0, n) for n in COUNTS[::-1]))
    assert positions[..., 0].size == held == np.prod(COUNTS) - exact.outside_lattice
    assert (held < 0.5 * np.prod(COUNTS)) == (name == "part")
    whole = volumes.resample(volume, lattice, with_field=True)
    np.testing.assert_array_equal(whole.field.values[part], positions - points[part])
    for voxels in 41 * 29 * 4, 41 * 7:
        monkeypatch.setattr(warping, "_VOXELS_AT_ONCE", voxels)
        blocks = volumes.resample(volume, lattice, with_field=True)
        assert blocks.outside_lattice == exact.outside_lattice
        for other in exact, whole:
            difference = in_voxels(volume, blocks.field.values - other.field.values)
            assert difference.max() < 1e-5


def test_voxels_that_are_no_grid():
    volume = phantom()
    for lattice in (hwffd.Lattice.around("sphere", volume.points(np.array([[0.0, 0, 0], COUNTS]))),
                    around(volume),  # along x, y and z, to which the volume is turned
                    hwffd.Lattice.around("box", [[0, 0, 0], [1, 1, 1]], family="clamped")):
        assert RegularVoxels.of(lattice, volume) is None
    c, s = np.cos(1e-6), np.sin(1e-6)
    skew = volumes.Volume(volume.values, (1, 2, 3), volume.spacing, [[c, -s, 0], [s, c, 0], [0, 0, 1]])
    assert RegularVoxels.of(around(skew), skew) is None
    bent = volumes.lattice_over(volume).rest_points.copy()
    bent[1, 2, 1] += 1e-3
    assert RegularVoxels.of(hwffd.Lattice.of(bent), volume) is None
