"""What a netlist that yosys has mapped consists of, and how deep its logic is.

Reads what `json` writes: modules of cells, perhaps in a hierarchy. Each target has a table of its
cells; a cell that is in none of them, a latch for example, is an error. synth/README.md says what
the counts mean.

SPDX-License-Identifier: Apache-2.0
"""

import re
from collections import Counter, defaultdict

from tools.synth import liberty

NOWHERE = float("-inf")  # the depth of what no register and no port leads to


class NetlistError(Exception):
    """A netlist that cannot be counted, in one line."""


# Cells by kind. A register cuts paths; a ram is read through the pins that match.
# type -> (kind, what the cell adds to the counts)
_GATES = ("NOT", "AND", "NAND", "OR", "NOR", "XOR", "XNOR", "ANDNOT", "ORNOT", "MUX", "NMUX",
          "AOI3", "OAI3", "AOI4", "OAI4", "BUF")
_LUT = ("logic", {"lut": 1})
_FF = ("register", {"ff": 1})
_WIRED = ("carry", {})
_BLOCK = ("register", {"bram": 1})


def _shift_register(luts):
    return ("register", {"lutram": luts})


_ICE40 = {
    "SB_LUT4": _LUT, "SB_CARRY": _WIRED, "SB_RAM40_4K": _BLOCK,
    **{f"SB_DFF{kind}": _FF for kind in ("", "E", "SR", "SS", "R", "S", "ESR", "ESS", "ER", "ES")},
}
# The standard cells are those of a file (tools/synth/liberty.py).
CELLS = {
    "generic": {f"$_{gate}_": ("logic", {"cells": 1}) for gate in _GATES},
    "ecp5": {
        "LUT4": _LUT, "CCU2C": ("ccu2c", {"lut": 2}), "TRELLIS_FF": _FF,
        "MULT18X18D": ("mult18", {"dsp": 1}),
        "TRELLIS_DPR16X4": ("ram", {"lutram": 4}), "DP16KD": _BLOCK, "PDPW16KD": _BLOCK,
    },
    "up5k": {**_ICE40, "SB_MAC16": ("mac16", {"dsp": 1})},
    "hx8k": _ICE40,
    "xilinx7": {
        **{f"LUT{inputs}": _LUT for inputs in range(1, 7)}, "INV": _LUT,
        "CARRY4": ("carry4", {}), "MUXF7": _WIRED, "MUXF8": _WIRED,
        "FDRE": _FF, "FDSE": _FF, "FDCE": _FF, "FDPE": _FF,
        "SRL16E": _shift_register(1), "SRLC16E": _shift_register(1), "SRLC32E": _shift_register(1),
        "RAM32X1D": ("ram", {"lutram": 2}), "RAM64X1D": ("ram", {"lutram": 2}),
        "RAM128X1D": ("ram", {"lutram": 4}),
        "RAM32M": ("ram", {"lutram": 4}), "RAM64M": ("ram", {"lutram": 4}),
        "DSP48E1": ("dsp48e1", {"dsp": 1}),
        "RAMB18E1": _BLOCK, "RAMB36E1": ("register", {"bram": 2}),
    },
}
_GENERIC_FF = re.compile(r"\$_S?DFFC?E?_[PN01]+_\Z")
TARGETS = (*CELLS, liberty.TARGET)
# What a target's table counts; the other fields mean nothing there.
FIELDS = {
    **{target: ("lut", "lutram", "ff", "dsp", "bram") for target in TARGETS},
    "generic": ("cells", "ff"),
    liberty.TARGET: ("area_um2", "cells", "ff"),
}


def kind_of(target, cell_type):
    """(kind, counts) of a cell that is not a module of the design. Raises NetlistError."""
    if target == "generic" and _GENERIC_FF.match(cell_type):
        return "register", {"cells": 1, "ff": 1}
    cells = liberty.cells() if target == liberty.TARGET else CELLS[target]
    if cell_type not in cells:
        raise NetlistError(f"a cell {cell_type}, which {target} does not have")
    return cells[cell_type]


def kinds(netlist, top):
    """How many cells of each type there are, every instance counted: {type: number}."""
    modules, known = netlist["modules"], {}

    def of(name):
        if name not in known:
            total = Counter()
            for cell_type, number in Counter(
                    cell["type"] for cell in modules[name]["cells"].values()).items():
                inside = of(cell_type) if cell_type in modules else {cell_type: 1}
                for kind, each in inside.items():
                    total[kind] += number * each
            known[name] = total
        return known[name]

    return dict(sorted(of(top).items()))


def count(target, netlist, top):
    """What the cells add up to: {field: number}. Raises NetlistError."""
    total = Counter()
    for cell_type, number in kinds(netlist, top).items():
        for field, each in kind_of(target, cell_type)[1].items():
            total[field] += number * each
    return {field: round(total[field]) for field in FIELDS[target]}


# Depth ----------------------------------------------------------------------------------------


