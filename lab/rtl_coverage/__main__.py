"""make -C lab coverage: which lines, branches and bits of the RTL the tests run, and which lines of the C++.

    python3 -m lab.rtl_coverage [--build FOLDER] [-j JOBS] [--share N] [--only PATTERN]

Runs the test programs of a build whose models count. Writes build/reports/coverage.json, and each
module's source with counts into FOLDER/coverage/annotated/. The exit status is 1 where a module falls
short of its aim, or a reason to leave a place out is not needed.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import fnmatch
import json
import pathlib
import sys

from lab.rtl_coverage import annotated, counts as counting, cpp, exclusions, programs, report as reporting
from tools import command_line, whole_file

ROOT = pathlib.Path(__file__).resolve().parents[2]


def annotate(folder, sources, counts, left_out):
    folder.mkdir(parents=True, exist_ok=True)
    for module, places in counting.modules(counts).items():
        if module in sources:
            whole_file.write(folder / f"{module}.v",
                             annotated.text(sources[module], places, counts, left_out))


def work_on(options):
    build = options.build.resolve()
    run = [program for program in programs.listed(build)
           if fnmatch.fnmatchcase(program.name, options.only)]
    if not run:
        raise counting.CoverageError(f"no program matches '{options.only}'")
    folder = build / "coverage"
    cpp.forget_outdated(build)
    counts = counting.read(programs.run(run, build, folder, options.jobs, options.share))
    if options.only == "*":
        programs.run_calls(build, folder)
    sources = {path.stem: path.read_text(encoding="utf-8").splitlines()
               for path in sorted((ROOT / "rtl").rglob("*.v"))}
    reasons = exclusions.read(pathlib.Path(__file__).with_name("exclusions.csv"))
    left_out, idle = exclusions.excluded(reasons, counts, sources)
    absent, there = exclusions.unneeded(reasons, counts)
    wanted = [module for module in sources if module not in absent]
    annotate(folder / "annotated", sources, counts, left_out)
    report = {"programs": len(run), "share": options.share,
              "rows": reporting.rows(wanted, counts, left_out), "cpp": cpp.rows(ROOT, build)}
    report["short"] = [*reporting.faults(report), *idle, *there]
    path = ROOT / "build" / "reports" / "coverage.json"
    whole_file.write(path, json.dumps(report, indent=2) + "\n")
    print(f"wrote {path.relative_to(ROOT)}")
    return report["short"]


def main():
    parser = argparse.ArgumentParser(prog="coverage", description=__doc__.split("\n\n")[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build-coverage")
    parser.add_argument("-j", "--jobs", type=int, default=2, help="programs side by side")
    parser.add_argument("--share", type=int, default=1, metavar="N",
                        help="run one of N parts of each program's tests")
    parser.add_argument("--only", default="*", metavar="PATTERN", help="programs of these names")
    options = parser.parse_args()
    return command_line.measured(parser.prog, lambda: work_on(options), (counting.CoverageError,))


if __name__ == "__main__":
    sys.exit(main())
