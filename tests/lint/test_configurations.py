"""tools/tables/configurations.py: what it reads, writes and refuses.

SPDX-License-Identifier: Apache-2.0
"""

import os
import re
import subprocess

from tools.project_root import ROOT
from tools.tables import configurations

import pytest

HEADER = ",".join(configurations.COLUMNS)
GOOD = "good-row,basic,1,fx18,overlapped,pipelined,2,1,0,1,stream,test,test"

# what is wrong -> (table, line of the fault or None, word of the message)
BAD = {
    "no file": (None, None, "cannot be read"),
    "empty file": ("", 1, "first line"),
    "wrong header": ("name,org\n" + GOOD, 1, "first line"),
    "no rows": (HEADER + "\n", None, "no configurations"),
    "column missing": (f"{HEADER}\n{GOOD.rsplit(',', 1)[0]}\n", 2, "columns"),
    "column too many": (f"{HEADER}\n{GOOD},x\n", 2, "columns"),
    "name twice": (f"{HEADER}\n{GOOD}\n{GOOD}\n", 3, "twice"),
    "affine in binary32": (f"{HEADER}\ngood-row,affine,64,fp32,overlapped,pipelined,2,1,0,1,stream,"
                           "test,test\n", 2, "affine is exact in fixed point only"),
    "powers of one polynomial at a time": (
        f"{HEADER}\ngood-row,tree,4,fx18,overlapped,powers,2,1,0,1,stream,test,test\n", 2, "powers"),
    "powers in sequence": (
        f"{HEADER}\ngood-row,affine/64,1,fx17,overlapped,powers,2,1,0,1,stream,test,test\n", 2, "powers"),
    "powers in binary32": (
        f"{HEADER}\ngood-row,factored,64,fp32,overlapped,powers,2,1,0,1,stream,test,test\n", 2, "powers"),
    "streams of a row without": (f"{HEADER}\n{GOOD.replace('stream,test', 'evaluator,test')}\n", 2, "stream_tier"),
    "no tier of streams": (f"{HEADER}\n{GOOD.replace('test,test', 'test,none')}\n", 2, "stream_tier"),
    "streams in a tier that lacks the row": (f"{HEADER}\n{GOOD.replace('test,test', 'all,test')}\n", 2, "stream_tier"),
    "name twice after a blank line": (f"{HEADER}\n{GOOD}\n\n{GOOD}\n", 4, "twice"),
}
FIELDS = {
    "name": ("Good", "good_row", "1-row", "good-", "", "two words", "a;b"),
    "org": ("", "Basic", "nothing", "tree/", "tree/x", "/3"),
    "n": ("", "0", "65", "-1", "x", "1.0", "8"),
    "format": ("", "fp64", "fx", "fx11", "fx33", "fx018", "18", "FX18"),
    "schedule": ("", "late"),
    "evaluator": ("", "none"),
    "mul_latency": ("", "-1", "two", "100"),
    "add_latency": ("", "-1", "1 "),
    "fma_latency": ("", "-1", "x", "3"),
    "convert_latency": ("", "-1", "0x1"),
    "top": ("", "1", "stream axi"),
    "tier": ("", "test-all", "nightly", "none"),
    "stream_tier": ("", "test-all", "-"),
}
for column, values in FIELDS.items():
    for value in values:
        fields = dict(zip(configurations.COLUMNS, GOOD.split(",")), **{column: value})
        BAD[f"{column} '{value}'"] = (f"{HEADER}\n{','.join(fields.values())}\n", 2, column)
ROWS = (
    f"{HEADER}\n"
    "small,basic,1,fp32,overlapped,pipelined,2,1,0,1,stream,sim,sim\n"
    "good-row,tree,4,fx18,paper,iterative,5,4,0,3,axi,test,test\n"
    "large,parallel,64,fx32,overlapped,pipelined,2,1,0,1,evaluator,all,none\n"
)


@pytest.fixture
def script(checkout):
    """(exit status, what it printed, its complaints) of the script on that table"""
    def run(*arguments, text=None):
        if text is not None:
            checkout.put({"table.csv": text})
        table = checkout.root / "table.csv"
        return checkout.module("tools.tables.configurations", "--table", table, *arguments)
    return run


@pytest.mark.parametrize("text, line, word", BAD.values(), ids=BAD)
def test_bad_tables(checkout, script, text, line, word):
    status, out, error = script("list", text=text)
    assert (status, out, error.count("\n")) == (1, "", 1)
    assert word in error
    assert line is None or f"{checkout.root}/table.csv:{line}: " in error


def test_bad_requests(script):
    status, _, error = script("parameters", "other", text=f"{HEADER}\n{GOOD}\n")
    assert status == 1 and "no configuration named 'other'" in error
    assert script("nothing")[0] == 2


