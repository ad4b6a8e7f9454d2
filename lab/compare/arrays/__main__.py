"""Of make compare: ten million points through a lattice, from array to array, by libraries of Python.

    python3 -m lab.compare.arrays [--points N] [--threads N ...] [--output FOLDER]

Each library and number of threads is a process of its own, whose largest memory is measured, too.
Writes FOLDER/reports/bench.json. The exit status is 1 where a library fails or is wrong.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import json
import os
import pathlib
import resource
import subprocess
import sys
import time

from tools import command_line, whole_file
from tools.project_root import ROOT

THREADS_OF_LIBRARIES = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "NUMBA_NUM_THREADS",
                        "VTK_SMP_MAX_THREADS")
RUNS = 3  # behind one that is not counted


class BenchError(Exception):
    """Why there is no figure, in one line."""


def measured(number, points, threads):
    """What a library does, measured in this process. Raises BenchError."""
    from lab.compare.arrays import libraries
    from lab.compare.arrays.scene import CHECKED, Scene
    library = libraries.LIBRARIES[number]
    deform = library.prepare(Scene.random(min(points, CHECKED)), threads)
    deform()
    scene = Scene.random(points)
    deform, seconds = library.prepare(scene, threads), []
    for _ in range(RUNS):
        start = time.perf_counter()
        moved = deform()
        seconds.append(time.perf_counter() - start)
    error = float(abs(moved[:CHECKED] - scene.exact).max())
    if not error <= library.bound:
        raise BenchError(f"{library.name}, {library.call}: error {error:.1e}, bound {library.bound:.0e}")
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    return {"what": library.call, "library": library.name, "version": library.version,
            "threads": threads, "points": points, "points_per_s": points / min(seconds),
            "peak_mb": peak, "max_error": error}


def row(number, points, threads):
    """The same in a process of its own, which has so many processors. Raises BenchError."""
    processors = sorted(os.sched_getaffinity(0))[-threads:]
    result = subprocess.run(
        [sys.executable, "-B", "-m", "lab.compare.arrays", "--library", str(number), "--points", str(points),
         "--threads", str(threads)], capture_output=True, text=True, check=False,
        env={**os.environ, **dict.fromkeys(THREADS_OF_LIBRARIES, str(threads))},
        preexec_fn=lambda: os.sched_setaffinity(0, processors))
    if result.returncode:
        raise BenchError((result.stderr.strip().splitlines() or ["no message"])[-1])
    return json.loads(result.stdout)


def measure(options):
    """Every library with each number of threads."""
    from lab.compare.arrays import libraries
    rows = []
    for threads in options.threads:
        for number, library in enumerate(libraries.LIBRARIES):
            print(f"compare: {library.name}, {library.call}, {threads} of the processors", file=sys.stderr,
                  flush=True)
            rows.append(row(number, options.points, threads))
    path = options.output / "reports" / "bench.json"
    whole_file.write(path, json.dumps({"rows": rows}, indent=2) + "\n")
    print(f"wrote {path}")


def work_on(options, processors):
    if options.points < 1 or not all(1 <= n <= processors for n in options.threads):
        raise BenchError(f"--points from 1 up and --threads of 1 to {processors} are wanted")
    if options.library is None:
        measure(options)
    else:
        print(json.dumps(measured(options.library, options.points, options.threads[0])))
    return 0


def main():
    processors = len(os.sched_getaffinity(0))
    parser = argparse.ArgumentParser(prog="compare", description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--points", type=int, default=10_000_000)
    parser.add_argument("--threads", type=int, nargs="+", default=sorted({1, processors}))
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build",
                        help="folder for reports")
    parser.add_argument("--library", type=int, help="measure this one here and print its row")
    options = parser.parse_args()
    return command_line.ended(parser.prog, lambda: work_on(options, processors), (BenchError, ImportError))


if __name__ == "__main__":
    sys.exit(main())
