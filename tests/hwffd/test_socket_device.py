#!/usr/bin/env python3
"""The command hwffd with a core that another process serves: registers, memory and interrupt.

    test_socket_device.py HWFFD SERVED_CORE

SPDX-License-Identifier: Apache-2.0
"""

import contextlib
import pathlib
import subprocess
import sys
import unittest

from tests.support.deformed_files import DeviceTest, cloud
from tests.support.program import FAILURE, USAGE

SERVER = pathlib.Path(sys.argv.pop(1)).resolve()  # behind the program, which that import takes
ROWS = ("basic-fx18-overlapped", "basic-fp32-overlapped")


class SocketDevice(DeviceTest):
    given = {"cloud.xyz": cloud()}
    scenes = (("cloud.xyz", "out.xyz", "--lattice", "box", "--deform", "bend:30"),
              ("cloud.xyz", "out.xyz", "--lattice", "box", "--dims", "20x5x4", "--deform", "random:3"))

    @contextlib.contextmanager
    def served(self, row, *words):
        """The device, and the exit status of its process when it has ended."""
        path = self.folder / "core"
        ended = []
        with subprocess.Popen([SERVER, row, path, *map(str, words)], stdout=subprocess.PIPE, text=True) as process:
            self.assertEqual(process.stdout.readline(), "listening\n")
            yield f"socket:{path}", ended
            ended.append(process.wait())
        path.unlink()

    def test_the_files_of_the_model(self):
        for row in ROWS:
            for scene in self.scenes:
                with self.subTest(row=row, scene=scene):
                    expected = self.deform(scene, "model", "--org", row)[1]
                    with self.served(row) as (device, ended):
                        result, data = self.deform(scene, device)
                    self.assertEqual((result.returncode, ended), (0, [0]), result.stderr)
                    self.assertTrue(data and data == expected)

    def test_a_process_that_ends_is_one_line_and_no_file(self):
        for requests in 1, 40, 400:
            with self.subTest(requests=requests):
                with self.served(ROWS[0], requests) as (device, _):
                    deformed = self.deform(self.scenes[0], device)
                self.assert_no_file(deformed, FAILURE, ("socket:", "has ended"))

    def test_what_is_refused(self):
        for device, status, words in (
                (("socket:",), USAGE, ("needs the path of a socket",)),
                ((f"socket:{self.folder}/away",), FAILURE, ("is the process there",)),
                ((f"socket:{self.folder}/cloud.xyz",), FAILURE, ("is the process there",)),
                ((f"socket:{'x' * 200}",), FAILURE, ("longer than 107 bytes",))):
            self.refused(self.scenes[0], status, words, *device)
        with self.served(ROWS[0]) as (device, _):
            deformed = self.deform(self.scenes[0], device, "--org", ROWS[1])
        self.assert_no_file(deformed, FAILURE, (f"is not {ROWS[1]}",))


if __name__ == "__main__":
    unittest.main()
