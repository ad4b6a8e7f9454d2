"""One program aligns one pair, in a process of its own, so that its memory and its time are its own.

    python3 -m lab.align.run FOLDER NUMBER

FOLDER has what `start` wrote, and gets files of the program and field.npy. Prints a line of JSON.

SPDX-License-Identifier: Apache-2.0
"""

import dataclasses
import json
import os
import pathlib
import resource
import subprocess
import sys
import time

import numpy

from lab.align import programs

# Before a library counts the processors. OPENBLAS is not of the loops, and must not start threads.
THREADS = ("OMP_NUM_THREADS", "ITK_GLOBAL_DEFAULT_NUMBER_OF_THREADS")
MEGABYTE = 1024  # of the kilobytes that the system counts


def work(job, program):
    """The row of a run, and the field. Raises Absent and AlignError."""
    start, processor = time.monotonic(), time.process_time()
    outcome = program.run(job)
    usage = outcome.usage or {"elapsed_s": time.monotonic() - start, "processor_s": time.process_time() - processor,
                              "peak_mb": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / MEGABYTE}
    if outcome.field.shape != (*job.fixed.shape, 3) or not numpy.isfinite(outcome.field).all():
        raise programs.AlignError(f"{program.name}: a field of {outcome.field.shape} that is none")
    # Seconds of the wall, less what other programs of this machine took of the processor.
    share = min(1.0, usage["processor_s"] / max(usage["elapsed_s"], 1e-9)) if outcome.elapsed and job.threads == 1 else 1.0
    return {"evaluations": outcome.evaluations, "voxel_evaluations": round(outcome.voxel_evaluations),
            "seconds": outcome.seconds * share, "share": share, "peak_mb": usage["peak_mb"],
            "all_s": usage["processor_s"], "stopped": outcome.stopped}, outcome.field


def answer(folder, number):
    """What a process prints."""
    options = json.loads((folder / "job.json").read_text(encoding="utf-8"))
    with numpy.load(folder / "pair.npz") as pair:
        job = programs.Job(**options, folder=folder, fixed=pair["fixed"], moving=pair["moving"])
    try:
        row, field = work(job, programs.PROGRAMS[number])
    except programs.Absent as error:
        return {"absent": str(error)}
    except programs.AlignError as error:
        return {"failed": str(error)}
    numpy.save(folder / "field.npy", field)
    return row


def start(program, job, processors, python_path=None):
    """(row, field) of a program in a process of its own, on these processors. The row of a program that is absent has
    only why, and no field. Raises AlignError."""
    job.folder.mkdir(parents=True, exist_ok=True)
    numpy.savez(job.folder / "pair.npz", fixed=job.fixed, moving=job.moving)
    options = {field.name: getattr(job, field.name) for field in dataclasses.fields(job)
               if field.name not in ("fixed", "moving", "folder")}
    (job.folder / "job.json").write_text(json.dumps(options), encoding="utf-8")
    environment = {**os.environ, **dict.fromkeys(THREADS, str(job.threads)), "OPENBLAS_NUM_THREADS": "1"}
    if python_path:
        environment["PYTHONPATH"] = os.pathsep.join([str(python_path), environment.get("PYTHONPATH", "")])
    result = subprocess.run([sys.executable, "-B", "-m", "lab.align.run", job.folder, str(programs.PROGRAMS.index(program))],
                            capture_output=True, text=True, check=False, env=environment,
                            preexec_fn=lambda: os.sched_setaffinity(0, processors))
    lines = result.stdout.strip().splitlines()
    if result.returncode or not lines:
        why = (result.stderr.strip().splitlines() or ["no message"])[-1]
        raise programs.AlignError(f"{program.name} ended with {result.returncode}: {why}")
    row = json.loads(lines[-1])
    if "failed" in row:
        raise programs.AlignError(row["failed"])
    return row, None if "absent" in row else numpy.load(job.folder / "field.npy")


if __name__ == "__main__":
    print(json.dumps(answer(pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2]))))
