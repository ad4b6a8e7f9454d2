"""A copy of an ECP5 netlist in which one LUT is wrong, for the proof that a fault is found.

It is the first LUT of a unit through which every vertex goes; its table is inverted.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import re
import sys

UNIT = "ffd_num_term"
LUT = re.compile(rf"(^module \S*{UNIT}\b(?:(?!endmodule).)*?"
                 r"\bLUT4 #\(\s*\.INIT\(16'h)([0-9a-f]{4})", re.DOTALL | re.MULTILINE)


def spoiled(netlist):
    """(the text with the fault, how many faults)"""
    return LUT.subn(lambda match: f"{match.group(1)}{0xFFFF ^ int(match.group(2), 16):04x}",
                    netlist, count=1)


def main():
    parser = argparse.ArgumentParser(description="Copies an ECP5 netlist with one LUT inverted.")
    parser.add_argument("netlist", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path, help="Verilog to write")
    options = parser.parse_args()
    try:
        text, faults = spoiled(options.netlist.read_text())
        if faults:
            options.out.write_text(text)
            return 0
        print(f"netlist_fault: {options.netlist}: no LUT4 in {UNIT}: name a unit that has one",
              file=sys.stderr)
    except OSError as error:
        print(f"netlist_fault: {error}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
