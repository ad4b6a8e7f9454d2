"""Constraints of a standalone core by itself, in SDC and in XDC.

SPDX-License-Identifier: Apache-2.0
"""

from tools.standalone import templates

_KINDS = {"sdc": "For OpenSTA and other tools that read SDC.", "xdc": "For Vivado."}


def files(core, design):
    """name -> text"""
    def ports(wanted):
        return [name if width == 1 else f"{name}[*]" for name, (direction, width) in design.ports.items()
                if direction == wanted and name != "aclk"]

    return {f"{core.prefix}.{suffix}": templates.text(
        "constraints.sdc", core=core, kind=kind, inputs=ports("input"), outputs=ports("output"),
        interrupt="irq_o" in design.ports) for suffix, kind in _KINDS.items()}
