"""synth/boards/host.py at a pseudo terminal, whose other end is a board that answers by the rules.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import pty
import select
import struct
import subprocess
import sys
import tempfile
import threading
import time
import tty
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HOST = ROOT / "synth" / "boards" / "host.py"
sys.dont_write_bytecode = True
sys.path.insert(0, str(HOST.parent))

import host  # noqa: E402

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


class Host(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.master, self.slave = pty.openpty()
        tty.setraw(self.slave)
        self.addCleanup(os.close, self.master)
        self.addCleanup(os.close, self.slave)

    def send(self, packets, silent_after=None):
        board = Board(self.master, silent_after)
        (self.folder / "packets").write_bytes(packets)
        os.write(self.master, b"left over")  # of a session before
        board.start()
        done = subprocess.run(
            [sys.executable, "-B", str(HOST), os.ttyname(self.slave), str(self.folder / "packets"),
             str(self.folder / "results"), "--timeout", "0.5"],
            text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False, timeout=60)
        board.ended.set()
        board.join()
        return done.returncode, done.stdout, done.stderr.splitlines(), board.frames

    def test_results_come_back_in_order(self):
        start = time.monotonic()
        status, out, err, frames = self.send(COEFFICIENTS + LATTICE + vertices(150))
        self.assertEqual((status, err), (0, []))
        self.assertGreater(time.monotonic() - start, host.PAUSE)
        self.assertEqual([struct.unpack("<I", f[4:8])[0] for f in frames[2:]], [64, 64, 22])
        self.assertEqual(frames[:2], [COEFFICIENTS, LATTICE])
        self.assertEqual((self.folder / "results").read_bytes(), vertices(150)[16:])
        self.assertIn("5 frames, 150 results", out)

    def test_derivatives_make_four_results(self):
        status, _, err, frames = self.send(vertices(20, kind=1))
        self.assertEqual((status, err), (0, []))
        self.assertEqual([struct.unpack("<I", f[4:8])[0] for f in frames], [16, 4])
        self.assertEqual(len((self.folder / "results").read_bytes()), 16 * 80)

    def test_what_is_refused(self):
        for packets, wrong in ((vertices(2)[:-16], "ends inside a packet"),
                               (vertices(2) + b"1", "a piece of a beat"),
                               (beat(9, 0, 0, 0), "opcode 9"),
                               (vertices(1, kind=3), "results 3")):
            status, _, err, frames = self.send(packets)
            self.assertEqual((status, len(err), frames), (1, 1, []))
            self.assertIn(wrong, err[0])

    def test_a_board_that_falls_silent(self):
        status, _, err, _ = self.send(vertices(70), silent_after=1)
        self.assertEqual(status, 1)
        self.assertEqual(err, ["host.py: 0 of 6 results came: is the board loaded, and the rate "
                               "right?"])
        self.assertFalse((self.folder / "results").exists())


if __name__ == "__main__":
    unittest.main()
