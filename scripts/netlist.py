#!/usr/bin/env python3
"""A generic gate netlist of one configuration of hwffd_stream, in Verilog, made by yosys.

Everything becomes gates and flip-flops of one bit, except the memories: as flip-flops they would be
two thirds of the cells and tell nothing about the logic. All is flattened but the multiplier of the
fixed-point formats, the same gates a dozen times.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import subprocess
import sys

import configurations
import rtl

TOP = "hwffd_stream"
KEPT = "*ffd_fx_product*"


def script(sources, configuration, out):
    """The steps of yosys: its own `synth` but for memory_map, and nets of one bit each at the end.

    A netlist assigns the bits of a bus one by one, which simulators take for loops through it.
    """
    folders = "".join(f"-I {folder} " for folder in sources.includes)
    files = " ".join(f'"{path}"' for path in sources.needed(TOP))
    parameters = "".join(
        f" -chparam {name} {value}" for name, value in configuration.parameters.items())
    return "; ".join([
        f"read_verilog {folders}{files}",
        f"hierarchy -check -top {TOP}{parameters}",
        f"setattr -mod -set keep_hierarchy 1 {KEPT}",
        f"synth -flatten -top {TOP} -run begin:fine",
        "opt -fast -full",
        "opt -undriven -fine",
        "techmap",
        "opt -fast",
        "abc -fast",
        "opt -fast",
        "splitnets",
        "opt_clean -purge",
        "check -assert",
        f'write_verilog -noattr "{out}"',
    ])


def main():
    parser = argparse.ArgumentParser(description="Writes the gate netlist of a configuration.")
    parser.add_argument("name", help="a row of rtl/configurations.csv")
    parser.add_argument("out", type=pathlib.Path, help="Verilog to write")
    options = parser.parse_args()
    try:
        configuration = configurations.find(configurations.read(), options.name)
        steps = script(rtl.Sources(), configuration, options.out)
        options.out.parent.mkdir(parents=True, exist_ok=True)
        return subprocess.run(["yosys", "-Q", "-T", "-q", "-p", steps], check=False).returncode
    except (configurations.TableError, OSError) as error:
        print(f"netlist.py: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
