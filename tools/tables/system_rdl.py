"""rtl/hwffd.rdl, the registers for tools that read SystemRDL 2.0, as rtl/bus/registers.csv has them.

SPDX-License-Identifier: Apache-2.0
"""

from tools.tables import registers

NAME = "rtl/hwffd.rdl"
GENERATED = "Made by python3 -m tools.tables.generated_files write; changes here are lost."
# Access of the table -> properties of a field
ACCESS = {
    "const": "sw = r; hw = na;", "ro": "sw = r; hw = w;", "log": "sw = r; hw = w;", "counter": "sw = r; hw = w;",
    "rw": "sw = rw; hw = r;", "w1": "sw = w; hw = r; singlepulse;", "w1s": "sw = rw; hw = r; onwrite = woset;",
    "w1c": "sw = rw; hw = rw; onwrite = woclr;", "event": "sw = rw; hw = rw; onwrite = woclr;",
}


def _quoted(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _field(field):
    reset = f" = {field.width}'h{field.reset:X}" if field.access not in registers.RESETLESS else (
        " = 1'h0" if field.access == "w1" else "")
    return (f"    field {{ desc = {_quoted(field.description)}; {ACCESS[field.access]} }} "
            f"{field.name}[{field.low + field.width - 1}:{field.low}]{reset};")


def text(root):
    """What rtl/hwffd.rdl must be."""
    lines = [f"// {GENERATED}", "// The registers of hwffd_axi and hwffd_wishbone; docs/registers.md says how to use them.",
             "// SPDX-License-Identifier: Apache-2.0", "addrmap hwffd {", "  default regwidth = 32;",
             "  default accesswidth = 32;"]
    for register in registers.read(root):
        lines += ["", "  reg {", *(_field(field) for field in register.fields), f"  }} {register.name} @ 0x{register.offset:03X};"]
    return "\n".join([*lines, "};"]) + "\n"
