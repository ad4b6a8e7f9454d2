"""rtl/organizations.csv: what it says, what is refused, what follows from it.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from tools.csv_table import TableError
from tools.project_root import ROOT
from tools.tables import configurations, organization_rtl, organizations

HEADER = ",".join(organizations.COLUMNS)
# Software reads these in CONFIG.org: a core of any version has them.
NUMBERS = {"basic": 0, "cg1": 1, "cg3": 3, "tree": 4, "parallel": 5, "factored": 6,
           "factored/3": 7, "affine": 10, "affine/3": 11, "affine/3x2": 12,
           "affine/64": 13, "affine/2": 14, "affine/6": 15, "affine/4": 16, "affine/4x3": 17,
           "jacobian/3": 18, "jet/3": 20, "walk": 22, "walk/2": 23}

ROW = "basic,0,tree SERIAL=1,1,product,1,64 * poly,0,64 * start,every,"


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
    "nothing behind the lanes' x": (row(org="factored/3x"), 2, "bad org"),
    "name twice": (TREE + TREE, 3, "twice"),
    "number twice": (row() + "\n" + TREE.replace(",4,", ",0,"), 4, "number 0 is that of 'basic'"),
    "number of one that went": (row(number="2"), 2, "number 2 was that of cg2, and is never given again"),
    "name of one that went": (row(org="cg2"), 2, "cg2 went with 0.3.0: take cg1"),
    "no module": (row(module=""), 2, "unknown module"),
    "no such module": (row(module="nothing"), 2, "there is no ffd_org_nothing.v"),
    "no such parameter": (row(module="tree SIZE=1"), 2, "of ffd_org_tree.v: SERIAL, FORMAT"),
    "no value": (row(module="tree SERIAL"), 2, "'SERIAL' is not NAME=NUMBER"),
    "no such form": (row(form="sum"), 2, "unknown form 'sum': one of product, factored, "),
    "units of 0": (row(units="0"), 2, "units is '0', 1 to 999 wanted"),
    "no clocks": (row(overlapped=""), 2, "overlapped: no formula"),
    "paper without the last": (row(last=""), 2, "last: a formula where paper has one"),
    "more than CONFIG.org has bits for": (row(number="256"), 2, "number is '256', 0 to 255"),
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


@pytest.fixture
def tree(checkout):
    checkout.copy("rtl/evaluator")
    return checkout


@pytest.mark.parametrize("rows, line, word", BAD.values(), ids=BAD)
def test_bad_tables(tree, rows, line, word):
    tree.put({f"rtl/{organizations.TABLE}": f"{HEADER}\n{rows}"})
    with pytest.raises(TableError) as caught:
        organizations.read(tree.root / "rtl")
    message, table = str(caught.value), tree.root / "rtl" / organizations.TABLE
    assert word in message
    assert message.startswith(f"{table}:{line}: " if line else f"{table}: ")


@pytest.mark.parametrize("name, paper, with_fused, overlapped", (
    ("basic", 640, 384, 192), ("cg1", 392, 292, 64), ("cg3", 344, 268, 64),
    ("tree", 96, 72, 24), ("parallel", 15, 12, 3)))
def test_formulas_are_those_of_the_paper(name, paper, with_fused, overlapped):
    unfused, fused = ({"n": 8, "poly": poly, "add": add, "start": 3}
                      for poly, add in ((6, 1), (3, 0)))
    formulas = organizations.read()[name].formulas
    assert formulas["paper"].value(**unfused) == paper
    assert formulas["paper"].value(**fused) == with_fused
    assert formulas["overlapped"].value(**unfused) == overlapped


def test_numbers_are_those_that_software_knows():
    numbers = {name: organization.number for name, organization in organizations.read().items()}
    assert {**numbers, **NUMBERS} == numbers


def backwards(path):
    """A table with its rows in the other order."""
    head, *rows = path.read_text().splitlines()
    return "\n".join([head, *reversed(rows)]) + "\n"


def test_numbers_do_not_follow_the_order_of_rows(tree):
    tree.put({"configurations.csv": backwards(configurations.TABLE)})
    numbers = {row.org: row.parameters["ORG"]
               for row in configurations.read(tree.root / "configurations.csv")}
    assert {**numbers, **NUMBERS} == numbers
    assert len(set(numbers.values())) == len(numbers)


def test_the_selector_has_the_numbers_in_any_order_of_lines(tree):
    name = f"rtl/{organizations.TABLE}"
    tree.put({name: backwards(ROOT / name)})
    assert organization_rtl.select_text(tree.root / "rtl") == (
        ROOT / "rtl/evaluator/ffd_org_select.v").read_text()
