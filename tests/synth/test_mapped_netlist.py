"""tools/synth/mapped_netlist.py counts what yosys counts, and finds the depth that `ltp` finds; by hand where
there is no such command: carry chains, memories, registers inside multipliers, hierarchies.

SPDX-License-Identifier: Apache-2.0
"""

import json
import re
from collections import Counter

import pytest

from tools.project_root import ROOT
from tools.rtl import rtl_sources
from tools.synth import chips, liberty, mapped_netlist

SOURCES = rtl_sources.Sources()
LIBRARY = """\
cell (INV) {
  area : 16;
}
cell (DFF) {
  area : 96;
  ff (D,Q) {
  }
}
"""


def cell(cell_type, inputs, outputs, **parameters):
    """Pins are lists of bits: cell("LUT4", {"A": [2]}, {"Z": [3]})."""
    return {"type": cell_type, "parameters": parameters, "connections": {**inputs, **outputs},
            "port_directions": {**dict.fromkeys(inputs, "input"),
                                **dict.fromkeys(outputs, "output")}}


def lut(inputs, output):
    return cell("LUT4", {"A": inputs}, {"Z": [output]})


def ff(d, q):
    return cell("TRELLIS_FF", {"CLK": [1], "DI": [d]}, {"Q": [q]})


def module(cells, inputs=(), outputs=()):
    return {"cells": {str(i): each for i, each in enumerate(cells)},
            "ports": {"i": {"direction": "input", "bits": list(inputs)},
                      "o": {"direction": "output", "bits": list(outputs)}}}


def measure(cells, target="ecp5", inputs=(), outputs=(), **others):
    netlist = {"modules": {"top": module(cells, inputs, outputs), **others}}
    return mapped_netlist.count(target, netlist, "top"), mapped_netlist.depth(target, netlist, "top")


def depth(cells, target="ecp5", **more):
    return measure(cells, target, **more)[1]


def placed(*names):
    """Cells that are connected to nothing."""
    return [cell(name, {}, {}) for name in names]


@pytest.mark.parametrize("target, cells, counts", (
    ("ecp5", [lut([2], 3), lut([2], 4), ff(3, 5),
              *placed("CCU2C", "MULT18X18D", "TRELLIS_DPR16X4", "DP16KD")],
     {"lut": 4, "lutram": 4, "ff": 1, "dsp": 1, "bram": 1}),
    ("xilinx7", placed("LUT1", "LUT6", "INV", "MUXF7", "CARRY4", "SRL16E", "RAM32M", "FDRE", "FDSE",
                       "DSP48E1", "RAMB18E1", "RAMB36E1"),
     {"lut": 3, "lutram": 5, "ff": 2, "dsp": 1, "bram": 3}),
    ("up5k", placed("SB_LUT4", "SB_CARRY", "SB_DFFESR", "SB_MAC16", "SB_RAM40_4K"),
     {"lut": 1, "lutram": 0, "ff": 1, "dsp": 1, "bram": 1}),
    ("nexus", placed("LUT4", "INV", "CCU2", "VHI", "VLO", "FD1P3IX", "FD1P3JX", "MULT18X18",
                     "DPR16X4", "PDPSC16K"),
     {"lut": 4, "lutram": 4, "ff": 2, "dsp": 1, "bram": 1}),
    ("gowin", placed("LUT1", "LUT4", "ALU", "VCC", "GND", "DFF", "DFFRE", "MULT18X18", "RAM16SDP4",
                     "SDPB", "SDPX9B"),
     {"lut": 3, "lutram": 4, "ff": 2, "dsp": 1, "bram": 2}),
    ("gw5a", placed("LUT3", "ALU", "DFFSE", "MULTALU27X18", "RAM16SDP4", "SDPX9B"),
     {"lut": 2, "lutram": 4, "ff": 1, "dsp": 1, "bram": 1}),
    ("gatemate", placed("CC_LUT1", "CC_LUT2", "CC_L2T4", "CC_L2T5", "CC_MX2", "CC_MX4", "CC_ADDF",
                        "CC_DFF", "CC_MULT", "CC_BRAM_20K", "CC_BRAM_40K"),
     {"lut": 7, "lutram": 0, "ff": 1, "dsp": 1, "bram": 3}),
    ("generic", placed("$_NOT_", "$_MUX_", "$_SDFFE_PP0P_", "$_DFF_P_"), {"cells": 4, "ff": 2})))
