"""The file VERSION is the one place that says the version: what follows from it is up to date, and is
noticed when it is not.

SPDX-License-Identifier: Apache-2.0
"""

import re
import unittest

from workspace import ROOT, Workspace

import core_file
import registers
import version
from tables import TableError

BAD = ("", "\n", "1.2\n", "1.2.3", "v1.2.3\n", "1.2.3\n\n", "1.2.3-rc1\n", "01.2.3\n", "1.2.-3\n")


class Version(Workspace):
    def setUp(self):
        super().setUp()
        self.copy("rtl")
        for name in (version.FILE, core_file.NAME, *registers.outputs()):
            self.copy(name)

    def stale(self):
        return [line.split(":")[0]
                for line in registers.stale(self.root) + core_file.stale(self.root)]

    def test_what_follows_goes_with_it(self):
        self.assertEqual(self.stale(), [])
        (self.root / version.FILE).write_text("3.41.59\n")
        wanted = [name for name in registers.outputs() if "events" not in name]
        self.assertEqual(self.stale(), [*wanted, core_file.NAME])
        self.assertEqual(registers.main(["--root", str(self.root), "write"]), 0)
        self.assertEqual(core_file.main(["--root", str(self.root), "write"]), 0)
        self.assertEqual(self.stale(), [])
        for name, words in ((version.HEADER, '#define HWFFD_VERSION "3.41.59"'),
                            (version.HEADER, "#define HWFFD_VERSION_MINOR 41"),
                            ("driver/include/hwffd/registers.h", "HWFFD_VERSION_MAJOR_RESET 0x3u"),
                            ("rtl/bus/ffd_axil_registers.v", "{16'h3, 8'h29, 8'h3b}"),
                            (core_file.NAME, 'name: "hwffd:ip:hwffd:3.41.59"')):
            self.assertIn(words, (self.root / name).read_text())

    def test_cmake_reads_it(self):
        text = (ROOT / "CMakeLists.txt").read_text()
        self.assertIn("file(STRINGS VERSION HWFFD_VERSION LIMIT_COUNT 1)", text)
        self.assertRegex(text, r"(?m)^project\(hwffd VERSION \$\{HWFFD_VERSION\}")

    def test_no_other_place_says_it(self):
        number = re.escape(str(version.read(ROOT)))
        for pattern in ("CMakeLists.txt", "*/CMakeLists.txt", "cmake/*.cmake", "api/**/*.[ch]pp",
                        "apps/**/*.[ch]pp", "scripts/*.py", "rtl/bus/registers.csv"):
            for path in ROOT.glob(pattern):
                self.assertNotRegex(path.read_text(), rf"\b{number}\b", path)

    def test_what_is_no_version_is_refused(self):
        for text in BAD:
            with self.subTest(text):
                (self.root / version.FILE).write_text(text)
                with self.assertRaisesRegex(TableError, r"VERSION:1: not a version"):
                    version.read(self.root)
        (self.root / version.FILE).write_text("0.256.0\n")
        with self.assertRaisesRegex(TableError, "reset '256' is not a number of 8 bits"):
            registers.read(self.root)
        (self.root / version.FILE).unlink()
        with self.assertRaisesRegex(TableError, "VERSION: cannot be read"):
            version.read(self.root)


if __name__ == "__main__":
    unittest.main(verbosity=2)
