"""Whether a mutant changes anything: proved by yosys' equivalence check, module by module, then whole;
else whether it can: a difference found by SAT.

SPDX-License-Identifier: Apache-2.0
"""

from netlist import base, module, single, yosys

SECONDS = 15  # of a proof, and of a search
CLOCKS = 8    # from a state of zeros, in which a difference is looked for


def _flat(steps, top, name, out):
    return ["design -reset", *steps, f"hierarchy -top {top}", "flatten", "memory_collect", "memory_map",
            "opt_clean", f"rename {top} {name}", f"write_rtlil {out}"]


def _pair(mutant, top, path):
    """The steps that leave the module before and after the change side by side: gold and gate."""
    design = base(path.parent)
    gold, gate = (path.with_suffix(f".{name}.il") for name in ("gold", "gate"))
    return [*_flat([design], top, "gold", gold), *_flat([design, single(mutant)], top, "gate", gate),
            "design -reset", f"read_rtlil {gold}", f"read_rtlil {gate}"]


def _proved(root, mutant, top, path):
    return yosys(root, path, [
        *_pair(mutant, top, path), "equiv_make gold gate equiv", "hierarchy -top equiv",
        "equiv_simple", "equiv_induct -seq 4", "equiv_status -assert"], SECONDS)


def _differs(root, mutant, top, path):
    """True if SAT finds inputs after which an output differs."""
    return yosys(root, path, [
        *_pair(mutant, top, path), "miter -equiv -flatten gold gate miter", "hierarchy -top miter",
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
