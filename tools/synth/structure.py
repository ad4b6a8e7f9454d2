"""Measures the module hierarchy of the tops for rows of the table of configurations.

yosys maps each design on ECP5 with every module by itself, so that the area of each is known; the
sum is more than that of `make synth`, which lets logic cross the borders. Writes
build/reports/structure.json and prints it.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import sys

from tools.project_root import ROOT
from tools.reports import structure_tables
from tools.reports.results import Results
from tools.rtl import rtl_sources
from tools.synth import hierarchy, mapped_netlist
from tools.tables import configurations, features


class StructureError(Exception):
    """A design that could not be mapped, in one line."""


def netlist(sources, top, row, folder):
    """The design, mapped module by module, as yosys' `json` describes it."""
    folder.mkdir(parents=True, exist_ok=True)
    out, log = (folder / f"{top}-{row.name}.{suffix}" for suffix in ("netlist", "log"))
    files, headers = (" ".join(os.path.relpath(path, sources.root) for path in paths)
                      for paths in (sources.needed(top), sources.includes))
    values = "".join(f" -chparam {name} {value}" for name, value in features.of_top(top, row.parameters).items())
    steps = [
        f"read_verilog {''.join(f'-I {path} ' for path in headers.split())}{files}",
        f"hierarchy -check -top {top}{values}",
        "setattr -mod -set keep_hierarchy 1 *",
        "script synth/prepare.ys",
        f"script synth/{hierarchy.TARGET}.ys",
        f"json -o {os.path.relpath(out, sources.root)} *",
    ]
    try:
        status, output = rtl_sources.run(["yosys", "-Q", "-T", "-q", "-p", "; ".join(steps)],
                                         sources.root)
        log.write_text(output)
        if status != 0:
            raise StructureError(f"{top}, {row.name}: yosys failed: see {log}")
        return json.loads(out.read_text())
    finally:
        out.unlink(missing_ok=True)


def measure(sources, top, row, shown, folder):
    """A design as the report has it: its modules, parents first. Raises StructureError."""
    try:
        tree = hierarchy.Design(netlist(sources, top, row, folder), top).tree()
    except mapped_netlist.NetlistError as error:
        raise StructureError(f"{top}, {row.name}: {error}") from error
    modules = [{"depth": depth, "module": node.module, "instances": node.instances,
                "folder": sources.files[node.module].relative_to(sources.rtl).parts[0],
                **{name: node.counts[name] for name in hierarchy.FIELDS},
                "own_lut": node.own()["lut"]} for depth, node in tree.walk()]
    return {"top": top, "row": row.name, "shown": shown, "modules": modules}


def main():
    parser = argparse.ArgumentParser(description="Measures the module hierarchy of the tops.")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="checkout to look at")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    root = options.root.absolute()
    report = root / "build" / "reports" / "structure.json"
    try:
        sources = rtl_sources.Sources(root)
        rows = configurations.read(root / "rtl" / "configurations.csv")
        chosen = [(top, configurations.find(rows, name), shown) for top, name, shown in structure_tables.DESIGNS]
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            designs = list(pool.map(
                lambda design: measure(sources, *design, root / "build" / "structure"), chosen))
    except (StructureError, configurations.TableError, OSError) as error:
        print(f"structure: {error}", file=sys.stderr)
        return 1
    report.parent.mkdir(parents=True, exist_ok=True)
    report.write_text(json.dumps({"target": hierarchy.TARGET, "designs": designs}) + "\n")
    print(structure_tables.printed(Results(root)) + "\n")
    print(f"wrote {os.path.relpath(report, root)}: {len(designs)} designs")
    return 0


if __name__ == "__main__":
    sys.exit(main())
