"""Simulates a processor that deforms a mesh through the core, and reports what came of it.

LiteX makes the system and its simulator, in build/soc/system/. Writes build/reports/soc.json. The exit status is 1 if
a word differs from the model's, if something hangs, or if the program says that it failed; 2 if the request makes no
sense.

SPDX-License-Identifier: Apache-2.0
"""

import json
import logging
import os
import re
import selectors
import subprocess
import sys

from litex.build.generic_platform import Pins, Subsignal
from litex.build.io import CRG
from litex.build.sim import SimPlatform
from litex.build.sim.config import SimConfig
from litex.build.sim.platform import SimFinish

from soc import program
from soc.system import CPU, System
from tools import command_line, whole_file
from tools.tables import configurations

ROW = "cg1-fx18-overlapped"
MEMORY = 0x80000       # bytes for scene, packets and results
CLOCK = int(1e6)       # of the simulation's time; no figure depends on it
RESETS = 1000
REFUSALS = 4           # firmware/refusals.h
QUIET = 240            # seconds without a word, after which a simulation is ended
SERIAL = [(f"{side}_{name}", width) for side in ("source", "sink")
          for name, width in (("valid", 1), ("ready", 1), ("data", 8))]
FIGURE = re.compile(r"([a-z_]+) (\d+)")


class SimulationError(Exception):
    """There is nothing to report, in one line."""


class Platform(SimPlatform):
    def __init__(self):
        super().__init__("SIM", [
            ("sys_clk", 0, Pins(1)),
            ("serial", 0, *[Subsignal(name, Pins(width)) for name, width in SERIAL])])


def parameters(root):
    """Of the core, by the table of configurations."""
    return configurations.find(configurations.read(root / "rtl" / "configurations.csv"), ROW).parameters


def make_system(root, memory):
    platform = Platform()
    system = System(platform, CLOCK, root / "rtl", parameters(root), memory, faults=True,
                    uart_name="sim")
    system.crg = CRG(platform.request("sys_clk"))
    system.sim_finish = SimFinish()
    system.finalize()
    return system


def write_simulator(system, folder, code, scene, jobs):
    """All files of the simulator, with the memories' contents, by LiteX."""
    try:
        system.init_rom("rom", code, auto_size=False)
        system.init_ram("main_ram", scene)
    except Exception as error:
        raise SimulationError("a memory is too small for what it must hold at the start") from error
    config = SimConfig()
    config.add_clocker("sys_clk", freq_hz=CLOCK)
    config.add_module("serial2console", "serial")
    system.build(build_dir=str(folder), sim_config=config, run=False, interactive=False,
                 opt_level="O2", jobs=jobs)


def design(folder):
    """What decides the simulator: the system, but for the date in its first lines, and its build."""
    lines = (folder / "sim.v").read_text(encoding="utf-8").splitlines()
    text = "\n".join(line for line in lines if not line.startswith("//"))
    return text + (folder / "build_sim.sh").read_text(encoding="utf-8")


def compile_simulator(root, folder):
    """Unless that of this design is there. Raises SimulationError."""
    wanted = design(folder) + "".join(
        path.read_text(encoding="utf-8") for path in sorted((root / "rtl").rglob("*.v*")))
    record = folder / "compiled"
    simulator = folder / "obj_dir" / "Vsim"
    if simulator.exists() and record.exists() and record.read_text(encoding="utf-8") == wanted:
        return simulator
    print("soc: compiling the simulator, for a minute or two", flush=True)
    record.unlink(missing_ok=True)
    log = folder / "build.log"
    with log.open("w", encoding="utf-8") as out:
        result = subprocess.run(["bash", "build_sim.sh"], cwd=folder, stdout=out,
                              stderr=subprocess.STDOUT, check=False)
    if result.returncode != 0:
        raise SimulationError(f"the simulator does not compile: {log}")
    whole_file.write(record, wanted)
    return simulator


