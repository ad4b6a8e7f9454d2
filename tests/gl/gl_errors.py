"""Every row of the error tables of the GL commands, beside OpenGL's own commands where they can
make the same mistake.

A call is a tuple: the command, then its arguments.

SPDX-License-Identifier: Apache-2.0
"""

import itertools
from typing import NamedTuple, Optional

import numpy as np
from opengl import gl

OK, ENUM, VALUE, OPERATION = gl.NO_ERROR, gl.INVALID_ENUM, gl.INVALID_VALUE, gl.INVALID_OPERATION
ROOM = np.zeros(4096)  # for whatever a query returns
MAP_POINTS = np.zeros(3 * 40 * 40)  # for every order that is tried
STREAM = np.zeros(195, np.float32)
UNITS = (0, 1, 3, 1) * 3  # of glMap3: one point


class Case(NamedTuple):
    """A mistake, or the lack of one."""

    name: str  # "command: mistake"
    expected: int
    call: tuple
    planar: Optional[tuple] = None  # the same in OpenGL's own command, where it has one


class Mistake(NamedTuple):
    """What is wrong with the arguments of glMap3, and of glMap2 beside them."""

    name: str
    error: int
    volume: dict
    planar: dict


def axis_mistakes(axis):
    planar = "u" if axis == "u" else "v"
    for name, argument, volume, surface in (
            (f"1 = {axis}2", "2", 0, 0), ("order 0", "order", 0, 0), ("order -1", "order", -1, -1),
            ("order too high", "order", 17, 31), ("stride 2", "stride", 2, 2)):
        yield Mistake(axis + name, VALUE, {axis + argument: volume}, {planar + argument: surface})


BETWEEN = Mistake("between glBegin and glEnd", OPERATION, *2 * ({"between": True},))
MISTAKES = [*itertools.chain(*map(axis_mistakes, "uvw")),
            Mistake("unknown target", ENUM, *2 * ({"target": 1},)),
            Mistake("texture unit 1", OPERATION, *2 * ({"unit": gl.TEXTURE1},)), BETWEEN]


def call_map(command, target, axes, changes):
    """glMap3d or glMap2d of two points an axis, but for the changes."""
    arguments = {"target": target, "unit": gl.TEXTURE0, "between": False}
    for axis in axes:
        arguments |= {axis + "1": 0, axis + "2": 1, axis + "stride": 3, axis + "order": 2}
    arguments |= changes
    gl.ActiveTexture(arguments.pop("unit"))
    call = (command, *(value for name, value in arguments.items() if name != "between"), MAP_POINTS)
    (between_begin_and_end if arguments["between"] else perform)(*call)
    gl.ActiveTexture(gl.TEXTURE0)


def first_error(mistakes):
    """What the specification says of several mistakes: the first of its order of checks."""
    order = (lambda mistake: mistake is BETWEEN,
             lambda mistake: mistake.error == VALUE and "stride" not in mistake.name,
             lambda mistake: mistake.error == ENUM, lambda mistake: mistake.error == VALUE,
             lambda mistake: True)
    return next((mistake.error for is_next in order for mistake in mistakes if is_next(mistake)), OK)


def map_cases():
    """All mistakes that glMap3 knows, alone, in pairs and by three, so that the order of the checks
    shows."""
    for count in range(4):
        for mistakes in itertools.combinations(MISTAKES, count):
            volume, planar = ({key: value for mistake in mistakes
                               for key, value in getattr(mistake, kind).items()}
                              for kind in ("volume", "planar"))
            yield Case("glMap3: " + ", ".join(mistake.name for mistake in mistakes), first_error(mistakes),
                       (call_map, gl.Map3d, gl.MAP3_VERTEX_3, "uvw", volume),
                       (call_map, gl.Map2d, gl.MAP2_VERTEX_3, "uv", planar))


def perform(command, *arguments):
    command(*arguments)


def between_begin_and_end(command, *arguments):
    gl.Begin(gl.POINTS)
    command(*arguments)
    gl.End()


