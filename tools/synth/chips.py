"""Targets that are mapped only to be routed, rows of synth/clocks.csv: the cells of each.

Their tables join those of mapped_netlist.py. They stand by themselves because the keys of all results have
the statements of mapped_netlist.py, which a chip that is added does not change.

SPDX-License-Identifier: Apache-2.0
"""

from tools.synth import mapped_netlist

_LUT = ("logic", {"lut": 1})
_FF = ("register", {"ff": 1})
_CONSTANT = ("carry", {})
_BLOCK = ("register", {"bram": 1})
_ADDER = ("adder", {"lut": 1})
CELLS = {
    "nexus": {
        "LUT4": _LUT, "INV": _LUT, "CCU2": ("ccu2c", {"lut": 2}), "VHI": _CONSTANT,
        "VLO": _CONSTANT, "FD1P3IX": _FF, "FD1P3JX": _FF, "MULT18X18": ("logic", {"dsp": 1}),
        "DPR16X4": ("ram", {"lutram": 4}), "PDPSC16K": _BLOCK,
    },
    "gowin": {
        **{f"LUT{inputs}": _LUT for inputs in range(1, 5)}, "ALU": _ADDER,
        **{f"DFF{kind}": _FF for kind in ("", "E", "R", "RE", "S", "SE")}, "VCC": _CONSTANT,
        "GND": _CONSTANT, "MULT18X18": ("logic", {"dsp": 1}),
        "RAM16SDP4": ("ram", {"lutram": 4}), "SDPB": _BLOCK, "SDPX9B": _BLOCK,
    },
    "gatemate": {
        **{f"CC_{kind}": _LUT for kind in ("LUT1", "LUT2", "L2T4", "L2T5", "MX2", "MX4")},
        "CC_ADDF": _ADDER, "CC_DFF": _FF, "CC_MULT": ("logic", {"dsp": 1}), "CC_BRAM_20K": _BLOCK,
        "CC_BRAM_40K": ("register", {"bram": 2}),
    },
}
CELLS["gw5a"] = {**CELLS["gowin"], "MULTALU27X18": CELLS["gowin"]["MULT18X18"]}
del CELLS["gw5a"]["MULT18X18"]
TARGETS = tuple(CELLS)
# Whose script runs at the end of another's.
_BEHIND = {"gw5a": "gowin"}


def files(root, target):
    """What the script of a target reads besides: cells, maps and memories, but no modules."""
    behind = _BEHIND.get(target)
    return sorted(path for path in (root / "synth" / target).glob("*")
                  if not path.name.startswith("ffd_")) + (
        [root / "synth" / f"{behind}.ys", *files(root, behind)] if behind else [])


def _adder(module, cell):
    """A bit of a sum: its carry comes in through CIN or CI and adds no level to the chain."""
    pins = [(pin, bit) for pin, bits in cell["connections"].items() for bit in bits]
    module.arcs([(bit, 0 if pin in ("CIN", "CI") else 1) for pin, bit in pins
                 if cell["port_directions"][pin] == "input"],
                [bit for pin, bit in pins if cell["port_directions"][pin] == "output"])


mapped_netlist._ADD["adder"] = _adder
mapped_netlist.CELLS.update(CELLS)
mapped_netlist.FIELDS.update({target: mapped_netlist.FIELDS["ecp5"] for target in TARGETS})
