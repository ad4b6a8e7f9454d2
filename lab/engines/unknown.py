"""What is X in Icarus Verilog and must be known: outputs of a core, and registers that reset clears.

In sources an X is lost where an `if` takes its other arm for it. So a core is also simulated as
gates, which hand an X on unless their other input decides; of its `if` are left those of memories.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
from dataclasses import dataclass

from lab.engines import icarus, planted, registers
from tools.project_root import ROOT
from tools.rtl import rtl_sources
from tools.synth import netlist
from tools.tables import features

HERE = pathlib.Path(__file__).resolve().parent
WATCH = "ffd_bench_registers"
NETLIST = "FFD_NETLIST"
_WATCHED = re.compile(r"\bffd_bench_known #\((\d+), ")


@dataclass(frozen=True)
class Unknown:
    """In how many clocks, of how many bits that must be known; what was X, or broke a rule. And how
    long that took."""

    clocks: int
    checked: int
    names: tuple
    seconds: float


@dataclass(frozen=True)
class Subject:
    """A top with its bench and row, the parameters that the bench has besides, the folder in which it
    finds its files, and changes of sources."""

    top: str
    bench: str
    row: object
    parameters: dict
    folder: pathlib.Path
    faults: tuple = ()

    def copies(self):
        """{file name: copy of the source with its change}; memories leave X."""
        return {path.name: path for path in (planted.copy(name, self.folder)
                                             for name in (planted.UNDEFINED, *self.faults))}

    def simulate(self, tops, files, includes, watched=0, macros=()):
        """The Unknown of files with the core, and that many bits watched by others than the bench."""
        benches = [HERE / f"{self.bench}.v", ROOT / "tb" / "rtl" / "ffd_bench_known.v", HERE / "ffd_bench_memory.v"]
        clocks, names, seconds = icarus.run(icarus.Bench(
            (self.bench, *tops), {**self.row.parameters, **self.parameters}, (*files, *benches),
            tuple(includes), macros), self.folder)
        outputs = sum(map(int, _WATCHED.findall(benches[0].read_text(encoding="utf-8"))))
        return Unknown(clocks, outputs + watched, tuple(names), seconds)


def in_sources(subject):
    """The Unknown of the sources. The registers are those of sources without a fault."""
    sources = rtl_sources.Sources()
    places_by_name = registers.find(sources, subject.top, features.of_top(subject.top, subject.row.parameters), subject.folder)
    watch = subject.folder / f"{WATCH}.v"
    bench = subject.bench
    watch.write_text(registers.watch(places_by_name, f"{bench}.u_core", f"{bench}.aclk", f"{bench}.settled"),
                     encoding="utf-8")
    copies = subject.copies()
    files = [copies.get(pathlib.Path(path).name, path) for path in sources.needed(subject.top)]
    return subject.simulate((WATCH,), (*files, watch), sources.includes,
                            sum(map(len, places_by_name.values())), (rtl_sources.SIMULATION,))


def in_gates(subject):
    """The Unknown of a netlist of generic gates, whose flip-flops have neither reset nor enable."""
    out = subject.folder / "gates.v"
    read, *mapping = netlist.steps(subject.row, "generic", out)
    for name, copy in subject.copies().items():
        read = re.sub(rf"\S+/{re.escape(name)}\b", str(copy), read)
    steps = "; ".join([read, *mapping[:-1], "dffunmap", "opt_expr", "simplemap", "opt_clean -purge",
                       mapping[-1]])
    icarus.command(["yosys", "-Q", "-T", "-qq", "-p", steps], ROOT, subject.folder / "yosys.log")
    return subject.simulate((), (out,), rtl_sources.Sources().includes, macros=(NETLIST,))
