"""The cells of the liberty file (tools/synth/liberty.py) as the simulator and OpenSTA want them here.

The simulator gets a model of each cell, its function with a delay. OpenSTA gets a copy of the library
that lets toggles be given cell by cell: Debian's (2.0.17, of 2019) takes activities of input ports
only and derives all others by itself. In the copy each cell has one more input, TOGGLES, without
capacitance; what toggles there the output does. That OpenSTA also adds the energies of a rising and a
falling output, and of all inputs from which it may come, where the mean is meant. In the copy they
are divided, so that the mean comes out; lab/tests/energy computes some by hand.

SPDX-License-Identifier: Apache-2.0
"""

import functools
import re
from dataclasses import dataclass

# At which entry of the tables delays are read: about two inputs of other cells, steep inputs.
LOAD_PF, SLEW_NS = 0.025, 0.06
PIN = "TOGGLES"
VOLTS = 1.8

_CELL = re.compile(r"(?m)(?=^cell \()")
_NAME = re.compile(r"cell \((\w+)\)")
_PIN = re.compile(r"(?m)(?=^  pin ?\()")
_PIN_NAME = re.compile(r"  pin ?\((\w+)\)")
_FIELD = r'(?m)^ *{} *: *"?([^";]*)"?;'
_DELAY = re.compile(r'cell_(?:rise|fall)\(\w+\) \{\s*index_1 \("([^"]*)"\);\s*index_2 \("([^"]*)"\);'
                    r"\s*values \(([^;]*)\);", re.DOTALL)
_POWER = re.compile(r"^    internal_power\(\) \{.*?^    \}", re.DOTALL | re.MULTILINE)
_VALUES = re.compile(r"(?<=values \()[^;]*(?=\);)")
_NUMBER = re.compile(r"-?\d+\.?\d*(?:e-?\d+)?")
_OTHER = re.compile(r"(?m)^ *(?:latch|three_state|clear|preset)\b")


class LibraryError(Exception):
    """A library that is not as it is taken to be, in one line."""


def _field(text, name):
    match = re.search(_FIELD.format(name), text)
    return match.group(1).strip() if match else None


@dataclass
class Cell:
    """One cell, its parts as they stand in the file."""

    name: str
    text: str

    @functools.cached_property
    def pins(self):
        """name -> its text"""
        return {_PIN_NAME.match(part).group(1): part for part in _PIN.split(self.text)[1:]}

    @functools.cached_property
    def outputs(self):
        return [name for name, text in self.pins.items() if _field(text, "direction") == "output"]

    @functools.cached_property
    def inputs(self):
        """pin -> its capacitance in pF"""
        return {name: float(_field(text, "capacitance")) for name, text in self.pins.items()
                if name not in self.outputs}

    @functools.cached_property
    def is_register(self):
        return _field(self.text, "clocked_on") is not None

    def delay_ps(self, pin):
        """Of an output: the mean over rising and falling and over the inputs."""
        delays = []
        for loads, slews, values in _DELAY.findall(self.pins[pin]):
            row = _nearest(loads, LOAD_PF)
            column = _nearest(slews, SLEW_NS)
            numbers = [float(number) for number in _NUMBER.findall(values)]
            delays.append(numbers[row * len(slews.split(",")) + column])
        if not delays:
            raise LibraryError(f"cell {self.name} has no delay")
        return round(1000 * sum(delays) / len(delays))


def _nearest(index, wanted):
    numbers = [float(number) for number in index.split(",")]
    return min(range(len(numbers)), key=lambda place: abs(numbers[place] - wanted))


def read(text):
    """(what stands before the cells, cell by name). Latches, what can float and what has an
    asynchronous reset are left out."""
    head, *bodies = _CELL.split(text)
    cells = {_NAME.match(body).group(1): Cell(_NAME.match(body).group(1), body) for body in bodies
             if not _OTHER.search(body)}
    if not cells:
        raise LibraryError("the library names no cells")
    return head, cells


# Models for the simulator -------------------------------------------------------------------------


def expression(function):
    """A liberty function in Verilog: AND is a blank there, OR a plus."""
    text = re.sub(r"\s*\+\s*", "|", function.strip())
    return re.sub(r"\s+", "&", text).replace("!", "~")


def model(cell):
    """A cell in Verilog. A register starts with any value, as one does that is switched on."""
    kind = "output reg" if cell.is_register else "output"
    pins = ", ".join([*(f"input {pin}" for pin in cell.inputs),
                      *(f"{kind} {pin}" for pin in cell.outputs)])
    lines = [f"module {cell.name} ({pins});"]
    for pin in cell.outputs:
        delay = f"#{cell.delay_ps(pin)}"
        if not cell.is_register:
            lines.append(f"  assign {delay} {pin} = {expression(_field(cell.pins[pin], 'function'))};")
            continue
        clock = expression(_field(cell.text, "clocked_on"))
        state = expression(_field(cell.text, "next_state"))
        lines += [f"  initial {pin} = $random;",
                  f"  always @(posedge {clock}) if ({pin} !== {state}) {pin} <= {delay} {state};"]
    return "\n".join([*lines, "endmodule", ""])


def models(cells):
    """All of them, in picoseconds."""
    return "`timescale 1ps/1ps\n" + "".join(map(model, cells.values()))


# A copy for OpenSTA -------------------------------------------------------------------------------


def _divided(text, by):
    return _VALUES.sub(lambda values: _NUMBER.sub(
        lambda number: f"{float(number.group(0)) / by:.8g}", values.group(0)), text)


def _mean(pin):
    """A pin with energies as that OpenSTA wants them. An input's own are right but for a clock."""
    if _field(pin, "direction") != "output" and _field(pin, "clock") != "true":
        return pin
    count = len(_POWER.findall(pin))
    of_clock = _field(pin, "clock") == "true" or "rising_edge" in pin or "falling_edge" in pin
    return _POWER.sub(lambda group: _divided(group.group(0), 2 if of_clock else count), pin)


def _toggled(cell):
    start, *pins = _PIN.split(cell.text)
    field = "next_state" if cell.is_register else "function"
    text = start + f"  pin({PIN}) {{ direction : input; capacitance : 0; }}\n"
    text += "".join(map(_mean, pins))
    return re.sub(rf'(?m)^( *{field} *:).*$', rf'\1 "{PIN}";', text)


def copy(head, cells):
    """The library with TOGGLES and with means of energies."""
    text = head + "".join(map(_toggled, cells.values()))
    return text if text.count("{") == text.count("}") else text.rstrip() + "\n}\n"
