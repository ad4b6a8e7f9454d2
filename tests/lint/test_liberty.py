"""scripts/liberty.py reads the cells of a library, and agrees with yosys on those of OSU 0.18 um.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import tempfile
import unittest
from unittest import mock

from workspace import ROOT

import liberty
import rtl

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


class Liberty(unittest.TestCase):
    def test_cells(self):
        self.assertEqual(liberty.parse(TEXT), {
            "INV": ("logic", {"area_um2": 16, "cells": 1}),
            "DFF": ("register", {"area_um2": 96.5, "cells": 1, "ff": 1})})

    def test_no_area_is_an_error(self):
        with self.assertRaisesRegex(liberty.LibertyError, "cell INV has no area"):
            liberty.parse(TEXT.replace("area : 16;", ""))

    def test_no_library_names_the_cure(self):
        with mock.patch.object(liberty, "PATH", pathlib.Path("/nowhere.lib")):
            with self.assertRaisesRegex(liberty.LibertyError, "/nowhere.lib: install .*qflow"):
                liberty.path()

    @unittest.skipUnless(liberty.PATH.is_file(), "no OSU library here")
    def test_areas_are_those_that_yosys_reads(self):
        """One cell of each kind, for `stat` to add up."""
        cells = liberty.cells()
        with tempfile.NamedTemporaryFile("w", suffix=".v") as source:
            source.write("module top;\n" + "".join(f"  {name} u_{name} ();\n" for name in cells)
                         + "endmodule\n")
            source.flush()
            status, output = rtl.run(["yosys", "-Q", "-T", "-p", (
                f"read_liberty -lib {liberty.PATH}; read_verilog {source.name}; "
                f"hierarchy -check -top top; stat -liberty {liberty.PATH}")])
        self.assertEqual(status, 0, output)
        area = float(re.search(r"Chip area for .*top.*: ([\d.]+)", output).group(1))
        self.assertEqual(area, sum(counts["area_um2"] for _, counts in cells.values()))
        print(f"liberty: {len(cells)} cells, {area:.0f} um2")


if __name__ == "__main__":
    unittest.main(verbosity=2)
