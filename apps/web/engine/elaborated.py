"""The instances of a row's hwffd_stream, as Verilator elaborates it.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import subprocess
import tempfile
import xml.etree.ElementTree as xml
from collections import Counter

from tools.tables import features

ROOT = pathlib.Path(__file__).resolve().parents[3]
TOP = "hwffd_stream"


class ElaborationError(Exception):
    """A design that Verilator does not take, in one line."""


def _command(row, out):
    return ["verilator", "--xml-only", "--xml-output", str(out), "--Mdir", str(out.parent),
            "--default-language", "1364-2005", "-Wno-lint", "-Wno-fatal", "-DFFD_SIMULATION",
            "-F", "rtl/hwffd.f", "--top-module", TOP,
            *(f"-G{name}={value}" for name, value in features.of_top(TOP, row.parameters).items())]


class Tree:
    """Instances of modules, those of generate loops one by one."""

    def __init__(self, root):
        self.counts = Counter()  # module -> instances
        self._walk(root)

    def _walk(self, cell):
        # Of a module with parameters Verilator makes module__PARAMETERS.
        module = cell.get("submodname").split("__")[0]
        self.counts[module] += 1
        for below in cell.findall("cell"):
            self._walk(below)


def tree_of(row):
    """The tree of a row of rtl/configurations.csv. Raises ElaborationError."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "design.xml"
        result = subprocess.run(_command(row, out), cwd=ROOT, text=True,
                                capture_output=True, check=False)
        if result.returncode != 0 or not out.is_file():
            raise ElaborationError(f"{row.name}: Verilator: {(result.stderr.splitlines() or ['?'])[0]}")
        return Tree(xml.parse(out).getroot().find("cells/cell"))
