"""What the tests of the GL commands draw, and what eq. (1) makes of it, straight from the paper.

Blending functions are a matrix, row l function l, columns the powers; that of n rows is of degree
n - 1.

SPDX-License-Identifier: Apache-2.0
"""

import math
import unittest

import numpy as np
from opengl import Context, gl

UNIT = ((0, 1), (0, 1), (0, 1))
BSPLINE = np.array([[1, -3, 3, -1], [4, 0, -6, 3], [1, 3, 3, -3], [0, 0, 0, 1]]) / 6
CATMULL_ROM = np.array([[0, -1, 2, -1], [2, 0, -5, 3], [0, 1, 4, -3], [0, 0, -1, 1]]) / 2
CORNERS = np.array(list(np.ndindex(2, 2, 2)), float)
HERMITE = np.array([[1., 0, -3, 2], [0, 1, -2, 1], [0, 0, 3, -2], [0, 0, -1, 1]])


def bernstein(degree):
    functions = np.zeros((degree + 1, degree + 1))
    for number in range(degree + 1):
        for power in range(degree - number + 1):
            functions[number, number + power] = (
                math.comb(degree, number) * math.comb(degree - number, power) * (-1) ** power)
    return functions


def eq1(points, functions, position):
    """Eq. (1) at a position, 0 to 1 along each axis of all of the points: n - degree cells."""
    for matrix, part in zip(functions, position):
        cells = len(points) - len(matrix) + 1
        cell = min(int(part * cells), cells - 1)
        weights = matrix @ (part * cells - cell) ** np.arange(len(matrix))
        points = np.tensordot(weights, points[cell:cell + len(matrix)], 1)
    return points


class RandomMap:
    """Control points at random, with gaps between them that strides step over. The first axis runs
    fastest, so that no two axes can be mistaken for one another."""

    def __init__(self, random, counts, components, low=-0.9):
        self.counts = counts
        along_s = components + 1
        along_t = along_s * counts[0] + 2
        self.strides = (along_s, along_t, along_t * counts[1] + 3)
        self.values = random.uniform(low, 0.9, self.strides[2] * counts[2])
        self.points = np.lib.stride_tricks.as_strided(
            self.values, (*counts, components), [8 * stride for stride in (*self.strides, 1)])

    def define(self, target, domain=UNIT):
        axes = zip(domain, self.strides, self.counts)
        gl.Map3d(target, *(n for ends, stride, order in axes for n in (*ends, stride, order)),
                 self.values)


def define_cube():
    """The identity: the volume's points are the corners of the unit cube."""
    gl.Map3d(gl.MAP3_VERTEX_3, 0, 1, 12, 2, 0, 1, 6, 2, 0, 1, 3, 2, CORNERS)
    gl.EnableMap3(gl.MAP3_VERTEX_3)


def draw(mode, command, vertices):
    """Calls a command for each vertex, between glBegin and glEnd."""
    gl.Begin(mode)
    for vertex in vertices:
        command(*vertex)
    gl.End()


def reset_state():
    """Puts the state of the GL commands back to what it is in a new thread, but for the points of
    maps."""
    for cap in (*range(gl.MAP3_COLOR_4, gl.MAP3_VERTEX_4 + 1), gl.AUTO_NORMAL):
        gl.DisableMap3(cap)
    for axis in (gl.MAP3_U, gl.MAP3_V, gl.MAP3_W):
        gl.BlendCoefficientd(axis, 0, None)
    gl.MapGrid3d(1, 0, 1, 1, 0, 1, 1, 0, 1)
    gl.FfdDevice(None)


class GlTest(unittest.TestCase):
    def setUp(self):
        self.random = np.random.default_rng(7)
        self.addCleanup(Context().close)
        self.addCleanup(reset_state)

    def assert_near(self, got, expected, tolerance, what=""):
        np.testing.assert_allclose(got, expected, rtol=0, atol=tolerance, err_msg=what)
