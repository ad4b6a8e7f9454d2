"""tools/synth/liberty.py reads the cells of a library, and agrees with yosys on those of OSU 0.18 um.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re

import pytest

from tools.rtl import rtl_sources
from tools.synth import liberty

TEXT = """\
library(small) {
cell (INV) {
  area : 16;
  pin(A) { direction : input; }
}
cell (DFF) {
area : 96.5;
  ff (D,Q) { next_state : "D"; }
}
cell (LATCH) {
  area : 8;
  latch (D,Q) { }
}
cell (TBUF) {
  area : 40;
  pin(Y) { three_state : "!EN"; }
}
}
"""


def test_cells():
    assert liberty.parse(TEXT) == {
        "INV": ("logic", {"area_um2": 16, "cells": 1}),
        "DFF": ("register", {"area_um2": 96.5, "cells": 1, "ff": 1})}


def test_no_area_is_an_error():
    with pytest.raises(liberty.LibertyError, match="cell INV has no area"):
        liberty.parse(TEXT.replace("area : 16;", ""))


def test_no_library_names_the_cure(monkeypatch):
    monkeypatch.setattr(liberty, "PATH", pathlib.Path("/nowhere.lib"))
    with pytest.raises(liberty.LibertyError, match="/nowhere.lib: install .*qflow"):
        liberty.path()


@pytest.mark.skipif(not liberty.PATH.is_file(), reason="no OSU library here")
def test_areas_are_those_that_yosys_reads(tmp_path):
    """One cell of each kind, for `stat` to add up."""
    cells, source = liberty.cells(), tmp_path / "top.v"
    source.write_text("module top;\n" + "".join(f"  {name} u_{name} ();\n" for name in cells)
                      + "endmodule\n")
    status, output = rtl_sources.run(["yosys", "-Q", "-T", "-p", (
        f"read_liberty -lib {liberty.PATH}; read_verilog {source}; "
        f"hierarchy -check -top top; stat -liberty {liberty.PATH}")])
    assert status == 0, output
    area = float(re.search(r"Chip area for .*top.*: ([\d.]+)", output).group(1))
    assert area == sum(counts["area_um2"] for _, counts in cells.values())
