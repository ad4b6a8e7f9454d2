"""How many multipliers, adders and fused multiply-adds an evaluator has, as JSON.

Counted in the design that yosys elaborates for a row of the table: every instance of a unit of the
number layer. Beside it the form as the paper draws it, where it differs: a tree of N units with
three polynomial evaluators and two weight products for each unit, which the RTL shares.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import sys
import tempfile

from tools import csv_table
from tools.rtl import rtl_sources
from tools.rtl.rtl_sources import module_of
from tools.tables import configurations

TOP = "ffd_org_select"
KINDS = ("mul", "add", "fma")
# Operators of each unit of the number layer; a step is one fused operator where the row fuses. The
# shifts and additions that multiply by a constant are not counted.
UNITS = {
    "ffd_num_mul": ("mul",),
    "ffd_num_term": ("mul",),
    "ffd_num_offset_term": ("mul",),
    "ffd_num_offset": ("add",),
    "ffd_num_add": ("add",),
    "ffd_num_mac": ("fma",),
    "ffd_num_powers": 2 * ("mul",) + 9 * ("add",),
}
STEP = "ffd_num_step"
EVALUATOR = "ffd_eval_poly"
POWERS = "ffd_eval_powers"  # the four polynomials of an axis
PRODUCT = "ffd_num_mul"
TREE = "ffd_org_tree"


class Design:
    """The hierarchy of one elaborated row, from the text of yosys' `stat`. (Its JSON is broken in
    the oldest yosys that we accept.)"""

    def __init__(self, statistics, fused):
        self.cells = {}
        cells = None
        for line in statistics.splitlines():
            if title := re.fullmatch(r"=== (.+) ===", line):
                cells = self.cells.setdefault(title.group(1), {})
            elif cell := re.fullmatch(r" +(\S*ffd_\w+) +(\d+)", line):
                cells[cell.group(1)] = int(cell.group(2))
        self.fused = fused

    def instances(self, top):
        """Counter of modules below `top`, itself counted once."""
        total = collections.Counter({module_of(top): 1})
        for cell, count in self.cells[top].items():
            for module, number in self.instances(cell).items():
                total[module] += count * number
        return total

    def find(self, module):
        """Names of all variants of a module."""
        return [name for name in self.cells if module_of(name) == module]

    def operators(self, top):
        total = collections.Counter()
        step = ("fma",) if self.fused else ("mul", "add")
        for module, count in self.instances(top).items():
            for kind in step if module == STEP else UNITS.get(module, ()):
                total[kind] += count
        return total


def drawn(design, top, row, built):
    """Operators of the form as drawn."""
    instances = design.instances(top)
    if not instances[TREE]:
        return built
    # All evaluators of a tree are alike.
    operators = design.operators(design.find(EVALUATOR)[0])
    total = collections.Counter(built)
    for kind, count in operators.items():
        total[kind] += (3 * row.n - instances[EVALUATOR]) * count
    total["mul"] += 2 * row.n - instances[PRODUCT]
    return total


def count(sources, row):
    """{"operators": {...}, "drawn": {...}, "evaluators": number} of a row."""
    values = "".join(f" -chparam {name} {value}" for name, value in row.parameters.items())
    folders = "".join(f"-I {folder} " for folder in sources.includes)
    files = " ".join(f'"{path}"' for path in sources.needed(TOP))
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "stat.txt"
        script = (f"read_verilog {folders}{files}; hierarchy -check -top {TOP}{values}; "
                  f"tee -q -o {report} stat")
        status, output = rtl_sources.run(["yosys", "-Q", "-T", "-q", "-p", script])
        if status != 0:
            raise configurations.TableError(f"{row.name}: yosys failed: {output.strip()}")
        design = Design(report.read_text(encoding="utf-8"), row.fma_latency > 0)
    top = design.find(TOP)[0]
    built = design.operators(top)
    as_drawn = drawn(design, top, row, built)
    return {
        "operators": {kind: built[kind] for kind in KINDS},
        "drawn": {kind: as_drawn[kind] for kind in KINDS},
        "evaluators": sum(design.instances(top)[evaluator] for evaluator in (EVALUATOR, POWERS)),
    }


def main():
    parser = argparse.ArgumentParser(description="Counts the operators of rows of the table.")
    parser.add_argument("out", help="JSON to write")
    configurations.add_selection(parser)
    options = parser.parse_args()
    try:
        rows = configurations.selected(configurations.read(), options)
        sources = rtl_sources.Sources()
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
            counted_rows = pool.map(lambda row: count(sources, row), rows)
            counts = {row.name: counted for row, counted in zip(rows, counted_rows)}
        csv_table.write_if_changed(options.out, json.dumps(counts, indent=1) + "\n")
    except (configurations.TableError, OSError) as error:
        print(f"operators: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