class Module:
    """The paths of one module: groups of arcs between bits, where they start and where they end.

    A group is (inputs [(bit, levels)], outputs [bit]): each output is as deep as the deepest of
    its inputs with the levels added.
    """

    def __init__(self):
        self.groups = []
        self.starts = defaultdict(lambda: NOWHERE)  # bit -> levels since a register
        self.ends = defaultdict(lambda: NOWHERE)    # bit -> levels until a register
        self.ports = {"input": {}, "output": {}}    # (port, index) -> bit
        self.inside = 0                             # deepest of the modules in it

    def arcs(self, inputs, outputs):
        inputs = [(bit, levels) for bit, levels in inputs if isinstance(bit, int)]
        outputs = [bit for bit in outputs if isinstance(bit, int)]
        if inputs and outputs:
            self.groups.append((inputs, outputs))

    def start(self, bits, levels=0):
        for bit in bits:
            if isinstance(bit, int):
                self.starts[bit] = max(self.starts[bit], levels)

    def end(self, bits, levels=0):
        for bit in bits:
            if isinstance(bit, int):
                self.ends[bit] = max(self.ends[bit], levels)

    def sort(self):
        """Groups in an order in which inputs come before outputs. Raises NetlistError."""
        users, waiting = defaultdict(list), [0] * len(self.groups)
        driven = {bit for _, outputs in self.groups for bit in outputs}
        for number, (inputs, _) in enumerate(self.groups):
            for bit, _ in inputs:
                if bit in driven:
                    users[bit].append(number)
                    waiting[number] += 1
        drivers = Counter(bit for _, outputs in self.groups for bit in outputs)
        ready = [number for number, count_ in enumerate(waiting) if not count_]
        order = []
        while ready:
            number = ready.pop()
            order.append(self.groups[number])
            for bit in self.groups[number][1]:
                drivers[bit] -= 1
                if drivers[bit]:
                    continue
                for user in users[bit]:
                    waiting[user] -= 1
                    if not waiting[user]:
                        ready.append(user)
        if len(order) != len(self.groups):
            raise NetlistError("a loop of logic without a register")
        self.groups = order

    def forward(self, starts):
        """bit -> levels since one of `starts`."""
        level = dict(starts)
        for inputs, outputs in self.groups:
            deepest = max(level.get(bit, NOWHERE) + levels for bit, levels in inputs)
            if deepest > NOWHERE:
                for bit in outputs:
                    level[bit] = max(level.get(bit, NOWHERE), deepest)
        return level

    def backward(self):
        """bit -> levels until a register."""
        level = dict(self.ends)
        for inputs, outputs in reversed(self.groups):
            deepest = max(level.get(bit, NOWHERE) for bit in outputs)
            if deepest > NOWHERE:
                for bit, levels in inputs:
                    level[bit] = max(level.get(bit, NOWHERE), deepest + levels)
        return level

    def close(self):
        """What an instance shows: paths that start, end or pass through at its ports."""
        self.sort()
        inputs, outputs = self.ports["input"], self.ports["output"]
        level = self.forward(self.starts)
        self.deepest = max([self.inside] + [
            level.get(bit, NOWHERE) + levels for bit, levels in self.ends.items()])
        until = self.backward()
        self.out_of = {pin: level.get(bit, NOWHERE) for pin, bit in outputs.items()}
        self.into = {pin: until.get(bit, NOWHERE) for pin, bit in inputs.items()}
        self.through = {}  # input pin -> {output pin: levels}
        level = self.forward({bit: 0 for bit in inputs.values()})
        self.passes = max([NOWHERE] + [level.get(bit, NOWHERE) for bit in outputs.values()])
        if self.passes > NOWHERE:
            for pin, start in inputs.items():
                level = self.forward({start: 0})
                self.through[pin] = {
                    out: level[bit] for out, bit in outputs.items() if bit in level}

    def total(self):
        """The longest path, from a register or a port to a register or a port."""
        return max([self.deepest, self.passes, 0, *self.out_of.values(), *self.into.values()])


def _pins(cell, direction):
    """[(pin, index, bit)]"""
    return [(pin, index, bit) for pin, bits in cell["connections"].items()
            if cell["port_directions"][pin] == direction for index, bit in enumerate(bits)]


def _bits(cell, direction, pattern=""):
    return [bit for pin, _, bit in _pins(cell, direction) if re.match(pattern, pin)]


def _set(cell, *parameters):
    """Whether any of these binary parameters is not zero."""
    return any("1" in str(cell["parameters"].get(name, "0")) for name in parameters)


def _logic(module, cell):
    module.arcs([(bit, 1) for bit in _bits(cell, "input")], _bits(cell, "output"))


def _carry(module, cell):
    module.arcs([(bit, 0) for bit in _bits(cell, "input")], _bits(cell, "output"))


def _register(module, cell):
    module.start(_bits(cell, "output"))
    module.end(_bits(cell, "input"))


def _ram(module, cell):
    """Written at a clock, read at once: RAD -> DO; ADDRA -> DOA; DPRA and A -> DPO and SPO."""
    module.start(_bits(cell, "output"))
    read = [bit for bit in _bits(cell, "input", r"RAD|ADDR|DPRA|A\d*\Z")]
    module.arcs([(bit, 1) for bit in read], _bits(cell, "output"))
    module.end(_bits(cell, "input"))


