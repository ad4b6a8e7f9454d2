"""The Python module: shapes, errors, devices. Run by test_install.py on what was installed.

SPDX-License-Identifier: Apache-2.0
"""

import unittest
import warnings

import hwffd
import numpy as np

CORNERS = np.array([[0.0, 0, 0], [1, 2, 3]])


class Module(unittest.TestCase):
    def setUp(self):
        self.points = np.random.default_rng(1).random((100, 3)) * [1, 2, 3]

    def test_arrays(self):
        lattice = hwffd.Lattice.around("box", CORNERS, [4, 5, 6])
        self.assertEqual(list(lattice.dims), [4, 5, 6])
        self.assertEqual(lattice.points.shape, (120, 3))
        lattice.points = lattice.rest + [10, 0, 0]
        moved = hwffd.deform(lattice, self.points)
        np.testing.assert_allclose(moved, self.points + [10, 0, 0], atol=1e-5)
        cells, local, residual, inside = lattice.embed(self.points)
        self.assertTrue(inside.all() and cells.shape == local.shape == (100, 3))
        self.assertLess(residual.max(), 1e-12)
        np.testing.assert_array_equal(lattice.evaluate(cells, local), moved)
        self.assertEqual(lattice.folds(), "proved")
        again = hwffd.Lattice(lattice.dims, lattice.points)
        np.testing.assert_array_equal(again.rest, lattice.points)
        # Any order in memory, and integers.
        np.testing.assert_array_equal(hwffd.deform(lattice, np.asfortranarray(self.points)), moved)
        self.assertEqual(hwffd.deform(lattice, np.ones((2, 3), dtype=int)).shape, (2, 3))

    def test_devices(self):
        lattice = hwffd.Lattice.around("cylinder", CORNERS)
        lattice.deform("bend:60")
        moved = {}
        for device in ("model", "rtl", "reference"):
            lattice.set_device(device, "basic", "fx32")
            moved[device] = hwffd.deform(lattice, self.points)
        np.testing.assert_array_equal(moved["model"], moved["rtl"])
        np.testing.assert_allclose(moved["model"], moved["reference"], atol=1e-6)

    def test_lattices_larger_than_a_core_keeps(self):
        lattice = hwffd.Lattice.around("box", CORNERS, [30, 8, 20])
        lattice.deform("bend:60")
        lattice.set_device("model", format="fx18", pages=1, axis_points=64)
        whole = hwffd.deform(lattice, self.points)
        for how in ({}, {"pages": 1}, {"pages": 4}, {"pages": 2, "axis_points": 20}):
            lattice.set_device("model", format="fx18", **how)
            for _ in range(2):
                np.testing.assert_array_equal(hwffd.deform(lattice, self.points), whole)
        lattice.set_device("rtl", format="fx18")
        np.testing.assert_array_equal(hwffd.deform(lattice, self.points), whole)
        with self.assertRaisesRegex(hwffd.UsageError, "300 pages: a core has 1 to 256"):
            lattice.set_device("model", pages=300)

    def test_errors(self):
        lattice = hwffd.Lattice.around("box", CORNERS)
        with self.assertRaisesRegex(hwffd.UsageError, "twirl"):
            lattice.deform("twirl")
        with self.assertRaises(ValueError):
            lattice.set_device("fpga")
        with self.assertRaises(hwffd.Error):
            hwffd.Lattice.read("no-such-file.json")
        with self.assertRaises(hwffd.Error):
            hwffd.deform(lattice, np.array([[np.nan, 0, 0]]))
        with self.assertRaises(hwffd.Error):
            lattice.points = np.zeros((5, 3))
        with self.assertRaises(TypeError):
            hwffd.deform(lattice, np.zeros((5, 2)))
        self.assertTrue(issubclass(hwffd.UsageError, hwffd.Error))
        self.assertTrue(issubclass(hwffd.UsageError, ValueError))
        self.assertTrue(issubclass(hwffd.Error, RuntimeError))
        with self.assertRaises(hwffd.Error):
            hwffd.Lattice.around("cube", CORNERS)

    def test_no_write_is_lost(self):
        lattice = hwffd.Lattice.around("box", CORNERS)
        before = lattice.points.copy()
        for array in (lattice.points, lattice.rest):
            with self.assertRaisesRegex(ValueError, "read-only"):
                array[0] += 5
        lattice.points = lattice.points + 5
        np.testing.assert_array_equal(lattice.points, before + 5)

    def test_cells_are_whole_numbers(self):
        lattice = hwffd.Lattice.around("box", CORNERS)
        local = np.full((1, 3), 0.5)
        for cells in ([[0.7, 0, 0]], [[True, False, False]]):
            with self.assertRaisesRegex(hwffd.UsageError, "integers"):
                lattice.evaluate(np.array(cells), local)
        for cell in (2**33, -2**33, 1, -1):
            with self.assertRaises(hwffd.Error):
                lattice.evaluate(np.array([[cell, 0, 0]]), local)
        with self.assertRaises(hwffd.Error):
            lattice.evaluate(np.array([[2**63, 0, 0]], dtype=np.uint64), local)
        for kind in (np.int8, np.uint16, np.int64, np.uint64):
            self.assertEqual(lattice.evaluate(np.zeros((1, 3), dtype=kind), local).shape, (1, 3))
        self.assertEqual(lattice.evaluate([[0, 0, 0]], local).shape, (1, 3))

    def test_lattices_span_a_volume(self):
        flat = hwffd.Lattice.around("box", CORNERS).points * [1, 1, 0]
        with self.assertRaisesRegex(hwffd.Error, "volume"):
            hwffd.Lattice([4, 4, 4], flat)

    def test_points_outside_are_told(self):
        lattice = hwffd.Lattice.around("box", CORNERS)
        lattice.deform("scale:2")
        inside_in_float = hwffd.deform(lattice, CORNERS.astype(np.float32))
        self.assertEqual(lattice.outside, 0)
        self.assertFalse((inside_in_float == CORNERS).any())
        points = np.array([[0.5, 0.5, 0.5], [7, 7, 7], [-1, 0, 0]])
        with self.assertWarnsRegex(UserWarning, "2 of 3 points"):
            moved = hwffd.deform(lattice, points)
        self.assertEqual(lattice.outside, 2)
        np.testing.assert_array_equal(moved[1:], points[1:])
        lattice.set_outside("clamp")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            hwffd.deform(lattice, points)
        self.assertEqual(lattice.outside, 2)


if __name__ == "__main__":
    unittest.main()