def test_counts(target, cells, counts):
    assert measure(cells, target)[0] == counts


def test_standard_cells(monkeypatch):
    monkeypatch.setattr(liberty, "cells", lambda: liberty.parse(LIBRARY))
    assert measure([cell("INV", {"A": [2]}, {"Y": [3]}), cell("INV", {"A": [3]}, {"Y": [4]}),
                    cell("DFF", {"D": [4], "CLK": [1]}, {"Q": [2]})], "osu018") == (
        {"area_um2": 128, "cells": 3, "ff": 1}, 2)


def test_instances_are_counted_each():
    inner = module([lut([2], 3), ff(3, 4)], [2], [4])
    middle = module([cell("inner", {"i": [2]}, {"o": [3]}),
                     cell("inner", {"i": [3]}, {"o": [4]})], [2], [4])
    counts, _ = measure([cell("middle", {"i": [2]}, {"o": [3]}), lut([3], 4),
                         cell("inner", {"i": [4]}, {"o": [5]})], inner=inner, middle=middle)
    assert (counts["lut"], counts["ff"]) == (4, 3)
    assert mapped_netlist.kinds({"modules": {
        "top": module([cell("middle", {}, {}), lut([3], 4)]), "inner": inner,
        "middle": middle}}, "top") == {"LUT4": 3, "TRELLIS_FF": 2}


@pytest.mark.parametrize("target, name", (
    ("ecp5", "$_DLATCH_P_"), ("ecp5", "$mul"), ("ecp5", "SB_LUT4"), ("generic", "$_DLATCH_P_"),
    ("generic", "$add"), ("up5k", "$lut"), ("hx8k", "SB_MAC16"), ("xilinx7", "LDCE"),
    ("generic", "$_SR_PP_"), ("gw5a", "MULT18X18"), ("gatemate", "CC_DLT")))
def test_unknown_cells_are_refused(target, name):
    with pytest.raises(mapped_netlist.NetlistError, match=re.escape(name)):
        measure([cell(name, {"A": [2]}, {"Y": [3]})], target)


def test_logic_between_registers_and_ports():
    assert depth([]) == depth([ff(2, 3)]) == 0
    chain = [ff(2, 3), lut([3], 4), lut([4, 3], 5), lut([5], 6), ff(6, 7)]
    assert depth(chain) == depth(list(reversed(chain))) == 3
    assert depth(chain + [lut([7], 8)], outputs=[8]) == 3
    assert depth([lut([i], i + 1) for i in range(2, 7)], inputs=[2], outputs=[7]) == 5


def test_a_loop_is_refused():
    with pytest.raises(mapped_netlist.NetlistError, match="loop"):
        measure([lut([2, 4], 3), lut([3], 4)], inputs=[2])


def test_carry_chains_add_no_level():
    def half(a, carry_in, out, carry_out):
        return cell("CCU2C", {"A0": [a], "A1": [a], "CIN": carry_in},
                    {"S0": [out], "COUT": carry_out})

    chain = [half(2, ["0"], 10, [20])] + [
        half(2, [19 + i], 10 + i, [20 + i]) for i in range(1, 9)]
    assert depth([ff(1, 2), *chain, ff(18, 40)]) == 1
    assert depth([ff(1, 2), *chain, lut([18], 30), ff(30, 40)]) == 2
    # The lower sum of a cell may feed its upper half.
    twice = cell("CCU2C", {"A0": [2], "A1": [3], "CIN": ["0"]}, {"S0": [3], "S1": [4]})
    assert depth([ff(1, 2), twice, ff(4, 5)]) == 2
    adders = [cell("ALU", {"I0": [2], "I1": [2], "CIN": [10 + i]}, {"SUM": [20 + i], "COUT": [11 + i]})
              for i in range(9)]
    assert depth([cell("DFF", {"D": [1]}, {"Q": [2]}), *adders, cell("DFF", {"D": [28]}, {"Q": [3]})],
                 "gowin") == 1
    carry = [cell("LUT2", {"I0": [2]}, {"O": [3]}),
             cell("CARRY4", {"S": [3, 3, 3, 3], "DI": [2, 2, 2, 2], "CI": ["0"]},
                  {"O": [4, 5, 6, 7], "CO": [8, 9, 10, 11]}),
             cell("CARRY4", {"S": [3, 3, 3, 4], "DI": [2, 2, 2, 2], "CI": [11]},
                  {"O": [12, 13, 14, 15], "CO": [16, 17, 18, 19]})]
    assert depth(carry, "xilinx7", inputs=[2], outputs=[15]) == 1