def _ccu2c(module, cell):
    """Two LUTs and their carry: a chain adds no level to the one it is entered by."""
    def inputs(half):
        return [(bit, 1) for bit in _bits(cell, "input", rf"[ABCD]{half}\Z")]

    carry = [(bit, 0) for bit in _bits(cell, "input", "CIN")]
    module.arcs(carry + inputs(0), _bits(cell, "output", "S0"))
    module.arcs(carry + inputs(0) + inputs(1), _bits(cell, "output", "S1|COUT"))


def _carry4(module, cell):
    into = [(bit, 0) for bit in _bits(cell, "input", "CI|CYINIT")]
    for place in range(4):
        into += [(bit, 0) for pin, index, bit in _pins(cell, "input")
                 if index == place and pin in ("S", "DI")]
        module.arcs(into, [bit for _, index, bit in _pins(cell, "output") if index == place])


def _staged(module, cell, pins, before, inside, behind):
    """Input pins of a multiplier with its own registers before, inside or behind it."""
    if before or inside or behind:
        module.end(_bits(cell, "input", pins), 0 if before else 1)
    else:
        module.arcs([(bit, 1) for bit in _bits(cell, "input", pins)], _bits(cell, "output"))
    if behind:
        module.start(_bits(cell, "output"))
    elif before or inside:
        module.start(_bits(cell, "output"), 1)


def _mult18(module, cell):
    def has(*stages):
        return any(cell["parameters"].get(f"REG_{stage}_CLK", "NONE") != "NONE"
                   for stage in stages)

    for pins, before in (("A\\d|SIGNEDA", "INPUTA"), ("B\\d|SIGNEDB", "INPUTB")):
        _staged(module, cell, pins, has(before), has("PIPELINE"), has("OUTPUT"))
    module.end(_bits(cell, "input", "CE|RST|CLK"))


def _mac16(module, cell):
    inside = _set(cell, "PIPELINE_16x16_MULT_REG1", "PIPELINE_16x16_MULT_REG2",
                  "TOP_8x8_MULT_REG", "BOT_8x8_MULT_REG")
    behind = cell["parameters"].get("TOPOUTPUT_SELECT") == "01"
    for pins, before in (("A\\Z", "A_REG"), ("B\\Z", "B_REG")):
        _staged(module, cell, pins, _set(cell, before), inside, behind)
    for pins, before in (("C\\Z", "C_REG"), ("D\\Z", "D_REG")):
        _staged(module, cell, pins, _set(cell, before), False, behind)
    _staged(module, cell, "CI|ACCUMCI|SIGNEXTIN|ADDSUB", False, False, behind)
    module.end(_bits(cell, "input", ".*(HOLD|LOAD|RST)|CE|CLK"))


def _dsp48e1(module, cell):
    inside, behind = _set(cell, "MREG"), _set(cell, "PREG")
    for pins, before in (("A\\Z|ACIN", "AREG"), ("B\\Z|BCIN", "BREG"), ("D\\Z", "DREG")):
        _staged(module, cell, pins, _set(cell, before), inside, behind)
    _staged(module, cell, "C\\Z", _set(cell, "CREG"), False, behind)
    _staged(module, cell, "PCIN|CARRYIN|CARRYCASCIN|MULTSIGNIN|OPMODE|ALUMODE|INMODE", False, False,
            behind)
    module.end(_bits(cell, "input", "CE|RST|CLK"))


_ADD = {"logic": _logic, "carry": _carry, "register": _register, "ram": _ram, "ccu2c": _ccu2c,
        "carry4": _carry4, "mult18": _mult18, "mac16": _mac16, "dsp48e1": _dsp48e1}


def _instance(module, cell, inner):
    """An instance of a module whose paths are known."""
    module.inside = max(module.inside, inner.deepest)
    wires = {(pin, index): bit for direction in ("input", "output")
             for pin, index, bit in _pins(cell, direction)}
    for pin, levels in inner.out_of.items():
        if levels > NOWHERE and pin in wires:
            module.start([wires[pin]], levels)
    for pin, levels in inner.into.items():
        if levels > NOWHERE and pin in wires:
            module.end([wires[pin]], levels)
    arcs = defaultdict(list)
    for pin, outputs in inner.through.items():
        for out, levels in outputs.items():
            if pin in wires and out in wires:
                arcs[out].append((wires[pin], levels))
    for out, inputs in arcs.items():
        module.arcs(inputs, [wires[out]])


def depth(target, netlist, top):
    """Levels on the longest path between registers or ports."""
    known = {}

    def of(name):
        if name in known:
            return known[name]
        module, described = Module(), netlist["modules"][name]
        for cell in described["cells"].values():
            if cell["type"] in netlist["modules"]:
                _instance(module, cell, of(cell["type"]))
            else:
                _ADD[kind_of(target, cell["type"])[0]](module, cell)
        for port, about in described["ports"].items():
            for index, bit in enumerate(about["bits"]):
                if isinstance(bit, int):
                    module.ports[about["direction"]][port, index] = bit
        module.close()
        known[name] = module
        return module

    return of(top).total()
