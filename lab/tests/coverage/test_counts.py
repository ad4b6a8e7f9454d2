"""Counts of a few places written by hand: what is made of them, and what is refused.

SPDX-License-Identifier: Apache-2.0
"""

import json
import re

import pytest

from lab.figures.studies import coverage
from lab.rtl_coverage import annotated, counts as counting, exclusions, report as reporting
from tools import whole_file
from tools.project_root import ROOT
from tools.reports.results import Results

SOURCE = ["module ffd_a;", "wire w;", "always @*", "if (x)", "y = 1;", "endmodule"]
WIDE = """v_line/ffd_a\t3\t1\tblock\t3\t7
v_branch/ffd_a\t4\t2\tif\t4-5\t0
v_branch/ffd_a\t4\t3\telse\t\t7
v_toggle/ffd_a\t2\t1\tw[0]\t\t3
v_toggle/ffd_a\t2\t1\tw[1]\t\t1
"""
NARROW = "v_branch/ffd_a__W8\t4\t2\tif\t4-5\t3\n"


def read(folder, *texts):
    paths = [folder / f"{number}.tsv" for number in range(len(texts))]
    for path, text in zip(paths, texts):
        path.write_text(text)
    return counting.read(paths)


def rows(counts, left_out=frozenset(), wanted=("ffd_a",)):
    return reporting.rows(wanted, counts, left_out)


def test_a_place_is_run_if_any_parameters_run_it(tmp_path):
    assert rows(read(tmp_path, WIDE))[0]["branch"] == 50
    row = rows(read(tmp_path, WIDE, NARROW))[0]
    assert (row["line"], row["branch"], row["toggle"]) == (100, 100, 50)
    assert row["missed_places"] == ["toggle 2 w[1]"]


def test_a_bit_must_rise_and_fall(tmp_path):
    fallen = "v_toggle/ffd_a__W8\t2\t1\tw[1]\t\t2\n"
    assert rows(read(tmp_path, WIDE, fallen))[0]["toggle"] == 100
    assert rows(read(tmp_path, WIDE, fallen.replace("\t2\n", "\t1\n")))[0]["toggle"] == 50


def test_lines_of_a_branch_are_lines(tmp_path):
    row = rows(read(tmp_path, WIDE))[0]
    assert (row["lines"], row["line"]) == (3, 66.67)  # line 4 is of `else`, too
    assert "line 5" in row["missed_places"]


def test_tables_and_figures_are_of_what_is_reported(tmp_path):
    report = {"programs": 1, "share": 1, "rows": rows(read(tmp_path, WIDE), wanted=("ffd_a", "ffd_b")),
              "cpp": [{"folder": "golden", "lines": 20, "line": 95.0, "branches": 10, "branch": 90.0}]}
    whole_file.write(tmp_path / "build" / "reports" / "coverage.json", json.dumps(report))
    reports = Results(tmp_path)
    assert coverage.modules(reports).rows == [["`ffd_a`", "3", "66.67", "2", "50.00", "2", "50.00", "0"],
                                              ["`ffd_b`", "0", "-", "0", "-", "0", "-", "0"]]
    assert "golden/" in coverage.printed(reports)
    assert {name: round(figure(reports), 3) for name, figure in coverage.FIGURES.items()} == {
        "modules": 2, "modules_full": 0, "line": 0.667, "branch": 0.5, "toggle": 0.5, "toggle_of_all": 0.5, "excluded": 0,
        "programs": 1}


@pytest.mark.parametrize("toggle, full", ((None, 1), (99.0, 1), (98.9, 0), (0.0, 0)))
def test_modules_as_asked(tmp_path, toggle, full):
    row = {"line": 100.0, "lines": 2, "branch": None, "branches": 0, "toggle": toggle, "toggles": 4, "excluded": 0}
    whole_file.write(tmp_path / "build" / "reports" / "coverage.json", json.dumps({"rows": [row]}))
    assert Results(tmp_path, modules={"coverage": coverage}).figure("coverage", "modules_full") == full


