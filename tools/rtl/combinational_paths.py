"""Looks for combinational paths from an input port to an output port of a module.

yosys flattens the module; then every output bit is followed backwards through cells without a
clock. A flip-flop and a memory read on a clock end a path; a latch, a memory read without a clock
and a cell that is not known do not. Cells of several bits count as if each output bit depended on
each input bit (but for those that yosys takes apart), so that no path is missed.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from tools.project_root import ROOT
from tools.rtl import rtl_sources

# Cells with a clock, and those of their inputs that reach the output without it.
FLIP_FLOPS = (
    (re.compile(r"\$(s?dffe?|sdffce|ff)|\$_DFFE?_[NP]{1,2}_|\$_SDFFC?E?_\w+_"), set()),
    (re.compile(r"\$(adffe?|aldffe?|dffsre?)"), {"ARST", "ALOAD", "AD", "SET", "CLR"}),
    (re.compile(r"\$_DFFE?_[NP]{2}[01][NP]?_"), {"R"}),
)
IGNORED = {"$assert", "$assume", "$cover", "$print", "$scopeinfo"}


class PathError(Exception):
    """Why a module cannot be looked at, in one line."""


def netlist(sources, module, parameters):
    """The flat module, as yosys writes it in JSON."""
    if module not in sources.files:
        raise PathError(f"no module {module} in rtl/hwffd.f")
    folders = "".join(f"-I {folder} " for folder in sources.includes)
    files = " ".join(f'"{path}"' for path in sources.needed(module))
    values = "".join(" -chparam {} {}".format(*word.split("=", 1)) for word in parameters)
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "netlist.json"
        status, output = rtl_sources.run(["yosys", "-Q", "-T", "-q", "-p", "; ".join([
            f"read_verilog {folders}{files}", f"hierarchy -check -top {module}{values}", "proc", "opt_clean -purge",
            *rtl_sources.FLATTEN, "opt_clean -purge", "memory_dff", "memory_collect", "splitnets", "simplemap",
            "opt_clean -purge", f'write_json "{out}"'])])
        if status != 0:
            lines = output.strip().splitlines()
            raise PathError(lines[-1] if lines else f"yosys: exit status {status}")
        modules = json.loads(out.read_text())["modules"]
    tops = [m for m in modules.values() if int(m["attributes"].get("top", "0"), 2)]
    return tops[0]


def _reaching(cell):
    """Bits of a cell's inputs from which its outputs can be reached without a clock."""
    kind = cell["type"]
    inputs = {port: bits for port, bits in cell["connections"].items()
              if cell["port_directions"][port] == "input"}
    wanted = next((ports for form, ports in FLIP_FLOPS if form.fullmatch(kind)), set(inputs))
    if kind.startswith("$mem"):
        clocked = "0" not in cell["parameters"].get("RD_CLK_ENABLE", "0")
        wanted = {"RD_ARST"} | (set() if clocked else {"RD_ADDR", "RD_EN"})
    return [bit for port in wanted & set(inputs) for bit in inputs[port]
            if not isinstance(bit, str)]


def paths(module):
    """([(input bit, output bit)], output bits looked at): one pair for each output that is reached."""
    sources = {}  # bit -> list of bits that drive it without a clock
    for cell in module["cells"].values():
        if cell["type"] in IGNORED:
            continue
        reaching = _reaching(cell)
        for port, bits in cell["connections"].items():
            if cell["port_directions"][port] != "input":
                for bit in bits:
                    sources.setdefault(bit, []).extend(reaching)
    names, outputs = {}, []
    for name, port in module["ports"].items():
        for index, bit in enumerate(port["bits"]):
            label = f"{name}[{index}]" if len(port["bits"]) > 1 else name
            if port["direction"] != "output":
                names[bit] = label
            if port["direction"] != "input":
                outputs.append((label, bit))
    reached = []
    for label, bit in outputs:
        seen, pending = {bit}, [bit]
        while pending:
            at = pending.pop()
            if at in names:
                reached.append((names[at], label))
                break
            pending += [b for b in sources.get(at, ()) if b not in seen]
            seen.update(sources.get(at, ()))
    return reached, len(outputs)


def main(arguments=None):
    parser = argparse.ArgumentParser(
        description="Fails where an output of a module depends on an input of the same clock.")
    parser.add_argument("module")
    parser.add_argument("parameters", nargs="*", metavar="NAME=value")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="checkout to look at")
    options = parser.parse_args(arguments)
    try:
        sources = rtl_sources.Sources(options.root)
        for word in options.parameters:
            if not re.fullmatch(r"\w+=-?\w+", word):
                raise PathError(f"'{word}' is not NAME=value")
        reached, looked_at = paths(netlist(sources, options.module, options.parameters))
    except (PathError, OSError, subprocess.SubprocessError) as error:
        print(f"combinational_paths: {error}", file=sys.stderr)
        return 2
    for start, end in reached:
        print(f"{options.module}: {end} depends on {start} in the same clock")
    print(f"{options.module}: {looked_at} output bits, {len(reached)} reached from an input")
    return 1 if reached else 0


if __name__ == "__main__":
    sys.exit(main())
