"""hwffd as one of the programs.

SPDX-License-Identifier: Apache-2.0
"""

import time

import numpy

from lab.align.programs import Level, Outcome

LONGER = 6  # times the iterations


def _aligned(job, device, iterations):
    import hwffd
    from hwffd import volumes
    hwffd.set_threads(job.threads)
    start = time.process_time()
    result = hwffd.register(job.fixed, job.moving, spacing=float(job.spacing), levels=job.levels, metric="mean-squares",
                            iterations=iterations, device=device,
                            progress=lambda state: time.process_time() - start < job.budget)
    # Levels are not told apart: all evaluations are of the mean number of voxels.
    mean = result.voxels / max(result.evaluations, 1)
    lattice = result.lattice
    lattice.set_device("reference")
    field = volumes.displacement_field(volumes.Volume(job.fixed), lattice).values
    return Outcome(numpy.asarray(field), [Level(result.evaluations, mean)], result.seconds, stopped=result.stopped)


def reference(job):
    return _aligned(job, "reference", job.iterations)


def longer(job):
    return _aligned(job, "reference", LONGER * job.iterations)


def model(job):
    return _aligned(job, "model", job.iterations)
