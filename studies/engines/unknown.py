"""What is X in Icarus Verilog and must be known: outputs of a core, and registers that reset clears.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
from dataclasses import dataclass

import icarus
import planted
import registers
import rtl

HERE = pathlib.Path(__file__).resolve().parent
WATCH = "ffd_bench_registers"
_WATCHED = re.compile(r"\bffd_bench_known #\((\d+), ")


@dataclass(frozen=True)
class Unknown:
    """In how many clocks, of how many bits that must be known; what was X, or broke a rule."""

    clocks: int
    checked: int
    names: tuple


def _sources(sources, top, faults, folder):
    """The files of the core, those with faults in copies, and with X for what memories leave undefined."""
    own = {path.name: path for path in (planted.copy(name, folder)
                                        for name in (planted.UNDEFINED, *faults))}
    return [own.get(pathlib.Path(path).name, path) for path in sources.needed(top)]


def run(top, bench, row, parameters, folder, faults=()):
    """The Unknown of a bench whose files lie in the folder, and whose core is a row. The registers are
    those of the sources without faults."""
    sources = rtl.Sources()
    found = registers.find(sources, top, row.parameters, folder)
    watch = folder / f"{WATCH}.v"
    watch.write_text(registers.watch(found, f"{bench}.u_core", f"{bench}.aclk", f"{bench}.settled"),
                     encoding="utf-8")
    benches = [HERE / f"{bench}.v", HERE / "ffd_bench_known.v", HERE / "ffd_bench_memory.v"]
    clocks, names = icarus.run(icarus.Bench(
        (bench, WATCH), {**row.parameters, **parameters},
        (*_sources(sources, top, faults, folder), *benches, watch),
        tuple(sources.includes), (rtl.SIMULATION,)), folder)
    outputs = sum(map(int, _WATCHED.findall(benches[0].read_text(encoding="utf-8"))))
    return Unknown(clocks, outputs + sum(map(len, found.values())), tuple(names))
