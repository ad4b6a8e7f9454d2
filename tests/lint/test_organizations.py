"""rtl/organizations.csv: what it says, what is refused, what follows from it.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import shutil
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import configurations  # noqa: E402
import organizations  # noqa: E402
from tables import TableError  # noqa: E402

HEADER = ",".join(organizations.COLUMNS)
# Software reads these in CONFIG.org: a core of any version has them.
NUMBERS = {"basic": 0, "cg1": 1, "cg2": 2, "cg3": 3, "tree": 4, "parallel": 5, "factored": 6,
           "factored/3": 7, "nested": 8, "nested/3": 9}

# what is wrong -> (rows, line of the fault or None, word of the message)
BAD = {
    "no rows": ("", None, "no organizations"),
    "column missing": ("basic,0\n", 2, "columns"),
    "name in capitals": ("Basic,0,1\n", 2, "bad org"),
    "nothing behind the stroke": ("factored/,0,64\n", 2, "bad org"),
    "no such module": ("nothing,0,1\n", 2, "unknown org"),
    "name twice": ("tree,4,\ntree,5,\n", 3, "twice"),
    "number twice": ("basic,0,1\n\ntree,0,\n", 4, "number 0 is that of 'basic'"),
    "no number": ("basic,,1\n", 2, "number"),
    "negative number": ("basic,-1,1\n", 2, "number"),
    "more than CONFIG.org has bits for": ("basic,256,1\n", 2, "number"),
    "n of 0": ("basic,0,0\n", 2, "n is '0'"),
    "n above 64": ("parallel,5,65\n", 2, "n is '65'"),
    "n in words": ("parallel,5,all\n", 2, "n is 'all'"),
}


class Organizations(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.rtl = pathlib.Path(folder.name)
        shutil.copytree(ROOT / "rtl/evaluator", self.rtl / "evaluator")
        self.table = self.rtl / organizations.TABLE

    def test_bad_tables_are_refused(self):
        for what, (rows, line, word) in BAD.items():
            with self.subTest(what):
                self.table.write_text(f"{HEADER}\n{rows}")
                with self.assertRaises(TableError) as caught:
                    organizations.read(self.rtl)
                message = str(caught.exception)
                self.assertIn(word, message)
                self.assertTrue(message.startswith(f"{self.table}:{line}: " if line else
                                                   f"{self.table}: "), message)
        print(f"organizations: {len(BAD)} bad tables refused")

    def test_numbers_are_those_that_software_knows(self):
        found = {name: one.number for name, one in organizations.read().items()}
        self.assertEqual({**found, **NUMBERS}, found)

    def test_numbers_do_not_follow_the_order_of_rows(self):
        rows = configurations.TABLE.read_text().splitlines()
        table = self.rtl / "configurations.csv"
        table.write_text("\n".join([rows[0], *reversed(rows[1:])]) + "\n")
        numbers = {row.org: row.parameters["ORG"] for row in configurations.read(table)}
        self.assertEqual(numbers, NUMBERS)

    def test_the_selector_has_the_numbers_in_any_order_of_lines(self):
        committed = (ROOT / "rtl/evaluator/ffd_org_select.v").read_text()
        lines = (ROOT / "rtl" / organizations.TABLE).read_text().splitlines()
        self.table.write_text("\n".join([lines[0], *reversed(lines[1:])]) + "\n")
        self.assertEqual(organizations.select_text(self.rtl), committed)


if __name__ == "__main__":
    unittest.main(verbosity=2)
