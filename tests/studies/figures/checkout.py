"""A small checkout for the tests of studies/figures, and where that package is.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "scripts"), str(ROOT / "studies")]

from figures.reports import COMMITTED, Reports  # noqa: E402


class Checkout(unittest.TestCase):
    """A folder with what a test puts into it."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def put(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text if isinstance(text, str) else json.dumps(text), encoding="utf-8")
        return path

    def reports(self, folder=COMMITTED, **contents):
        """The reports of a folder, with these written into it first."""
        for name, content in contents.items():
            self.put(f"{folder}/{name}.json", content)
        return Reports(self.root, folder)