def test_bad_table_leaves_the_output_alone(checkout, script):
    checkout.put({"out/configurations.cmake": "before"})
    assert script("build", "out", text=HEADER)[0] == 1
    assert checkout.text("out/configurations.cmake") == "before"


def test_committed_table():
    assert configurations.of_tier(configurations.read(), "test")


@pytest.mark.parametrize("tier, names", (("sim", "small\n"), ("test", "small\ngood-row\n"),
                                         ("all", "small\ngood-row\nlarge\n")))
def test_tiers_include_smaller_ones(script, tier, names):
    assert script("list", "--tier", tier, text=ROWS)[1] == names


def test_streams_have_a_tier_of_their_own(script):
    rows = ROWS.replace("axi,test,test", "axi,sim,all")
    for top in ("stream", "axi"):
        assert "good-row" not in script("list", "--tier", "test", "--top", top, text=rows)[1]
        assert "good-row" in script("list", "--tier", "all", "--top", top, text=rows)[1]
        # What counts lines has the streams of all its rows.
        assert "good-row" in script("list", "--tier", "cover", "--top", top, text=rows)[1]
    assert "good-row" in script("list", "--tier", "sim", text=rows)[1]


@pytest.mark.parametrize("words, tier", (
    ((), "sim"), (("--org", "tree"), "test"), (("--format", "fx18", "--schedule", "paper"), "test"),
    (("--org", "tree", "--top", "axi"), "all"), (("--org", "none"), "all")))
def test_smallest_tier(script, words, tier):
    rows = ROWS.replace("paper,iterative,5,4,0,3,axi", "paper,iterative,5,4,0,3,stream")
    assert script("tier", "--top", "stream", *words, text=rows) == (0, f"{tier}\n", "")


def test_parameters(script):
    words = ("ORG=4 N=4 FORMAT=18 SCHEDULE=1 EVALUATOR=1 MUL_LATENCY=5 ADD_LATENCY=4 FMA_LATENCY=0 "
             "CONVERT_LATENCY=3 PAGED=0 FOURTH=0 GRIDS=0 PACKED=0 MARKS=0 RESIDENT=1 INTERLEAVED=1 DERIVATIVES=1 "
             "DETERMINANT=1 HALVES=0")
    for option, prefix in (((), ""), (("--fusesoc",), "--"), (("--verilator",), "-G")):
        assert script("parameters", *option, "good-row", text=ROWS)[1] == " ".join(
            prefix + word for word in words.split()) + "\n"


# file of a build of tier test -> what stands in it; what does not, behind the last
BUILT = {
    "configurations.cmake": (
        "set(HWFFD_CONFIGURATION_IDENTIFIERS small good_row large)\n",
        "set(HWFFD_TIER_IDENTIFIERS small good_row)\n", "set(HWFFD_AXI_IDENTIFIERS good_row)\n",
        "set(HWFFD_SELECTED_IDENTIFIERS small large)\n",
        "set(HWFFD_STREAM_IDENTIFIERS small good_row)\n",
        "set(HWFFD_CONFIGURATION_PARAMETERS_good_row ORG=4 N=4 FORMAT=18 ", "nothing"),
    "configurations.cpp": (
        '{"good-row", "tree", 4, "fx18", "paper", "iterative", 5, 4, 0, 3, "test", "test"},', '"large"', "V"),
    "models.cpp": ("EvaluatorModelOf<Fixed<18>, OrgTree>", "OrgBasic"),
    "stream_core_factory.cpp": ('#include "Vgood_row.h"', "large"),
    "axi_core_factory.cpp": ('#include "Vgood_row_axi.h"', "Vsmall"),
    "evaluator_core_factory.cpp": ('#include "Vgood_row_evaluator.h"', "Vsmall", "large"),
    "selected_core_factory.cpp": ('#include "Vlarge_evaluator.h"', "Vsmall", "good_row"),
}


@pytest.mark.parametrize("name", BUILT)
def test_files_of_a_build(checkout, script, name):
    rows = ROWS.replace("large,parallel,64,fx32", "large,basic,1,fp32")
    assert script("build", "out", "--tier", "test", "--org", "basic", text=rows) == (0, "", "")
    text, (*present, absent) = checkout.text(f"out/{name}"), BUILT[name]
    assert [part for part in present if part not in text] == []
    assert absent not in text
    assert {path.name for path in (checkout.root / "out").iterdir()} == set(BUILT)


def test_many_float_units_are_wide():
    wide = {row.name: row.wide for row in configurations.read()}
    for name in ("tree16-fp32-overlapped", "factored-fp32-overlapped",
                 "parallel-fp32-paper-fmac"):
        assert wide[name], name
    for name in ("tree8-fp32-overlapped", "cg3-fp32-paper", "factored-fx18-overlapped"):
        assert not wide[name], name


