"""A design of which a number chooses one of many mutants: single changes by yosys' `mutate`.

The design is flat, and without what does not reach an output, so that a mutant is of one place in which
something happens: bits that are constant or go nowhere are not there, and what the design does not say, such
as the address of a write that is none, is what costs nothing. The memories stay memories, without what a
simulator makes of a read that comes with a write.
The chosen number comes from the environment, HWFFD_MUTANT; with 0 the design is as it was.

SPDX-License-Identifier: Apache-2.0
"""

import fnmatch
import hashlib
import os
import pathlib
import re
import subprocess

from lab.mutants.built import MutantError
from tools.rtl import rtl_sources

CHOICE = "mutant"
FOR_ONE = 4  # times as many are listed where only some of the modules are asked for
_PORT = re.compile(r"^  input \[(\d+):0\] mutant;\n  wire \[\1:0\] mutant;\n", re.MULTILINE)
# Changes of a clock: the proof of equivalence takes every register for clocked by the same one.
# And yosys takes no read of a memory that has an enable but no clock.
_LEFT_OUT = re.compile(r"-port (?:\S*CLK|\S*clk) |-wire \S*clk |\$memrd\S* -port EN ")
_MEMORY = pathlib.Path("rtl/common/ffd_mem_sdp.v")
_MOST = re.compile(r"(?<=localparam MOST = )[^;]+(?=;)")
_IMPORT = 'import "DPI-C" function int hwffd_mutant();\n'


def _by_bits(memory, folder):
    """The memory with a column for each bit, so that a bit that nobody reads is dead, as a register's is."""
    text, slices = _MOST.subn("1", memory.read_text(encoding="utf-8"))
    if not slices:
        raise MutantError(f"{memory} has no localparam MOST")
    sliced = folder / memory.name
    sliced.write_text(text, encoding="utf-8")
    return sliced


def _read(root, model, folder):
    """The steps of yosys that read a model's design."""
    inside = sorted(path.relative_to(root) for path in root.glob("rtl/**/*.v*"))
    folders = " ".join(f"-I {path}" for path in sorted({source.parent for source in inside}))
    sources = [str(path) for path in inside if path.suffix == ".v" and path != _MEMORY]
    sources += [str(_by_bits(root / _MEMORY, folder))] if _MEMORY in inside else []
    sources += [os.path.relpath(source, root) for source in model.sources
                if not source.startswith(str(root / "rtl"))]
    values = " ".join(f"-set {name} {value}" for name, value in model.parameters)
    return [f"read_verilog -defer {folders} {' '.join(sources)}",
            *([f"chparam {values} {model.top}"] if values else []),
            f"hierarchy -check -top {model.top}", "proc", *rtl_sources.FLATTEN, "opt_expr -mux_undef",
            "opt -full", "wreduce", "opt -full"]


def yosys(root, path, steps, limit=None):
    """Runs the steps; whether they went well. Output lies beside the script."""
    path.write_text("\n".join([*steps, ""]), encoding="utf-8")
    with path.with_suffix(".log").open("w") as log:
        try:
            return subprocess.run(["yosys", "-q", "-s", path], cwd=root, check=False, stdout=log,
                                  stderr=log, timeout=limit).returncode == 0
        except subprocess.TimeoutExpired:
            return False


def base(folder):
    """The design as it was read, its cells under the names that mutants know."""
    return folder / "design.il"


def _chosen(lines, modules, number):
    """So many of those in modules of these names, but of what is left out."""
    mutations = [line for line in lines if line.startswith("mutate") and not _LEFT_OUT.search(line)
                 and any(fnmatch.fnmatchcase(module(line), pattern) for pattern in modules.split())]
    return mutations[:number]


def read(root, model, folder):
    """Reads the design. A number that follows from it, the same on every machine."""
    if not yosys(root, folder / "read.ys", [*_read(root, model, folder), f"write_rtlil {base(folder)}"]):
        raise MutantError(f"yosys cannot read {model.top}: see {folder / 'read.log'}")
    design = base(folder).read_text(encoding="utf-8")
    base(folder).write_text(design.replace(str(folder / _MEMORY.name), str(_MEMORY)), encoding="utf-8")
    return int(hashlib.sha256(text(folder).encode()).hexdigest()[:6], 16)


def text(folder):
    """The design that was read, without comments."""
    return "".join(line for line in base(folder).read_text(encoding="utf-8").splitlines(True)
                   if not line.startswith("#"))


def listed(root, folder, number, seed, modules="*"):
    """So many mutants at most of these modules of the design that was read, each the command that
    makes it."""
    path = folder / "mutants.txt"
    if not yosys(root, folder / "list.ys", [
            f"read_rtlil {base(folder)}",
            f"mutate -list {number * (1 if modules == '*' else FOR_ONE)} -seed {seed} -ctrl {CHOICE} 16 1 -o {path}"]):
        raise MutantError(f"yosys lists no mutants: see {folder / 'list.log'}")
    mutations = _chosen(path.read_text().splitlines(), modules, number)
    if not mutations:
        raise MutantError("0 mutants were applied: the design has nothing to change")
    return [re.sub(rf" -ctrl {CHOICE} \d+ \d+", "", line) for line in mutations]


def write(root, model, mutants, folder):
    """The design with all of them, in SystemVerilog: number n chooses the n-th of them, from 1."""
    chosen = [f"{mutant} -ctrl {CHOICE} 16 {number}" for number, mutant in enumerate(mutants, 1)]
    plain = folder / "plain.v"
    if not yosys(root, folder / "apply.ys", [f"read_rtlil {base(folder)}", *chosen, "opt_clean",
                                             f"write_verilog -noattr {plain}"]):
        raise MutantError(f"yosys cannot apply the mutants: see {folder / 'apply.log'}")
    text = plain.read_text(encoding="utf-8")
    start = text.index(f"module {model.top}(")
    end = text.index("endmodule", start)
    top, ports = _PORT.subn(
        r"  int number;\n  wire [\1:0] mutant = number[\1:0];\n  initial number = hwffd_mutant();\n",
        re.sub(rf",\s*{CHOICE}(?=,|\s*\))", "", text[start:end], count=1))
    if ports != 1:
        raise MutantError(f"{plain}: the top has no number of the mutant")
    out = folder / f"{model.top}.sv"
    out.write_text(_IMPORT + text[:start] + top + text[end:], encoding="utf-8")
    return out


def module(mutant):
    """The module of rtl/ that it changes: that of its cell, else of the wire, as their source says."""
    match = (re.search(r"-cell \S*\$rtl/(?:\w+/)+(\w+)\.v:", mutant)
             or re.search(r"-src \S*?(\w+)\.s?v:", mutant) or re.search(r"-module \\?(\S+)", mutant))
    return match[1]
