"""Whether a mutant changes anything: proved by yosys' equivalence check, module by module, then whole.

SPDX-License-Identifier: Apache-2.0
"""

from netlist import base, module, single, yosys

SECONDS = 60


def _flat(steps, top, name, out):
    return ["design -reset", *steps, f"hierarchy -top {top}", "flatten", "memory_collect", "memory_map",
            "opt_clean", f"rename {top} {name}", f"write_rtlil {out}"]


def _proved(root, mutant, top, path):
    design = base(path.parent)
    gold, gate = (path.with_suffix(f".{name}.il") for name in ("gold", "gate"))
    return yosys(root, path, [
        *_flat([design], top, "gold", gold), *_flat([design, single(mutant)], top, "gate", gate),
        "design -reset", f"read_rtlil {gold}", f"read_rtlil {gate}", "equiv_make gold gate equiv",
        "hierarchy -top equiv", "equiv_simple", "equiv_induct -seq 4", "equiv_status -assert"], SECONDS)


def proved(root, model, mutant, number, folder):
    """True if the mutant is the design: in its module, or in the top that holds it."""
    place = module(mutant)[1]
    return any(_proved(root, mutant, top, folder / f"equal-{number}-{turn}.ys")
               for turn, top in enumerate(dict.fromkeys((place, model.top))))
