"""What all libraries are given: points in a box with a lattice over it, and where some of them go.

SPDX-License-Identifier: Apache-2.0
"""

import itertools
from dataclasses import dataclass

import numpy

DIMS = (8, 8, 8)
CHECKED = 20_000  # points whose place is known by equation (1)
SEED = 1


def weights(x):
    """B_0(x) to B_3(x) of the uniform cubic B-spline, along the last axis."""
    y = 1 - x
    return numpy.stack([y**3, 4 - 6 * x**2 + 3 * x**3, 4 - 6 * y**2 + 3 * y**3, x**3], -1) / 6


def evaluated(points, places):
    """Equation (1) of the paper, at places counted in control points from the first."""
    cells = numpy.clip(numpy.floor(places).astype(int), 1, numpy.array(points.shape[:3]) - 3)
    of_axis = [weights(places[:, axis] - cells[:, axis]) for axis in range(3)]
    moved = numpy.zeros(places.shape)
    for l, m, n in itertools.product(range(4), repeat=3):
        weight = of_axis[0][:, l] * of_axis[1][:, m] * of_axis[2][:, n]
        at = tuple((cells - 1 + (l, m, n)).T)
        moved += weight[:, None] * points[at]
    return moved


@dataclass
class Scene:
    """Points in the unit cube, and control points that were moved."""

    points: numpy.ndarray   # n x 3
    rest: numpy.ndarray     # 8 x 8 x 8 x 3: the cells fill the cube
    moved: numpy.ndarray
    exact: numpy.ndarray    # where the first CHECKED points go

    @classmethod
    def random(cls, count):
        random = numpy.random.default_rng(SEED)
        points = random.random((count, 3))
        axes = [(numpy.arange(n) - 1.0) / (n - 3) for n in DIMS]
        rest = numpy.stack(numpy.meshgrid(*axes, indexing="ij"), -1)
        moved = rest + random.uniform(-0.05, 0.05, rest.shape)
        return cls(points, rest, moved, evaluated(moved, cls.places(points[:CHECKED])))

    @staticmethod
    def places(points):
        """Points as they lie among the control points."""
        return points * (numpy.array(DIMS) - 3) + 1
