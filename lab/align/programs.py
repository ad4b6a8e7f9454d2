"""The programs that align volumes, in one form.

Each function gets a Job and returns an Outcome. A program of which something is missing raises Absent, with the reason
in one line, and stands in the table with it.

SPDX-License-Identifier: Apache-2.0
"""

import dataclasses
import importlib
import importlib.metadata
import pathlib

import numpy


class Absent(Exception):
    """Why a program cannot be run here, in one line."""


class AlignError(Exception):
    """Why there is no result, in one line."""


@dataclasses.dataclass
class Job:
    """A pair to align, and how."""

    fixed: numpy.ndarray  # (nz, ny, nx) of binary32, voxels of size 1
    moving: numpy.ndarray
    spacing: int          # of control points at the finest level, in voxels
    levels: int           # of the image pyramid: halved from one to the next, and lattices with them
    iterations: int       # most a level
    threads: int
    budget: float         # seconds of the processor after which a program that can be stopped is
    folder: pathlib.Path  # for files of its own

    @property
    def counts(self):
        return self.fixed.shape[::-1]


@dataclasses.dataclass
class Level:
    """What a program did at a level."""

    evaluations: int
    voxels: int  # of each evaluation


@dataclasses.dataclass
class Outcome:
    """What a program gave. Seconds are those of its loop; without them there is no rate."""

    field: numpy.ndarray   # u at the voxels of the fixed volume, (nz, ny, nx, 3), of the program's own type
    levels: list
    seconds: float
    elapsed: bool = True   # whether seconds are those of a clock on the wall; else of the processor
    stopped: bool = False  # by the budget
    usage: dict | None = None  # of a command: its processor_s, elapsed_s, peak_mb

    @property
    def evaluations(self):
        return sum(level.evaluations for level in self.levels)

    @property
    def voxel_evaluations(self):
        return sum(level.evaluations * level.voxels for level in self.levels)


@dataclasses.dataclass(frozen=True)
class Program:
    """A program, how it is called, and where that differs from what the others are told."""

    name: str
    package: str      # that it comes with
    optimiser: str
    module: str       # of this folder, which has the function
    function: str
    counted: str      # how evaluations are counted
    differs: str = ""  # from spacing, levels, metric and stopping as they are told
    most_voxels: int | None = None  # of a pair that it gets
    hwffd: bool = False
    rate_aim: float | None = None  # how many times its rate is aimed at

    @property
    def version(self):
        """Raises Absent."""
        try:
            if self.hwffd:
                import hwffd
                return hwffd.__version__
            return importlib.metadata.version(self.package)
        except ImportError:  # PackageNotFoundError is one
            raise Absent(f"{self.package} is not in build/venv") from None

    def run(self, job):
        """Raises Absent and AlignError."""
        try:
            module = importlib.import_module(f"lab.align.{self.module}")
            return getattr(module, self.function)(job)
        except ImportError as error:
            raise Absent(f"{error}") from error


VALUE_AND_GRADIENT = "the program's own count of the metric with its gradient"
PROGRAMS = (
    Program("hwffd, reference", "hwffd", "L-BFGS", "registration", "reference", VALUE_AND_GRADIENT, hwffd=True),
    Program("hwffd, longer", "hwffd", "L-BFGS", "registration", "longer", VALUE_AND_GRADIENT, hwffd=True,
            differs="six times the iterations"),
    Program("hwffd, model", "hwffd", "L-BFGS", "registration", "model", VALUE_AND_GRADIENT, most_voxels=48**3, hwffd=True,
            differs="positions and gradients are those of the bit-true model of a core"),
    Program("plastimatch", "plastimatch", "L-BFGS-B", "commands", "plastimatch",
            "lines of its log, one for each evaluation with gradient", rate_aim=3,
            differs="a level ends after as many evaluations as others have iterations"),
    Program("elastix, L-BFGS", "itk-elastix", "L-BFGS, all voxels", "libraries", "elastix_lbfgs",
            "of its log: for each level one, and for each iteration its line search steps and two"),
    Program("elastix, stochastic", "itk-elastix", "adaptive stochastic gradient descent", "libraries",
            "elastix_stochastic", "iterations, each of its samples",
            differs="4,096 random samples an iteration and five times the iterations; takes no other stopping rule"),
    Program("SimpleITK", "simpleitk", "L-BFGS", "libraries", "simpleitk",
            "seconds between iterations by the least of the level, rounded, as it does not say", rate_aim=100),
    Program("NiftyReg", "niftyreg", "conjugate gradient", "commands", "niftyreg",
            "of its log, with or without gradient",
            differs="three times the iterations, as it counts evaluations; squared differences of values scaled to 0 "
                    "to 1; gradients only once a line search"),
)
