"""Copies a file or folder of those that yosys brings, such as models of cells.

    python3 -m tools.synth.yosys_files NAME COPY

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import shutil
import sys


def main(name, copy):
    yosys = shutil.which("yosys")
    if not yosys:
        print("yosys not found: run tools/install", file=sys.stderr)
        return 1
    source = pathlib.Path(yosys).resolve().parents[1] / "share" / "yosys" / name
    copy = pathlib.Path(copy)
    copy.parent.mkdir(parents=True, exist_ok=True)
    if not source.exists():
        print(f"{source} not found: run tools/install (yosys-dev brings it)", file=sys.stderr)
        return 1
    if source.is_dir():
        shutil.copytree(source, copy, copy_function=shutil.copyfile, dirs_exist_ok=True)
    else:
        shutil.copyfile(source, copy)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
