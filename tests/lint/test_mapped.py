"""scripts/mapped.py counts what yosys counts, and finds the depth that `ltp` finds; by hand where
there is no such command: carry chains, memories, registers inside multipliers, hierarchies.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import re
import unittest
from collections import Counter
from unittest import mock

from workspace import ROOT, Workspace

import liberty
import mapped
import rtl

SOURCES = rtl.Sources()
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
    return mapped.count(target, netlist, "top"), mapped.depth(target, netlist, "top")


class ByHand(unittest.TestCase):
    def depth(self, cells, target="ecp5", **more):
        return measure(cells, target, **more)[1]

    def test_counts(self):
        counts, _ = measure([lut([2], 3), lut([2], 4), ff(3, 5), cell("CCU2C", {}, {}),
                             cell("MULT18X18D", {}, {}), cell("TRELLIS_DPR16X4", {}, {}),
                             cell("DP16KD", {}, {})])
        self.assertEqual(counts, {"lut": 4, "lutram": 4, "ff": 1, "dsp": 1, "bram": 1})
        counts, _ = measure([cell(name, {}, {}) for name in
                             ("LUT1", "LUT6", "INV", "MUXF7", "CARRY4", "SRL16E", "RAM32M", "FDRE",
                              "FDSE", "DSP48E1", "RAMB18E1", "RAMB36E1")], "xilinx7")
        self.assertEqual(counts, {"lut": 3, "lutram": 5, "ff": 2, "dsp": 1, "bram": 3})
        counts, _ = measure([cell(name, {}, {}) for name in
                             ("SB_LUT4", "SB_CARRY", "SB_DFFESR", "SB_MAC16", "SB_RAM40_4K")],
                            "up5k")
        self.assertEqual(counts, {"lut": 1, "lutram": 0, "ff": 1, "dsp": 1, "bram": 1})
        counts, _ = measure([cell(name, {}, {}) for name in
                             ("$_NOT_", "$_MUX_", "$_SDFFE_PP0P_", "$_DFF_P_")], "generic")
        self.assertEqual(counts, {"cells": 4, "ff": 2})
        with mock.patch.object(liberty, "cells", lambda: liberty.parse(LIBRARY)):
            counts, levels = measure(
                [cell("INV", {"A": [2]}, {"Y": [3]}), cell("INV", {"A": [3]}, {"Y": [4]}),
                 cell("DFF", {"D": [4], "CLK": [1]}, {"Q": [2]})], "osu018")
        self.assertEqual((counts, levels), ({"area_um2": 128, "cells": 3, "ff": 1}, 2))

    def test_instances_are_counted_each(self):
        inner = module([lut([2], 3), ff(3, 4)], [2], [4])
        middle = module([cell("inner", {"i": [2]}, {"o": [3]}),
                         cell("inner", {"i": [3]}, {"o": [4]})], [2], [4])
        counts, _ = measure([cell("middle", {"i": [2]}, {"o": [3]}), lut([3], 4),
                             cell("inner", {"i": [4]}, {"o": [5]})], inner=inner, middle=middle)
        self.assertEqual((counts["lut"], counts["ff"]), (4, 3))
        self.assertEqual(mapped.kinds({"modules": {
            "top": module([cell("middle", {}, {}), lut([3], 4)]), "inner": inner,
            "middle": middle}}, "top"), {"LUT4": 3, "TRELLIS_FF": 2})

    def test_unknown_cells_are_refused(self):
        for target, name in (("ecp5", "$_DLATCH_P_"), ("ecp5", "$mul"), ("ecp5", "SB_LUT4"),
                             ("generic", "$_DLATCH_P_"), ("generic", "$add"), ("up5k", "$lut"),
                             ("hx8k", "SB_MAC16"), ("xilinx7", "LDCE"), ("generic", "$_SR_PP_")):
            with self.subTest(f"{name} on {target}"):
                with self.assertRaisesRegex(mapped.NetlistError, re.escape(name)):
                    measure([cell(name, {"A": [2]}, {"Y": [3]})], target)

    def test_logic_between_registers_and_ports(self):
        self.assertEqual(self.depth([]), 0)
        self.assertEqual(self.depth([ff(2, 3)]), 0)
        chain = [ff(2, 3), lut([3], 4), lut([4, 3], 5), lut([5], 6), ff(6, 7)]
        self.assertEqual(self.depth(chain), 3)
        self.assertEqual(self.depth(list(reversed(chain))), 3)
        self.assertEqual(self.depth(chain + [lut([7], 8)], outputs=[8]), 3)
        self.assertEqual(self.depth([lut([i], i + 1) for i in range(2, 7)], inputs=[2],
                                    outputs=[7]), 5)

    def test_a_loop_is_refused(self):
        with self.assertRaisesRegex(mapped.NetlistError, "loop"):
            measure([lut([2, 4], 3), lut([3], 4)], inputs=[2])

    def test_carry_chains_add_no_level(self):
        def half(a, carry_in, out, carry_out):
            return cell("CCU2C", {"A0": [a], "A1": [a], "CIN": carry_in},
                        {"S0": [out], "COUT": carry_out})

        chain = [half(2, ["0"], 10, [20])] + [
            half(2, [19 + i], 10 + i, [20 + i]) for i in range(1, 9)]
        self.assertEqual(self.depth([ff(1, 2), *chain, ff(18, 40)]), 1)
        self.assertEqual(self.depth([ff(1, 2), *chain, lut([18], 30), ff(30, 40)]), 2)
        # The lower sum of a cell may feed its upper half.
        twice = cell("CCU2C", {"A0": [2], "A1": [3], "CIN": ["0"]}, {"S0": [3], "S1": [4]})
        self.assertEqual(self.depth([ff(1, 2), twice, ff(4, 5)]), 2)
        carry = [cell("LUT2", {"I0": [2]}, {"O": [3]}),
                 cell("CARRY4", {"S": [3, 3, 3, 3], "DI": [2, 2, 2, 2], "CI": ["0"]},
                      {"O": [4, 5, 6, 7], "CO": [8, 9, 10, 11]}),
                 cell("CARRY4", {"S": [3, 3, 3, 4], "DI": [2, 2, 2, 2], "CI": [11]},
                      {"O": [12, 13, 14, 15], "CO": [16, 17, 18, 19]})]
        self.assertEqual(self.depth(carry, "xilinx7", inputs=[2], outputs=[15]), 1)

    def test_memories(self):
        ram = cell("TRELLIS_DPR16X4", {"RAD": [3], "WAD": [6], "DI": [6], "WCK": [1]}, {"DO": [4]})
        self.assertEqual(self.depth([ff(1, 2), lut([2], 3), ram, lut([4], 5), ff(5, 7)]), 3)
        write = [ff(1, 2), lut([2], 5), lut([5], 6), ram, lut([4], 7), ff(7, 8)]
        self.assertEqual(self.depth(write), 2)
        block = cell("DP16KD", {"ADA": [3]}, {"DOB": [4]})
        self.assertEqual(self.depth([ff(1, 2), lut([2], 3), block, lut([4], 5), ff(5, 7)]), 1)

    def test_registers_inside_multipliers(self):
        def dsp(**stages):
            path = [cell("FDRE", {"D": [9]}, {"Q": [2]}), cell("LUT1", {"I0": [2]}, {"O": [3]}),
                    cell("DSP48E1", {"A": [3]}, {"P": [4]}, **stages),
                    cell("LUT1", {"I0": [4]}, {"O": [5]}), cell("LUT1", {"I0": [5]}, {"O": [6]}),
                    cell("FDRE", {"D": [6]}, {"Q": [7]})]
            return self.depth(path, "xilinx7")

        self.assertEqual(dsp(), 4)
        self.assertEqual(dsp(AREG="00000000000000000000000000000001"), 3)
        self.assertEqual(dsp(MREG="1"), 3)
        self.assertEqual(dsp(PREG="1"), 2)
        self.assertEqual(dsp(AREG="1", PREG="1"), 2)

        def mac(**stages):
            path = [cell("SB_DFF", {"D": [9]}, {"Q": [2]}),
                    cell("SB_LUT4", {"I0": [2]}, {"O": [3]}),
                    cell("SB_MAC16", {"A": [3]}, {"O": [4]}, **stages),
                    cell("SB_LUT4", {"I0": [4]}, {"O": [5]}),
                    cell("SB_DFF", {"D": [5]}, {"Q": [6]})]
            return self.depth(path, "up5k")

        self.assertEqual(mac(), 3)
        self.assertEqual(mac(TOPOUTPUT_SELECT="11", A_REG="0"), 3)
        self.assertEqual(mac(TOPOUTPUT_SELECT="11", A_REG="1"), 2)
        self.assertEqual(mac(TOPOUTPUT_SELECT="01"), 2)

    def test_paths_through_modules(self):
        wire = module([lut([2], 3), lut([2], 4), lut([4], 5)], [2], [3, 5])
        stage = module([lut([2], 3), ff(3, 4), lut([4], 5), lut([5], 6)], [2], [6])
        cells = [ff(1, 2), cell("wire", {"i": [2]}, {"o": [3, 4]}),
                 cell("wire", {"i": [4]}, {"o": [5, 6]}), ff(5, 7), ff(6, 8)]
        self.assertEqual(self.depth(cells, wire=wire), 4)
        cells = [ff(1, 2), lut([2], 3), lut([3], 4), lut([4], 5),
                 cell("stage", {"i": [5]}, {"o": [6]}), lut([6], 7), ff(7, 8)]
        self.assertEqual(self.depth(cells, stage=stage), 4)
        self.assertEqual(self.depth(cells[4:], stage=stage), 3)
        inside = module([ff(2, 3), lut([3], 4), lut([4], 5), ff(5, 6)], [2], [6])
        self.assertEqual(self.depth([cell("inside", {"i": [2]}, {"o": [3]}), lut([3], 4)],
                                    inputs=[2], outputs=[4], inside=inside), 2)


class AgainstYosys(Workspace):
    def setUp(self):
        super().setUp()

    def map(self, top, target, kept, *parameters):
        """Maps a module of the tree: {flat?: netlist}, and what yosys printed after flattening."""
        folders = " ".join(f"-I {folder}" for folder in SOURCES.includes)
        steps = [f"read_verilog {folders} " + " ".join(SOURCES.needed(top)),
                 f"hierarchy -check -top {top}" + "".join(f" -chparam {p}" for p in parameters),
                 f"setattr -mod -set keep_hierarchy 1 *{kept}", f"script {ROOT}/synth/{target}.ys",
                 f"json -o {self.root}/False.json *", "setattr -mod -unset keep_hierarchy *",
                 "flatten", f"json -o {self.root}/True.json *", "stat", "ltp -noff"]
        status, output = rtl.run(["yosys", "-Q", "-T", "-p", "; ".join(steps)])
        self.assertEqual(status, 0, output[-2000:])
        netlists = {flat: json.loads((self.root / f"{flat}.json").read_text())
                    for flat in (False, True)}
        os.remove(self.root / "True.json")
        return netlists, output

    def test_gates(self):
        netlists, output = self.map("ffd_eval_poly", "generic", "ffd_num_step", "FORMAT 12")
        self.assertGreater(len(netlists[False]["modules"]), 1)
        self.assertEqual(len(netlists[True]["modules"]), 1)
        length = int(re.findall(r"Longest topological path in .* \(length=(\d+)\)", output)[-1])
        cells = int(re.findall(r"Number of cells: +(\d+)", output)[-1])
        flipflops = sum(int(count) for count in re.findall(
            r"^ +\$_S?DFF\S+ +(\d+)$", output[output.rindex("Number of cells"):], re.MULTILINE))
        for flat, netlist in netlists.items():
            with self.subTest(flat=flat):
                self.assertEqual(mapped.depth("generic", netlist, "ffd_eval_poly"), length)
                self.assertEqual(mapped.count("generic", netlist, "ffd_eval_poly"),
                                 {"cells": cells, "ff": flipflops})

    def test_targets(self):
        for target in ("ecp5", "up5k", "hx8k", "xilinx7"):
            with self.subTest(target):
                netlists, output = self.map("ffd_eval_poly", target, "ffd_num_step", "FORMAT 18")
                listed = Counter({name: int(count) for name, count in re.findall(
                    r"^ +([A-Z]\w+) +(\d+)$", output[output.rindex("Number of cells"):],
                    re.MULTILINE)})
                totals = Counter()
                for name, number in listed.items():
                    for field, each in mapped.kind_of(target, name)[1].items():
                        totals[field] += number * each
                for netlist in netlists.values():
                    counts = mapped.count(target, netlist, "ffd_eval_poly")
                    self.assertEqual(counts, {field: totals[field] for field in counts})
                depths = {mapped.depth(target, netlist, "ffd_eval_poly")
                          for netlist in netlists.values()}
                self.assertEqual(len(depths), 1, depths)
                self.assertGreater(min(depths), 1)

    def test_a_fixed_point_product_is_one_multiplier(self):
        netlists, _ = self.map("ffd_fx_product", "ecp5", "none", "W 18", "LATENCY 2")
        counts = mapped.count("ecp5", netlists[True], "ffd_fx_product")
        self.assertEqual((counts["dsp"], counts["lut"]), (1, 0))

    def test_a_wide_product_with_two_registers_maps_on_ice40(self):
        netlists, _ = self.map("ffd_fx_product", "up5k", "none", "W 32", "LATENCY 4")
        self.assertEqual(mapped.count("up5k", netlists[True], "ffd_fx_product")["dsp"], 4)


if __name__ == "__main__":
    unittest.main(verbosity=2)
