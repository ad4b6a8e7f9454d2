"""Registers that reset clears, found by yosys: those that are constants while it lasts, and only then,
in modules that have a reset.

SPDX-License-Identifier: Apache-2.0
"""

import json
import re

from tools.rtl import rtl_sources

RESET = "aresetn"  # 0 while it lasts
RESETS = ("rst", RESET)  # of the modules below a top
DEEP = 4  # (SETTLING of the benches) registers behind each other, each of which is a constant because of the one before
# Bits below the first of these delays are beside a valid, which is that one, and known while it is 1.
_BESIDE = re.compile(r"_valid\.gen_stage\[\d+\]\.data_q$")
_CONSTANTS = ("0", "1")
# What yosys puts around an arm of a chain of `else if`, which has a name and lies in no other scope.
_ELSE = re.compile(r"\bgenblk\d+\.")


class RegisterError(Exception):
    """A design whose registers are not found, in one line."""


def steps(sources, top, parameters, tree, free, held):
    """The steps of yosys: the design by modules, flat as it is, and flat with a reset that does not end."""
    folders = " ".join(f"-I {folder}" for folder in sources.includes)
    given = "".join(f" -chparam {name} {value}" for name, value in parameters.items())
    return [f"read_verilog {folders} {' '.join(sources.needed(top))}",
            f"hierarchy -check -top {top}{given}", f"rename -top {top}", "proc", f"write_json {tree}", "flatten",
            f"write_json {free}", f"delete -input {top}/{RESET}", "setundef -undriven -zero",
            *["opt_expr", "opt_expr", "opt_dff -nodffe -nosdff"] * DEEP, f"write_json {held}"]


def _bits(module):
    """(name as simulators have it, place or None) -> bit, of all nets with a name; those inside a function
    have one that only yosys knows."""
    return {(name, place + wire.get("offset", 0) if len(wire["bits"]) > 1 else None): bit
            for name, wire in module["netnames"].items() if not wire.get("hide_name") and "$" not in name
            for place, bit in enumerate(wire["bits"])}


def without_reset(modules, top):
    """How names begin of what lies in instances whose module has no reset: what such a module keeps is
    data, whose valid is elsewhere."""
    prefixes = []
    for name, cell in modules[top]["cells"].items():
        kind = modules.get(cell["type"])
        if kind is None:
            continue
        below = [f"{name}.{prefix}" for prefix in without_reset(modules, cell["type"])]
        prefixes += below if set(RESETS) & set(kind["ports"]) else [f"{name}.", *below]
    return tuple(prefixes)


def _flattened(name):
    """A cell's name from the top on, as simulators would have it."""
    return name.removeprefix("$flatten").replace("\\", "")


def cleared(free, held, data=()):
    """{name: its bits, from the lowest on} of the registers of a flat module, without and with a reset
    that lasts: the shortest name of each bit, that of a register where there is one. Those whose own
    names begin as `data` says are none. Raises RegisterError."""
    outputs = {bit for name, cell in free["cells"].items()
               if cell["type"] == "$dff" and not _flattened(name).startswith(data)
               for bit in cell["connections"]["Q"]}
    lasting = _bits(held)
    names = {}
    for place, bit in _bits(free).items():
        if bit in outputs and lasting.get(place) in _CONSTANTS:
            own = _ELSE.sub("", place[0])
            names.setdefault(bit, []).append((not own.endswith("_q"), len(own), own, place[1]))
    if not names:
        raise RegisterError("no registers that reset clears")
    places_by_name = {}
    for _, _, name, place in map(min, names.values()):
        places_by_name.setdefault(name, []).append(place)
    return {name: sorted(places_by_name[name]) for name in sorted(places_by_name)}


def find(sources, top, parameters, folder):
    """cleared() of a top with its parameters. Raises RegisterError."""
    files = [folder / f"{name}.json" for name in ("tree", "free", "held")]
    status, output = rtl_sources.run(["yosys", "-q", "-p", "; ".join(steps(sources, top, parameters, *files))])
    if status:
        raise RegisterError(f"yosys: {output.strip().splitlines()[-1]}")
    tree, free, held = (json.loads(path.read_text(encoding="utf-8"))["modules"] for path in files)
    for path in files:
        path.unlink()
    return cleared(free[top], held[top], without_reset(tree, top))


def _split(name, places):
    """(places, the place of the valid that they are beside, or None) of what is watched together."""
    if len(places) > 1 and _BESIDE.search(name):
        return [(places[-1:], None), (places[:-1], places[-1])]
    return [(places, None)]


def watch(places_by_name, core, clock, must):
    """Verilog: a module ffd_bench_registers, a top of its own, that watches them in an instance `core`
    while `must` is 1, at the edges of `clock`."""

    def bit(name, place):
        return f"{core}.{name}" + ("" if place is None else f"[{place}]")

    lines = []
    for name, places in places_by_name.items():
        for some, valid in _split(name, places):
            when = must if valid is None else f"{must} && {bit(name, valid)}"
            value = ", ".join(bit(name, place) for place in reversed(some))
            lines.append(f'  ffd_bench_known #({len(some)}, "{name}") k{len(lines)} ({clock}, {when}, '
                         f"{{{value}}});")
    return "\n".join(["module ffd_bench_registers;", *lines, "endmodule", ""])
