"""What HARDENED holds three times is three times in a netlist of yosys, and a register that is, once where the
words that say so are left out.

SPDX-License-Identifier: Apache-2.0
"""

import json
import re
from collections import Counter

import pytest

from tools.rtl import rtl_sources

WIDTH = 8
ATTRIBUTE = re.compile(r"\(\*(?!\)).*?\*\)")
TARGETS = {"ecp5": ("synth_ecp5 -nowidelut", "TRELLIS_FF"), "ice40": ("synth_ice40", "SB_DFF"),
           "generic": ("synth -flatten", "$_DFF_P_")}


def registers(folder, module, parameters, target, words):
    """How many flip-flops of that kind a target's flow makes of it, with or without its attributes."""
    script, cell = TARGETS[target]
    sources, files = rtl_sources.Sources(), []
    for path in map(rtl_sources.pathlib.Path, sources.needed(module)):
        text = path.read_text()
        files.append(folder / path.name)
        files[-1].write_text(text if words else ATTRIBUTE.sub("", text))
    netlist = folder / "netlist.json"
    status, output = rtl_sources.run(["yosys", "-Q", "-T", "-p", "; ".join([
        "read_verilog " + "".join(f"-I {path} " for path in sources.includes) + " ".join(map(str, files)),
        f"hierarchy -check -top {module}" + "".join(f" -chparam {word}" for word in parameters),
        f"{script} -top {module}", "setattr -mod -unset keep_hierarchy *",
        "setattr -unset keep_hierarchy */t:*", "flatten", f"write_json {netlist}"])])
    assert status == 0, output[-2000:]
    cells = json.loads(netlist.read_text())["modules"][module]["cells"].values()
    return Counter(instance["type"] for instance in cells)[cell]


@pytest.mark.parametrize("target", TARGETS)
def test_a_bit_has_three_registers(tmp_path, target):
    tripled = registers(tmp_path, "ffd_hard_triple", [f"WIDTH {WIDTH}"], target, words=True)
    merged = registers(tmp_path, "ffd_hard_triple", [f"WIDTH {WIDTH}"], target, words=False)
    assert (tripled, merged) == (3 * WIDTH, WIDTH)


def test_the_slave_is_there_three_times(tmp_path):
    def count(hardened):
        return registers(tmp_path, "ffd_axil_voted", [f"HARDENED {hardened}"], "ecp5", words=True)
    once = count(0)
    assert once > 50
    assert count(1) >= 3 * once
