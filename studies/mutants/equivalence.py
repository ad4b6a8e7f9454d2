"""Whether a mutant changes anything: proved by ABC, module by module, then whole; else whether it can:
a difference found by SAT.

SPDX-License-Identifier: Apache-2.0
"""

import subprocess

from netlist import base, module, single, yosys

SECONDS = 20  # of a proof, and of a search
CLOCKS = 8    # from a state of zeros, in which a difference is looked for


def _flat(steps, top, name, out):
    return ["design -reset", *steps, f"hierarchy -top {top}", "flatten", "memory_collect", "memory_map",
            "opt_clean", f"rename {top} {name}", f"write_rtlil {out}"]


def _miter(mutant, top, path):
    """The steps that make one module of the module before and after the change: `trigger` tells that an
    output differs."""
    design = base(path.parent)
    gold, gate = (path.with_suffix(f".{name}.il") for name in ("gold", "gate"))
    return [*_flat([design], top, "gold", gold), *_flat([design, single(mutant)], top, "gate", gate),
            "design -reset", f"read_rtlil {gold}", f"read_rtlil {gate}",
            "miter -equiv -flatten gold gate miter", "hierarchy -top miter"]


def _proved(root, mutant, top, path):
    """True if property-directed reachability proves that no output differs, whatever comes in, once all
    registers have been zero."""
    design = path.with_suffix(".aig")
    made = yosys(root, path, [
        *_miter(mutant, top, path), "async2sync", "opt", "techmap", "opt_clean",
        "dfflegalize -cell $_DFF_P_ 01", "abc -fast -g AND", "opt_clean", "setundef -zero -init",
        f"write_aiger -zinit {design}"], SECONDS)
    if not made:
        return False
    answer = subprocess.run(["yosys-abc", "-c", f"read_aiger {design}; strash; pdr -T {SECONDS}"],
                            check=False, capture_output=True, text=True)
    return "Property proved" in answer.stdout


def _differs(root, mutant, top, path):
    """True if SAT finds inputs after which an output differs."""
    return yosys(root, path, [
        *_miter(mutant, top, path),
        f"sat -set-init-zero -prove trigger 0 -tempinduct-baseonly -maxsteps {CLOCKS} -falsify"], SECONDS)


def verdict(root, model, mutant, number, folder):
    """"equivalent" if the mutant is the design, in its module or in the top that holds it; "survived"
    if the top with it can answer otherwise; "undecided" where neither is found in time."""
    place = module(mutant)[1]
    tops = dict.fromkeys((place, model.top))
    if any(_proved(root, mutant, top, folder / f"equal-{number}-{turn}.ys")
           for turn, top in enumerate(tops)):
        return "equivalent"
    return "survived" if _differs(root, mutant, model.top, folder / f"differs-{number}.ys") else "undecided"
