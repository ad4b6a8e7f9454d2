"""The size of a standalone core on a chip, as yosys maps it by the scripts of synth/.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import shutil
import subprocess
import tempfile

from tools.project_root import ROOT
from tools.standalone.configuration import Refused
from tools.synth import mapped_netlist

TARGETS = ("ecp5", "xilinx7")


def check(target):
    """Raises Refused where it cannot be mapped: before there is work to lose."""
    if target and not shutil.which("yosys"):
        raise Refused(f"--map {target}: yosys is not there; install it, or leave the option out")


def of(core, text, target):
    """({what is counted: number}, the version of yosys). Raises Refused."""
    with tempfile.TemporaryDirectory() as folder:
        source, netlist = pathlib.Path(folder) / "core.v", pathlib.Path(folder) / "netlist.json"
        source.write_text(text, encoding="utf-8")
        steps = (f"read_verilog {source}", f"hierarchy -check -top {core.prefix}", "script synth/prepare.ys",
                 f"script synth/{target}.ys", f"write_json {netlist}")
        result = subprocess.run(["yosys", "-Q", "-T", "-q", "-p", "; ".join(steps)], cwd=ROOT, text=True, check=False,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if result.returncode != 0:
            raise Refused(f"--map {target}: {(result.stdout.strip().splitlines() or ['yosys ends without a word'])[-1]}")
        modules = json.loads(netlist.read_text(encoding="utf-8"))["modules"]
    version = subprocess.run(["yosys", "-V"], text=True, check=True, stdout=subprocess.PIPE).stdout.split(" (")[0]
    # Flat, and without the models of the cells of the chip.
    return mapped_netlist.count(target, {"modules": {core.prefix: modules[core.prefix]}}, core.prefix), version
