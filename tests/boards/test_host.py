"""synth/boards/host.py at a pseudo terminal, whose other end is a board that answers by the rules.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pty
import select
import struct
import sys
import threading
import time
import tty

import pytest

from synth.boards import host
from tools.project_root import ROOT

HOST = ROOT / "synth" / "boards" / "host.py"

LAST = 1 << 31


def beat(*words):
    return struct.pack("<4I", *words)


def vertices(count, kind=0):
    return beat(3, count, kind << 8, 0) + b"".join(beat(v, 2, 3, v) for v in range(count))


COEFFICIENTS = beat(1, 0, 0, 0) + bytes(16 * 12)
LATTICE = beat(2, 0, 0x040404, 0) + bytes(16 * 64)


class Board(threading.Thread):
    """Answers each vertex with its own beat, as often as its packet wants."""

    def __init__(self, file, silent_after=None):
        super().__init__(daemon=True)
        self.file, self.left, self.frames = file, silent_after, []
        self.ended = threading.Event()

    def take(self, size):
        data = b""
        while len(data) < size:
            if self.ended.is_set():
                return None
            if select.select([self.file], [], [], 0.05)[0]:
                data += os.read(self.file, size - len(data))
        return data

    def run(self):
        while (count := self.take(2)) is not None:
            packet = self.take(16 * struct.unpack("<H", count)[0])
            if packet is None:
                return
            self.frames.append(packet)
            opcode, number, word, _ = struct.unpack("<4I", packet[:16])
            if opcode != 3:
                continue
            each = host.RESULTS[word >> 8 & 3]
            answers = [packet[16 * v + 16:16 * v + 32] for v in range(number) for _ in range(each)]
            for at, answer in enumerate(answers):
                if self.left is not None and len(self.frames) > self.left:
                    return
                *rest, last = struct.unpack("<4I", answer)
                mark = LAST if at == len(answers) - 1 else 0
                os.write(self.file, struct.pack("<4I", *rest, last | mark))


@pytest.fixture
def send(checkout):
    """Exit status, output, lines of complaints, frames that the board has got."""
    master, slave = pty.openpty()
    tty.setraw(slave)

    def sent(packets, silent_after=None):
        board = Board(master, silent_after)
        (checkout.root / "packets").write_bytes(packets)
        os.write(master, b"left over")  # of a session before
        board.start()
        status, out, errors = checkout.run(
            sys.executable, "-B", HOST, os.ttyname(slave), "packets", "results", "--timeout", "0.5",
            timeout=60)
        board.ended.set()
        board.join()
        return status, out, errors.splitlines(), board.frames
    yield sent
    os.close(master)
    os.close(slave)


def numbers(frames):
    """How many vertices each has."""
    return [struct.unpack("<I", frame[4:8])[0] for frame in frames]


def test_results_come_back_in_order(checkout, send):
    start = time.monotonic()
    status, out, errors, frames = send(COEFFICIENTS + LATTICE + vertices(150))
    assert (status, errors) == (0, [])
    assert time.monotonic() - start > host.PAUSE
    assert numbers(frames[2:]) == [64, 64, 22]
    assert frames[:2] == [COEFFICIENTS, LATTICE]
    assert (checkout.root / "results").read_bytes() == vertices(150)[16:]
    assert "5 frames, 150 results" in out


def test_derivatives_make_four_results(checkout, send):
    status, _, errors, frames = send(vertices(20, kind=1))
    assert (status, errors) == (0, [])
    assert numbers(frames) == [16, 4]
    assert len((checkout.root / "results").read_bytes()) == 16 * 80


@pytest.mark.parametrize("packets, wrong", (
    (vertices(2)[:-16], "ends inside a packet"), (vertices(2) + b"1", "a piece of a beat"),
    (beat(9, 0, 0, 0), "opcode 9")))
def test_what_is_refused(send, packets, wrong):
    status, _, (error,), frames = send(packets)
    assert (status, frames) == (1, [])
    assert wrong in error


def test_a_board_that_falls_silent(checkout, send):
    status, _, errors, _ = send(vertices(70), silent_after=1)
    assert (status, errors) == (1, [
        "host.py: 0 of 6 results came: is the board loaded, and the rate right?"])
    assert not (checkout.root / "results").exists()
