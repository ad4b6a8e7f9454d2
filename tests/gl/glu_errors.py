"""Every row of the error tables of the GLU commands. They need no context.

SPDX-License-Identifier: Apache-2.0
"""

from typing import NamedTuple

import numpy as np
from opengl import gl, glu

OK, ENUM, VALUE = gl.NO_ERROR, glu.FFD_INVALID_ENUM, glu.FFD_INVALID_VALUE
ORDER, STRIDE, INDEX = glu.FFD_INVALID_ORDER, glu.FFD_INVALID_STRIDE, glu.FFD_INVALID_INDEX
NULL, MISSING, DECREASING = glu.FFD_NULL_CONTROL, glu.FFD_MISSING_DATA, glu.FFD_DECREASING_KNOTS
POINTS = np.zeros(4 * 20 * 20 * 20, np.float32)
NAN = float("nan")
# The arguments of gluFfdVolume: one vertex in a lattice of 4 x 4 x 4 points.
VOLUME = {"count": 1, "stride": 4, "coordinates": [0.5, 0.5, 0.5, 0],
          "sknot_count": 8, "sknots": None, "tknot_count": 8, "tknots": None,
          "uknot_count": 8, "uknots": None, "sstride": 48, "tstride": 12, "ustride": 3,
          "control": POINTS, "sorder": 4, "torder": 4, "uorder": 4, "type": gl.MAP3_VERTEX_3}
BEGIN, END = (glu.BeginVolume,), (glu.EndVolume,)


class Case(NamedTuple):
    """A mistake, or the lack of one."""

    name: str  # "command: mistake"
    expected: int  # what the callback gets, once; OK: it is not called
    calls: tuple  # each the command, and its arguments but for the renderer


def volume(**changes):
    """A call of gluFfdVolume."""
    return (glu.FfdVolume, *(VOLUME | changes).values())


def axis_cases(axis):
    """Mistakes that each axis can have."""
    for name, error, changes in (
            ("order 0", ORDER, {"order": 0}), ("order 5", ORDER, {"order": 5}),
            ("7 knots for order 4", glu.FFD_TOO_FEW_KNOTS, {"knot_count": 7}),
            ("14 cells", glu.FFD_TOO_MANY_CELLS, {"knot_count": 21}),
            ("as many knots as there are numbers", glu.FFD_TOO_MANY_CELLS, {"knot_count": 2**31 - 1}),
            ("13 cells", OK, {"knot_count": 20}), ("negative stride", STRIDE, {"stride": -1})):
        yield f"{axis}: {name}", error, {axis + key: value for key, value in changes.items()}
    for name, error, knots in (
            ("empty range", glu.FFD_EMPTY_KNOT_RANGE, [0, 1, 2, 3, 3, 4, 5, 6]),
            ("decreasing outside the range", DECREASING, [1, 0, 2, 3, 4, 5, 6, 7]),
            ("decreasing, at the end", DECREASING, [0, 1, 2, 3, 4, 5, 7, 6]),
            ("a knot that is not a number", DECREASING, [0, NAN, 2, 3, 4, 5, 6, 7]),
            ("five equal knots", glu.FFD_KNOT_MULTIPLICITY, [0, 0, 0, 0, 1, 1, 1, 1, 1, 2]),
            ("five equal knots, then decreasing", DECREASING, [0, 0, 0, 0, 1, 1, 1, 1, 1, 0]),
            ("clamped knots", OK, [0, 0, 0, 0, 1, 1, 1, 1])):
        yield f"{axis}: {name}", error, {axis + "knots": knots, axis + "knot_count": len(knots)}


def volume_mistakes():
    yield from (
        ("valid", OK, {}), ("unknown type", ENUM, {"type": 1}),
        ("colour index", ENUM, {"type": gl.MAP3_INDEX}),
        ("unknown type, negative stride", ENUM, {"type": 1, "sstride": -1}),
        ("negative stride, order 0", STRIDE, {"uorder": 0, "sstride": -1}),
        ("no control points, order 0", NULL, {"uorder": 0, "control": None}),
        ("stride 3 of vertices", STRIDE, {"stride": 3}),
        ("stride 3, no control points", STRIDE, {"stride": 3, "control": None}),
        ("count -1", VALUE, {"count": -1}), ("no coordinates", NULL, {"coordinates": None}),
        ("no control points", NULL, {"control": None}),
        ("only a colour", MISSING, {"type": gl.MAP3_COLOR_4}),
        ("control point not a number", glu.FFD_DEVICE_FAILED,
         {"control": np.where(np.arange(POINTS.size) == 0, np.float32(NAN), POINTS)}),
        ("coordinate not a number", VALUE, {"coordinates": [0.5, NAN, 0.5, 0]}),
        ("vertex of an empty cell", INDEX,
         {"uknots": [0, 0, 0, 0, 1, 1, 2, 2, 2, 2], "uknot_count": 10,
          "coordinates": [0.5, 0.5, 0.5, 1]}))
    for number in (-1, 0.5, 1, 64, 1e9):
        yield f"cell {number}", INDEX, {"coordinates": [0.5, 0.5, 0.5, number]}
    for axis in "stu":
        yield from axis_cases(axis)


