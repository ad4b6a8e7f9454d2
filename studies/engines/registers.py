"""Registers that reset clears, found by yosys: those whose next value is a constant while it lasts.

SPDX-License-Identifier: Apache-2.0
"""

import json

import rtl

# Of each top: the reset, and its value while it lasts.
RESET = ("aresetn", "1'0")
_CONSTANTS = ("0", "1")


class RegisterError(Exception):
    """A design whose registers are not found, in one line."""


def steps(sources, top, parameters, out):
    """The steps of yosys: every next value, with a reset that does not end."""
    folders = " ".join(f"-I {folder}" for folder in sources.includes)
    given = "".join(f" -chparam {name} {value}" for name, value in parameters.items())
    return [f"read_verilog {folders} {' '.join(sources.needed(top))}",
            f"hierarchy -check -top {top}{given}", f"rename -top {top}", "proc", "flatten",
            f"connect -set {RESET[0]} {RESET[1]}", "opt_expr", "opt_expr", f"write_json {out}"]


def cleared(module):
    """{name: its bits, from the lowest on} of the registers of a flat module: the shortest name of
    each bit, as simulators have it."""
    bits = {q for cell in module["cells"].values() if cell["type"] == "$dff"
            for q, d in zip(cell["connections"]["Q"], cell["connections"]["D"]) if d in _CONSTANTS}
    places = {}
    for name, wire in module["netnames"].items():
        for place, bit in enumerate(wire["bits"]):
            if bit in bits and not wire.get("hide_name"):
                places.setdefault(bit, []).append((len(name), name, place + wire.get("offset", 0),
                                                   len(wire["bits"])))
    found = {}
    for _, name, place, width in map(min, places.values()):
        found.setdefault(name, []).append(place if width > 1 else None)
    return {name: sorted(found[name]) for name in sorted(found)} if len(places) == len(bits) else {}


def find(sources, top, parameters, folder):
    """cleared() of a top with its parameters. Raises RegisterError."""
    out = folder / "registers.json"
    status, said = rtl.run(["yosys", "-q", "-p", "; ".join(steps(sources, top, parameters, out))])
    if status:
        raise RegisterError(f"yosys: {said.strip().splitlines()[-1]}")
    found = cleared(json.loads(out.read_text(encoding="utf-8"))["modules"][top])
    out.unlink()
    if not found:
        raise RegisterError(f"{top}: no registers that reset clears, or some without a name")
    return found


def watch(found, core, clock, must):
    """Verilog: a module ffd_bench_registers, a top of its own, that watches them in an instance `core`
    while `must` is 1, at the edges of `clock`."""

    def value(name, places):
        return "{" + ", ".join(f"{core}.{name}" + ("" if place is None else f"[{place}]")
                               for place in reversed(places)) + "}"

    lines = [f'  ffd_bench_known #({len(places)}, "{name}") k{number} ({clock}, {must}, '
             f"{value(name, places)});" for number, (name, places) in enumerate(found.items())]
    return "\n".join(["module ffd_bench_registers;", *lines, "endmodule", ""])