def lines_of(simulator, folder):
    """What the simulated processor prints. Raises SimulationError."""
    with subprocess.Popen([str(simulator)], cwd=folder, stdin=subprocess.PIPE,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
        watch = selectors.DefaultSelector()
        watch.register(process.stdout, selectors.EVENT_READ)
        rest = b""
        try:
            while True:
                if not watch.select(timeout=QUIET):
                    raise SimulationError(f"the processor has said nothing for {QUIET} seconds")
                more = os.read(process.stdout.fileno(), 1 << 16)
                *lines, rest = (rest + more).split(b"\n")
                yield from (line.decode("ascii", "replace").strip() for line in lines)
                if not more:
                    break
        finally:
            process.kill()


def run(simulator, folder):
    """name -> figure of what the program prints; what it says in words is shown."""
    figures = {}
    for line in lines_of(simulator, folder):
        figure = FIGURE.fullmatch(line)
        if figure:
            figures[figure[1]] = int(figure[2])
        elif line.startswith("soc: "):
            print(line, flush=True)
    if "status" not in figures:
        raise SimulationError("the simulation ended before the program did")
    return figures


def report(figures):
    """The figures by the names of the report; clocks of the firmware are in thousandths."""
    def clocks(name):
        return figures[name] / 1000 if name in figures else None

    return {
        "cpu": CPU, "row": ROW, "vertices": figures.get("vertices", 0),
        "mismatches": figures.get("mismatches_polled", 0) + figures.get("mismatches_interrupt", 0),
        "compared": figures.get("vertices", 0) * sum(
            name in figures for name in ("mismatches_polled", "mismatches_interrupt")),
        "clocks_per_vertex": clocks("core_clocks"),
        "clocks_per_vertex_by_interrupt": clocks("interrupt_clocks"),
        "embedding_clocks_per_vertex": clocks("embedding_clocks"),
        "lattice_clocks": figures.get("lattice_clocks"),
        "software_clocks_per_vertex": clocks("software_clocks"),
        "software_vertices": figures.get("software_vertices", 0),
        "software_mismatches": figures.get("software_mismatches", 0),
        "refusals": figures.get("refusals", 0),
        "resets": figures.get("resets", 0), "resets_caught": figures.get("resets_caught", 0),
        "resets_silent": figures.get("resets_silent", 0),
        "resets_results": figures.get("resets_results", 0),
        "resets_mismatches": figures.get("resets_mismatches", 0),
        "hangs": figures.get("hangs", 0), "status": figures["status"],
    }


def faults(soc, resets):
    """What does not hold, a line each."""
    held = (
        (soc["status"] == 0, f"the program ends with status {soc['status']}"),
        (soc["compared"] == 2 * soc["vertices"] > 0, "not every vertex was compared twice"),
        (soc["mismatches"] == 0, f"{soc['mismatches']} results differ from the model's"),
        (soc["software_vertices"] > 0 and soc["software_mismatches"] == 0,
         f"{soc['software_mismatches']} of {soc['software_vertices']} sums in C differ from the model's"),
        (soc["refusals"] == REFUSALS, f"{soc['refusals']} of {REFUSALS} refusals"),
        (soc["resets"] == resets, f"{soc['resets']} of {resets} resets and errors"),
        (2 * soc["resets_caught"] >= soc["resets"],
         f"only {soc['resets_caught']} of {soc['resets']} resets and errors met the core at work"),
        (soc["resets_silent"] == 0, f"{soc['resets_silent']} errors of the bus are not in ERROR_STATUS"),
        (soc["resets_mismatches"] == 0, f"{soc['resets_mismatches']} results after a reset differ"),
        (soc["hangs"] == 0, f"{soc['hangs']} hangs"))
    return [text for holds, text in held if not holds]


def ended_early(soc):
    """Whether the program has ended at something that it has said in a line of its own."""
    return soc["status"] != 0 and soc["refusals"] == 0


def text(soc):
    core, software = soc["clocks_per_vertex"], soc["software_clocks_per_vertex"]
    lines = [f"{soc['compared']:,} results of {soc['vertices']:,} vertices compared with the model, "
             f"{soc['mismatches']} differ"]
    if core is not None:
        lines.append(f"{core:.2f} clocks a vertex through the core ({soc['row']}), "
                     f"{soc['embedding_clocks_per_vertex']:.1f} to make its packet on {soc['cpu']}")
    if software is not None:
        lines.append(f"{software:,.0f} clocks a vertex for the same sum in C on {soc['cpu']}, of a sample of "
                     f"{soc['software_vertices']}, {soc['software_mismatches']} of which differ")
    lines.append(f"{soc['refusals']} refusals; {soc['resets']:,} soft resets and errors of the bus, "
                 f"{soc['resets_caught']:,} of them with the core at work; {soc['hangs']} hangs; "
                 f"{soc['resets_results']:,} results afterwards, {soc['resets_mismatches']} differ")
    return "\n".join(lines)


def work(options, root):
    if options.memory % 4096 or not 4096 <= options.memory <= 1 << 24:
        raise command_line.Request(f"--memory {options.memory}: a multiple of 4096 up to 16 MiB")
    logging.disable(logging.WARNING)
    folder = root / "build" / "soc" / "system"
    scene = program.scene(options, ROW, folder)
    system = make_system(root, options.memory)
    code = program.build(system, folder, RESETS=options.resets)
    write_simulator(system, folder / "gateware", code, scene, options.jobs)
    soc = report(run(compile_simulator(root, folder / "gateware"), folder / "gateware"))
    whole_file.write(root / "build" / "reports" / "soc.json", json.dumps({"rows": [soc]}, indent=1) + "\n")
    if ended_early(soc):
        return 1
    print(text(soc))
    print("wrote build/reports/soc.json")
    wrong = faults(soc, options.resets)
    for line in wrong:
        print(f"soc: {line}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    parser = command_line.Parser(prog="soc", description="Simulates a system with the core.")
    program.arguments(parser)
    parser.add_argument("--memory", type=int, default=MEMORY, help=f"bytes for meshes ({MEMORY})")
    parser.add_argument("--resets", type=int, default=RESETS,
                        help=f"soft resets and errors of the bus ({RESETS})")
    sys.exit(command_line.run(parser, work, (SimulationError, program.ProgramError)))