def evaluate_line(points, degree=None):
    """A map of so many points along u, under blending functions of a degree or Bernstein's."""
    gl.Map3d(gl.MAP3_VERTEX_3, 0, 1, 3, points, *UNITS[4:], ROOM)
    if degree is not None:
        gl.BlendCoefficientd(gl.MAP3_U, degree, ROOM)
    gl.EnableMap3(gl.MAP3_VERTEX_3)
    gl.EvalCoord3d(0, 0, 0)
    gl.DisableMap3(gl.MAP3_VERTEX_3)
    gl.BlendCoefficientd(gl.MAP3_U, 0, None)


def query_cases():
    yield from (
        Case("glGetMap3: valid", OK, (gl.GetMap3dv, gl.MAP3_VERTEX_3, gl.ORDER, ROOM),
             (gl.GetMapdv, gl.MAP2_VERTEX_3, gl.ORDER, ROOM)),
        Case("glGetMap3: unknown target", ENUM, (gl.GetMap3dv, 1, gl.COEFF, ROOM),
             (gl.GetMapdv, 1, gl.COEFF, ROOM)),
        Case("glGetMap3: unknown query", ENUM, (gl.GetMap3dv, gl.MAP3_VERTEX_3, 1, ROOM),
             (gl.GetMapdv, gl.MAP2_VERTEX_3, 1, ROOM)),
        Case("glGetMap3: both unknown", ENUM, (gl.GetMap3dv, 1, 1, ROOM),
             (gl.GetMapdv, 1, 1, ROOM)),
        Case("glGetEval3: valid", OK, (gl.GetEval3dv, gl.MAP3_GRID_DOMAIN, ROOM),
             (gl.GetDoublev, gl.MAP2_GRID_DOMAIN, ROOM)),
        Case("glGetEval3: unknown name", ENUM, (gl.GetEval3dv, 1, ROOM), (gl.GetDoublev, 1, ROOM)))
    for name in ("Enable", "Disable", "IsEnabled"):
        volume, planar = getattr(gl, name + "Map3"), getattr(gl, name)
        yield Case(f"gl{name}Map3: valid", OK, (volume, gl.MAP3_NORMAL), (planar, gl.MAP2_NORMAL))
        yield Case(f"gl{name}Map3: unknown map", ENUM, (volume, 1), (planar, 1))


def grid_cases():
    u, v, w = (2, 0, 1), (2, 0, 1), (2, 0, 1)
    yield Case("glMapGrid3: valid", OK, (gl.MapGrid3d, *u, *v, *w), (gl.MapGrid2d, *u, *v))
    yield Case("glMapGrid3: empty domain", OK, (gl.MapGrid3f, 2, 0, 0, *v, 2, 1, 1),
               (gl.MapGrid2f, 2, 0, 0, 2, 1, 1))
    for few in ((0, 0, 1), (-1, 0, 1)):
        yield Case(f"glMapGrid3: un = {few[0]}", VALUE, (gl.MapGrid3d, *few, *v, *w),
                   (gl.MapGrid2d, *few, *v))
        yield Case(f"glMapGrid3: vn = {few[0]}", VALUE, (gl.MapGrid3f, *u, *few, *w),
                   (gl.MapGrid2f, *u, *few))
        yield Case(f"glMapGrid3: wn = {few[0]}", VALUE, (gl.MapGrid3d, *u, *v, *few),
                   (gl.MapGrid2d, *u, *few))


def mesh_cases():
    for name, error, mode, u, v in (("valid", OK, gl.LINE, (0, 1), (0, 1)),
                                    ("unknown mode", ENUM, 1, (0, 1), (0, 1)),
                                    ("empty range", OK, gl.POINT, (1, 0), (1, 0)),
                                    ("beyond the grid", OK, gl.POINT, (-2, 5), (0, 1))):
        yield Case("glEvalMesh3: " + name, error, (gl.EvalMesh3, mode, *u, *v, *v),
                   (gl.EvalMesh2, mode, *u, *v))
    yield Case("glEvalMesh3: GL_FILL", ENUM, (gl.EvalMesh3, gl.FILL, 0, 1, 0, 1, 0, 1))


