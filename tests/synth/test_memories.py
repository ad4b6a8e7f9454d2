"""The one memory of the core becomes block memory where nothing is said about who reads it: neither
yosys' SYNTHESIS nor a macro of ours is defined.

SPDX-License-Identifier: Apache-2.0
"""

import json
from collections import Counter

import pytest

from tools.rtl import rtl_sources

MEMORY = "ffd_mem_sdp"


@pytest.mark.parametrize("width, depth, blocks", ((54, 512, 2), (36, 512, 1), (36, 1024, 2)))
def test_a_registered_read_is_block_memory_and_nothing_else(tmp_path, width, depth, blocks):
    """A block of ECP5 has 512 words of 36 bits."""
    netlist = tmp_path / "netlist.json"
    status, output = rtl_sources.run(["yosys", "-Q", "-T", "-p", "; ".join([
        "read_verilog -nosynthesis " + " ".join(rtl_sources.Sources().needed(MEMORY)),
        f"hierarchy -check -top {MEMORY} -chparam WIDTH {width} -chparam DEPTH {depth}",
        f"synth_ecp5 -top {MEMORY} -json {netlist}"])])
    assert status == 0, output[-2000:]
    cells = json.loads(netlist.read_text())["modules"][MEMORY]["cells"]
    assert Counter(cell["type"] for cell in cells.values()) == {"DP16KD": blocks}
