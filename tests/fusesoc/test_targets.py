"""hwffd.core as its users run it: FuseSoC lints, simulates and maps the core, and writes nothing
outside build/.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

from tools.project_root import ROOT
from tools.tables import configurations

FUSESOC = pathlib.Path(sys.executable).parent / "fusesoc"
BUILT = ROOT / "build" / "fusesoc"


def row(name):
    """A row of the table as FuseSoC takes it."""
    configuration = configurations.find(configurations.read(), name)
    return [f"--{word}" for word in configuration.assignments()]


def outside():
    """Every file of the checkout that is not in a build folder."""
    paths = set()
    for folder, folders, files in os.walk(ROOT):
        folders[:] = [name for name in folders if name not in ("build", "build-trace", ".git")]
        paths.update(f"{folder}/{name}" for name in files)
    return paths


@pytest.fixture
def fusesoc(tmp_path):
    """(exit status, what it printed); nothing but build/ may have changed."""
    shutil.rmtree(BUILT, ignore_errors=True)
    before = outside()
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("MAKE", "MFLAGS", "XDG_"))}

    def run(target, *words, flags=()):
        result = subprocess.run(
            [FUSESOC, "run", *flags, f"--target={target}", "hwffd", *words], cwd=ROOT,
            env={**environment, "HOME": str(tmp_path)}, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        assert outside() - before == set()
        # yosys keeps a history in the home of whoever runs a script of Tcl.
        assert {path.name for path in tmp_path.iterdir()} <= {".yosys_history"}
        return result.returncode, result.stdout
    return run


@pytest.mark.parametrize("flags, words", (((), ()), ((), row("factored3-fx18-overlapped")),
                                          (("--flag", "axi"), row("basic-fp32-overlapped"))))
def test_lint(fusesoc, flags, words):
    status, output = fusesoc("lint", *words, flags=flags)
    assert (status, re.findall("%Warning.*", output)) == (0, []), output


def test_lint_refuses_a_bad_parameter(fusesoc):
    status, output = fusesoc("lint", "--FORMAT=5")
    assert status != 0 and "ERROR_" in output


# Another row's evaluator ignores what is loaded: the B-spline is not Bezier's.
@pytest.mark.parametrize("name, summary", (
    ("basic-fx18-overlapped", r"fixed-point words: 27 of 27 results, 0 differ, \d+ clocks\n"),
    ("basic-fp32-overlapped", r"binary32 words: 27 of 27 results, 0 differ, \d+ clocks\n"),
    ("affine3-fx17-overlapped-powers", r"27 of 27 results, [1-9]\d* differ")))
def test_sim(fusesoc, name, summary):
    status, output = fusesoc("sim", *row(name))
    assert (status == 0) == (" 0 differ" in summary), output
    assert re.search(f"hwffd_stream, {summary}" if " 0 " in summary else summary, output)


def test_synth(fusesoc):
    status, output = fusesoc("synth")
    assert status == 0, output
    (netlist,) = BUILT.glob("*/synth/*.json")
    cells = json.loads(netlist.read_text())["modules"]["hwffd_stream"]["cells"]
    kinds = {cell["type"] for cell in cells.values()}
    assert kinds >= {"LUT4", "TRELLIS_FF", "MULT18X18D"}
    assert {kind for kind in kinds if kind.startswith("$")} == set()
