"""Prints reports that commands have written to build/reports/ as tables: python3 -m tools.reports.show NAME...

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import sys

from tools.project_root import ROOT
from tools.reports import report_modules, results


def main():
    parser = argparse.ArgumentParser(prog="show", description="Prints reports of build/reports/ as tables.")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="checkout to look at")
    parser.add_argument("names", nargs="+", metavar="NAME", choices=report_modules.MODULES)
    options = parser.parse_args()
    reports = results.Results(options.root, modules=report_modules.MODULES)
    try:
        report_modules.show(reports, options.names)
    except (results.Missing, results.RequestError) as error:
        print(f"show: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