def test_memories():
    ram = cell("TRELLIS_DPR16X4", {"RAD": [3], "WAD": [6], "DI": [6], "WCK": [1]}, {"DO": [4]})
    assert depth([ff(1, 2), lut([2], 3), ram, lut([4], 5), ff(5, 7)]) == 3
    assert depth([ff(1, 2), lut([2], 5), lut([5], 6), ram, lut([4], 7), ff(7, 8)]) == 2
    block = cell("DP16KD", {"ADA": [3]}, {"DOB": [4]})
    assert depth([ff(1, 2), lut([2], 3), block, lut([4], 5), ff(5, 7)]) == 1


@pytest.mark.parametrize("stages, levels", (
    ({}, 4), ({"AREG": "00000000000000000000000000000001"}, 3), ({"MREG": "1"}, 3),
    ({"PREG": "1"}, 2), ({"AREG": "1", "PREG": "1"}, 2)))
def test_registers_inside_dsp48(stages, levels):
    assert depth([cell("FDRE", {"D": [9]}, {"Q": [2]}), cell("LUT1", {"I0": [2]}, {"O": [3]}),
                  cell("DSP48E1", {"A": [3]}, {"P": [4]}, **stages),
                  cell("LUT1", {"I0": [4]}, {"O": [5]}), cell("LUT1", {"I0": [5]}, {"O": [6]}),
                  cell("FDRE", {"D": [6]}, {"Q": [7]})], "xilinx7") == levels


@pytest.mark.parametrize("stages, levels", (
    ({}, 3), ({"REG_OUTPUT_CLK": "NONE"}, 3), ({"REG_INPUTA_CLK": "CLK0"}, 2),
    ({"REG_INPUTB_CLK": "CLK0"}, 3), ({"REG_PIPELINE_CLK": "CLK0"}, 2),
    ({"REG_INPUTA_CLK": "CLK0", "REG_OUTPUT_CLK": "CLK0"}, 1)))
def test_registers_inside_mult18(stages, levels):
    assert depth([ff(9, 2), lut([2], 3), cell("MULT18X18D", {"A3": [3]}, {"P7": [4]}, **stages),
                  lut([4], 5), ff(5, 6)]) == levels


@pytest.mark.parametrize("stages, levels", (
    ({}, 3), ({"TOPOUTPUT_SELECT": "11", "A_REG": "0"}, 3),
    ({"TOPOUTPUT_SELECT": "11", "A_REG": "1"}, 2), ({"TOPOUTPUT_SELECT": "01"}, 2)))
def test_registers_inside_mac16(stages, levels):
    assert depth([cell("SB_DFF", {"D": [9]}, {"Q": [2]}), cell("SB_LUT4", {"I0": [2]}, {"O": [3]}),
                  cell("SB_MAC16", {"A": [3]}, {"O": [4]}, **stages),
                  cell("SB_LUT4", {"I0": [4]}, {"O": [5]}),
                  cell("SB_DFF", {"D": [5]}, {"Q": [6]})], "up5k") == levels


def test_paths_through_modules():
    wire = module([lut([2], 3), lut([2], 4), lut([4], 5)], [2], [3, 5])
    stage = module([lut([2], 3), ff(3, 4), lut([4], 5), lut([5], 6)], [2], [6])
    cells = [ff(1, 2), cell("wire", {"i": [2]}, {"o": [3, 4]}),
             cell("wire", {"i": [4]}, {"o": [5, 6]}), ff(5, 7), ff(6, 8)]
    assert depth(cells, wire=wire) == 4
    cells = [ff(1, 2), lut([2], 3), lut([3], 4), lut([4], 5),
             cell("stage", {"i": [5]}, {"o": [6]}), lut([6], 7), ff(7, 8)]
    assert depth(cells, stage=stage) == 4
    assert depth(cells[4:], stage=stage) == 3
    inside = module([ff(2, 3), lut([3], 4), lut([4], 5), ff(5, 6)], [2], [6])
    assert depth([cell("inside", {"i": [2]}, {"o": [3]}), lut([3], 4)],
                 inputs=[2], outputs=[4], inside=inside) == 2


