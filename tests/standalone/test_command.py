"""The program that writes standalone cores: what it refuses, what it leaves behind, and folders side by side.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import re
import shutil

import pytest

from tests.standalone import bench
from tools.project_root import ROOT
from tools.standalone import command, configuration, folder
from tools.tables import parameter_space

LITTLE = {"ORG": 1, "N": 1, "FORMAT": 18, "EVALUATOR": 0, "INTERLEAVED": 0, "AXIS": 4}
SMALL = ("--org", "cg1", "--format", "fx18", "--axis", "4", "--features", "resident", "--vertices", "20")


@pytest.fixture(scope="module")
def little(tmp_path_factory):
    """Tests change nothing in its folder."""
    core = configuration.of_parameters(parameter_space.Space(), "hwffd_stream", "little", LITTLE)
    return bench.Folder(core, tmp_path_factory.mktemp("folder") / "little", 20)


@pytest.fixture
def made(tmp_path, capsys, monkeypatch):
    """The program in a folder: (exit status, what it printed, its complaints)"""
    monkeypatch.chdir(tmp_path)

    def called(*words):
        status = command.main([str(word) for word in words])
        captured = capsys.readouterr()
        return status, captured.out, captured.err
    return called


@pytest.mark.parametrize("words, status, complaint", [
    (("--org", "walk", "--format", "fp32"), 1, "want fixed point (ORG is 22, FORMAT is 0); the RTL refuses it by "
     "ERROR_ffd_num_offset_needs_fixed_point"),
    (("--org", "cg1", "--pages", "300"), 1, "PAGES is 300: 1 to 256 wanted; the RTL refuses it by "
     "ERROR_ffd_stream_pages_pages_must_be_1_to_256"),
    (("--org", "cg1", "--format", "fx18", "--n", "4"), 1, "ERROR_ffd_org_select_n_is_not_that_of_the_organization"),
    (("--org", "affine/64", "--add-latency", "3"), 1, "ERROR_ffd_eval_serial_add_latency_must_be_1"),
    (("--org", "cg1", "--features", "resident+halves"), 1, "ERROR_ffd_stream_header_features_do_not_go_together"),
    (("--features", "resident+pages+large"), 1, "--features resident+pages+large: large needs AXIS > 32"),
    (("--features", "resident+spans", "--spans", "1"), 1, "--features resident+spans: spans needs SPANS > 1"),
    (("--org", "walk", "--top", "hwffd_axi", "--data-width", "32"), 1, "ERROR_ffd_dma_width_read_data_width_must_be"),
    (("--org", "walk", "--format", "fx18"), 1, "no bit-true model of walk in fx18 with these units: it has fx17, fx32"),
    (("--org", "cg1", "--top", "hwffd_axi", "--set", "BUS_TIMEOUT=3"), 1, "BUS_TIMEOUT is 3: the memory of the testbench pauses"),
    (("--org", "cg1", "--set", "RESULT_WIDTH=256"), 1, "RESULT_WIDTH is 256: that is hwffd_stream inside hwffd_stream_bus"),
    (("--org", "cg1", "--set", "BESIDE=1"), 1, "BESIDE is 1: that is hwffd_stream inside hwffd_adjoint; 0 wanted"),
    (("--org", "walker"), 1, "--org walker: unknown organization: one of basic, cg1"),
    (("--org", "cg2"), 1, "cg2 went with 0.3.0: take cg1"),
    (("--set", "ORG=2"), 1, "ORG is 2: cg2 went with 0.3.0: take cg1"),
    (("--set", "EVALUATOR=2"), 1, "EVALUATOR is 2: bspline went with 0.3.0: take pipelined"),
    (("--evaluator", "bspline"), 2, "argument --evaluator: bspline went with 0.3.0: take pipelined"),
    (("--mul-latency", "2147483648"), 1, "MUL_LATENCY is 2147483648: 32 at most wanted of a core by itself"),
    (("--set", "WAITING=4294967296"), 1, "WAITING is 4294967296: 32768 at most wanted"),
    (("--org", "cg1", "--format", "fx40"), 1, "unknown format 'fx40': fp32, bfp32, or fx12 to fx32"),
    (("--row", "nothing"), 1, "no configuration named 'nothing'"),
    (("--org", "cg1", "--features", "resident+more"), 1, "unknown feature 'more'"),
    (("--org", "cg1", "--set", "MUL_LATENCY"), 1, "--set MUL_LATENCY: NAME=NUMBER wanted"),
    (("--org", "cg1", "--set", "COLOUR=1"), 1, "--set COLOUR=1: NAME=NUMBER wanted"),
    (("--org", "cg1", "--prefix", "1st"), 1, "--prefix 1st: at most 41 lower case letters, digits"),
    (("--org", "cg1", "--prefix", "a" * 42), 1, "at most 41 lower case letters"),
    (("--org", "cg1", "--prefix", "two__lines"), 1, "digits and single _ between them wanted"),
    (("--org", "cg1", "--prefix", "module"), 1, "--prefix module: a word of Verilog, VHDL or C++"),
    (("--org", "cg1", "--prefix", "always_ff"), 1, "--prefix always_ff: a word of Verilog, VHDL or C++"),
    (("--org", "cg1", "--prefix", "signal"), 1, "--prefix signal: a word of Verilog, VHDL or C++"),
    ((*SMALL, "--prefix", "event_o"), 1, "--prefix event_o: a name within the core; take another one"),
    (("--org", "cg1", "--vertices", "0"), 1, "--vertices 0: 1 to 100000 wanted"),
    (("--org", "cg1", "--data-width", "64"), 1, "--data-width: hwffd_stream has none"),
    (("--org", "cg1", "--axis", "many"), 2, "argument --axis: 'many' is no number"),
    (("--colour", "red"), 2, "unrecognized arguments: --colour red"),
])
def test_a_core_that_cannot_be_is_one_line(made, tmp_path, words, status, complaint):
    got, out, errors = made(*words, "-o", "core")
    assert (got, out) == (status, "") and complaint in errors
    assert re.fullmatch(r"hwffd core: [^\n]+\n", errors)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_cannot_be_written_is_one_line(made, tmp_path):
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "file").touch()
    (tmp_path / "file").touch()
    for path, complaint in ((os.fsdecode(b"no\xff"), "its name is not in UTF-8"), ("full", "the folder is not empty"), ("file", "is there, and no folder"),
                            ("no/core", "there is no folder")):
        status, out, errors = made(*SMALL, "-o", path)
        assert (status, out) == (1, "") and complaint in errors and errors.count("\n") == 1
    assert sorted(os.listdir(tmp_path)) == ["file", "full"] and os.listdir(tmp_path / "full") == ["file"]


def test_a_link_to_a_folder_stays_one(made, tmp_path):
    (tmp_path / "empty").mkdir()
    (tmp_path / "link").symlink_to("empty")
    assert made(*SMALL, "--prefix", "core", "-o", "link")[0] == 0
    assert (tmp_path / "link").is_symlink() and (tmp_path / "empty" / "core.v").is_file()
    assert sorted(os.listdir(tmp_path)) == ["empty", "link"]


def test_nothing_is_left_of_a_folder_that_fails(tmp_path, monkeypatch):
    monkeypatch.setattr(folder.os, "replace", lambda *_: (_ for _ in ()).throw(OSError("no room")))
    with pytest.raises(OSError, match="no room"):
        folder.write(tmp_path / "core", {"a": "text"})
    assert list(tmp_path.iterdir()) == []


def test_the_folder_has_what_it_says(made, tmp_path):
    (tmp_path / "core").mkdir()  # empty
    status, out, errors = made(*SMALL, "-o", "core")
    assert (status, errors) == (0, "") and out.startswith("core: hwffd_stream, cg1 in fx18, resident: ")
    names = {"README.md", "LICENSE", "interface.md", "core.v", "core_tb.v", "core_commands.hex", "core_results.hex",
             "core_model.hpp", "core.sdc", "core.xdc"}
    assert set(os.listdir(tmp_path / "core")) == names == set(out.strip().rpartition(": ")[2].split(", "))
    sheet = (tmp_path / "core" / "README.md").read_text()
    assert "hwffd core --org cg1 --format fx18 --axis 4 --features resident --vertices 20 -o core" in sheet
    assert "| 3 | vertices of the lattice | a beat for each vertex |" in sheet and "opcode 4" not in sheet
    assert "64 clocks from a vertex to the next" in sheet and "No release has mapped this configuration." in sheet
    assert len(sheet.splitlines()) <= 125  # two pages


@pytest.mark.parametrize("folder_name, prefix", [("round", "round"), ("my--ffd_", "my_ffd"), ("commands", "commands")])
def test_names_that_others_have_too(made, tmp_path, folder_name, prefix):
    """A function of C, names that Verilator has for itself, and what the testbench has."""
    assert made(*SMALL, "-o", folder_name)[0] == 0
    path = tmp_path / folder_name
    (path / "main.cpp").write_text(f'#define {prefix.upper()}_MODEL_IMPLEMENTATION\n#include "{prefix}_model.hpp"\n')
    assert bench.run("g++", "-std=c++17", "-Wall", "-Wextra", "-fsyntax-only", "main.cpp", cwd=path) == (0, "")
    assert bench.run("verilator_bin", "--lint-only", "--timing", "-Wall", "--top-module", f"{prefix}_tb", f"{prefix}.v",
                     f"{prefix}_tb.v", cwd=path) == (0, "")


@pytest.mark.parametrize("top, words, listed", [
    ("hwffd_stream", ("--features", "resident"), "0 1 2 3 4 5 6 8 9"),
    ("hwffd_stream", ("--features", "interleaved"), "0 1 2 3 8 9"),
    ("hwffd_stream", ("--format", "fp32", "--features", "resident+pages"), "0 1 2 3 4 5 6 7 8 10"),
    ("hwffd_stream_bus", ("--org", "affine/3", "--features", "resident+pages+fourth"), "0 1 2 3 4 5 6 8 9 10 12 14"),
    ("hwffd_stream_bus", ("--row", "affine3-fx17-overlapped-powers", "--features", "resident+packed"),
     "0 1 2 3 4 5 6 8 9 13"),
    ("hwffd_axi", ("--features", "resident+grids", "--set", "BUS_TIMEOUT=0"),
     "0 1 2 3 4 5 6 8 9 10 11 12 13 14 15 16 17 18 27"),
])
def test_the_data_sheet_is_of_this_core(made, tmp_path, top, words, listed):
    assert made("--top", top, "--axis", "4", *words, "--vertices", "1", "-o", "core")[0] == 0
    sheet = (tmp_path / "core" / "README.md").read_text()
    assert set(re.findall(r"`([\w.]+\.(?:v|hex|hpp|h|md|sdc|xdc)|LICENSE)`", sheet)) == {
        name for name in os.listdir(tmp_path / "core") if name != "README.md"}
    before, events = sheet.split("What is wrong ")
    assert events.startswith("sets a bit of the register `ERROR_STATUS`:" if top == "hwffd_axi" else
                             "is a pulse of a bit of `event_o`:")
    assert " ".join(re.findall(r"^\| (\d+) \| [A-Z]", events.split("\n## ")[0], re.MULTILINE)) == listed
    assert ("A lattice has 4 points an axis" in before) == ("| 2 | a whole lattice |" in before)


@pytest.mark.parametrize("words, multipliers, has", [
    ((), 6, "resident+interleaved"),
    (("--features", "resident+interleaved+derivatives+determinant"), 9, "resident+interleaved+derivatives+determinant")])
def test_a_core_that_a_release_has_mapped_has_its_size(made, tmp_path, words, multipliers, has):
    """Without an option it gives positions."""
    status, out, _ = made(*words, "--vertices", "1", "-o", "core")
    assert status == 0 and out.startswith(f"core: hwffd_stream, cg1 in fx18, {has}: ")
    assert re.search(rf"^\| ecp5 \| \d+ \| \d+ \| {multipliers} \| \d+ \| \d+\.\d+\.\d+ \|$",
                     (tmp_path / "core" / "README.md").read_text(), re.MULTILINE)


def test_the_latency_is_that_of_the_testbench(made, tmp_path, monkeypatch):
    assert made(*SMALL, "--simulate", "-o", "core")[0] == 0
    status, printed = bench.run("sh", "-c", "iverilog -g2005 -o tb core.v core_tb.v && vvp -N tb", cwd=tmp_path / "core")
    vertices, _, clocks, latency = bench.numbers(printed)
    assert (status, vertices) == (0, 20)
    assert f"takes {clocks:,} clocks for 20 vertices" in (text := (tmp_path / "core" / "README.md").read_text())
    assert f"by itself comes {latency} clocks after" in " ".join(text.split())
    monkeypatch.setenv("PATH", str(tmp_path))
    assert made(*SMALL, "--simulate", "-o", "other") == (1, "", "hwffd core: --simulate: iverilog is not there; install it, "
                                                         "or leave the option out\n")


def test_a_word_that_is_wrong_is_seen(little, monkeypatch, tmp_path):
    assert little.passed()[0] == 20
    monkeypatch.setattr(little, "path", pathlib.Path(shutil.copytree(little.path, tmp_path / "wrong")))
    results = little.path / "little_results.hex"
    lines = results.read_text().splitlines()
    lines[11] = lines[11][:-1] + ("0" if lines[11][-1] != "0" else "1")
    results.write_text("\n".join(lines) + "\n")
    status, output = little.simulated()
    assert status == 1 and "FAIL result 11 of 20" in output


@pytest.mark.parametrize("top, words", [("hwffd_stream", "commands"), ("hwffd_axi", "memory")])
def test_a_file_that_is_not_where_the_testbench_runs_is_seen(made, tmp_path, top, words):
    assert made(*SMALL, "--top", top, "-o", "core")[0] == 0
    files = [tmp_path / "core" / f"core{ending}.v" for ending in ("", "_tb")]
    assert bench.run("iverilog", "-g2005", "-o", "tb", *files, cwd=tmp_path) == (0, "")
    status, output = bench.run("vvp", "-N", "tb", cwd=tmp_path)
    assert status == 1 and f"FAIL core_{words}.hex and core_results.hex must be in the folder where this runs" in output


def test_two_cores_are_in_one_design(little, tmp_path):
    other = configuration.of_parameters(parameter_space.Space(), "hwffd_stream", "other", {
        "ORG": 0, "N": 1, "FORMAT": 18, "EVALUATOR": 0, "RESIDENT": 0, "AXIS": 4})
    folders = [little, bench.Folder(other, tmp_path / "other", 10)]
    files = [one.path / f"{one.prefix}.v" for one in folders]
    for one, vertices in zip(folders, (20, 10)):
        assert one.passed(sources=files, name="both")[0] == vertices
    # Nothing of one is called as anything of the other.
    modules = [set(re.findall(r"^module (\w+)", one.text(".v"), re.MULTILINE)) for one in folders]
    assert modules[0] and not modules[0] & modules[1]
    both = tmp_path / "both.v"
    both.write_text("module both;\n  little u_little ();\n  other u_other ();\nendmodule\n")
    status, output = bench.run("iverilog", "-g2005", "-t", "null", "-s", "both", *files, both)
    assert (status, output) == (0, "")


def test_free_parameters_at_their_ends_change_no_word(tmp_path):
    core = configuration.of_parameters(parameter_space.Space(), "hwffd_stream", "grids", {**LITTLE, "GRIDS": 1})
    grids = bench.Folder(core, tmp_path / "grids", 100)
    for end in 0, -1:
        values = {free.name: free.values[end] for free in core.free.values()}
        assert grids.passed(testbench=grids.with_parameters("grids", values), name=f"end{end}")[0] == 100


def test_a_free_parameter_beyond_its_range_stops_elaboration(little, tmp_path):
    assert little.core.free["MUL_LATENCY"].text == "1 to 8"
    (tmp_path / "tb.v").write_text(little.with_parameters("little", {"MUL_LATENCY": 9}))
    status, output = bench.run("iverilog", "-g2005", "-t", "null", "-s", "little_tb", little.path / "little.v", tmp_path / "tb.v")
    assert status != 0 and "ERROR_little_mul_latency_is_not_one_of_those_above" in output


@pytest.mark.parametrize("vertices", (20, pytest.param(1000, marks=pytest.mark.whole)))
def test_the_page_prints_what_it_says(made, tmp_path, vertices):
    """With 20 vertices but for these numbers and the clocks."""
    page = (ROOT / "docs" / "standalone.md").read_text(encoding="utf-8")
    blocks = re.compile(r"\n    hwffd core (.*)\n    (cd .*)\n")
    ((command_line, tools_line),) = blocks.findall(page)
    assert blocks.findall((ROOT / "docs" / "integrate.md").read_text(encoding="utf-8")) == [(command_line, tools_line)]
    (printed,) = re.findall(r"\n```text\n(.*?)```\n", page, re.DOTALL)
    status, out, errors = made(*command_line.split(), *([] if vertices == 1000 else ["--vertices", vertices]))
    assert (status, errors) == (0, "") and printed.startswith(out)
    status, passed = bench.run("sh", "-c", tools_line, cwd=tmp_path)
    wanted = printed.removeprefix(out)
    if vertices != 1000:
        passed = re.sub("[0-9]+ clocks", re.search("[0-9]+ clocks", wanted)[0], passed.replace(f" {vertices} ", " 1000 "))
    assert (status, passed) == (0, wanted)


@pytest.mark.whole
def test_a_core_is_mapped(made, tmp_path):
    """As yosys counts it: some cells are there in any case."""
    assert made(*SMALL, "--map", "ecp5", "-o", "core")[0] == 0
    (row,) = re.findall(r"^\| ecp5 \| (\d+) \| (\d+) \| (\d+) \| (\d+) \| Yosys [\d.]+ \|$",
                        (tmp_path / "core" / "README.md").read_text(), re.MULTILINE)
    luts, registers, multipliers, memories = map(int, row)
    assert luts > 500 and registers > 500 and multipliers >= 6 and memories >= 1


@pytest.mark.whole
@pytest.mark.parametrize("top", configuration.TOPS)
def test_verilator_says_the_same_as_icarus(tmp_path, top):
    core = configuration.of_parameters(parameter_space.Space(), top, "little", LITTLE)
    little = bench.Folder(core, tmp_path / "little", 20)
    passed = little.passed()
    status, output = bench.run("verilator", "--binary", "--timing", "--top-module", "little_tb", "little.v", "little_tb.v",
                               cwd=little.path)
    assert status == 0, output
    status, output = bench.run("obj_dir/Vlittle_tb", cwd=little.path)
    assert status == 0 and bench.numbers(output) == passed


def test_constraints_have_every_port(made, tmp_path):
    assert made(*SMALL, "--vertices", "1", "--top", "hwffd_axi", "-o", "core")[0] == 0
    header = re.search(r"\nmodule core #\(.*?\n\);", (tmp_path / "core" / "core.v").read_text(), re.DOTALL)[0]
    for suffix in "sdc", "xdc":
        text = (tmp_path / "core" / f"core.{suffix}").read_text()
        for direction in "input", "output":
            ports = set(re.findall(rf"^  {direction} +wire +(?:\[\d+:0\] +)?(\w+)", header, re.MULTILINE)) - {"aclk"}
            (line,) = re.findall(rf"^set {direction}s \[get_ports {{ (.*) }}\]$", text, re.MULTILINE)
            assert {name.removesuffix("[*]") for name in line.split()} == ports
        assert "set_false_path -to [get_ports irq_o]" in text
