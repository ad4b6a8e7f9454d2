#!/usr/bin/env python3
"""Sends packets to a board over its serial line and keeps the results.

Reads packets and writes results as 128-bit beats, 16 bytes each, as docs/interface.md describes
them; where a packet ends follows from its header. One packet at a time: its results are awaited
before the next goes out. A packet of vertices with more than 64 results is split.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import os
import select
import struct
import sys
import termios
import time

BEAT = 16
COEFFICIENTS, LATTICE, VERTICES, INTERLEAVED = 1, 2, 3, 4
RESULTS = {0: 1, 1: 4, 2: 2, 3: 1}  # kind -> beats a vertex
MOST_RESULTS = 64             # of a frame, so that the board never has to refuse a byte
PAUSE = 0.1                   # seconds: longer than the board's, 2^20 clocks
LAST = 1 << 31                # of a result's word 3


class HostError(Exception):
    """What went wrong, in one line."""


def words(beat):
    return struct.unpack("<4I", beat)


def payload(header):
    """(beats after the header, vertices, beats a vertex, results a vertex) of a packet."""
    opcode, count, word, _ = words(header)
    opcode &= 0xFF
    if opcode == COEFFICIENTS:
        return (24 if word >> 31 else 12), 0, 0, 0
    if opcode == LATTICE:
        return (word & 0xFF) * (word >> 8 & 0xFF) * (word >> 16 & 0xFF), 0, 0, 0
    each = {VERTICES: 1, INTERLEAVED: 49}.get(opcode)
    results = RESULTS.get(word >> 8 & 3)
    if each is None or results is None:
        raise HostError(f"opcode {opcode}, results {word >> 8 & 3}: not a packet")
    return count * each, count, each, results


def requests(data):
    """(beats, results) of each frame to send. Raises HostError."""
    at = 0
    while at < len(data):
        header = data[at:at + BEAT]
        if len(header) < BEAT:
            raise HostError(f"byte {at}: a piece of a beat")
        beats, vertices, each, results = payload(header)
        at += BEAT
        body = data[at:at + beats * BEAT]
        if len(body) < beats * BEAT:
            raise HostError(f"byte {at}: the file ends inside a packet")
        at += len(body)
        if not vertices:
            yield header + body, 0
            continue
        most = MOST_RESULTS // results
        for first in range(0, vertices, most):
            count = min(most, vertices - first)
            part = header[:4] + struct.pack("<I", count) + header[8:]
            yield (part + body[first * each * BEAT:(first + count) * each * BEAT],
                   count * results)


class Line:
    """A serial line, 8 data bits, no parity, 1 stop bit, without flow control."""

    def __init__(self, path, baud):
        speed = getattr(termios, f"B{baud}", None)
        if speed is None:
            raise HostError(f"{baud} baud: not a rate of this system")
        self.file = os.open(path, os.O_RDWR | os.O_NOCTTY)
        settings = termios.tcgetattr(self.file)
        settings[0] = settings[1] = settings[3] = 0
        settings[2] = termios.CS8 | termios.CREAD | termios.CLOCAL
        settings[4] = settings[5] = speed
        settings[6][termios.VMIN], settings[6][termios.VTIME] = 0, 0
        termios.tcsetattr(self.file, termios.TCSANOW, settings)

    def close(self):
        os.close(self.file)

    def synchronise(self):
        """A pause ends what a frame of before may have left open; its results are dropped."""
        time.sleep(PAUSE)
        while self.read(BEAT, PAUSE):
            pass

    def read(self, most, timeout):
        """What comes next, at most so many bytes; nothing after `timeout` seconds."""
        if not select.select([self.file], [], [], timeout)[0]:
            return b""
        return os.read(self.file, most)

    def ask(self, beats, results, timeout):
        """Sends a packet as a frame and returns its results. Raises HostError."""
        frame = struct.pack("<H", len(beats) // BEAT) + beats
        while frame:
            frame = frame[os.write(self.file, frame):]
        received = b""
        while len(received) < results * BEAT:
            more = self.read(results * BEAT - len(received), timeout)
            if not more:
                raise HostError(f"{len(received) // BEAT} of {results} results came: is the board "
                                "loaded, and the rate right?")
            received += more
        if results and not words(received[-BEAT:])[3] & LAST:
            raise HostError("the last result of a packet is not marked so: out of step")
        return b"".join(unmarked(received[at:at + BEAT]) for at in range(0, len(received), BEAT))


def unmarked(result):
    """Without the mark of the line's frames."""
    return result[:12] + struct.pack("<I", words(result)[3] & ~LAST)


def main():
    parser = argparse.ArgumentParser(description="Sends packets to a board, keeps its results.")
    parser.add_argument("device", help="serial line, such as /dev/ttyUSB1")
    parser.add_argument("packets", help="file of beats to send")
    parser.add_argument("results", help="file for the beats that come back")
    parser.add_argument("--baud", type=int, default=1000000, help="bits a second (1000000)")
    parser.add_argument("--timeout", type=float, default=1.0, help="seconds for a result (1)")
    options = parser.parse_args()
    try:
        with open(options.packets, "rb") as file:
            frames = list(requests(file.read()))
        line = Line(options.device, options.baud)
        try:
            line.synchronise()
            start = time.monotonic()
            received = b"".join(line.ask(*frame, options.timeout) for frame in frames)
        finally:
            line.close()
        with open(options.results, "wb") as file:
            file.write(received)
    except (HostError, OSError, termios.error) as error:
        print(f"host.py: {error}", file=sys.stderr)
        return 1
    print(f"{len(frames)} frames, {len(received) // BEAT} results in "
          f"{time.monotonic() - start:.2f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
