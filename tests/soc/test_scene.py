#!/usr/bin/env python3
"""The memory of a system that is simulated: what it is made of, and what is refused.

    test_scene.py HWFFD_SOC_SCENE

SPDX-License-Identifier: Apache-2.0
"""

import unittest

from tests.support.program import FAILURE, ProgramTest

ROW = ("--row", "cg1-fx18-overlapped", "--output", "scene.bin")


class Scene(ProgramTest):
    given = {"three.obj": "v 0 0 0\nv 1 0 0\nv 0 1 2\nf 1 2 3\n"}

    def test_vertices_that_are_asked_for(self):
        result = self.call(*ROW, "--vertices", "16")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn(": 16 vertices, ", result.stdout)
        self.assertTrue((self.folder / "scene.bin").is_file())

    def test_fewer_than_a_run_after_a_reset_has(self):
        self.assert_refused(self.call(*ROW, "--model", "three.obj"), FAILURE, "three.obj: 3 vertices")
        self.assert_refused(self.call(*ROW, "--vertices", "15"), FAILURE, "give 16 or more")


if __name__ == "__main__":
    unittest.main()
