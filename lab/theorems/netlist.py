"""A unit of rtl/ as terms: what each of its outputs is, how many clocks after its inputs.

yosys elaborates and flattens it. Registers are taken for wires, and beside that counted: on every
way from an input to an output there must be the same number, or the unit is refused. So a unit
without feedback gives in every clock what its terms say of the inputs of so many clocks before.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import subprocess
from dataclasses import dataclass

from lab.theorems import terms
from tools.project_root import ROOT
from tools.rtl import rtl_sources

# What holds words, by unit: its outputs are inputs of the unit, any words.
BOXES = {"ffd_eval_poly_pipelined": "ffd_eval_coefficient_file"}
FOLDERS = ("rtl/number", "rtl/common", "rtl/evaluator", "rtl/scatter")
HEADERS = (*FOLDERS, "rtl/stream")


class TheoremError(Exception):
    """A unit or a theorem that makes no sense, in one line."""


@dataclass
class Unit:
    """A unit with given parameters."""

    name: str
    inputs: dict
    outputs: dict
    depths: dict                       # clocks from the inputs, by output


@dataclass(frozen=True)
class Bug:
    """A text of a file of rtl/ that is there exactly once, and what replaces it."""

    module: str
    original: str
    mutant: str


def _sources(bug, folder):
    """The files to read; of the one with a bug a copy that has it."""
    files = [path for part in FOLDERS for path in sorted((ROOT / part).rglob("*.v"))]
    if bug is None:
        return files
    place = next((number for number, path in enumerate(files) if path.stem == bug.module), None)
    if place is None:
        raise TheoremError(f"the planted bug is in {bug.module}, which is not read")
    try:
        text = rtl_sources.changed(files[place].read_text(encoding="utf-8"), bug.original, bug.mutant, bug.module)
    except ValueError as error:
        raise TheoremError(str(error)) from error
    files[place] = folder / f"{bug.module}.v"
    files[place].write_text(text, encoding="utf-8")
    return files


def _elaborated(wanted, bug, folder):
    """The flat netlists as yosys writes them, of (unit, parameters)."""
    folder.mkdir(parents=True, exist_ok=True)
    includes = " ".join(f"-I {ROOT / part}" for part in HEADERS)
    steps = [f"read_verilog -defer {includes} " + " ".join(map(str, _sources(bug, folder))),
             "design -save sources"]
    outs = [folder / f"netlist-{place}.json" for place in range(len(wanted))]
    for (name, parameters), out in zip(wanted, outs):
        out.unlink(missing_ok=True)
        values = "".join(f" -chparam {key} {number}" for key, number in parameters.items())
        box = BOXES.get(name)
        steps += ["design -load sources", f"hierarchy -check -top {name}{values}",
                  *([f"blackbox *{box}*"] if box else []), "proc", "flatten",
                  *([f"expose -evert t:*{box}*"] if box else []), "check -assert", "opt_clean", f"rename -top {name}", f"write_json {out}"]
    (folder / "script.ys").write_text("\n".join(steps) + "\n", encoding="utf-8")
    result = subprocess.run(["yosys", "-q", "-s", folder / "script.ys"], check=False,
                            capture_output=True, text=True)
    for (name, parameters), out in zip(wanted, outs):
        if not out.exists():
            message = (result.stderr or result.stdout or "nothing").strip().splitlines()[-1]
            raise TheoremError(f"{name} {parameters}: yosys says: {message}")
        yield json.loads(out.read_text(encoding="utf-8"))["modules"][name]
        out.unlink()


class _Reader:
    """Terms and depths of the bits of a netlist."""

    def __init__(self, module, name, late, cut):
        self.name, self.cut = name, cut
        self.drivers, self.words, self.depth = {}, {}, {}
        self.inputs = {}
        for port, description in module["ports"].items():
            if description["direction"] == "input":
                word = terms.var(port, len(description["bits"]))
                self.inputs[port] = word
                clocks = late.get(port, 0)
                clocks = clocks if isinstance(clocks, tuple) else (clocks,)
                for place, bit in enumerate(description["bits"]):
                    self.words[bit] = word, place
                    self.depth[bit] = clocks[place * len(clocks) // word.width]
        for key, cell in module["cells"].items():
            out = "Q" if cell["type"] == "$dff" else "Y"
            if out not in cell["connections"]:
                raise TheoremError(f"{name}: a cell of type {cell['type']}")
            for bit in cell["connections"][out]:
                self.drivers[bit] = (key, cell, out)

    def resolve(self, wanted):
        """Makes terms of these bits, and of what they depend on."""
        stack = [bit for bit in wanted if isinstance(bit, int)]
        waiting = set()
        while stack:
            bit = stack[-1]
            if bit in self.words:
                stack.pop()
                continue
            if bit not in self.drivers:
                raise TheoremError(f"{self.name}: a wire that nothing drives")
            key, cell, out = self.drivers[bit]
            needed = [bit for port, ports in cell["connections"].items() if port not in (out, "CLK")
                      for bit in ports if isinstance(bit, int) and bit not in self.words]
            if needed:
                if key in waiting:
                    raise TheoremError(f"{self.name}: it has feedback, which is not a pipeline")
                waiting.add(key)
                stack += needed
                continue
            stack.pop()
            self._finish(cell, out)

    def _finish(self, cell, out):
        ports = cell["connections"]
        used = [bit for port, connected in ports.items() if port not in (out, "CLK") for bit in connected]
        if cell["type"] == "$dff":
            for bit, before in zip(ports["Q"], ports["D"]):
                self.words[bit] = self.at(before)
                self.depth[bit] = None if self._depth(before) is None else self._depth(before) + 1
            return
        depths = {self._depth(bit) for bit in used} - {None}
        if len(depths) > 1:
            raise TheoremError(f"{self.name}: words of {sorted(depths)} clocks after the inputs meet")
        word = _computed(cell, self.word, self.cut)
        for place, bit in enumerate(ports[out]):
            self.words[bit], self.depth[bit] = (word, place), next(iter(depths), None)

    def at(self, bit):
        if isinstance(bit, int):
            return self.words[bit]
        # An x may be either.
        return (terms.const(int(bit), 1) if bit in "01" else terms.var("unknown", 1), 0)

    def _depth(self, bit):
        return self.depth[bit] if isinstance(bit, int) else None

    def depths(self, net_bits):
        return {self._depth(bit) for bit in net_bits} - {None}

    def word(self, net_bits):
        """The word of these bits, lowest first."""
        pieces = [term.bit(place) for term, place in map(self.at, reversed(net_bits))]
        return terms.concat(*pieces)


def _extended(term, width, signed):
    if term.width >= width:
        return term.bits(width - 1, 0)
    return term.sext(width) if signed else term.zext(width)


_ARITHMETIC = {"$add": "__add__", "$sub": "__sub__", "$and": "__and__", "$or": "__or__",
               "$xor": "__xor__"}
_COMPARED = {"$lt": lambda a, b, s: a.slt(b) if s else a < b,
             "$le": lambda a, b, s: a.sle(b) if s else a <= b,
             "$gt": lambda a, b, s: b.slt(a) if s else a > b,
             "$ge": lambda a, b, s: b.sle(a) if s else a >= b,
             "$eq": lambda a, b, s: a.eq(b), "$ne": lambda a, b, s: a.ne(b),
             "$eqx": lambda a, b, s: a.eq(b), "$nex": lambda a, b, s: a.ne(b)}
_REDUCED = {"$reduce_or": lambda a: a.any(), "$reduce_bool": lambda a: a.any(),
            "$logic_not": lambda a: ~a.any(), "$reduce_and": lambda a: (~a).eq(0)}


def _shifted(kind, operand, amount, width, signed):
    """A shift fills with zeros, but for an arithmetic one of a signed word to the right."""
    wide = max(width, operand.width, amount.width)
    word, by = _extended(operand, wide, signed), amount.zext(wide)
    right = kind in ("$shr", "$sshr")
    shifted = (word.ashr(by) if signed and kind == "$sshr" else word >> by) if right else word << by
    return shifted.bits(width - 1, 0)


def _computed(cell, word, cut):
    """What a cell without a register makes of its inputs."""
    kind, parameters, ports = cell["type"], cell["parameters"], cell["connections"]
    a = word(ports["A"])
    b = word(ports["B"]) if "B" in ports else None
    if kind == "$mux":
        return terms.ite(word(ports["S"]), b, a)
    if kind == "$pmux":
        chosen = a
        for place in reversed(range(len(ports["S"]))):
            part = b.bits((place + 1) * a.width - 1, place * a.width)
            chosen = terms.ite(word([ports["S"][place]]), part, chosen)
        return chosen
    width, signed = len(ports["Y"]), int(parameters["A_SIGNED"], 2) == 1
    if kind in ("$shl", "$shr", "$sshl", "$sshr"):
        return _shifted(kind, a, b, width, signed)
    if kind in _REDUCED:
        return _REDUCED[kind](a).zext(width)
    if kind in ("$logic_and", "$logic_or"):
        both = (a.any() & b.any()) if kind == "$logic_and" else (a.any() | b.any())
        return both.zext(width)
    if kind in _COMPARED:
        wide = max(a.width, b.width)
        return _COMPARED[kind](_extended(a, wide, signed), _extended(b, wide, signed), signed).zext(width)
    a = _extended(a, width, signed)
    if kind in ("$not", "$neg", "$pos"):
        return {"$not": ~a, "$neg": -a, "$pos": a}[kind]
    b = _extended(b, width, signed)
    if kind == "$mul":
        return cut(a, b)
    if kind not in _ARITHMETIC:
        raise TheoremError(f"a cell of type {kind}")
    return getattr(a, _ARITHMETIC[kind])(b)


def read(wanted, folder, bug=None, cut=terms.Term.__mul__):
    """Units as terms, of (unit, parameters, late): `late` says how many clocks after the others an
    input comes, or each of so many equal parts of it, `cut` what a product is."""
    netlists = _elaborated([(name, parameters) for name, parameters, _ in wanted], bug, pathlib.Path(folder))
    return [_unit(name, module, late, cut) for (name, _, late), module in zip(wanted, netlists)]


def _unit(name, module, late, cut):
    reader = _Reader(module, name, late, cut)
    unit = Unit(name, reader.inputs, {}, {})
    for port, description in module["ports"].items():
        if description["direction"] != "output" or "." in port:  # of a box
            continue
        reader.resolve(description["bits"])
        depths = reader.depths(description["bits"])
        if len(depths) > 1:
            raise TheoremError(f"{name}: bits of {port} come {sorted(depths)} clocks after the inputs")
        unit.outputs[port], unit.depths[port] = reader.word(description["bits"]), next(iter(depths), None)
    return unit
