"""Vertices through the netlist of an evaluator in Icarus Verilog, and what its nets do meanwhile.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
from dataclasses import dataclass

from lab.energy import activity, power
from tools.rtl import rtl_sources

HERE = pathlib.Path(__file__).resolve().parent
BENCH = "ffd_bench_energy"
PERIOD_PS = 1000 * power.PERIOD_NS
_SAID = re.compile(r"^compared (\d+) wrong (\d+)$", re.MULTILINE)


class SimulationError(Exception):
    """A simulation that did not end, or whose results are wrong, in one line."""


@dataclass(frozen=True)
class Run:
    """The vertices of a run: those before the first are not counted, but fill the evaluator; the
    last one ends the count when it is taken."""

    first: int
    vertices: int

    @property
    def counted(self):
        return self.vertices - 1 - self.first


def command(command_line, folder, log):
    """Raises SimulationError where a program fails."""
    status, output = rtl_sources.run(list(map(str, command_line)), folder)
    (folder / log).write_text(output, encoding="utf-8")
    if status:
        raise SimulationError(f"{command_line[0]} ended with {status}: see {folder / log}")
    return output


def sources(work):
    """What of rtl/ is around the organization, and the bench."""
    needed = [pathlib.Path(path) for top in ("ffd_eval_stream", "ffd_num_in")
              for path in work.sources.needed(top)]
    around = [path for path in dict.fromkeys(needed) if not path.name.startswith("ffd_org_")]
    return [*around, work.root / "cores" / "rtl" / "ffd_bench_evaluator.v",
            HERE / "ffd_org_select.v", HERE / f"{BENCH}.v"]


def checked(output, run):
    """How many results were compared. Raises SimulationError unless all came and were right."""
    match = _SAID.search(output)
    if not match:
        raise SimulationError("the bench did not end")
    compared, wrong = map(int, match.groups())
    if compared != run.vertices or wrong:
        raise SimulationError(f"{compared} results of {run.vertices} vertices, {wrong} of them wrong")
    return compared


def simulate(work, row, run, files, folder):
    """(results compared, Activity). steps.hex and results.hex are in the folder.

    files: the netlist and the models of its cells
    """
    steps = (folder / "steps.hex").read_text(encoding="utf-8").count("\n")
    parameters = {**row.parameters, "STEPS": steps, "VERTICES": run.vertices, "FIRST": run.first}
    command(["iverilog", "-g2005", "-o", "bench.vvp", "-s", BENCH,
             *(f"-P{BENCH}.{name}={value}" for name, value in parameters.items()),
             *(f"-I{include}" for include in work.sources.includes), *sources(work), *files],
            folder, "icarus.log")
    compared = checked(command(["vvp", "-n", "bench.vvp"], folder, "bench.log"), run)
    nets = folder / "nets.vcd"
    with nets.open(encoding="ascii") as lines:
        toggles = activity.read(lines, PERIOD_PS)
    nets.unlink()
    return compared, toggles
