"""What tests of the command hwffd with a device of another process share.

SPDX-License-Identifier: Apache-2.0
"""

from tests.support.program import ProgramTest


def cloud():
    return "".join(f"{n % 7} {n % 11} {n % 13}\n" for n in range(300))


class DeviceTest(ProgramTest):
    """A scene is (source, output, word...) of `hwffd deform`."""

    name = "hwffd"

    def deform(self, scene, *device):
        """What the command said, and the bytes that it wrote; None where it wrote no file."""
        source, out, *words = scene
        result = self.call("deform", source, *words, "-o", out, "--device", *device)
        path = self.folder / out
        if not path.exists():
            return result, None
        data = path.read_bytes()
        path.unlink()
        return result, data

    def assert_no_file(self, deformed, status, words):
        """Of what deform() returned: it was refused, and nothing written."""
        result, data = deformed
        self.assertIsNone(data)
        self.assert_refused(result, status, words)

    def refused(self, scene, status, words, *device):
        self.assert_no_file(self.deform(scene, *device), status, words)
