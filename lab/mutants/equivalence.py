"""Whether a mutant changes anything: proved by ABC, of every step from where the design can be, or by what is
equal in the design before and after the change; else whether it can: inputs are found after which an output differs.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import subprocess

from lab.mutants import aiger
from lab.mutants.netlist import base, yosys

# What a memory holds and a multiplier gives stays the same as long as nothing differs that goes in, so a
# proof may cut them.
SMALL = 20_000  # bits of memories that may become registers
# Registers are bits before, so that a memory which only feeds bits that nobody reads is none.
CUT, WHOLE = ("simplemap", "opt_clean", "expose -evert t:$mem_v2 t:$mul", "opt_clean"), ("memory_map", "opt_clean")


def domain(top):
    """The file that says for which inputs a design is made, in a list; an empty one where that is all."""
    return list(pathlib.Path(__file__).parent.glob(f"{top}.v"))


def _inside(steps, top):
    """(steps that make a design, its top) with the inputs that it is made for."""
    if not domain(top):
        return steps, top
    return [*steps, f"read_verilog {domain(top)[0]}", "hierarchy -top domain", "proc", "flatten", "opt_clean"], "domain"


def _side(steps, top, memories, name, out):
    """The design by one name."""
    steps, top = _inside(steps, top)
    return ["design -reset", *steps, f"hierarchy -top {top}", "memory_collect", *memories,
            f"rename {top} {name}", f"write_rtlil {out}"]


def _public(design, mutant):
    """A design in RTLIL and its change, multipliers by names that may become those of ports."""
    return (design.replace("  cell $mul $", "  cell $mul \\$"),
            re.sub(r"(?<=-cell )(?=\$\S*\$mul\$)", r"\\", mutant))


def _before_and_after(mutant, path):
    """The steps that read the design, and those that read it and make the change."""
    text, mutant = _public(base(path.parent).read_text(encoding="utf-8"), mutant)
    own = path.with_suffix(".base.il")
    own.write_text(text, encoding="utf-8")
    return [f"read_rtlil {own}"], [f"read_rtlil {own}", mutant]


def _miter(mutant, top, memories, path):
    """The steps that make one module of the design before and after the change: `trigger` tells that an
    output differs."""
    before, after = _before_and_after(mutant, path)
    gold, gate = (path.with_suffix(f".{name}.il") for name in ("gold", "gate"))
    return [*_side(before, top, memories, "gold", gold),
            *_side(after, top, memories, "gate", gate),
            "design -reset", f"read_rtlil {gold}", f"read_rtlil {gate}",
            "miter -equiv -flatten gold gate miter", "hierarchy -top miter"]


def _alike(root, steps, path, limit):
    """The graph of a design whose registers have the names that they have with the change, or without it;
    or None."""
    design = path.with_suffix(".aig")
    written = yosys(root, path, [
        *steps, *CUT, "async2sync", "techmap", "opt_clean", "dfflegalize -cell $_DFF_P_ 01", "aigmap", "opt_clean",
        "setundef -zero -init", f"write_aiger -zinit -symbols {design}"], limit)
    return aiger.read(design) if written else None


def step(root, mutant, top, path, limit):
    """A file: from what states the design can reach with the change it comes to others in a clock, or gives
    other outputs. None where registers cannot be matched."""
    design, graphs = path.with_suffix(".aig"), []
    for name, steps in zip(("gold", "gate"), _before_and_after(mutant, path)):
        steps, its = _inside(steps, top)
        graphs.append(_alike(root, [*steps, f"hierarchy -top {its}", "memory_collect"],
                             path.with_suffix(f".{name}.ys"), limit))
    return design if None not in graphs and aiger.step(*graphs, design) else None


def _gates(root, steps, path, limit):
    """What the steps make in gates and registers, a file with one output; or None."""
    design = path.with_suffix(".aig")
    written = yosys(root, path, [
        *steps, "async2sync", "opt", "techmap", "opt_clean",
        "dfflegalize -cell $_DFF_P_ 01", "abc -fast -g AND", "opt_clean", "setundef -zero -init",
        f"write_aiger -zinit {design}"], limit)
    return design if written else None


def _abc(design, steps, limit):
    """What ABC says to these steps."""
    try:
        return subprocess.run(["yosys-abc", "-c", f"read_aiger {design}; strash; {steps}"], check=False,
                              capture_output=True, text=True, timeout=limit).stdout
    except subprocess.TimeoutExpired:
        return ""


def proved(design, seconds):
    """True if no output differs, whatever comes in, once all registers have been zero: registers that are
    always equal become one, then gates, and what is left is decided by reachability in so many seconds."""
    return "Property proved" in _abc(design, f"lcorr; &get -n; &scorr; &put; pdr -T {seconds}", 4 * seconds)


def _differs(design, seconds):
    """True if inputs are found after which an output differs."""
    return "was asserted" in _abc(design, f"bmc3 -T {seconds}", 2 * seconds)


def _memory_bits(design):
    """Bits of all memories of a design in RTLIL."""
    return sum(int(width or 1) * int(size or 1) for width, size in re.findall(
        r"^  memory(?: width (\d+))?(?: size (\d+))?", design.read_text(encoding="utf-8"), re.MULTILINE))


def verdict(root, model, mutant, path, limit):
    """"equivalent" if the mutant is the design; "survived" if it can answer otherwise; "undecided" where
    neither is found in time.

    @param path   what its files begin with
    @param limit  seconds; of a step no more than that, or twice
    """
    design = step(root, mutant, model.top, path.with_suffix(".step.ys"), limit)
    if design and proved(design, limit // 2):
        return "equivalent"
    cut = path.with_suffix(".cut.ys")
    design = _gates(root, _miter(mutant, model.top, CUT, cut), cut, limit)
    if _memory_bits(path.with_name("design.il")) > SMALL:
        return "equivalent" if design and proved(design, limit // 2) else "undecided"
    # What is easily proved first, then what is easily found.
    if design and proved(design, limit // 6):
        return "equivalent"
    whole = path.with_suffix(".whole.ys")
    design = _gates(root, _miter(mutant, model.top, WHOLE, whole), whole, limit)
    if design and _differs(design, limit // 3):
        return "survived"
    return "equivalent" if design and proved(design, limit // 2) else "undecided"
