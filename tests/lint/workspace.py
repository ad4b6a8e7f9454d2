"""A folder for each test, with copies of what it needs of the checkout, and scripts/ to import.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import shutil
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))


class Workspace(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()

    def copy(self, name):
        """A file or a folder of the checkout."""
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, self.root / name)
        else:
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, self.root / name)

    def put(self, name, text):
        """Writes a file, in a folder that is made where it is missing."""
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def program(self, name, text):
        """The same for a file that can be run."""
        self.put(name, text).chmod(0o755)
