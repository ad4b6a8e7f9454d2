"""rtl/organizations.csv: what it says, what is refused, what follows from it.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import shutil
import tempfile
import unittest

from workspace import ROOT

import configurations
import organization_rtl
import organizations
from tables import TableError

HEADER = ",".join(organizations.COLUMNS)
# Software reads these in CONFIG.org: a core of any version has them.
NUMBERS = {"basic": 0, "cg1": 1, "cg2": 2, "cg3": 3, "tree": 4, "parallel": 5, "factored": 6,
           "factored/3": 7, "nested": 8, "nested/3": 9}

ROW = "basic,0,tree SERIAL=1,1,product,1,64 * poly,0,64 * start,,0,0,every,"


def row(**changes):
    """A good row but for these cells."""
    cells = dict(zip(organizations.COLUMNS, ROW.split(",")), **changes)
    return ",".join(cells.values()) + "\n"


TREE = row(org="tree", number="4", module="tree", n="")

# what is wrong -> (rows, line of the fault or None, word of the message)
BAD = {
    "no rows": ("", None, "no organizations"),
    "column missing": ("basic,0\n", 2, "columns"),
    "name in capitals": (row(org="Basic"), 2, "bad org"),
    "nothing behind the stroke": (row(org="factored/"), 2, "bad org"),
    "name twice": (TREE + TREE, 3, "twice"),
    "number twice": (row() + "\n" + TREE.replace(",4,", ",0,"), 4, "number 0 is that of 'basic'"),
    "no module": (row(module=""), 2, "unknown module"),
    "no such module": (row(module="nothing"), 2, "there is no ffd_org_nothing.v"),
    "no such parameter": (row(module="tree SIZE=1"), 2, "of ffd_org_tree.v: SERIAL, FORMAT"),
    "no value": (row(module="tree SERIAL"), 2, "'SERIAL' is not NAME=NUMBER"),
    "no such form": (row(form="sum"), 2, "one of product, factored, nested"),
    "units of 0": (row(units="0"), 2, "units is '0', 1 to 999 wanted"),
    "no clocks": (row(overlapped=""), 2, "overlapped: no formula"),
    "paper without the last": (row(last=""), 2, "last: a formula where paper has one"),
    "more than CONFIG.org has bits for": (row(number="256"), 2, "number is '256', 0 to 255"),
    "seam in words": (row(seam_float="none"), 2, "seam_float is 'none'"),
    "no such target": (row(mapped="fx99"), 2, "unknown mapped 'fx99'"),
    "half a range": (row(mapped_n="2-"), 2, "as in 1-64"),
    "range the wrong way": (row(mapped_n="8-2"), 2, "1 to 64 wanted"),
    "range above 64": (row(mapped_n="2-65"), 2, "1 to 64 wanted"),
}
for wrong in ("", "-1", "x"):
    BAD[f"number '{wrong}'"] = (row(number=wrong), 2, "0 to 255 wanted")
for wrong in ("0", "65", "all"):
    BAD[f"n '{wrong}'"] = (row(n=wrong), 2, f"n is '{wrong}', 1 to 64 wanted")
for wrong in ("64 *", "sqrt(64)", "clocks", "log2(64; 2)", "max(64)", "64 ** 2", "'64'", "n.n",
              "max(n=1)", "-poly"):
    BAD[f"formula {wrong}"] = (row(overlapped=wrong), 2,
                               f"overlapped: '{wrong}' is not a formula of numbers, + - * / and n, ")


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

    def test_formulas_are_those_of_the_paper(self):
        unfused, fused = ({"n": 8, "poly": poly, "add": add, "start": 6, "read": 2, "contract": 5}
                          for poly, add in ((6, 1), (3, 0)))
        found = organizations.read()
        for name, paper, with_fused, overlapped in (
                ("basic", 640, 384, 384), ("cg1", 392, 292, 72), ("cg2", 356, 274, 64),
                ("cg3", 344, 268, 64), ("tree", 96, 72, 48), ("parallel", 15, 12, 6)):
            formulas = found[name].formulas
            self.assertEqual((formulas["paper"].value(**unfused), formulas["paper"].value(**fused),
                              formulas["overlapped"].value(**unfused)),
                             (paper, with_fused, overlapped), name)
        self.assertEqual(found["nested/3"].formulas["formed"].value(**unfused), 238)

    def test_numbers_are_those_that_software_knows(self):
        found = {name: one.number for name, one in organizations.read().items()}
        self.assertEqual({**found, **NUMBERS}, found)

    def test_numbers_do_not_follow_the_order_of_rows(self):
        rows = configurations.TABLE.read_text().splitlines()
        table = self.rtl / "configurations.csv"
        table.write_text("\n".join([rows[0], *reversed(rows[1:])]) + "\n")
        numbers = {row.org: row.parameters["ORG"] for row in configurations.read(table)}
        self.assertEqual({**numbers, **NUMBERS}, numbers)
        self.assertEqual(len(set(numbers.values())), len(numbers))

    def test_the_selector_has_the_numbers_in_any_order_of_lines(self):
        committed = (ROOT / "rtl/evaluator/ffd_org_select.v").read_text()
        lines = (ROOT / "rtl" / organizations.TABLE).read_text().splitlines()
        self.table.write_text("\n".join([lines[0], *reversed(lines[1:])]) + "\n")
        self.assertEqual(organization_rtl.select_text(self.rtl), committed)


if __name__ == "__main__":
    unittest.main(verbosity=2)
