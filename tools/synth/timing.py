"""Clock and power of a netlist of standard cells, by OpenSTA: no wires, an ideal clock.

The netlist is what `json` of yosys writes, mapped. It is written for OpenSTA in the Verilog that
this reads, with each register named after what it holds, so that paths can be told in words.

SPDX-License-Identifier: Apache-2.0
"""

import re

from tools.synth import liberty

PROGRAM, PACKAGE = "sta", "opensta"
PERIOD_NS = 10  # of synth/osu018.tcl; power is that at this clock

_SLACK = re.compile(r"^\s*(-?[\d.]+)\s+slack \((?:MET|VIOLATED)\)", re.MULTILINE)
_START = re.compile(r"^Startpoint: (\S+)", re.MULTILINE)
_END = re.compile(r"^Endpoint: (\S+)", re.MULTILINE)
_POWER = re.compile(r"^Total(?:\s+[\d.e+-]+){3}\s+([\d.e+-]+)", re.MULTILINE)
_FAULT = re.compile(r"^(?:Error: .*|.*invalid command name.*)$", re.MULTILINE)


class TimingError(Exception):
    """A netlist that OpenSTA does not take, in one line."""


# The netlist as Verilog ---------------------------------------------------------------------------


class _Module:
    """One module; `names` are those of the modules in the text."""

    def __init__(self, about, names):
        self.about, self.names = about, names
        self.nets = {}
        for direction in ("input", "output"):
            for port, index, bit in self._port_bits(direction):
                self.nets.setdefault(bit, self._port(port, index))
        self.held = self._public_names()

    def _port_bits(self, direction):
        return [(port, index, bit) for port, which in self.about["ports"].items()
                if which["direction"] == direction for index, bit in enumerate(which["bits"])]

    def _port(self, port, index):
        return port if len(self.about["ports"][port]["bits"]) == 1 else f"{port}[{index}]"

    def _public_names(self):
        """bit -> the name that the sources have for it: a register's (_q), else the shortest."""
        named = {}
        for name, net in self.about["netnames"].items():
            if net["hide_name"]:
                continue
            for index, bit in enumerate(net["bits"]):
                full = name if len(net["bits"]) == 1 else f"{name}_{index}"
                rank = (not name.endswith("_q"), len(full), full)
                if isinstance(bit, int) and rank < named.get(bit, (2,)):
                    named[bit] = rank
        return {bit: rank[-1] for bit, rank in named.items()}

    def net(self, bit):
        if not isinstance(bit, int):
            return f"1'b{bit if bit in '01' else 0}"
        return self.nets.get(bit, f"n{bit}")

    def _instance(self, number, name, cell):
        inner = cell["type"] in self.names
        kind = self.names[cell["type"]] if inner else cell["type"]
        label = name if inner else f"g{number}"
        if not inner and liberty.cells()[kind][0] == "register":
            held = [self.held[bit] for pin, bits in cell["connections"].items() for bit in bits
                    if cell["port_directions"][pin] == "output" and bit in self.held]
            label = min(held, key=len) if held else label
        pins = ", ".join(f".{pin}({self._bus(bits)})"
                         for pin, bits in cell["connections"].items() if bits)
        return f"  {kind} \\{label.lstrip(chr(92))} ({pins});"

    def _bus(self, bits):
        nets = [self.net(bit) for bit in reversed(bits)]
        return nets[0] if len(nets) == 1 else "{" + ", ".join(nets) + "}"

    def text(self, name):
        ports = self.about["ports"]
        lines = [f"module {name} ({', '.join(ports)});"]
        for port, which in ports.items():
            width = len(which["bits"])
            lines.append(f"  {which['direction']} {f'[{width - 1}:0] ' if width > 1 else ''}{port};")
        lines += [self._instance(number, label, cell)
                  for number, (label, cell) in enumerate(self.about["cells"].items())]
        lines += [f"  assign {self._port(port, index)} = {self.net(bit)};"
                  for port, index, bit in self._port_bits("output")
                  if self.net(bit) != self._port(port, index)]
        return "\n".join([*lines, "endmodule", ""])


def verilog(netlist, top):
    """The netlist in Verilog, its modules m0, m1 and so on, but for the top."""
    modules = netlist["modules"]
    names = {module: top if module == top else f"m{number}"
             for number, module in enumerate(modules)}
    return "".join(_Module(about, names).text(names[module]) for module, about in modules.items())


# OpenSTA ------------------------------------------------------------------------------------------


def script(netlist, top, steps):
    """What OpenSTA reads: names and the steps of synth/osu018.tcl."""
    return "\n".join([f"set library {liberty.PATH}", f"set netlist {netlist}", f"set top {top}",
                      f"source {steps}", ""])


def parse(output):
    """fmax_mhz, power_mw and critical_path. Raises TimingError."""
    fault = _FAULT.search(output)
    if fault:
        raise TimingError(f"OpenSTA: {fault.group(0)}")
    found = [pattern.search(output) for pattern in (_SLACK, _START, _END, _POWER)]
    if None in found:
        raise TimingError("OpenSTA reported no path or no power")
    slack, start, end, power = (match.group(1) for match in found)
    return {
        "fmax_mhz": round(1000 / (PERIOD_NS - float(slack)), 1),
        "power_mw": round(1000 * float(power), 3),
        "critical_path": f"from {start} to {end}",
    }