@pytest.fixture
def mapping(tmp_path):
    """Maps a module of the tree: {flat?: netlist}, and what yosys printed after flattening."""
    def run(top, target, units, *parameters):
        folders = " ".join(f"-I {folder}" for folder in SOURCES.includes)
        steps = [f"read_verilog {folders} " + " ".join(SOURCES.needed(top)),
                 f"hierarchy -check -top {top}" + "".join(f" -chparam {p}" for p in parameters),
                 f"setattr -mod -set keep_hierarchy 1 *{units}", f"script {ROOT}/synth/{target}.ys",
                 f"json -o {tmp_path}/False.json *", "setattr -mod -unset keep_hierarchy *",
                 "flatten", f"json -o {tmp_path}/True.json *", "stat", "ltp -noff"]
        status, output = rtl_sources.run(["yosys", "-Q", "-T", "-p", "; ".join(steps)], ROOT)
        assert status == 0, output[-2000:]
        return {flat: json.loads((tmp_path / f"{flat}.json").read_text())
                for flat in (False, True)}, output
    return run


def test_gates_as_yosys_counts_them(mapping):
    netlists, output = mapping("ffd_eval_poly", "generic", "ffd_num_step", "FORMAT 12")
    assert len(netlists[False]["modules"]) > len(netlists[True]["modules"]) == 1
    length = int(re.findall(r"Longest topological path in .* \(length=(\d+)\)", output)[-1])
    cells = int(re.findall(r"Number of cells: +(\d+)", output)[-1])
    flipflops = sum(int(count) for count in re.findall(
        r"^ +\$_S?DFF\S+ +(\d+)$", output[output.rindex("Number of cells"):], re.MULTILINE))
    for netlist in netlists.values():
        assert mapped_netlist.depth("generic", netlist, "ffd_eval_poly") == length
        assert mapped_netlist.count("generic", netlist, "ffd_eval_poly") == {
            "cells": cells, "ff": flipflops}


# In make test-synth those that take a second, and one of iCE40.
SOON = ("ecp5", "up5k", "gowin", "gw5a", "gatemate")


@pytest.mark.parametrize("target", [target if target in SOON else pytest.param(target, marks=pytest.mark.whole)
                                    for target in ("ecp5", "up5k", "hx8k", "xilinx7", *chips.TARGETS)])
def test_targets_as_yosys_counts_them(mapping, target):
    netlists, output = mapping("ffd_eval_poly", target, "ffd_num_step", "FORMAT 18")
    totals = Counter()
    for name, number in re.findall(r"^ +([A-Z]\w+) +(\d+)$",
                                   output[output.rindex("Number of cells"):], re.MULTILINE):
        for field, each in mapped_netlist.kind_of(target, name)[1].items():
            totals[field] += int(number) * each
    for netlist in netlists.values():
        counts = mapped_netlist.count(target, netlist, "ffd_eval_poly")
        assert counts == {field: totals[field] for field in counts}
    first, second = (mapped_netlist.depth(target, netlist, "ffd_eval_poly") for netlist in netlists.values())
    assert first == second > 1


def test_a_fixed_point_product_is_one_multiplier(mapping):
    netlists, _ = mapping("ffd_fx_product", "ecp5", "none", "W 18", "LATENCY 2")
    counts = mapped_netlist.count("ecp5", netlists[True], "ffd_fx_product")
    assert (counts["dsp"], counts["lut"]) == (1, 0)


def test_a_wide_product_with_two_registers_maps_on_ice40(mapping):
    netlists, _ = mapping("ffd_fx_product", "up5k", "none", "W 32", "LATENCY 4")
    assert mapped_netlist.count("up5k", netlists[True], "ffd_fx_product")["dsp"] == 4
