"""The Python module with the simulated hardware. Run by test_install.py on what was installed; the rest of
the module is tested in tests/python.

SPDX-License-Identifier: Apache-2.0
"""

import unittest

import hwffd
import numpy as np

CORNERS = np.array([[0.0, 0, 0], [1, 2, 3]])


class Module(unittest.TestCase):
    def setUp(self):
        self.points = np.random.default_rng(1).random((100, 3)) * [1, 2, 3]

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


if __name__ == "__main__":
    unittest.main()
