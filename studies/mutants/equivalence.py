"""Whether a mutant changes anything: proved by ABC, which finds what is equal in the design before and
after the change; else whether it can: a difference found by SAT.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import subprocess

from netlist import base, yosys

CLOCKS = 8    # from a state of zeros, in which a difference is looked for
# What a memory holds stays the same as long as nothing differs that goes into it, so a proof may cut it.
SMALL = 20_000  # bits of memories that may become registers
CUT, WHOLE = ("expose -evert t:$mem_v2", "opt_clean"), ("memory_map", "opt_clean")


def _side(steps, top, memories, name, out):
    """The design by one name; with the inputs that it is made for, where a file of its name says which."""
    domain = pathlib.Path(__file__).with_name(f"{top}.v")
    if domain.exists():
        steps, top = [*steps, f"read_verilog {domain}", "hierarchy -top domain", "flatten", "opt_clean"], "domain"
    return ["design -reset", *steps, f"hierarchy -top {top}", "memory_collect", *memories,
            f"rename {top} {name}", f"write_rtlil {out}"]


def _miter(mutant, top, memories, path):
    """The steps that make one module of the design before and after the change: `trigger` tells that an
    output differs."""
    design = base(path.parent)
    gold, gate = (path.with_suffix(f".{name}.il") for name in ("gold", "gate"))
    return [*_side([design], top, memories, "gold", gold),
            *_side([design, mutant], top, memories, "gate", gate),
            "design -reset", f"read_rtlil {gold}", f"read_rtlil {gate}",
            "miter -equiv -flatten gold gate miter", "hierarchy -top miter"]


def _proved(root, mutant, top, memories, path, limit):
    """True if no output differs, whatever comes in, once all registers have been zero: registers that are
    always equal become one, then gates, and what is left is decided by reachability."""
    design = path.with_suffix(".aig")
    made = yosys(root, path, [
        *_miter(mutant, top, memories, path), "async2sync", "opt", "techmap", "opt_clean",
        "dfflegalize -cell $_DFF_P_ 01", "abc -fast -g AND", "opt_clean", "setundef -zero -init",
        f"write_aiger -zinit {design}"], limit)
    if not made:
        return False
    try:
        answer = subprocess.run(
            ["yosys-abc", "-c", f"read_aiger {design}; strash; lcorr; &get -n; &scorr; &put; pdr -T {limit // 2}"], check=False,
            capture_output=True, text=True, timeout=2 * limit)
    except subprocess.TimeoutExpired:
        return False
    return "Property proved" in answer.stdout


def _differs(root, mutant, top, path, limit):
    """True if SAT finds inputs after which an output differs."""
    return yosys(root, path, [
        *_miter(mutant, top, WHOLE, path),
        f"sat -set-init-zero -prove trigger 0 -tempinduct-baseonly -maxsteps {CLOCKS} -falsify"], limit)


def _memory_bits(design):
    """Bits of all memories of a design in RTLIL."""
    return sum(int(width or 1) * int(size or 1) for width, size in re.findall(
        r"^  memory(?: width (\d+))?(?: size (\d+))?", design.read_text(encoding="utf-8"), re.MULTILINE))


def verdict(root, model, mutant, path, limit):
    """"equivalent" if the mutant is the design; "survived" if it can answer otherwise; "undecided" where
    neither is found in time.

    @param path   what its files begin with
    @param limit  seconds of a proof, and of a search
    """
    small = _memory_bits(path.with_name("design.il")) <= SMALL
    if any(_proved(root, mutant, model.top, memories, path.with_suffix(f".equal{turn}.ys"), limit)
           for turn, memories in enumerate((CUT, WHOLE) if small else (CUT,))):
        return "equivalent"
    return "survived" if small and _differs(root, mutant, model.top, path.with_suffix(".differs.ys"), limit) else "undecided"
