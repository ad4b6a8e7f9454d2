"""Whatever is refused is an hwffd.Error of one line, and nothing that a program may try ends the process.

SPDX-License-Identifier: Apache-2.0
"""

import subprocess
import sys
import types

import hwffd
import numpy as np
import pytest

CORNERS = np.array([[-1.0, -1, -1], [1, 1, 1]])
LATTICE = hwffd.Lattice.around("box", CORNERS)
EMBEDDING = LATTICE.embed(CORNERS)
MASKED = np.ma.masked_array(CORNERS, mask=CORNERS < 0)

BARE = """
import hwffd
kind = getattr(hwffd, {kind!r})
bare = kind.__new__(kind)
members = [name for name in dir(kind) if not name.startswith("_") and isinstance(vars(kind)[name], property)]
calls = [lambda name=name: getattr(bare, name) for name in members]
calls += [lambda: repr(bare), lambda: bare.__getstate__()]
calls += [lambda: hwffd.deform(bare, [[0, 0, 0]]), lambda: hwffd.deform(
    hwffd.Lattice.around("box", [[0, 0, 0], [1, 1, 1]]), bare)]
calls += {calls}
for number, call in enumerate(calls):
    try:
        call()
    except hwffd.Error as error:
        assert "\\n" not in str(error), error
        assert number >= len(members) + 2 or "__new__ alone has made" in str(error), error
    else:
        raise AssertionError(number)
print(len(calls))
"""
METHODS = {
    "Lattice": "[lambda: bare.deform('none'), bare.folds, lambda: bare.set_device('model'), "
               "lambda: bare.embed([[0, 0, 0]]), lambda: bare.write('x'), "
               "lambda: setattr(bare, 'points', [[0, 0, 0]]), lambda: bare.set_outside('keep')]",
    "Embedding": "[lambda: len(bare), lambda: iter(bare), bare.weights, bare.csr, bare.unmoved, "
                 "lambda: bare.jacobians(hwffd.Lattice.around('box', [[0, 0, 0], [1, 1, 1]]))]"}


@pytest.mark.parametrize("kind", METHODS)
def test_an_object_that_new_alone_has_made_is_refused(kind):
    result = subprocess.run([sys.executable, "-B", "-c", BARE.format(kind=kind, calls=METHODS[kind])],
                            text=True, check=False, capture_output=True, timeout=60)
    assert (result.returncode, result.stderr) == (0, "")
    assert int(result.stdout) > 12


@pytest.mark.parametrize("call, text", [
    (lambda: hwffd.set_threads(-1), "count: -1; give an integer from 0 to 4096"),
    (lambda: hwffd.set_threads(10**30), "count: 1" + "0" * 30 + "; give an integer from 0 to 4096"),
    (lambda: hwffd.set_threads("4"), "count: '4'; give an integer from 0 to 4096"),
    (lambda: hwffd.set_threads(1.5), "count: 1.5; give an integer from 0 to 4096"),
    (lambda: hwffd.Lattice.around("box", CORNERS, dims="444"),
     "dims: '444'; give (ns, nt, nu), three integers"),
    (lambda: hwffd.Lattice.around("box", CORNERS, (4, 4)), "dims: (4, 4); give (ns, nt, nu), three integers"),
    (lambda: hwffd.Lattice.around("box", CORNERS, 4), "dims: 4; give (ns, nt, nu), three integers"),
    (lambda: hwffd.Lattice((4, 4, 2**40), CORNERS),
     "dims: (4, 4, 1099511627776); give (ns, nt, nu), three integers"),
    (lambda: LATTICE.evaluate_grid((0, 0, "0"), (1, 1, 1), (2, 2, 2)),
     "first: (0, 0, '0'); give (s, t, u), three finite numbers"),
    (lambda: LATTICE.evaluate_grid((0, 0, 0), (1, np.nan, 1), (2, 2, 2)),
     "last: (1, nan, 1); give (s, t, u), three finite numbers"),
    (lambda: LATTICE.evaluate_grid((0, 0, 0), (1, 1, 1), (2, 2, 0.5)),
     "counts: (2, 2, 0.5); give (cs, ct, cu), three integers"),
    (lambda: hwffd.devices("gpu"), "device 'gpu' is unknown; one of "),
    (lambda: LATTICE.deform(3), "deform: arguments (int); give (deformation: str)"),
    (lambda: LATTICE.deform(), "deform: arguments (); give (deformation: str)"),
    (lambda: hwffd.deform(None, CORNERS),
     "deform: arguments (NoneType, ndarray); give (lattice: Lattice, points: object, *, out: object = None)"),
    (lambda: EMBEDDING.jacobians(EMBEDDING), "jacobians: arguments (Embedding); give (lattice: Lattice)"),
    (lambda: hwffd.Lattice(dims=(4, 4, 4)), "Lattice: arguments (dims=tuple); give (dims: object, points: object"),
    (lambda: hwffd.Lattice.of(CORNERS, kind="x"), "of: arguments (ndarray, kind=str); give (control_points"),
    (lambda: hwffd.Lattice.read(3), "read: arguments (int); give (path: "),
])
def test_refusals_name_the_argument_and_what_to_give(call, text):
    with pytest.raises(hwffd.UsageError) as caught:
        call()
    assert str(caught.value).startswith(text) and "\n" not in str(caught.value)
    assert isinstance(caught.value, (ValueError, TypeError))


def test_numpy_ma_that_another_thread_imports_has_no_masked_arrays_yet(monkeypatch):
    monkeypatch.setitem(sys.modules, "numpy.ma", types.ModuleType("numpy.ma"))
    assert np.allclose(hwffd.deform(LATTICE, CORNERS), CORNERS)


@pytest.mark.parametrize("points", [MASKED, np.ma.masked_array(CORNERS), [MASKED[0], MASKED[1]],
                                    MASKED.astype(np.float32), MASKED[::-1]])
def test_masked_arrays_are_refused(points):
    text = ": a masked array; give one without a mask, as filled\\(value\\) makes it$"
    for name, call in {"points": lambda: hwffd.deform(LATTICE, points),
                       "control points": lambda: setattr(LATTICE, "points", points),
                       "gradient": lambda: EMBEDDING.pull_back(points),
                       "normals": lambda: EMBEDDING.normals(LATTICE, points),
                       "cells": lambda: LATTICE.evaluate(np.ma.masked_array([[0, 0, 0]]), [[0, 0, 0]]),
                       "out": lambda: hwffd.deform(LATTICE, CORNERS, out=np.ma.masked_array(CORNERS))}.items():
        with pytest.raises(hwffd.UsageError, match="^" + name + text):
            call()
    with pytest.raises(hwffd.UsageError, match="^points" + text):
        LATTICE.embed(points)


def test_writing_to_control_points_says_how_they_are_changed():
    lattice = hwffd.Lattice.around("box", CORNERS)

    def set_number():
        lattice.control_points[1, 1, 1] += 1

    def set_one():
        lattice.points[0] = 7

    def all_of_them():
        points = lattice.rest_points
        points *= 2

    for call in set_number, set_one, all_of_them, lambda: np.add(CORNERS, 1, out=lattice.points[:2]):
        with pytest.raises(hwffd.UsageError, match="^control points: read-only, .* set lattice.control_points = "):
            call()
    points = lattice.control_points.copy()
    points[1, 1, 1] += 1
    lattice.control_points = points
    assert (lattice.control_points != lattice.rest_points).sum() == 3
    more = lattice.control_points + 1
    assert type(more) is np.ndarray and type(points) is np.ndarray
    more[0] = 0
    assert lattice.control_points.max() == more.max() - 1