def point_cases():
    yield Case("glEvalCoord3: valid", OK, (gl.EvalCoord3d, 0, 0, 0), (gl.EvalCoord2d, 0, 0))
    yield Case("glEvalCoord3: beyond the domain", OK, (gl.EvalCoord3f, 9, -9, 0),
               (gl.EvalCoord2f, 9, -9))
    yield Case("glEvalPoint3: valid", OK, (gl.EvalPoint3, 0, 0, 0), (gl.EvalPoint2, 0, 0))
    yield Case("glEvalPoint3: beyond the grid", OK, (gl.EvalPoint3, 99, -1, 0),
               (gl.EvalPoint2, 99, -1))


def stream_cases():
    for name, error, mode, count in (("valid", OK, gl.POINTS, 1), ("no vertices", OK, gl.POINTS, 0),
                                     ("unknown mode", ENUM, 77, 1),
                                     ("count -1", VALUE, gl.POINTS, -1),
                                     ("count -1, unknown mode", VALUE, 77, -1)):
        yield Case("glFFD: " + name, error, (gl.FFD, mode, count, gl.FLOAT, STREAM),
                   (gl.DrawArrays, mode, 0, count))
    yield Case("glFFD: unknown type", ENUM, (gl.FFD, gl.POINTS, 1, gl.SHORT, STREAM))
    yield Case("glFFD: null stream", VALUE, (gl.FFD, gl.POINTS, 1, gl.FLOAT, None))
    yield Case("glFfdDevice: unknown device", VALUE, (gl.FfdDevice, b"abacus"))


def blend_cases():
    for name, error, axis, degree, numbers in (
            ("initial state", OK, gl.MAP3_U, 3, None), ("unknown axis", ENUM, gl.S, 3, ROOM),
            ("unknown axis, degree 4", ENUM, gl.S, 4, ROOM),
            ("degree -1", VALUE, gl.MAP3_U, -1, ROOM), ("degree 4", VALUE, gl.MAP3_W, 4, ROOM),
            ("not a number", VALUE, gl.MAP3_V, 3, np.full(16, np.nan))):
        yield Case("glBlendCoefficient: " + name, error,
                   (gl.BlendCoefficientd, axis, degree, numbers))
    for name, axis, query in (("axis", gl.S, gl.ORDER), ("query", gl.MAP3_U, gl.DOMAIN)):
        yield Case("glGetBlendCoefficient: unknown " + name, ENUM,
                   (gl.GetBlendCoefficientdv, axis, query, ROOM))


def volume_cases():
    """What can be wrong only with volumes."""
    yield Case("glMap3: null points", VALUE, (gl.Map3d, gl.MAP3_VERTEX_3, *UNITS, None))
    yield Case("glMap3: target of glMap2", ENUM, (gl.Map3d, gl.MAP2_VERTEX_3, *UNITS, ROOM),
               (gl.Map2d, gl.MAP1_VERTEX_3, *UNITS[4:], ROOM))
    for name, error, line in (("four points, Bernstein", OK, (4,)),
                              ("five points, Bernstein", OPERATION, (5,)),
                              ("13 cells", OK, (15, 2)), ("14 cells", OPERATION, (16, 2)),
                              ("fewer points than functions", OPERATION, (3, 3))):
        yield Case("glEvalCoord3: " + name, error, (evaluate_line, *line))


def cases():
    yield from map_cases()
    yield from volume_cases()
    for make, between in ((query_cases, OPERATION), (grid_cases, OPERATION),
                          (mesh_cases, OPERATION), (point_cases, OK), (stream_cases, OPERATION),
                          (blend_cases, OPERATION)):
        for case in make():
            yield case
            yield Case(case.name + ", between glBegin and glEnd", between,
                       (between_begin_and_end, *case.call),
                       case.planar and (between_begin_and_end, *case.planar))
