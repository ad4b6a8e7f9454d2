"""A netlist of one configuration of hwffd_stream on one target, in Verilog, to be simulated.

It is what `make synth` maps, but that generic gates keep their memories: as flip-flops they would be
two thirds of the cells and tell nothing about the logic. Nets of several bits are split, since a
netlist assigns them bit by bit, which simulators take for loops.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import subprocess
import sys

from tools.project_root import ROOT
from tools.synth import synthesis, variants
from tools.tables import configurations

# The script of synth/ for each target.
SCRIPTS = {"ecp5": "ecp5", "generic": "generic_memories", "gw5a": "gw5a"}


def steps(row, target, out):
    """The steps of yosys, to be run in the root."""
    subject = synthesis.Subject(row, synthesis.CORE, target)
    mapped = [step.replace(f"script synth/{target}.ys", f"script synth/{SCRIPTS[target]}.ys")
              for step in synthesis.Synthesis(ROOT).script(subject)]
    return [*mapped, "splitnets", "opt_clean -purge", f'write_verilog -noattr "{out}"']


def find(name):
    """A row, or a core of synth/variants.csv. Raises TableError."""
    rows = configurations.read()
    changed = variants.read(ROOT / "synth" / "variants.csv", rows, synthesis.TOPS)
    named = {variant.name: variant for variant, top in changed if top == synthesis.CORE}
    return named[name] if name in named else configurations.find(rows, name)


def main():
    parser = argparse.ArgumentParser(description="Writes the netlist of a configuration.")
    parser.add_argument("name", help="a row of rtl/configurations.csv, or NAME+VARIANT")
    parser.add_argument("target", choices=SCRIPTS)
    parser.add_argument("out", type=pathlib.Path, help="Verilog to write")
    options = parser.parse_args()
    try:
        row = find(options.name)
        options.out.parent.mkdir(parents=True, exist_ok=True)
        commands = "; ".join(steps(row, options.target, options.out.resolve()))
        return subprocess.run(["yosys", "-Q", "-T", "-qq", "-p", commands], cwd=ROOT,
                              check=False).returncode
    except (configurations.TableError, OSError) as error:
        print(f"netlist: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
