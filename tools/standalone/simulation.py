"""What the testbench of a standalone core says in Icarus: its latency, for the data sheet.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass

from tools.standalone.configuration import Refused

_PASSED = re.compile(r"^PASS (\d+) vertices, \d+ results, (\d+) clocks, (?:latency (\d+)|\d+ packets)$", re.MULTILINE)


@dataclass(frozen=True)
class Run:
    vertices: int
    clocks: int
    latency: "int | None"  # of a vertex by itself, of a core between two streams
    simulator: str


def check(wanted):
    """Raises Refused where there is no simulator: before there is work to lose."""
    if wanted and not (shutil.which("iverilog") and shutil.which("vvp")):
        raise Refused("--simulate: iverilog is not there; install it, or leave the option out")


def of(core, texts):
    """The run of a core's testbench, of the files of its folder. Raises Refused where it does not pass."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in texts.items():
            (pathlib.Path(folder) / name).write_text(text, encoding="utf-8")
        said = _said(folder, "iverilog", "-g2005", "-o", "tb", f"{core.prefix}.v", f"{core.prefix}_tb.v")
        said += _said(folder, "vvp", "-N", "tb")
    passed = _PASSED.search(said)
    if not passed:
        raise Refused(f"--simulate: {(said.strip().splitlines() or ['the testbench ends without a word'])[-1]}")
    vertices, clocks, latency = passed.groups()
    version = re.search(r"version ([\d.]+)", _said(None, "iverilog", "-V"))
    return Run(int(vertices), int(clocks), int(latency) if latency else None,
               f"Icarus Verilog {version[1]}" if version else "Icarus Verilog")


def _said(folder, *words):
    return subprocess.run(words, cwd=folder, text=True, check=False, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT).stdout
