"""Writes the blocks of the texts that are of the sources, or of reports of the product's own commands.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import sys

from tools.project_root import ROOT
from tools.reports import report_modules, text_blocks


def main():
    parser = argparse.ArgumentParser(prog="write_blocks", description="Writes blocks of the texts.")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="checkout to work on")
    options = parser.parse_args()
    changed, wrong = text_blocks.Blocks(options.root.absolute(), report_modules.MODULES, partly=True).write()
    for line in wrong:
        print(f"write_blocks: {line}", file=sys.stderr)
    print(f"write_blocks: {len(changed)} texts changed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
