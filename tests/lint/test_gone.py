"""rtl/gone.csv: what a core no longer has is refused by name, with what replaces it, and no number of it comes
again.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from tools.csv_table import TableError
from tools.tables import configurations, gone, organizations

GONE = {("org", "cg2", 2): "cg1", ("evaluator", "bspline", 2): "pipelined",
        ("org", "jacobian/3x3", 19): "jacobian/3", ("org", "scan/4", 21): "walk",
        ("org", "nested", 8): "factored", ("org", "nested/3", 9): "factored/3"}
CG2 = "cg2 went with 0.3.0: take cg1"
BSPLINE = "bspline went with 0.3.0: take pipelined"
JACOBIAN = "jacobian/3x3 went with 0.3.0: take jacobian/3"


def test_what_went_stays_there():
    found = {(one.kind, one.name, one.number): one.instead for one in gone.read()}
    assert {**found, **GONE} == found


def test_neither_a_name_nor_a_number_is_given_again_and_what_to_take_is_there():
    live = {"org": {name: one.number for name, one in organizations.read().items()}, "evaluator": configurations.EVALUATORS}
    for one in gone.read():
        assert one.name not in live[one.kind] and one.number not in live[one.kind].values()
        assert one.instead in live[one.kind]


@pytest.mark.parametrize("rows, words", (
    ("row,cg2,2,cg1,0.3.0", "unknown kind 'row'"), ("org,cg2,x,cg1,0.3.0", "number is 'x'"), ("org,cg2", "columns")))
def test_bad_tables(checkout, rows, words):
    checkout.put({"gone.csv": f"{','.join(gone.COLUMNS)}\n{rows}\n"})
    with pytest.raises(TableError, match=words):
        gone.read(checkout.root / "gone.csv")


@pytest.mark.parametrize("words, said", (
    (("list", "--org", "cg2"), CG2), (("list", "--org", "cg2", "--format", "fx18"), CG2),
    (("build", "out", "--org", "cg2"), CG2), (("parameters", "cg2-fx18-overlapped"), CG2),
    (("models", "out.cpp", "--rows", "cg2-fx18-paper"), CG2),
    (("parameters", "basic-fx18-overlapped-bspline"), BSPLINE), (("list", "--org", "jacobian/3x3"), JACOBIAN),
    (("parameters", "jacobian3x3-fx17-overlapped"), JACOBIAN)))
def test_what_went_is_refused(call, words, said):
    assert call(configurations.main, *words) == (1, [], [f"configurations: {said}"])


@pytest.mark.parametrize("old, new, said", (
    ("good-row,basic", "good-row,cg2", CG2), ("pipelined", "bspline", BSPLINE)))
def test_a_row_that_has_what_went_is_refused(checkout, call, old, new, said):
    table = "\n".join((",".join(configurations.COLUMNS),
                       "good-row,basic,1,fx18,overlapped,pipelined,2,1,0,1,stream,test,test".replace(old, new)))
    checkout.put({"table.csv": table})
    path = checkout.root / "table.csv"
    assert call(configurations.main, "--table", path, "list") == (1, [], [f"configurations: {path}:2: {said}"])
