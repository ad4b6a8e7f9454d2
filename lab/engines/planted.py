"""Copies of sources with a line changed: faults, which what must find them has to find, and memories
whose undefined words are X.

    python3 -m lab.engines.planted NAME FOLDER

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import sys
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[2]


class PlantError(Exception):
    """A change that cannot be made, in one line."""


@dataclass(frozen=True)
class Change:
    """A line of a source, and what it is in the copy."""

    source: str
    right: str
    wrong: str


COEFFICIENT, RESET, UNDEFINED = "coefficient", "reset", "undefined"
CHANGES = {
    # One bit of each coefficient.
    COEFFICIENT: Change("rtl/top/hwffd_stream.v", ".load_entry_i        (load_entry)",
                        ".load_entry_i        (load_entry ^ 256)"),
    # A register of control that nothing resets.
    RESET: Change("rtl/stream/ffd_stream_slots.v", "used_q <= {(SLOT_W + 1) {1'b0}};", ""),
    # A word that is read while it is written, which Verilator can only make wrong.
    UNDEFINED: Change("rtl/common/ffd_mem_sdp.v", "clash ? ~memory_q[read_address_i] :",
                      "clash ? {WIDTH{1'bx}} :"),
}


def changed(change, text):
    """The text with the change. Raises PlantError unless the line stands there once."""
    if text.count(change.right) != 1:
        raise PlantError(f"{change.source}: '{change.right}' does not stand there once")
    return text.replace(change.right, change.wrong)


def copy(name, folder):
    """The copy, under the name of its source. Raises PlantError."""
    change = CHANGES[name]
    out = folder / pathlib.Path(change.source).name
    text = changed(change, (ROOT / change.source).read_text(encoding="utf-8"))
    folder.mkdir(parents=True, exist_ok=True)
    out.write_text(text, encoding="utf-8")
    return out


def main():
    parser = argparse.ArgumentParser(description="Copies a source with a line changed.")
    parser.add_argument("name", choices=CHANGES)
    parser.add_argument("folder", type=pathlib.Path, help="for the copy, under the source's name")
    options = parser.parse_args()
    try:
        copy(options.name, options.folder)
    except (PlantError, OSError) as error:
        print(f"planted: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
