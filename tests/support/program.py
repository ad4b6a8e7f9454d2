"""What tests of programs share: a folder for each test, the program run in it, and what a refusal is.

The program is the first argument of the test that imports this.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
FAILURE, USAGE = 1, 2


def vertices(obj):
    """The coordinates in the text of an obj file."""
    return [tuple(map(float, line.split()[1:4]))
            for line in obj.splitlines() if line.startswith("v ")]


def size_of(png):
    """Width and height."""
    return struct.unpack(">II", png[16:24])


class ProgramTest(unittest.TestCase):
    """Each test has a folder with `given` in it: name -> text, or None for a folder."""

    given = {}
    name = PROGRAM.name  # with which its messages begin

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name, text in self.given.items():
            path = self.folder / name
            path.mkdir() if text is None else path.write_text(text)
        self.before = self.files()

    def files(self, folder="."):
        """Name -> bytes of what a folder holds, None for folders."""
        root = self.folder / folder
        return {str(path.relative_to(root)): path.read_bytes() if path.is_file() else None
                for path in root.rglob("*")}

    def text(self, name):
        return (self.folder / name).read_text()

    def call(self, *words, given="", **environment):
        return subprocess.run([PROGRAM, *words], cwd=self.folder, input=given, check=False,
                              capture_output=True, text=True, env={**os.environ, **environment})

    def assert_refused(self, result, status, words):
        """One line that has the words, that status, and the files as they were given."""
        self.assertEqual((result.returncode, result.stdout), (status, ""), result.stderr)
        self.assertRegex(result.stderr, rf"\A{self.name}: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word, result.stderr)
        self.assertEqual(self.files(), self.before, "something was written")
