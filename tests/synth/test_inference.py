"""What yosys makes of memories and products on several families (tools/synth/inference.py).

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from tools import command_line
from tools.project_root import ROOT
from tools.synth import inference

BY_NAME = {family.name: family for family in inference.FAMILIES}
PRINTED = """
=== hwffd_stream ===

   Number of cells:                 12
     DP16KD                          3
     LUT4                            4
     MULT18X18D                      5

=== design hierarchy ===

   Number of cells:                 14
     DP16KD                          4
     LUT4                            4
     PDPW16KD                        1
     TRELLIS_DPR16X4                 2
     MULT18X18D                      6
"""


def test_counts_are_those_of_the_whole():
    assert inference.counted(BY_NAME["Lattice ECP5"], PRINTED) == {
        "multipliers": {"MULT18X18D": 6}, "blocks": {"DP16KD": 4, "PDPW16KD": 1}, "small": {"TRELLIS_DPR16X4": 2}}


@pytest.mark.parametrize("family, module, parameters, kind", (
    ("Lattice ECP5", "ffd_mem_sdp", {"WIDTH": 36, "DEPTH": 512}, "blocks"),
    ("Lattice ECP5", "ffd_mem_sdp", {"WIDTH": 36, "DEPTH": 16, "READ_LATENCY": 0}, "small"),
    ("Lattice iCE40 UP5K", "ffd_fx_product", {"W": 16}, "multipliers"),
    ("Intel Cyclone V", "ffd_mem_sdp", {"WIDTH": 40, "DEPTH": 256}, "blocks"),
    ("Xilinx 7", "ffd_fx_product", {"W": 18}, "multipliers")))
def test_what_a_family_has(family, module, parameters, kind):
    counts = inference.mapped(ROOT, BY_NAME[family], module, parameters)
    assert {name for name, cells in counts.items() if cells} == {kind}
    assert sum(counts[kind].values()) in ((1, 2) if kind == "blocks" else (1, 2, 3, 4, 9))


def test_what_is_refused_is_one_line():
    with pytest.raises(inference.InferenceError, match="ffd_mem_sdp for Lattice ECP5: ERROR.*depth_must_be_at_least_2"):
        inference.mapped(ROOT, BY_NAME["Lattice ECP5"], "ffd_mem_sdp", {"DEPTH": 1})
    parser = command_line.Parser(prog="inference")
    parser.add_argument("row")
    parser.add_argument("parameters", nargs="*")
    with pytest.raises(command_line.Request, match="'AXIS': NAME=NUMBER wanted"):
        inference.work(parser.parse_args([inference.ROW, "AXIS"]), ROOT)
