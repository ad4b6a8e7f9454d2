"""What design.py makes of elaborated cores: drawings, and the blocks that C++ knows.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as xml

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
SVG = "{http://www.w3.org/2000/svg}"
ROWS = ("factored3-fx18-overlapped", "cg1-fx18-overlapped", "walk-fx17-overlapped")


def run(folder, *rows):
    result = subprocess.run([sys.executable, "-B", "-m", "apps.web.engine.design", folder, folder / "design.cpp",
                             *rows], text=True, capture_output=True, check=False)
    return result.returncode, result.stdout, result.stderr


@pytest.fixture(scope="module", name="design")
def design_fixture(tmp_path_factory):
    """(row -> drawing, C++)"""
    folder = tmp_path_factory.mktemp("design")
    assert run(folder, *ROWS) == (0, "", "")
    script = (folder / "drawings.js").read_text(encoding="utf-8")
    assert script.startswith("self.HWFFD_DRAWINGS = ")
    drawings = json.loads(script[script.index("{"):].rstrip().rstrip(";"))
    return ({row: xml.fromstring(svg) for row, svg in drawings.items()},
            (folder / "design.cpp").read_text(encoding="utf-8"))


def blocks(drawing):
    return {element.get("id")[len("block-"):]: element for element in drawing.iter(f"{SVG}g")
            if element.get("class") == "block"}


def test_each_row_has_a_drawing(design):
    assert tuple(design[0]) == ROWS


@pytest.mark.parametrize("row", ROWS)
def test_blocks_are_those_of_the_cpp(design, row):
    drawings, cpp = design
    part = cpp[cpp.index(f'{{"{row}"'):].split("}},")[0]
    assert list(blocks(drawings[row])) == re.findall(r'^ +\{"([a-z-]+)"', part, re.MULTILINE)


def test_only_what_is_elaborated_is_drawn(design):
    factored, cg1, walk = (blocks(design[0][row]) for row in ROWS)
    assert "sum-u" in factored and "sum-u" not in cg1
    assert "generator" in cg1 and "generator" not in factored
    assert {"row", "planes", "vertex-s"} <= set(walk) and not {"row", "planes", "vertex-s"} & (set(cg1) | set(factored))
    names = {text.text for text in factored["memory"].iter(f"{SVG}text")}
    assert names == {"Memories x 32"}


@pytest.mark.parametrize("row", ROWS)
def test_a_drawing_has_no_colours_and_stays_inside(design, row):
    drawing = design[0][row]
    _, _, width, height = map(int, drawing.get("viewBox").split())
    for element in drawing.iter():
        for name in ("fill", "stroke"):
            assert element.get(name) in (None, "none", "currentColor")
    for box in drawing.iter(f"{SVG}rect"):
        assert int(box.get("x")) >= 0 and int(box.get("x")) + int(box.get("width")) <= width
        assert int(box.get("y")) >= 0 and int(box.get("y")) + int(box.get("height")) <= height


def test_an_unknown_row_is_one_line(tmp_path):
    status, out, err = run(tmp_path, "basic-fx99")
    assert (status, out, err.count("\n")) == (1, "", 1)
    assert "basic-fx99" in err
