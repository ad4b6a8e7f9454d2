"""Faults planted in a copy of a source, for the proof that what must find them does.

    planted.py NAME FOLDER

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import sys
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[2]


class PlantError(Exception):
    """A fault that cannot be planted, in one line."""


@dataclass(frozen=True)
class Fault:
    """A line of a source, and what it is in the copy."""

    source: str
    right: str
    wrong: str


FAULTS = {
    "coefficient": Fault("rtl/top/hwffd_stream.v", ".load_entry_i        (load_entry)",
                         ".load_entry_i        (load_entry ^ 256)"),
}


def spoiled(fault, text):
    """The text with the fault. Raises PlantError unless the line stands there once."""
    if text.count(fault.right) != 1:
        raise PlantError(f"{fault.source}: '{fault.right}' does not stand there once")
    return text.replace(fault.right, fault.wrong)


def copy(name, folder):
    """The copy, under the name of its source. Raises PlantError."""
    fault = FAULTS[name]
    out = folder / pathlib.Path(fault.source).name
    text = spoiled(fault, (ROOT / fault.source).read_text(encoding="utf-8"))
    folder.mkdir(parents=True, exist_ok=True)
    out.write_text(text, encoding="utf-8")
    return out


def main():
    parser = argparse.ArgumentParser(description="Copies a source with a planted fault.")
    parser.add_argument("name", choices=FAULTS)
    parser.add_argument("folder", type=pathlib.Path, help="for the copy, under the source's name")
    options = parser.parse_args()
    try:
        copy(options.name, options.folder)
    except (PlantError, OSError) as error:
        print(f"planted.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
