#!/usr/bin/env python3
"""hwffd view in a window of a virtual screen (Xvfb), with real events of mouse and keys (xdotool).

    test_view.py HWFFD

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import re
import signal
import struct
import subprocess
import time
import unittest

from tests.support.program import PROGRAM, ProgramTest

PATIENCE = 60  # seconds

# A grey octahedron: all that is red on the screen are control points.
MESH = "".join(f"v {x} {y} {z}\n" for x, y, z in
               ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)))
MESH += "".join(f"f {a} {b} {c}\n" for a, b, c in
                ((1, 3, 5), (3, 2, 5), (2, 4, 5), (4, 1, 5), (3, 1, 6), (2, 3, 6), (4, 2, 6), (1, 4, 6)))


def wait_for(what, condition):
    """The first value of the condition that is not false."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.1)
    raise AssertionError(f"waited {PATIENCE} s for {what}")


class Screen:
    """A virtual screen, whose pixels are in a file of the format XWD."""

    def __init__(self, folder):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1200x900x24", "-fbdir", folder,
             "-nolisten", "tcp"],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as number:
            self.environment = {**os.environ, "DISPLAY": ":" + number.readline().strip()}
        self.file = pathlib.Path(folder) / "Xvfb_screen0"

    def close(self):
        self.server.terminate()
        self.server.wait()

    def do(self, *words):
        """What xdotool prints."""
        return subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True,
                              capture_output=True, text=True).stdout.strip()

    def pixels(self):
        """Rows of bytes, four a pixel: blue, green, red, none."""
        content = self.file.read_bytes()
        header = struct.unpack(">25I", content[:100])
        begin, height, stride = header[0] + 12 * header[19], header[5], header[12]
        return [content[begin + y * stride:begin + (y + 1) * stride] for y in range(height)]

    def still(self):
        """pixels(), once they change no more."""
        before = self.pixels()
        while True:
            time.sleep(0.5)
            after = self.pixels()
            if after == before:
                return after
            before = after


def leftmost_control_point(rows):
    """The middle (x, y) of the red spot that is farthest to the left."""
    red = {(x, y) for y, row in enumerate(rows)
           for x, (b, r) in enumerate(zip(row[0::4], row[2::4])) if r > b + 60}
    spot, new = set(), [min(red)]
    while new:
        x, y = new.pop()
        if (x, y) not in red or (x, y) in spot:
            continue
        spot.add((x, y))
        new += [(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)]
    return tuple(round(sum(p[axis] for p in spot) / len(spot)) for axis in (0, 1))


class View(ProgramTest):
    given = {"solid.obj": MESH}

    def setUp(self):
        super().setUp()
        self.assertEqual(self.call("lattice", "--around", "solid.obj", "-o", "rest.json").returncode, 0)

    def open(self, *words):
        self.screen = Screen(str(self.folder))
        self.addCleanup(self.screen.close)
        self.viewer = subprocess.Popen(
            [PROGRAM, "view", "solid.obj", *words], cwd=self.folder, env=self.screen.environment,
            text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(self.viewer.kill)
        self.window = wait_for("the window", self.find_window)
        return self.screen.still()

    def find_window(self):
        self.assertIsNone(self.viewer.poll(), "the viewer has ended")
        try:
            return self.screen.do("search", "--onlyvisible", "--name", r"solid\.obj.*frames/s")
        except subprocess.CalledProcessError:
            return None

    def drag(self, button, begin, way):
        """The picture that follows. The viewer, as on a busy machine, sees the events all at once
        when the mouse is at its end already."""
        do, seen = self.screen.do, self.screen.pixels()
        self.viewer.send_signal(signal.SIGSTOP)
        do("mousemove", *begin)
        do("mousedown", button)
        do("mousemove", begin[0] + way[0] // 2, begin[1] + way[1] // 2)
        do("mousemove", begin[0] + way[0], begin[1] + way[1])
        do("mouseup", button)
        self.viewer.send_signal(signal.SIGCONT)
        wait_for("another picture", lambda: self.screen.pixels() != seen)
        return self.screen.still()

    def save(self, name):
        (self.folder / name).unlink(missing_ok=True)
        self.screen.do("key", "s")
        wait_for("the lattice", (self.folder / name).exists)
        return json.loads((self.folder / name).read_text())["points"]

    def close(self):
        """What the viewer has printed: standard output and error."""
        self.screen.do("key", "Escape")
        printed = self.viewer.communicate(timeout=PATIENCE)
        self.assertEqual(self.viewer.returncode, 0)
        return printed

    def test_a_point_that_is_dragged_takes_the_mesh_along(self):
        before = self.open("--lattice", "rest.json", "-o", "moved.json")
        title = self.screen.do("getwindowname", self.window)
        self.assertRegex(title, r"\Asolid\.obj - reference - \d+ frames/s\Z")
        point = leftmost_control_point(before)
        after = self.drag(1, point, (60, 40))
        self.assertNotEqual(before, after)
        self.assertNotEqual(leftmost_control_point(after), point)

        rest = json.loads((self.folder / "rest.json").read_text())["points"]
        moved = [(old, new) for old, new in zip(rest, self.save("moved.json")) if old != new]
        self.assertEqual(len(moved), 1)
        self.assertGreater(sum((a - b) ** 2 for a, b in zip(*moved[0])), 0.01)

        self.screen.do("key", "r")
        wait_for("the picture at the beginning", lambda: self.screen.pixels() == before)
        self.assertEqual(self.save("moved.json"), rest)
        self.assertEqual(self.close(), ("wrote moved.json\n" * 2, ""))

    def test_the_view_turns_and_zooms_and_the_lattice_stays(self):
        before = self.open("--lattice", "rest.json", "--device", "model")
        self.assertIn(" - model basic-fp32-overlapped - ", self.screen.do("getwindowname", self.window))
        turned = self.drag(3, (500, 400), (80, 30))
        self.assertNotEqual(before, turned)
        self.screen.do("click", 4)
        wait_for("another picture", lambda: self.screen.pixels() != turned)
        rest = json.loads((self.folder / "rest.json").read_text())["points"]
        self.assertEqual(self.save("lattice.json"), rest)
        self.assertEqual(self.close(), ("wrote lattice.json\n", ""))

    def test_a_lattice_that_cannot_be_saved_is_one_line_and_the_window_stays(self):
        (self.folder / "gone").mkdir()
        before = self.open("-o", "gone/lattice.json")
        (self.folder / "gone").rmdir()
        self.screen.do("key", "s")
        self.assertNotEqual(before, self.drag(1, leftmost_control_point(before), (60, 40)))
        out, err = self.close()
        self.assertEqual(out, "")
        self.assertRegex(err, r"\Ahwffd: .*gone.*\n\Z")

    def test_refusals_are_one_line(self):
        for words, status, part in (("solid.obj", 1, "DISPLAY"),
                                    ("solid.obj --lattice box --lattice box", 2, "one lattice"),
                                    ("solid.obj --outside away", 2, "away"),
                                    ("solid.obj --device fpga", 2, "fpga"),
                                    ("none.obj", 1, "none.obj")):
            with self.subTest(words):
                result = subprocess.run(
                    [PROGRAM, "view", *words.split()], cwd=self.folder, capture_output=True,
                    text=True, env={k: v for k, v in os.environ.items()
                                    if not re.match("DISPLAY|WAYLAND", k)})
                self.assertEqual(result.returncode, status)
                self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
                self.assertIn(part, result.stderr)


if __name__ == "__main__":
    unittest.main()