def content_cases():
    """What lies in a volume beside its positions."""
    two = [0.5, 0.5, 0.5, 0, 0, 0, 0, 0]
    for name, error, call in (
            ("gluEndVolume: positions twice", MISSING, volume(coordinates=two)),
            ("gluEndVolume: more colours than positions", MISSING,
             volume(coordinates=two, type=gl.MAP3_COLOR_4, count=2)),
            ("gluEndVolume: a colour", OK, volume(coordinates=two, type=gl.MAP3_COLOR_4)),
            ("gluFfdNormals: valid", OK, (glu.FfdNormals, 1, 3, [0, 0, 1])),
            ("gluFfdNormals: more than positions", MISSING,
             (glu.FfdNormals, 2, 3, [0, 0, 1, 0, 0, 1])),
            ("gluFfdNormals: stride 2", STRIDE, (glu.FfdNormals, 1, 2, [0, 0, 1])),
            ("gluFfdNormals: count -1", VALUE, (glu.FfdNormals, -1, 3, [0, 0, 1])),
            ("gluFfdNormals: none", NULL, (glu.FfdNormals, 1, 3, None)),
            ("gluFfdElements: valid", OK, (glu.FfdElements, 1, [0])),
            ("gluFfdElements: beyond the vertices", INDEX, (glu.FfdElements, 2, [0, 1])),
            ("gluFfdElements: count -1", VALUE, (glu.FfdElements, -1, [0, 1])),
            ("gluFfdElements: none", NULL, (glu.FfdElements, 1, None))):
        yield Case(name, error, (BEGIN, volume(), call, END))


def order_cases():
    yield Case("gluBeginVolume: twice", glu.FFD_NESTED_VOLUME, (BEGIN, BEGIN))
    yield Case("gluEndVolume: without positions", MISSING, (BEGIN, END))
    for name, call in (("gluEndVolume", END), ("gluFfdVolume", volume()),
                       ("gluFfdNormals", (glu.FfdNormals, 1, 3, [0, 0, 1])),
                       ("gluFfdElements", (glu.FfdElements, 1, [0]))):
        yield Case(name + ": without begin", glu.FFD_MISSING_BEGIN, (call,))


def property_cases():
    for name, error, key, value in (
            ("valid", OK, glu.FFD_LINE_WIDTH, 2), ("unknown", ENUM, 1, 1),
            ("unknown mode", VALUE, glu.FFD_MODE, 1),
            ("unknown primitive", VALUE, glu.FFD_PRIMITIVE, 77),
            ("unknown display mode", VALUE, glu.FFD_DISPLAY_MODE, 1),
            ("line width 0", VALUE, glu.FFD_LINE_WIDTH, 0),
            ("line width not a number", VALUE, glu.FFD_LINE_WIDTH, NAN),
            ("point size -1", VALUE, glu.FFD_POINT_SIZE, -1),
            ("unknown device", VALUE, glu.FFD_DEVICE, 1)):
        yield Case("gluFfdProperty: " + name, error, ((glu.FfdProperty, key, value),))
    yield Case("gluGetFfdProperty: unknown", ENUM,
               ((glu.GetFfdProperty, 1, np.zeros(1, np.float32)),))
    for name, device in (("unknown kind", b"abacus"), ("empty part", b"model::fp32"),
                         ("unknown organization", b"model:circle:fp32")):
        yield Case("gluFfdDevice: " + name, glu.FFD_DEVICE_FAILED, ((glu.FfdDevice, device),))
    yield Case("gluFfdCallback: unknown", ENUM, ((glu.FfdCallback, glu.FFD_END + 1, None),))


def cases():
    for name, error, changes in volume_mistakes():
        yield Case("gluFfdVolume: " + name, error, (BEGIN, volume(**changes), END))
    yield from content_cases()
    yield from order_cases()
    yield from property_cases()
