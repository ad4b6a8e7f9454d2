"""make compare: what evaluates equation (1), on one core of this processor and in hardware.

    python3 -m lab.compare [--program PROGRAM] [--output FOLDER]

First hwffd-compare makes the scene, times the project's own programs and counts clocks in the RTL of those
cores that have been routed, and the programs of others follow, all on one processor core, into
FOLDER/reports/compare.json. Then lab/compare/arrays times whole calls of libraries of Python, on one
core and on all, into FOLDER/reports/bench.json. The exit status is 1 where something was not measured or is wrong.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import contextlib
import json
import os
import pathlib
import subprocess
import sys

# Before a library counts the processors.
for _variable in ("OMP_NUM_THREADS", "NUMBA_NUM_THREADS", "OPENBLAS_NUM_THREADS",
                  "MKL_NUM_THREADS", "VTK_SMP_MAX_THREADS"):
    os.environ[_variable] = "1"

from lab.compare import joined, peers, routed
from tools import project_root
from tools.project_root import ROOT
from tools.reports.results import Missing, RequestError, Results, released
from tools.tables import configurations


@contextlib.contextmanager
def pinned():
    """This process, and those that it starts, on one processor: the last that it may use."""
    allowed = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {max(allowed)})
    try:
        yield
    finally:
        os.sched_setaffinity(0, allowed)


def show(what):
    print(f"compare: {what}", file=sys.stderr, flush=True)


def own(options, reports):
    """What hwffd-compare measures, and the scene that it leaves behind."""
    command = [str(options.program), "--output", str(options.output),
               "--scene", str(options.output / "compare"), *options.more]
    for name in routed.names(reports):
        command += ["--row", name]
    show("the project's own programs and cores")
    status = subprocess.run(command, check=False).returncode
    if status:
        raise joined.CompareError(f"{options.program} ended with {status}")
    path = options.output / "reports" / "compare-own.json"
    return json.loads(path.read_text(encoding="utf-8"))


def with_module():
    """The environment, in which the module hwffd is that of the build."""
    more = project_root.environment()
    return {**more, "PYTHONPATH": os.pathsep.join([str(ROOT / "build" / "lab" / "product" / "api" / "python"), more["PYTHONPATH"]])}


def arrays(options):
    """Whole calls of libraries, in processes of their own."""
    command = [sys.executable, "-B", "-m", "lab.compare.arrays",
               "--points", str(options.points), "--output", str(options.output)]
    if subprocess.run(command, check=False, env=with_module()).returncode:
        raise joined.CompareError("no figures of whole calls; see the line above")


def work(options):
    # Clocks and sizes are of the release that is being measured, or of the last.
    folder = os.environ.get("HWFFD_RESULTS")
    reports = Results(ROOT, folder) if folder else released(ROOT)
    with pinned():
        measured = own(options, reports)
        rows = peers.rows(peers.Scene.read(options.output / "compare"), show)
    report = joined.report(measured, rows, routed.rows(reports, measured["cores"]))
    path = options.output / "reports" / "compare.json"
    path.write_text(json.dumps(report, indent=2) + "\n", encoding="utf-8")
    print(f"wrote {path}")
    arrays(options)


def main():
    parser = argparse.ArgumentParser(prog="compare", description=__doc__.split("\n\n")[0])
    parser.add_argument("--program", type=pathlib.Path,
                        default=ROOT / "build" / "lab" / "compare" / "hwffd-compare")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build",
                        help="folder for reports")
    parser.add_argument("--points", type=int, default=10_000_000, help="of whole calls of libraries")
    parser.add_argument("more", nargs="*", help="for hwffd-compare, behind --")
    options = parser.parse_args()
    try:
        work(options)
    except Missing as missing:
        print(f"compare: there is no report yet: {missing}", file=sys.stderr)
        return 1
    except (joined.CompareError, peers.PeerError, RequestError, configurations.TableError,
            ImportError, OSError) as error:
        print(f"compare: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
