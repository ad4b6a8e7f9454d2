"""How often the nets of a netlist change, counted in what a simulator writes of them (VCD).

SPDX-License-Identifier: Apache-2.0
"""

from dataclasses import dataclass, field


class ActivityError(Exception):
    """A file that says nothing of activity, in one line."""


@dataclass
class Net:
    """One bit: its changes between 0 and 1, those that are left where only its last value of each
    clock counts, and the time for which it was 1. Known: it was always one or the other."""

    toggles: int = 0
    settled: int = 0
    high: int = 0
    known: bool = True


@dataclass
class Activity:
    """What the nets did between $dumpon and $dumpoff."""

    nets: dict = field(default_factory=dict)  # "net", or "net[3]" -> Net
    time: int = 0

    def unknown(self):
        """How many nets were neither 0 nor 1 for a while."""
        return sum(not net.known for net in self.nets.values())

    def clocks(self, period):
        """How many there were. Raises ActivityError where they are not whole ones."""
        if not self.time or self.time % period:
            raise ActivityError(f"the nets were written for {self.time} units of time, not for whole "
                                f"clocks of {period}")
        return self.time // period


class _Bit:
    """A bit on the way: its value and since when, its value when the clock of that began."""

    __slots__ = ("net", "value", "since", "clock", "before")

    def __init__(self):
        self.net, self.value, self.since, self.clock, self.before = Net(), "x", 0, 0, "x"

    def begins(self, value, time):
        self.value = self.before = value
        self.since, self.clock = time, 0
        self.net.known = value in "01"

    def takes(self, value, time, clock):
        """What it is from now on."""
        old = self.value
        if old == value:
            return
        if clock != self.clock:
            self._settles(clock)
        if old == "1":
            self.net.high += time - self.since
        if value not in "01":
            self.net.known = False
        elif old in "01":
            self.net.toggles += 1
        self.value, self.since = value, time

    def _settles(self, clock):
        if self.value != self.before and self.value in "01" and self.before in "01":
            self.net.settled += 1
        self.before, self.clock = self.value, clock

    def ends(self, time):
        self._settles(self.clock)
        if self.value == "1":
            self.net.high += time - self.since


def _variables(lines):
    """(identifier -> its bits, the last first as they are written; name -> bit)."""
    by_identifier, by_name = {}, {}
    for line in lines:
        words = line.split()
        if words[:1] == ["$var"]:
            width, identifier, name = int(words[2]), words[3], words[4]
            if identifier not in by_identifier:
                by_identifier[identifier] = [_Bit() for _ in range(width)]
            places = [name] if width == 1 else [f"{name}[{bit}]" for bit in reversed(range(width))]
            by_name.update(zip(places, by_identifier[identifier]))
        elif words[:1] == ["$enddefinitions"]:
            break
    return by_identifier, by_name


def _values(value, width):
    """As many as there are bits: leading zeros are not written, nor a leading x more than once."""
    return value if len(value) == width else value.rjust(
        width, "0" if value[0] in "01" else value[0])


class _Reader:
    """Lines of a file behind its names. Clocks are counted from $dumpon, in units of its time."""

    def __init__(self, by_identifier, period):
        self.bits, self.period = by_identifier, period
        self.time = self.begun = self.ended = self.clock = 0
        self.on = self.first = False  # what is written counts; it is how all of it begins

    def moves(self, time):
        self.time, self.clock = time, (time - self.begun) // self.period
        self.first = self.first and time == self.begun

    def turns(self, line):
        if line.startswith("$dumpon"):
            self.on = self.first = True
            self.begun, self.clock = self.time, 0
        elif line.startswith("$dumpoff") and self.on:
            self.on, self.ended = False, self.time

    def changes(self, identifier, value):
        bits = self.bits[identifier]
        for bit, digit in zip(bits, _values(value, len(bits))):
            if self.first:
                bit.begins(digit, self.time)
            else:
                bit.takes(digit, self.time, self.clock)

    def reads(self, lines):
        for line in lines:
            first = line[0]
            if first == "#":
                self.moves(int(line[1:]))
            elif first == "$":
                self.turns(line)
            elif not self.on:
                continue
            elif first in "01xz":
                self.changes(line[1:].rstrip(), first)
            elif first == "b":
                self.changes(*reversed(line[1:].split()))


def read(lines, period):
    """The Activity of the lines of a file, its clock in units of the file's time."""
    lines = iter(lines)
    by_identifier, by_name = _variables(lines)
    reader = _Reader(by_identifier, period)
    reader.reads(lines)
    for bits in by_identifier.values():
        for bit in bits:
            bit.ends(reader.ended)
    time = reader.ended - reader.begun if reader.ended else 0
    return Activity({name: bit.net for name, bit in by_name.items()}, time)
