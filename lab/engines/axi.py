"""The recorded commands in memory, and the steps of a driver that has hwffd_axi work them off.

SPDX-License-Identifier: Apache-2.0
"""

import csv
from dataclasses import dataclass

from tools.project_root import ROOT

BEAT = 16
RING, PACKETS = 0x0, 0x10000  # in bytes; results lie behind the packets
PAGE = 0x1000
# Kinds of steps, as ffd_bench_axi.v numbers them.
END, WRITE, READ, EQUAL, WAIT = range(5)
ID = 0x48464644


class AxiError(Exception):
    """Commands that do not go through memory, in one line."""


@dataclass(frozen=True)
class Job:
    """Lines of steps.hex and of memory.hex, and where results will be, all in beats."""

    steps: tuple
    memory: tuple
    first: int
    words: int


def offsets():
    """{register: its offset} of those that every core has."""
    with (ROOT / "rtl" / "bus" / "registers.csv").open(newline="", encoding="utf-8") as table:
        return {row["register"]: int(row["offset"], 16) for row in csv.DictReader(table)
                if not row["link"].startswith("if:")}


def packets(beats):
    """Lists of the beats of each packet. Raises AxiError where the last has no end."""
    cut = [[]]
    for beat in beats:
        cut[-1].append(beat)
        if beat.startswith("1"):
            cut.append([])
    if cut.pop():
        raise AxiError("the last packet has no end")
    return cut


def _words(beats):
    """Of a beat what lies in memory."""
    return [beat[2:].replace("_", "") for beat in beats]


def _registers(at, log2, packets_, first, results):
    """(kind, register, data) of a run, and of all registers before and behind it."""
    area = (results + 1) * BEAT
    every = [(READ, name, 0) for name in at]
    windows = [("READ_WINDOW", 0, first - 1), ("WRITE_WINDOW", first, first + area - 1)]
    bounds = [(WRITE, f"{window}_{name}_{half}", value if half == "LO" else 0)
              for window, base, limit in windows for name, value in (("BASE", base), ("LIMIT", limit))
              for half in ("LO", "HI")]
    given = (("RING_BASE_LO", RING), ("RING_BASE_HI", 0), ("RING_LOG2_SIZE", log2),
             ("RESULT_BASE_LO", first), ("RESULT_BASE_HI", 0), ("RESULT_SIZE", area),
             ("IRQ_ENABLE", 1), ("RING_HEAD", packets_), ("CONTROL", 1))
    return [(EQUAL, "ID", ID), *every, *bounds, (WRITE, "WINDOW_LOCK", 1),
            *((WRITE, name, value) for name, value in given), (WAIT, None, 0),
            (EQUAL, "RESULT_COUNT", results), *every, (END, None, 0)]


def job(beats, results):
    """The Job of a stream that has so many results."""
    cut, at = packets(beats), offsets()
    log2 = len(cut).bit_length()
    first = -(-(PACKETS + len(beats) * BEAT) // PAGE) * PAGE
    memory, address = [f"@{RING // BEAT:x}"], PACKETS
    for packet in cut:
        memory.append(f"{len(packet) * BEAT:016x}{address:016x}")
        address += len(packet) * BEAT
    memory += [f"@{PACKETS // BEAT:x}", *_words(beats)]
    steps = [f"{kind:x}{at.get(name, 0):03x}{data:08x}"
             for kind, name, data in _registers(at, log2, len(cut), first, results)]
    return Job(tuple(steps), tuple(memory), first // BEAT, first // BEAT + results + 1)
