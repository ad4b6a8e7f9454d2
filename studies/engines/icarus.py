"""A bench in Icarus Verilog, with real X, and what it tells.

SPDX-License-Identifier: Apache-2.0
"""

import re
from dataclasses import dataclass

import rtl

_END = re.compile(r"^clocks (\d+)\b", re.MULTILINE)
_FOUND = re.compile(r"^(?:unknown|broken) .*$", re.MULTILINE)


class SimulationError(Exception):
    """A simulation that did not end, in one line."""


@dataclass(frozen=True)
class Bench:
    """The tops, the first of which is the bench; its parameters; files, folders of headers, macros."""

    tops: tuple
    parameters: dict
    files: tuple
    includes: tuple
    macros: tuple = ()


def command(line, folder, log):
    """What a program says. Raises SimulationError where it fails."""
    status, said = rtl.run(list(map(str, line)), folder)
    (folder / log).write_text(said, encoding="utf-8")
    if status:
        raise SimulationError(f"{line[0]} ended with {status}: see {folder / log}")
    return said


def told(said):
    """(clocks, what was unknown or broken). Raises SimulationError unless the bench came to its end."""
    end = _END.search(said)
    if not end:
        raise SimulationError("the bench did not end")
    return int(end[1]), _FOUND.findall(said)


def run(bench, folder):
    """told() of the bench, whose files lie in the folder."""
    command(["iverilog", "-g2005", "-o", "bench.vvp",
             *(word for top in bench.tops for word in ("-s", top)),
             *(f"-P{bench.tops[0]}.{name}={value}" for name, value in bench.parameters.items()),
             *(f"-D{macro}" for macro in bench.macros),
             *(f"-I{include}" for include in bench.includes), *bench.files], folder, "icarus.log")
    return told(command(["vvp", "-n", "bench.vvp"], folder, "bench.log"))
