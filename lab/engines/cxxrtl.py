#!/usr/bin/env python3
"""One configuration of hwffd_stream as C++, by yosys' CXXRTL: another simulator of the same sources.

Modules stay apart: flattened, the C++ is four times as large and takes three times as long to make.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import subprocess
import sys

from tools.project_root import ROOT
from tools.rtl import rtl_sources
from tools.synth import synthesis
from tools.tables import configurations, features


def steps(row, out, planted=()):
    """The steps of yosys, to be run in the root. planted: sources in place of those of their names."""
    own = {pathlib.Path(path).name: path for path in planted}
    sources = rtl_sources.Sources()
    files = [own.get(pathlib.Path(path).name, path) for path in sources.needed(synthesis.CORE)]
    folders = " ".join(f"-I {folder}" for folder in sources.includes)
    parameters = "".join(f" -chparam {name} {value}" for name, value in features.of_top(synthesis.CORE, row.parameters).items())
    return [f"read_verilog {folders} {' '.join(map(str, files))}",
            f"hierarchy -check -top {synthesis.CORE}{parameters}", f"rename -top {synthesis.CORE}",
            "proc", f'write_cxxrtl -header -noflatten -g0 "{out}"']


def main():
    parser = argparse.ArgumentParser(description="Writes a configuration as C++.")
    parser.add_argument("name", help="a row of rtl/configurations.csv")
    parser.add_argument("out", type=pathlib.Path, help="C++ to write; its header is beside it")
    parser.add_argument("--planted", type=pathlib.Path, nargs="*", default=[], metavar="FILE",
                        help="sources to take in place of those of their names")
    options = parser.parse_args()
    try:
        row = configurations.find(configurations.read(), options.name)
        options.out.parent.mkdir(parents=True, exist_ok=True)
        commands = "; ".join(steps(row, options.out.resolve(), options.planted))
        return subprocess.run(["yosys", "-Q", "-T", "-qq", "-p", commands], cwd=ROOT,
                              check=False).returncode
    except (configurations.TableError, OSError) as error:
        print(f"cxxrtl: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
