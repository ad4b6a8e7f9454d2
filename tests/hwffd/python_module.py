"""The Python module: shapes, errors, devices. Run by test_install.py on what was installed.

SPDX-License-Identifier: Apache-2.0
"""

import unittest

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


if __name__ == "__main__":
    unittest.main()
