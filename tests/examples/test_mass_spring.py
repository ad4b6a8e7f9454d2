"""hwffd-example-mass-spring: the meshes and the picture it writes, and what it prints.

Called with the path of the program.

SPDX-License-Identifier: Apache-2.0
"""

import re
import unittest

from tests.support.program import ProgramTest, size_of, vertices

FRAMES = 9
PYRAMID = """v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 2 0
f 1 2 3 4\nf 2 1 5\nf 3 2 5\nf 4 3 5\nf 1 4 5\n"""


class MassSpring(ProgramTest):
    given = {"pyramid.obj": PYRAMID}

    def film(self, output):
        result = self.call("--model", "pyramid.obj", "--frames", str(FRAMES), "--output", output)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout, self.files(output)

    def test_meshes_picture_and_energies(self):
        printed, files = self.film("out")
        names = [f"frame-{n:04}.obj" for n in range(1, FRAMES + 1)]
        meshes = [name for name in sorted(files) if name.endswith(".obj")]
        self.assertEqual(meshes, names)
        self.assertIn("strip.png", files)
        self.assertEqual(size_of(files["strip.png"]), (4 * 400, 2 * 260))

        rest = vertices(PYRAMID)
        shapes = [vertices(files[name].decode()) for name in names]
        rounded = sorted(tuple(round(x, 5) for x in vertex) for vertex in shapes[0])
        self.assertEqual(rounded, sorted(rest))
        self.assertEqual(len({tuple(shape) for shape in shapes}), FRAMES)

        rows = re.findall(r"^ +(\d+)  (pulled|free) +[\d.]+ +[\d.]+ +([\d.]+)   proved$", printed,
                          re.MULTILINE)
        self.assertEqual([int(number) for number, _, _ in rows], list(range(1, FRAMES + 1)))
        free = [float(energy) for _, state, energy in rows if state == "free"]
        self.assertEqual(len(free), FRAMES - 3)
        self.assertEqual(free, sorted(free, reverse=True))

    def test_two_runs_give_the_same_files(self):
        self.assertEqual(self.film("one")[1], self.film("two")[1])

    def test_bad_input(self):
        for options, word in ((("--frames", "3"), "4 to 9999"), (("--what",), "--help"),
                              (("--model", "nowhere.obj"), "nowhere.obj")):
            result = self.call(*options)
            self.assertNotEqual(result.returncode, 0)
            self.assertRegex(result.stderr, r"\Ahwffd-example-mass-spring: [^\n]+\n\Z")
            self.assertIn(word, result.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
