"""make -C lab theorems: the arithmetic units against what they should compute, for all operands.

    python3 -m lab.theorems [--only NAME ...] [--nightly | --quick] [-j JOBS] [--build FOLDER]

Each theorem is a unit of rtl/ at every width and latency, an independent specification of it, and a
planted bug. Writes FOLDER/reports/theorems.json. The exit status is 1 where a theorem is open or its
planted bug is not refuted.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import fnmatch
import json
import pathlib
import sys

from lab.theorems import fixed, floating, lemmas, powers, prove, scatter, seams, solve, words
from tools import command_line, whole_file
from tools.project_root import ROOT

EVERYTHING = (*lemmas.LEMMAS, *fixed.THEOREMS, *powers.THEOREMS, *scatter.THEOREMS, *words.THEOREMS,
              *seams.THEOREMS, *floating.THEOREMS)


def chosen(options):
    """The theorems that are asked for. Raises TheoremError."""
    theorems = [theorem for theorem in EVERYTHING
                if any(fnmatch.fnmatchcase(theorem.name, pattern) for pattern in options.only or ["*"])
                and (theorem.quick or not options.quick) and (options.nightly or options.only or not theorem.nightly)]
    if not theorems:
        raise prove.TheoremError("0 theorems were asked for: no name matches")
    return theorems


def complaint(row):
    """What is wrong with a row; '' if nothing."""
    if row["result"] != prove.PROVED:
        return f"open: {'; '.join(row['left'])}"
    return "" if row["negative_control"] == prove.REFUTED else "the planted bug is not refuted"


def work_on(options):
    """What does not hold, a line each."""
    prover = prove.Prover(options.build / "theorems", options.jobs, lambda text: print(text, file=sys.stderr, flush=True))
    rows, faults = [], []
    for theorem in chosen(options):
        row = prover.row(theorem)
        rows.append(row)
        print(f"{row['name']:20s} {row['result']:8s} planted bug {row['negative_control']:12s} "
              f"{row['cases']:5d} cases {row['seconds']:8.1f} s", flush=True)
        if complaint(row):
            faults.append(f"{row['name']}: {complaint(row)}")
    report = {"solvers": solve.versions(), "theorems": len(rows),
              "proved": sum(row["result"] == prove.PROVED for row in rows),
              "refuted": sum(row["negative_control"] == prove.REFUTED for row in rows), "rows": rows}
    path = options.build / "reports" / "theorems.json"
    whole_file.write(path, json.dumps(report, indent=1) + "\n")
    print(f"theorems: {report['proved']} of {len(rows)} proved, {report['refuted']} planted bugs refuted\n"
          f"wrote {path}")
    return faults


def main():
    parser = argparse.ArgumentParser(prog="theorems", description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--only", action="append", metavar="NAME", help="theorems, as patterns; all unless given")
    parser.add_argument("--quick", action="store_true", help="those that take seconds")
    parser.add_argument("--nightly", action="store_true", help="those that take long too")
    parser.add_argument("-j", "--jobs", type=int, default=1, help="solvers side by side")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    options = parser.parse_args()
    options.build = options.build.resolve()
    return command_line.measured(parser.prog, lambda: work_on(options), (prove.TheoremError,))


if __name__ == "__main__":
    sys.exit(main())