def test_what_falls_short_is_named(tmp_path):
    report = {"rows": rows(read(tmp_path, WIDE), wanted=("ffd_a", "ffd_b")),
              "cpp": [{"folder": "golden", "line": 95.0, "branch": 89.9}]}
    assert reporting.faults(report) == [
        "ffd_a: line 66.67 %, need 100", "ffd_a: branch 50.0 %, need 100", "ffd_a: toggle 50.0 %, need 99",
        "ffd_b: no program has it", "golden/: branch 89.9 %, need 90"]


def test_exclusions_leave_out_what_they_name_and_must_be_needed(tmp_path):
    counts = read(tmp_path, WIDE)
    reasons = [{"module": "ffd_a", "kind": "toggle", "what": "w[1]", "reason": "always 0"},
               {"module": "ffd_a", "kind": "branch", "what": "if (x)", "reason": "x is 0 here"},
               {"module": "ffd_a", "kind": "line", "what": "y = 1;", "reason": "x is 0 here"}]
    left_out, idle = exclusions.excluded(reasons, counts, {"ffd_a": SOURCE})
    assert idle == []
    row = rows(counts, left_out)[0]
    assert (row["line"], row["branch"], row["toggle"], row["excluded"]) == (100, 100, 100, 3)
    more = [{**reasons[0], "what": "w[0]"}, *reasons, {**reasons[1], "what": "if (z)"}]
    assert exclusions.excluded(more, counts, {"ffd_a": SOURCE}) == (left_out, [
        f"exclusions.csv: ffd_a, {what}: no such place is missed: take the row out" for what in ("toggle w[0]", "branch if (z)")])


def test_exclusions_of_several_bits_and_of_a_module(tmp_path):
    counts = read(tmp_path, WIDE.replace("w[0]\t\t3", "w[0]\t\t2"))
    bits = {"module": "ffd_a", "kind": "toggle", "what": "w[0-1]", "reason": "always 0"}
    assert {place.what for place in exclusions.excluded([bits], counts, {})[0]} == {"w[0]", "w[1]"}
    assert len(exclusions.excluded([{**bits, "what": "w[2-9]"}], counts, {})[1]) == 1
    module = {"module": "ffd_b", "kind": "module", "what": "all", "reason": "for boards of others"}
    assert exclusions.unneeded([module], counts) == ({"ffd_b"}, [])
    assert exclusions.excluded([module], counts, {}) == (set(), [])
    assert exclusions.unneeded([{**module, "module": "ffd_a"}], counts) == (
        set(), ["exclusions.csv: ffd_a, module: a program has it: take the row out"])


def test_exclusions_need_a_reason(tmp_path):
    path = tmp_path / "exclusions.csv"
    path.write_text("module,kind,what,reason\nffd_a,toggle,w,\n")
    with pytest.raises(counting.CoverageError, match="exclusions.csv:2"):
        exclusions.read(path)


def test_the_table_names_what_is_in_the_sources():
    """Names that have changed are found before the tests have run for hours."""
    sources = {path.stem: path.read_text(encoding="utf-8") for path in (ROOT / "rtl").rglob("*.v")}
    for row in exclusions.read(ROOT / "lab" / "rtl_coverage" / "exclusions.csv"):
        source = sources[row["module"]]
        if row["kind"] == "toggle":
            name = re.split(r"[.\[]", row["what"])[-2 if "[" in row["what"] else -1]
            assert re.search(rf"\b{name}\b", re.sub("//.*", "", source)), row
        elif row["kind"] != exclusions.MODULE:
            assert row["what"] in map(str.strip, source.splitlines()), row


def test_nothing_counted_is_an_error(tmp_path):
    with pytest.raises(counting.CoverageError, match="nothing was counted"):
        read(tmp_path, "")
    with pytest.raises(counting.CoverageError, match="not a count"):
        read(tmp_path, "v_line/ffd_a\t3\n")


def test_annotated_source_shows_what_was_missed(tmp_path):
    counts = read(tmp_path, WIDE)
    text = annotated.text(SOURCE, counting.modules(counts)["ffd_a"], counts, frozenset())
    assert "           7  always @*\n" in text
    assert "           0  y = 1;\n" in text
    assert "MISSED toggle w[1]\n" in text and "w[0]" not in text
