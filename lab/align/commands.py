"""Programs that are commands: plastimatch, and reg_f3d of NiftyReg.

Each is started by a launcher that imports nothing, so that the largest memory that the system counts is that of the
command, and not of the Python that started it.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import re
import subprocess
import sys

import numpy

from lab.align.programs import Absent, AlignError, Level, Outcome

LAUNCHER = """
import json, os, resource, subprocess, sys, time
start = time.monotonic()
with open(sys.argv[1], "wb") as log:
    status = subprocess.call(sys.argv[3:], stdout=log, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
with open(sys.argv[2], "w") as file:
    json.dump({"status": status, "elapsed_s": time.monotonic() - start, "processor_s": used.ru_utime + used.ru_stime,
               "peak_mb": used.ru_maxrss / 1024}, file)
"""


def launched(job, name, command):
    """Runs a command in the job's folder; (what it printed, its usage). Raises AlignError."""
    log, usage = job.folder / f"{name}.log", job.folder / f"{name}.json"
    subprocess.run([sys.executable, "-I", "-S", "-c", LAUNCHER, log, usage, *map(str, command)], check=True,
                   cwd=job.folder, env={**os.environ, "OMP_NUM_THREADS": str(job.threads)})
    text, used = log.read_text(encoding="utf-8", errors="replace"), json.loads(usage.read_text(encoding="utf-8"))
    if used["status"]:
        lines = text.strip().splitlines() or ["no message"]
        raise AlignError(f"{name} ended with {used['status']}: {lines[-1]}")
    return text, used


_EVALUATION = re.compile(r"^\[ *\d+, *\d+\] MSE .* NV +(\d+) .*\[ +([\d.]+) s \]", re.MULTILINE)
_STAGE = re.compile(r"roi_dim = (\d+) (\d+) (\d+)")


def plastimatch_log(text):
    """(levels, seconds of their evaluations) that a log of plastimatch says."""
    levels, seconds = [], 0.0
    for stage in _STAGE.finditer(text):
        rest = text[stage.end():]
        following = _STAGE.search(rest)
        lines = _EVALUATION.findall(rest[:following.start()] if following else rest)
        levels.append(Level(len(lines), int(numpy.prod([int(n) for n in stage.groups()]))))
        seconds += sum(float(line[1]) for line in lines)
    return levels, seconds


def plastimatch_options(job):
    """A command file: a stage for each level."""
    lines = ["[GLOBAL]", "fixed=fixed.mha", "moving=moving.mha", "vf_out=field.mha"]
    for level in reversed(range(job.levels)):
        step = 2**level
        lines += ["[STAGE]", "xform=bspline", "impl=plastimatch", "optim=lbfgsb", "metric=mse", "threading=openmp",
                  f"max_its={job.iterations}", f"res={step} {step} {step}",
                  "grid_spac=" + " ".join([str(job.spacing * step)] * 3)]
    return "\n".join(lines) + "\n"


def plastimatch(job):
    import SimpleITK
    program = pathlib.Path(sys.prefix) / "bin" / "plastimatch"
    if not program.is_file():
        raise Absent("no command plastimatch in build/venv")
    for name, values in (("fixed", job.fixed), ("moving", job.moving)):
        SimpleITK.WriteImage(SimpleITK.GetImageFromArray(values), str(job.folder / f"{name}.mha"))
    (job.folder / "options.txt").write_text(plastimatch_options(job), encoding="utf-8")
    text, used = launched(job, "plastimatch", [program, "register", "options.txt"])
    levels, seconds = plastimatch_log(text)
    if len(levels) != job.levels:
        raise AlignError(f"plastimatch: {len(levels)} levels in its log, {job.levels} wanted")
    field = SimpleITK.GetArrayFromImage(SimpleITK.ReadImage(str(job.folder / "field.mha")))
    return Outcome(field, levels, seconds, usage=used)


_SIZE = re.compile(r"Current reference image\s.*image dimension: (\d+) x (\d+) x (\d+)", re.DOTALL)


def niftyreg_log(text):
    """The levels that a log of reg_f3d says: the last number in brackets counts evaluations of the value."""
    levels = []
    for part in text.split("Current level:")[1:]:
        size = re.search(r"image dimension: (\d+) x (\d+) x (\d+)", part)
        counts = re.findall(r"\[(\d+)\] Current objective function", part)
        if size and counts:
            levels.append(Level(int(counts[-1]), int(numpy.prod([int(n) for n in size.groups()]))))
    return levels


def niftyreg(job):
    import nibabel
    import niftyreg as package
    for name, values in (("fixed", job.fixed), ("moving", job.moving)):
        nibabel.save(nibabel.Nifti1Image(values.transpose(2, 1, 0), numpy.eye(4)), job.folder / f"{name}.nii")
    # A negative spacing is one in voxels; a level has twice the evaluations of the next finer one.
    text, used = launched(job, "reg_f3d", [
        package.bin_path / "reg_f3d", "-ref", "fixed.nii", "-flo", "moving.nii", "-sx", -job.spacing, "-ln", job.levels,
        "--ssd", "-be", 0, "-le", 0, "-maxit", 3 * job.iterations, "-omp", job.threads, "-cpp", "lattice.nii",
        "-res", "warped.nii"])
    levels = niftyreg_log(text)
    if len(levels) != job.levels:
        raise AlignError(f"reg_f3d: {len(levels)} levels in its log, {job.levels} wanted")
    launched(job, "reg_transform", [package.bin_path / "reg_transform", "-ref", "fixed.nii", "-disp", "lattice.nii",
                                    "field.nii"])
    field = numpy.asanyarray(nibabel.load(job.folder / "field.nii").dataobj)
    # It tells no time but whole seconds of all it does, of which the loop is nearly all.
    return Outcome(numpy.ascontiguousarray(field.squeeze().transpose(2, 1, 0, 3)), levels, used["elapsed_s"], usage=used)
