"""Commands for a standalone core and what the bit-true model answers, as the beats of its bus.

SPDX-License-Identifier: Apache-2.0
"""

import sys
from dataclasses import dataclass

from tools.project_root import ROOT
from tools.standalone.configuration import Refused
from tools.tables import features

UNIT = 128  # bits of a beat of docs/interface.md
SEED = 1
LAST, USER, HALF = 1, 2, 4  # flags of a beat; HALF: of 256 bits, without its upper half


@dataclass(frozen=True)
class Beat:
    data: int
    flags: int

    @property
    def last(self):
        return bool(self.flags & LAST)


@dataclass(frozen=True)
class Sample:
    """Units of 16 bytes in and out."""

    commands: list
    results: list
    vertices: int
    first: int  # commands up to the end of the first vertex, which is in a packet by itself
    errors: int  # ERROR_STATUS


def _units(table):
    return [Beat(sum(int(word) << 32 * place for place, word in enumerate(row[:4])), int(row[4])) for row in table]


def _library():
    """The library's model: that which is installed, or that of the checkout's build. Raises Refused."""
    sys.path.append(str(ROOT / "build" / "api" / "python"))
    try:
        from hwffd import _core  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        raise Refused(f"the Python package hwffd is wanted, whose model says what a core answers ({error}): "
                      "make hwffd installs it") from error
    return _core


def sample(core, vertices):
    """So many vertices, in packets of every kind that the core takes. Raises Refused."""
    parameters = core.parameters
    commands, results, count, first, errors = _library().core_sample(
        org=core.organization.name, n=parameters["N"], format=core.number_format.name,
        powers=core.evaluator == "powers", fused=parameters["FMA_LATENCY"] > 0, features=features.number_of(parameters),
        axis=parameters["AXIS"], pages=parameters["PAGES"], spans=parameters["SPANS"],
        grid_limit=parameters["GRID_LIMIT"], vertices=vertices, seed=SEED)
    return Sample(_units(commands), _units(results), count, first, errors)


def on_bus(units, width):
    """Units as beats of a bus of 64, 128 or 256 bits."""
    if width == UNIT:
        return units
    if width == UNIT // 2:
        return [Beat(unit.data >> shift & (1 << width) - 1, unit.flags if shift else 0)
                for unit in units for shift in (0, width)]
    beats, low = [], None
    for unit in units:
        if low is not None:
            beats.append(Beat(unit.data << UNIT | low.data, unit.flags))
            low = None
        elif unit.last:
            beats.append(Beat(unit.data, unit.flags | HALF))
        else:
            low = unit
    return beats


def hexadecimal(beats, width):
    """The text of a file for $readmemh: a digit of flags, then the data."""
    return "".join(f"{beat.flags:x}{beat.data:0{width // 4}x}\n" for beat in beats)


def packets(units):
    """The units of each packet."""
    some = []
    for unit in units:
        some.append(unit)
        if unit.last:
            yield some
            some = []
