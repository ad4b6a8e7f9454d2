"""Targets that are mapped only to be routed, rows of synth/clocks.csv: the cells of each.

Their tables join those of mapped.py. They stand by themselves because the keys of all results have
the statements of mapped.py, which a chip that is added does not change.

SPDX-License-Identifier: Apache-2.0
"""

import mapped

_LUT = ("logic", {"lut": 1})
_FF = ("register", {"ff": 1})
_CONSTANT = ("carry", {})
_BLOCK = ("register", {"bram": 1})
CELLS = {
    "nexus": {
        "LUT4": _LUT, "INV": _LUT, "CCU2": ("ccu2c", {"lut": 2}), "VHI": _CONSTANT,
        "VLO": _CONSTANT, "FD1P3IX": _FF, "FD1P3JX": _FF, "MULT18X18": ("logic", {"dsp": 1}),
        "DPR16X4": ("ram", {"lutram": 4}), "PDPSC16K": _BLOCK,
    },
}
TARGETS = tuple(CELLS)

mapped.CELLS.update(CELLS)
mapped.FIELDS.update({target: mapped.FIELDS["ecp5"] for target in TARGETS})
