"""Programs that are libraries of Python: SimpleITK, and elastix in ITK.

SPDX-License-Identifier: Apache-2.0
"""

import re
import time

import numpy

from lab.align.programs import AlignError, Level, Outcome

SAMPLES, STOCHASTIC_ITERATIONS = 4096, 5  # of an iteration of elastix, and times those of the others


def counted(times):
    """How many evaluations lie between iterations that ended at `times`: the least is one."""
    steps = numpy.diff(times)
    return int(numpy.rint(steps / max(steps.min(), 1e-9)).sum()) if len(steps) else 0


class _Over(Exception):
    """The time of a program, whose loop cannot be asked to stop."""


def simpleitk(job):
    import SimpleITK as itk
    itk.ProcessObject.SetGlobalDefaultNumberOfThreads(job.threads)
    fixed, moving = (itk.GetImageFromArray(values) for values in (job.fixed, job.moving))
    steps = [2**level for level in reversed(range(job.levels))]
    method = itk.ImageRegistrationMethod()
    method.SetNumberOfThreads(job.threads)
    method.SetMetricAsMeanSquares()
    method.SetMetricSamplingStrategy(method.NONE)
    method.SetInterpolator(itk.sitkLinear)
    method.SetShrinkFactorsPerLevel(steps)
    method.SetSmoothingSigmasPerLevel([step / 2 if step > 1 else 0 for step in steps])
    cells = [max(1, round(n / job.spacing / steps[0])) for n in job.counts]
    transform = itk.BSplineTransformInitializer(fixed, cells, order=3)
    method.SetInitialTransformAsBSpline(transform, inPlace=True, scaleFactors=[steps[0] // step for step in steps])
    method.SetOptimizerAsLBFGS2(numberOfIterations=job.iterations, deltaConvergenceDistance=5,
                                deltaConvergenceTolerance=1e-4)
    start, ends, seen = time.process_time(), [[] for _ in steps], []

    def iterated():
        seen.append(time.process_time())  # of all threads
        ends[method.GetCurrentLevel()].append(seen[-1])
        if seen[-1] - start > job.budget:
            raise _Over

    method.AddCommand(itk.sitkIterationEvent, iterated)
    stopped = False
    try:
        method.Execute(fixed, moving)
    except _Over:  # the transform is that of the last evaluation
        stopped = True
    except RuntimeError as error:
        if not seen or seen[-1] - start <= job.budget:
            raise AlignError(f"SimpleITK: {str(error).strip().splitlines()[-1]}") from error
        stopped = True
    if not seen:
        raise AlignError("SimpleITK: no iteration")
    levels, seconds = [], 0.0
    for times, step in zip(ends, steps):
        levels.append(Level(counted(times), int(numpy.prod([n // step for n in job.counts]))))
        seconds += times[-1] - times[0] if times else 0.0
    field = itk.GetArrayFromImage(itk.TransformToDisplacementField(transform, itk.sitkVectorFloat64, fixed.GetSize()))
    return Outcome(field, levels, seconds, elapsed=False, stopped=stopped)


def elastix_log(text):
    """For each level the lines of its iterations, as numbers and words."""
    return [[line.split() for line in part.splitlines() if re.match(r"\d+\t", line)]
            for part in re.split(r"^1:ItNr.*$", text, flags=re.MULTILINE)[1:]]


def elastix(job, parameters):
    """(field, for each level its iterations) of a registration with these parameters and those of all."""
    import itk
    fixed, moving = (itk.image_view_from_array(values) for values in (job.fixed, job.moving))
    options = dict(itk.ParameterObject.GetDefaultParameterMap("bspline", job.levels, float(job.spacing)))
    for name in ("FinalGridSpacingInPhysicalUnits", "Metric0Weight", "Metric1Weight"):
        options.pop(name, None)
    options.update({
        "Registration": ["MultiResolutionRegistration"], "Metric": ["AdvancedMeanSquares"],
        "Interpolator": ["LinearInterpolator"], "NumberOfResolutions": [str(job.levels)],
        "FinalGridSpacingInVoxels": [str(job.spacing)] * 3, "WriteResultImage": ["false"],
        "GridSpacingSchedule": [str(2**level) for level in reversed(range(job.levels))], **parameters})
    parameter_object = itk.ParameterObject.New()
    parameter_object.AddParameterMap(options)
    method = itk.ElastixRegistrationMethod.New(fixed, moving)
    method.SetParameterObject(parameter_object)
    method.SetNumberOfThreads(job.threads)
    method.SetOutputDirectory(str(job.folder))
    method.SetLogFileName("elastix.log")
    method.SetLogToConsole(False)
    method.SetLogToFile(True)
    method.UpdateLargestPossibleRegion()
    transform = itk.TransformixFilter.New(moving)
    transform.SetTransformParameterObject(method.GetTransformParameterObject())
    transform.SetComputeDeformationField(True)
    transform.SetOutputDirectory(str(job.folder))
    transform.LogToConsoleOff()
    transform.UpdateLargestPossibleRegion()
    iterations = elastix_log((job.folder / "elastix.log").read_text(encoding="utf-8"))
    if len(iterations) != job.levels:
        raise AlignError(f"elastix: {len(iterations)} levels in its log, {job.levels} wanted")
    return numpy.array(itk.array_from_image(transform.GetOutputDeformationField())), iterations


def _seconds(iterations):
    """The last column is of an iteration, in milliseconds."""
    return sum(float(line[-1]) for level in iterations for line in level) / 1000


def line_search_evaluations(iterations):
    """Of a level: one before the first, and for each iteration the steps of its line search, of which the third column
    counts the further ones, and one more when it has ended."""
    return 1 + sum(int(line[2]) + 2 for line in iterations)


def elastix_lbfgs(job):
    field, iterations = elastix(job, {
        "Optimizer": ["QuasiNewtonLBFGS"], "ImageSampler": ["Full"], "NewSamplesEveryIteration": ["false"],
        "MaximumNumberOfIterations": [str(job.iterations)]})
    voxels = [int(numpy.prod([n // 2**level for n in job.counts])) for level in reversed(range(job.levels))]
    levels = [Level(line_search_evaluations(lines), n) for lines, n in zip(iterations, voxels)]
    return Outcome(field, levels, _seconds(iterations))


def elastix_stochastic(job):
    field, iterations = elastix(job, {
        "Optimizer": ["AdaptiveStochasticGradientDescent"], "ImageSampler": ["RandomCoordinate"],
        "NumberOfSpatialSamples": [str(SAMPLES)], "NewSamplesEveryIteration": ["true"],
        "MaximumNumberOfIterations": [str(STOCHASTIC_ITERATIONS * job.iterations)]})
    return Outcome(field, [Level(len(lines), SAMPLES) for lines in iterations], _seconds(iterations))
