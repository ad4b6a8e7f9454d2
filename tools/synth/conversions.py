"""Conversions between the programs that synth/Snakefile runs: files in, text out.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import json
import pathlib
import sys

from tools import whole_file
from tools.synth import boards, engine, mapped_netlist, nextpnr, placement, scan_chain, timing


def load(path):
    return json.loads(pathlib.Path(path).read_text())


def count(target, top, netlist, took, report=None):
    """What a mapped netlist consists of; of standard cells also what OpenSTA reported."""
    text = load(netlist)
    counts = {**mapped_netlist.count(target, text, top), "depth": mapped_netlist.depth(target, text, top),
              "kinds": mapped_netlist.kinds(text, top)}
    if report:
        counts.update(timing.parse(pathlib.Path(report).read_text(errors="replace")))
    return json.dumps({"seconds": engine.seconds(pathlib.Path(took)), **counts}) + "\n"


def cells(top, netlist):
    """A netlist of standard cells as OpenSTA reads it."""
    return timing.verilog(load(netlist), top)


def chain(top, netlist):
    """The chain around the ports of a netlist."""
    return scan_chain.verilog(placement.CHAINED, top, load(netlist)["modules"][top]["ports"])


def fastest(*reports):
    """The report with the highest clock, without its suffix."""
    return boards.fastest({report.removesuffix(".report"): nextpnr.clock(load(report))
                           for report in reports})


STEPS = (count, cells, chain, fastest)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("step", choices=[step.__name__ for step in STEPS])
    parser.add_argument("words", nargs="*")
    parser.add_argument("--out", help="file to write, whole or not at all")
    options = parser.parse_args()
    try:
        text = globals()[options.step](*options.words)
        if options.out:
            whole_file.write(options.out, text)
        else:
            sys.stdout.write(text)
    except (OSError, ValueError, KeyError, mapped_netlist.NetlistError, timing.TimingError) as error:
        print(f"ERROR: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