def test_selection(script):
    assert script("list", "--n", "4", "--format", "fx18", text=ROWS)[1] == "good-row\n"
    status, _, error = script("list", "--n", "3")
    assert status == 1
    assert re.search(r"^configurations: N=3: unknown here: one of [0-9, ]+\n$", error)


def test_the_factory_has_the_rows_asked_for(checkout, script):
    script("factory", "out.cpp", "--suffix", "_netlist", "--rows", "good-row", text=ROWS)
    assert '#include "Vgood_row_netlist.h"' in checkout.text("out.cpp")
    assert "Vsmall" not in checkout.text("out.cpp")


def test_there_are_models_of_the_rows_asked_for(checkout, script):
    script("models", "out.cpp", "--rows", "good-row", text=ROWS)
    assert "EvaluatorModelOf<Fixed<18>, OrgTree>" in checkout.text("out.cpp")
    assert "fx32" not in checkout.text("out.cpp")


def test_output_is_written_only_when_changed(checkout, script):
    script("build", "out", text=ROWS)
    files = sorted((checkout.root / "out").iterdir())
    for file in files:
        os.utime(file, (1, 1))
    script("build", "out")
    assert {file.stat().st_mtime for file in files} == {1}
    script("build", "out", text=ROWS.replace(",4,fx18", ",8,fx18"))
    assert [file.name for file in files if file.stat().st_mtime != 1] == [
        "configurations.cmake", "configurations.cpp"]


@pytest.mark.parametrize("head, row, wrong", (
    ("FEATURES,PAGES", "pages+resident,2", ""),
    ("FEATURES,PAGES", "pages+page,2", "cores.csv:7: FEATURES=pages+page: unknown feature 'page': some of pages, resident wanted"),
    ("FEATURES PAGES", "257", "cores.csv:7: 1 cells, 2 wanted: FEATURES PAGES")))
def test_a_row_of_a_table_of_cmake(tmp_path, head, row, wrong):
    (tmp_path / "row.cmake").write_text(f"""
include({ROOT}/cmake/HwffdTable.cmake)
set(HWFFD_FEATURES pages resident)
set(HWFFD_FEATURE_pages 1)
set(HWFFD_FEATURE_resident 256)
hwffd_row(cores.csv:6 "FEATURES PAGES" "resident 1")  # what a row has set does not change how the next is read
hwffd_row(cores.csv:7 "{head}" "{row}")
message("${{parameters}} ${{PAGES}}")
""")
    done = subprocess.run(["cmake", "-P", str(tmp_path / "row.cmake")], capture_output=True, text=True, check=False)
    assert (done.returncode == 0) == (not wrong)
    assert (wrong or "FEATURES=257;PAGES=2 2") in " ".join(done.stderr.split())


@pytest.mark.parametrize("given, wanted", (
    ("FEATURES=pages+resident AXIS=8", "AXIS=8;PAGED=1;RESIDENT=1"),
    ("FEATURES=256", "PAGED=0;RESIDENT=1"),
    ("AXIS=8", "AXIS=8;PAGED=1;RESIDENT=0"),
    ("AXIS=8 FEATURES=large", "core: large in FEATURES and AXIS above 32 come together; AXIS is 8"),
    ("SPANS=2 FEATURES=1", "core: spans in FEATURES and SPANS above 1 come together; SPANS is 2")))
def test_features_are_parameters_of_a_core(tmp_path, given, wanted):
    (tmp_path / "core.cmake").write_text(f"""
cmake_minimum_required(VERSION 3.18)
include({ROOT}/cmake/HwffdTable.cmake)
set(HWFFD_CORES core)
set(HWFFD_USUAL_FEATURES pages)
set(HWFFD_FEATURES pages large spans resident)
set(HWFFD_FEATURE_pages 1)
set(HWFFD_FEATURE_large 2)
set(HWFFD_FEATURE_spans 8)
set(HWFFD_FEATURE_resident 256)
set(HWFFD_FOLLOWS large spans)
set(HWFFD_FOLLOWS_large AXIS 32)
set(HWFFD_FOLLOWS_spans SPANS 1)
set(HWFFD_PARAMETER_OF_pages PAGED)
set(HWFFD_PARAMETER_OF_resident RESIDENT)
hwffd_feature_parameters(of_core core {given})
hwffd_feature_parameters(of_part part {given})
message("${{of_core}} ${{of_part}}")
""")
    done = subprocess.run(["cmake", "-P", str(tmp_path / "core.cmake")], capture_output=True, text=True, check=False)
    if "together" in wanted:
        assert done.returncode != 0 and wanted in " ".join(done.stderr.split())
        return
    assert done.returncode == 0
    within = given.replace("pages+resident AXIS=8", "257").replace("FEATURES=257", "AXIS=8;FEATURES=257")
    assert done.stderr.strip() == f"{wanted} {within}"
