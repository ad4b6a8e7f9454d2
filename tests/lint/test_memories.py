"""The one memory of the core becomes block memory where nothing is said about who reads it: neither
yosys' SYNTHESIS nor a macro of ours is defined.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import tempfile
import unittest
from collections import Counter

from workspace import ROOT

import rtl

MEMORY = "ffd_mem_sdp"


def mapped_cells(width, depth):
    """Cell -> how many, of a memory with a registered read on ECP5."""
    with tempfile.TemporaryDirectory() as folder:
        netlist = pathlib.Path(folder) / "netlist.json"
        status, output = rtl.run(["yosys", "-Q", "-T", "-p", "; ".join([
            "read_verilog -nosynthesis " + " ".join(rtl.Sources().needed(MEMORY)),
            f"hierarchy -check -top {MEMORY} -chparam WIDTH {width} -chparam DEPTH {depth}",
            f"synth_ecp5 -top {MEMORY} -json {netlist}"])])
        assert status == 0, output[-2000:]
        module = json.loads(netlist.read_text())["modules"][MEMORY]
    return Counter(cell["type"] for cell in module["cells"].values())


class Memories(unittest.TestCase):
    def test_a_registered_read_is_block_memory_and_nothing_else(self):
        """A block has 512 words of 36 bits."""
        for width, depth, blocks in ((54, 512, 2), (36, 512, 1), (36, 1024, 2)):
            with self.subTest(width=width, depth=depth):
                self.assertEqual(mapped_cells(width, depth), {"DP16KD": blocks})


if __name__ == "__main__":
    unittest.main(verbosity=2)
