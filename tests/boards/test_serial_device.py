#!/usr/bin/env python3
"""The command hwffd with a board behind a serial line, simulated through its pins.

    test_serial_device.py HWFFD SERIAL_BOARD

What is not here is the USB chip: the line is a pseudo terminal, which takes any rate.

SPDX-License-Identifier: Apache-2.0
"""

import contextlib
import csv
import os
import pathlib
import subprocess
import sys
import unittest

from tests.support.deformed_files import DeviceTest, cloud
from tests.support.program import FAILURE, USAGE
from tools.project_root import ROOT

BOARD = pathlib.Path(sys.argv.pop(1)).resolve()  # behind the program, which that import takes
SIDE = 12  # of the sheet, in vertices
QUESTION = 16 * (32 + 4 * 32)  # bytes of results before the first that is asked for


def sheet():
    """A mesh with more vertices than a frame of the line may ask for."""
    lines = [f"v {x} {y} {(x * y) % 5 / 5}" for x in range(SIDE) for y in range(SIDE)]
    for at in range(1, SIDE * SIDE - SIDE + 1):
        if at % SIDE:
            lines.append(f"f {at} {at + SIDE} {at + 1}")
    return "\n".join(lines) + "\n"


def rows():
    with open(ROOT / "synth" / "boards" / "boards.csv", encoding="utf-8", newline="") as file:
        return {board["name"]: board["row"] for board in csv.DictReader(file)}


@contextlib.contextmanager
def board(name, *words):
    """The path of its line, while it is there."""
    with subprocess.Popen([BOARD, name, *map(str, words)], stdin=subprocess.PIPE,
                          stdout=subprocess.PIPE, text=True) as process:
        try:
            yield process.stdout.readline().strip()
        finally:
            process.stdin.close()
            process.wait()


class SerialDevice(DeviceTest):
    given = {"sheet.obj": sheet(), "cloud.xyz": cloud()}
    scenes = (("sheet.obj", "out.obj", "--lattice", "box", "--deform", "twist:70"),
              ("cloud.xyz", "out.xyz", "--lattice", "box", "--deform", "bend:30"),
              ("cloud.xyz", "out.xyz", "--lattice", "box", "--dims", "20x5x4", "--deform", "random:3"))

    def test_the_files_of_the_model(self):
        with board("ulx3s") as line:
            for scene in self.scenes:
                model, expected = self.deform(scene, "model", "--org", rows()["ulx3s"])
                self.assertEqual((model.returncode, model.stderr), (0, ""))
                result, data = self.deform(scene, f"serial:{line}")
                self.assertEqual((result.returncode, result.stderr), (0, ""), scene)
                self.assertEqual(data, expected, scene)
                self.assertGreaterEqual(data.count(b"\n"), SIDE * SIDE)
                self.assertIn(f"serial:{line} {rows()['ulx3s']}", result.stdout)

    def test_a_frame_of_before_is_ended_by_the_pause(self):
        _, expected = self.deform(self.scenes[1], "model", "--org", "cg1", "--format", "fx18")
        with board("ulx3s") as line:
            file = os.open(line, os.O_RDWR | os.O_NOCTTY)
            os.write(file, b"\x03\x00" + b"\x03" * 20)  # 28 bytes are missing
            os.close(file)
            result, data = self.deform(self.scenes[1], f"serial:{line}", "--format", "fx18")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(data, expected)

    def test_a_cable_that_is_pulled(self):
        for count in (100, QUESTION, QUESTION + 16 * 70 + 5):
            with board("ulx3s", count) as line:
                self.refused(self.scenes[0], FAILURE, (line, "closed", "cable"), f"serial:{line}")

    def test_nobody_answers(self):
        with board("silent") as line:
            self.refused(self.scenes[0], FAILURE, (line, "0 of 32 results", "5 s"), f"serial:{line}")

    def test_another_board(self):
        with board("icebreaker") as line:
            self.refused(self.scenes[0], FAILURE, (line, "not those of", rows()["ulx3s"]), f"serial:{line}")
        with board("ulx3s") as line:
            self.refused(self.scenes[0], FAILURE, (line, "cg1-fx32-overlapped", "bitstream"),
                         f"serial:{line}", "--org", "cg1", "--format", "fx32")

    def test_lines_that_are_none(self):
        scene = self.scenes[0]
        self.refused(scene, FAILURE, ("serial:none", "cannot be opened"), "serial:none")
        self.refused(scene, FAILURE, ("/dev/null", "no serial line"), "serial:/dev/null")
        self.refused(scene, USAGE, ("serial:/dev/ttyUSB0",), "serial:")
        self.refused(scene, USAGE, ("device serial", "'cg7'"), "serial:/dev/null", "--org", "cg7")
        with board("silent") as line:
            with subprocess.Popen(["flock", line, "cat"], stdin=subprocess.PIPE) as other:
                self.wait_for_lock(line)
                self.refused(scene, FAILURE, (line, "another program"), f"serial:{line}")
                other.stdin.close()

    def wait_for_lock(self, line):
        while subprocess.run(["flock", "--nonblock", line, "true"], check=False).returncode == 0:
            continue

    def test_info_names_it(self):
        text = self.call("info").stdout
        self.assertIn("devices.serial:PATH", text)
        self.assertIn(f"devices.serial:PATH\n  {rows()['ulx3s']}\n",
                      "\n".join(line.rstrip() for line in text.splitlines()) + "\n")


if __name__ == "__main__":
    unittest.main()
