"""make -C lab bounds: bounds of the errors of weights and of every form, proved, beside errors that are reached.

    python3 -m lab.bounds [--build FOLDER] [--facts FILE ...] [--form FORM] [--format FORMAT] [--no-coq]

Gappa proves each bound from the operations of the core, Coq checks its proof and ties it to the
program of the form. What the proofs take of the weights (their largest errors over every coordinate)
and vertices that come near the bounds are those of hwffd-bounds, which searches the bit-true model.
Writes FOLDER/reports/bounds.json. The exit status is 1 where a bound is not proved or is exceeded, or
where one 2 % below what is reached is accepted too.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import hashlib
import json
import pathlib
import subprocess
import sys

from lab.bounds import gappa, rows, weights
from tools import command_line, whole_file
from tools.project_root import ROOT


def facts(options):
    """What the search has found: read, or searched for, a format at a time."""
    by_kind = {"weights": [], "forms": []}
    paths = options.facts or [search(options, name) for name in weights.FORMATS
                              if options.format in ("", name)]
    for path in paths:
        part = json.loads(path.read_text())
        for kind, entries in by_kind.items():
            entries += part[kind]
    if not by_kind["weights"]:
        raise gappa.BoundsError("the search has no weights: nothing was measured")
    return by_kind


def search(options, name):
    """What the program finds of a format; what it has found once is kept."""
    folder = options.build / "bounds" / name
    folder.mkdir(parents=True, exist_ok=True)
    program = options.build / "lab" / "bounds" / "hwffd-bounds"
    if not program.exists():
        raise gappa.BoundsError(f"{program} is not there: make -C lab bounds builds it")
    form = rows.searched(options.form)
    found, marker = folder / "reports" / "bounds_facts.json", folder / "searched"
    key = hashlib.sha256(program.read_bytes() + f"{name} {form}".encode()).hexdigest()
    if found.is_file() and marker.is_file() and marker.read_text() == key:
        return found
    command = [program, "--output", folder, f"--format={name}", *([f"--form={form}"] if form else [])]
    marker.unlink(missing_ok=True)
    if subprocess.run(command, check=False).returncode != 0:
        raise gappa.BoundsError("the search for errors has failed")
    marker.write_text(key)
    return found


def chosen(options, row):
    return (not options.form or options.form in (row.form, rows.searched(row.form))) and (
        not options.format or row.format == options.format)


def work_on(options):
    gappa.require("gappa", *([] if options.no_coq else ["coqc"]))
    measured = facts(options)
    theory = None if options.no_coq else gappa.Theory(options.build / "bounds" / "coq")
    wanted = [row for row in rows.all_rows(measured) if chosen(options, row)]
    if not wanted:
        raise gappa.BoundsError("no such form in this format")
    proved, faults = [], []
    for row in wanted:
        result = row.prove(theory)
        proved.append(result)
        faults += rows.faults(result)
        print(f"bounds: {result['form']} {result['format']}: {result['bound']:.4g}, reached "
              f"{result['witness']:.4g}, {result['checked_by']}", file=sys.stderr, flush=True)
    report = {"rows": proved, "axes": measured["weights"], "witnesses": measured["forms"]}
    path = options.build / "reports" / "bounds.json"
    whole_file.write(path, json.dumps(report, indent=1) + "\n")
    print(f"bounds: {len(proved)} proved\nwrote {path}")
    return faults


def main():
    parser = argparse.ArgumentParser(prog="bounds", description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    parser.add_argument("--facts", type=pathlib.Path, action="append", metavar="FILE",
                        help="of an earlier search, instead of a new one")
    parser.add_argument("--form", default="", help="this form only")
    parser.add_argument("--format", default="", help="this format only")
    parser.add_argument("--no-coq", action="store_true", help="Gappa alone")
    options = parser.parse_args()
    options.build = options.build.resolve()
    return command_line.measured(parser.prog, lambda: work_on(options), (gappa.BoundsError, KeyError))


if __name__ == "__main__":
    sys.exit(main())
