#!/usr/bin/env python3
"""The command hwffd-plates: ten pictures from the RTL, and a report.

    test_plates.py HWFFD_PLATES

SPDX-License-Identifier: Apache-2.0
"""

import json
import unittest

from tests.support.program import FAILURE, USAGE, ProgramTest, size_of

WIDTH = 160


class Plates(ProgramTest):
    def test_ten_plates_from_the_rtl(self):
        result = self.call("--width", str(WIDTH))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("rtl basic-fp32-overlapped", result.stdout)
        plates = json.loads(self.text("build/reports/plates.json"))["plates"]
        names = [f"plate{number:02}.png" for number in range(1, 11)]
        self.assertEqual([plate["file"] for plate in plates], names)
        pictures = {(self.folder / "build/plates" / name).read_bytes() for name in names}
        self.assertEqual(len(pictures), 10)
        for picture in pictures:
            self.assertEqual(size_of(picture), (WIDTH, WIDTH * 3 // 4))
        for plate in plates:
            self.assertEqual(sorted(plate), ["file", "mismatches", "vertices"])
            self.assertEqual(plate["mismatches"], 0)
            self.assertGreater(plate["vertices"], 1000)
            self.assertRegex(result.stdout, rf"{plate['file']} .* {plate['vertices']} +0\n")
        self.assertTrue((self.folder / "build/plates/plates.png").is_file())

    def test_results_that_are_not_the_models_end_with_1(self):
        result = self.call("--width", str(WIDTH), "--device", "reference")
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"\Ahwffd-plates: [0-9]+ results differ from the model.*\n\Z")
        plates = json.loads(self.text("build/reports/plates.json"))["plates"]
        self.assertTrue(all(plate["mismatches"] > 100 for plate in plates))

    def test_refusals_are_one_line(self):
        for words, status, part in (("--width 161", USAGE, "--width"),
                                    ("--device fpga", USAGE, "fpga")):
            with self.subTest(words):
                self.assert_refused(self.call(*words.split()), status, [part])
        result = self.call("--width", "160", "--device", "model", "--output", "/dev/null")
        self.assertEqual((result.returncode, len(result.stderr.splitlines())), (FAILURE, 1))
        self.assertIn("--output", result.stderr)

    def test_without_egl_one_line_names_the_packages(self):
        result = self.call(__EGL_VENDOR_LIBRARY_FILENAMES="/nowhere.json")
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"\Ahwffd-plates: no OpenGL .*libegl1.*\n\Z")
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
