"""make -C lab energy: what a vertex costs in an evaluator of standard cells, by the toggles of its nets.

    python3 -m lab.energy [--row ROW ...] [--words PROGRAM] [--output FOLDER]

Each row is mapped to a netlist (kept in FOLDER/energy/), which Icarus Verilog simulates with a delay
in each cell. Its results are compared with the bit-true model; what its nets did in some clocks goes
to OpenSTA. Writes FOLDER/reports/energy.json. The exit status is 1 where a result is wrong, a net was
not counted or a tool fails.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import json
import pathlib
import sys

from lab.energy import activity, flat, library, power, row_report, simulation
from tools import whole_file
from tools.project_root import ROOT
from tools.synth import liberty, synthesis
from tools.tables import configurations

DEVICE = "OSU 0.18 um standard cells"
# Vertices in front, until the evaluator is full, and of whole periods in which it takes them: cg1
# takes three in 192 clocks.
ROWS = {
    "affine64-fx17-overlapped": simulation.Run(first=2, vertices=6),
    "cg1-fx18-overlapped": simulation.Run(first=3, vertices=7),
    "basic-fx18-overlapped": simulation.Run(first=2, vertices=6),
    "affine4-fx17-overlapped": simulation.Run(first=24, vertices=41),
    "affine3-fx17-overlapped": simulation.Run(first=32, vertices=49),
}
USUAL = tuple(ROWS)[:3]  # the others take minutes, each to be mapped and to be simulated


def show(what):
    print(f"energy: {what}", file=sys.stderr, flush=True)


def words(options, name, run, folder):
    """Vertices for the bench, and the results that the model has for them."""
    folder.mkdir(parents=True, exist_ok=True)
    simulation.command([options.words, "--row", name, "--folder", folder,
                        "--vertices", run.vertices], folder, "words.log")


def measure(options, work, name):
    """One row."""
    run, folder = ROWS[name], options.output.resolve() / "energy" / name
    head, kinds = library.read(liberty.path().read_text(encoding="utf-8", errors="replace"))
    show(f"{name}: netlist")
    mapped = flat.subject(name)
    path = flat.netlist_file(work, mapped, folder.parent)
    netlist = flat.read(path.read_text(encoding="utf-8"), kinds)
    words(options, name, run, folder)
    models, copy, verilog = (folder / file for file in ("cells.v", "cells.lib", "toggles.v"))
    models.write_text(library.models(kinds), encoding="utf-8")
    show(f"{name}: simulation of {len(netlist.cells):,} cells")
    compared, toggled = simulation.simulate(work, mapped.row, run, [path, models], folder)
    if toggled.clocks(simulation.PERIOD_PS) != mapped.row.interval * run.counted:
        raise row_report.EnergyError(f"{name} was not full: {toggled.clocks(simulation.PERIOD_PS)} clocks for "
                          f"{run.counted} vertices")
    copy.write_text(library.copy(head, kinds), encoding="utf-8")
    verilog.write_text(flat.with_toggles(netlist), encoding="utf-8")
    show(f"{name}: power")
    powers = [power.run(netlist, toggles, (copy, verilog), folder)
              for toggles in row_report.counts(netlist, kinds, toggled)]
    return {"name": name, "what": f"ffd_org_select {name}", "device": DEVICE,
            "compared": compared, "mismatches": 0,
            **row_report.report(netlist, kinds, toggled, powers, run)}


def work_on(options):
    work = synthesis.Synthesis(ROOT)
    synthesis.require([flat.subject(name) for name in options.row])
    rows = [measure(options, work, name) for name in options.row]
    report = {"yosys": work.version, "sta": work.sta_version, "period_ns": power.PERIOD_NS,
              "volts": library.VOLTS, "rows": rows}
    path = options.output / "reports" / "energy.json"
    whole_file.write(path, json.dumps(report, indent=2) + "\n")
    print(f"wrote {path}")


def main():
    parser = argparse.ArgumentParser(prog="energy", description=__doc__.split("\n\n")[0])
    parser.add_argument("--row", action="append", choices=ROWS, help=f"one or several; {', '.join(USUAL)} unless given")
    parser.add_argument("--words", type=pathlib.Path,
                        default=ROOT / "build" / "lab" / "energy" / "hwffd-energy-words")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build",
                        help="folder for netlists and reports")
    options = parser.parse_args()
    options.row = options.row or list(USUAL)
    options.words = options.words.resolve()
    try:
        work_on(options)
    except (row_report.EnergyError, activity.ActivityError, flat.NetlistError, library.LibraryError,
            liberty.LibertyError, power.PowerError, simulation.SimulationError,
            synthesis.engine.EngineError, configurations.TableError, OSError) as error:
        print(f"energy: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
