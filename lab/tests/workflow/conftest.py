"""A copy of the tables and sources, with stand-ins for the programs that the workflow asks for their versions.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import re
import sys

import pytest

from lab.tests.upsets import stand_ins
from tools.synth import nextpnr

ROOT = pathlib.Path(__file__).resolve().parents[3]

WORKFLOW = ROOT / "lab" / "workflow"
SNAKEMAKE = pathlib.Path(sys.executable).parent / "snakemake"
SOURCES = ("rtl", "synth", "lab/mutants", "lab/soak", "lab/upsets", "tests/bus", "tests/evaluator",
           "tests/system", "tests/unit", "tb", "cores")
# A test program that passes, but for the seed that FAILS.
PROGRAM = """#!{python}
import json, os
seed = int(os.environ["SEED"])
case = {{"classname": "Few", "name": "Lines", "status": "RUN", **({{"failures": [{{}}]}} if seed == {fails} else {{}})}}
json.dump({{"testsuites": [{{"testsuite": [case]}}]}}, open(os.environ["GTEST_OUTPUT"].removeprefix("json:"), "w"))
print("1 seeds, 5 results, 70 clocks")
"""
# Of a build: it puts that program where the tables say that programs are.
CMAKE = """#!{python}
import csv, pathlib, shutil, sys
print(*sys.argv[1:], file=open("{root}/built", "a"))
for row in csv.DictReader(open("{root}/lab/soak/traffic.csv")):
    path = pathlib.Path("{root}/build/lab", row["program"])
    path.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy("{root}/program", path)
"""


class Tree:
    """The copy, and the workflow on it."""

    def __init__(self, checkout):
        self.root, self.put, self.text, self._run = checkout.root, checkout.put, checkout.text, checkout.run
        checkout.copy(*SOURCES)
        routers = {family.route[0] for family in nextpnr.FAMILIES.values()}
        packers = {family.pack[0] for family in nextpnr.FAMILIES.values()}
        # yosys elaborates nothing: keys are those of the sources, which takes seconds.
        self.put({f"bin/{name}": f'#!/bin/sh\n[ "$1" = -V ] || [ "$1" = --version ] && echo {name} 1\n'
                  for name in ("yosys", *routers, *packers)}, 0o755)
        (self.root / "build").mkdir()

    def buildable(self, fails=-1):
        """Stand-ins for CMake and for what it builds."""
        self.put({"bin/yosys": stand_ins.yosys(), **stand_ins.programs("build/lab/upsets", "build/lab/product/upsets"),
                  "program": PROGRAM.format(python=sys.executable, fails=fails),
                  "bin/cmake": CMAKE.format(python=sys.executable, root=self.root)}, 0o755)

    def snakemake(self, profile, *words, snakefile=WORKFLOW / "Snakefile", **config):
        """(exit status, what it said)"""
        environment = {**os.environ, "PATH": f"{self.root}/bin{os.pathsep}{os.environ['PATH']}"}
        status, out, errors = self._run(
            SNAKEMAKE, "--snakefile", snakefile, "--directory", self.root / "build", "--profile",
            WORKFLOW / "profiles" / profile, "--workflow-profile", ROOT / "synth" / "profiles" / "default", *words,
            "--config", f"root={self.root}", *(f"{name}={value}" for name, value in config.items()), env=environment)
        return status, out + errors


def counted(output):
    """Jobs of each rule, as Snakemake's table has them."""
    rows = re.search(r"^job +count\n-+ +-+\n((?:\w+ +\d+\n)+)", output, re.MULTILINE)
    assert rows, output
    return {name: int(number) for name, number in map(str.split, rows[1].splitlines())}


@pytest.fixture
def tree(checkout):
    return Tree(checkout)
