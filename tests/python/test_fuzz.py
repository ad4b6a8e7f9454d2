"""Calls with arguments that nobody would give: each ends with a result or an hwffd.Error of one line,
and what was to be written is unchanged then. HWFFD_FUZZ_CASES says how many are tried.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pickle
import warnings

import hwffd
import hypothesis
import numpy as np
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

CASES = int(os.environ.get("HWFFD_FUZZ_CASES", "100"))
CORNERS = np.array([[-1.0, -1, -1], [1, 1, 1]])
FAMILIES = {name: hwffd.Lattice.around("box", CORNERS, (4, 4, 4), family=name).rest_points
            for name in hwffd.families()}

hypothesis.settings.register_profile(
    "fuzz", max_examples=CASES, deadline=None, derandomize=True, database=None,
    suppress_health_check=list(hypothesis.HealthCheck))
hypothesis.settings.load_profile("fuzz")

NUMBERS = st.one_of(
    st.floats(-2, 2), st.floats(width=64), st.integers(-2**70, 2**70),
    st.sampled_from([0.0, -0.0, 1.0, 5e-324, 1e38, 3.5e38, 1e100, 1.1e100, 1e308, np.nan, np.inf]))
KINDS = st.sampled_from(["f2", "<f4", ">f4", "<f8", ">f8", "i1", "u8", "i8", "?", "c8", "S3", "O",
                         "M8[s]"])
SHAPES = st.one_of(arrays.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=5),
                   st.tuples(st.integers(0, 6), st.just(3)),
                   st.just((4, 4, 4, 3)), st.just((64, 3)), st.just((2**20, 0, 3)))


@st.composite
def any_array(draw):
    """An array with any strides, of any kind, or nearly one."""
    kind = np.dtype(draw(KINDS))
    shape = draw(SHAPES)
    if kind.kind == "f" and draw(st.booleans()):
        seed = draw(st.integers(0, 99))
        array = np.random.default_rng(seed).uniform(-1.5, 1.5, shape).astype(kind)
        if array.size and draw(st.booleans()):
            with np.errstate(all="ignore"):
                array.flat[draw(st.integers(0, array.size - 1))] = draw(st.floats(width=64))
    else:
        array = np.zeros(shape, kind)
    how = draw(st.sampled_from(["as it is", "reversed", "every other", "fortran", "read-only",
                                "transposed", "broadcast"]))
    if how == "reversed" and array.ndim:
        array = array[::-1]
    elif how == "every other" and array.ndim:
        array = np.repeat(array, 2, axis=0)[::2]
    elif how == "fortran":
        array = np.asfortranarray(array)
    elif how == "read-only":
        array.flags.writeable = False
    elif how == "transposed":
        array = array.T
    elif how == "broadcast" and array.ndim:
        array = np.broadcast_to(array, (2, *array.shape))
    return array


ANYTHING = st.one_of(
    any_array(), st.none(), st.text(max_size=5), st.integers(-2**70, 2**70), NUMBERS,
    st.lists(st.lists(NUMBERS, min_size=3, max_size=3), max_size=4),
    st.lists(st.lists(NUMBERS, max_size=4), max_size=3), st.binary(max_size=3))
TEXTS = st.one_of(
    st.text(max_size=12),
    st.builds("{}:{}".format,
              st.sampled_from(["twist", "bend", "scale", "move", "fade", "random", "shear", "to",
                               "helix", "taper"]), st.one_of(NUMBERS.map(str), st.text(max_size=8))),
    st.sampled_from(["keep", "clamp", "model", "reference", "bernstein", "bspline", "sphere",
                     "box", "fx18", "cg3", "factored/3", "twist:1:x", "move:0,0,0:1,2,3"]))


def tried(call, *arguments, **named):
    """What it gives, or None where it refuses properly."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return call(*arguments, **named)
    except hwffd.Error as error:
        text = str(error)
        assert text and "\n" not in text and len(text) < 1000, text
    return None


def a_lattice(family, deformation="random:1"):
    lattice = hwffd.Lattice.of(FAMILIES[family], family=family)
    lattice.deform(deformation)
    return lattice


@hypothesis.given(st.sampled_from(sorted(FAMILIES)), st.sampled_from(["keep", "clamp", "fade:1"]),
                  st.sampled_from(["model", "reference"]), ANYTHING,
                  st.one_of(st.none(), any_array()))
def test_points(family, outside, device, points, out):
    lattice = a_lattice(family)
    lattice.set_outside(outside)
    lattice.set_device(device)
    before = None if out is None else out.copy()
    moved = tried(hwffd.deform, lattice, points, out=out)
    if moved is None and out is not None and out.dtype.kind != "O":
        assert out.tobytes() == before.tobytes()
    embedding = tried(lattice.embed, points)
    if embedding is None:
        assert moved is None
        return
    assert moved is None or moved is out or moved.shape == tuple(embedding.shape)
    for call in embedding.jacobians, embedding.determinants:
        tried(call, lattice)
    tried(embedding.normals, lattice, points, out=out)
    pulled = tried(embedding.pull_back, points)
    assert pulled is None or pulled.shape == lattice.control_points.shape
    assert len(pickle.loads(pickle.dumps(embedding))) == len(embedding)


@hypothesis.given(ANYTHING, st.one_of(st.just((4, 4, 4)), st.lists(st.integers(-2**40, 2**40),
                                                                  max_size=4)),
                  st.one_of(TEXTS, st.sampled_from(sorted(FAMILIES))), TEXTS)
def test_lattices(points, dims, family, shape):
    for lattice in (tried(hwffd.Lattice, dims, points, family=family),
                    tried(hwffd.Lattice.of, points, family=family),
                    tried(hwffd.Lattice.around, shape, points),
                    tried(hwffd.Lattice.around, "sphere", points, dims, family=family)):
        if lattice is not None:
            assert np.isfinite(lattice.points).all()
            tried(lattice.folds)
            tried(hwffd.deform, lattice, [[0.1, 0.2, 0.3]])
    lattice = a_lattice("bspline")
    before = lattice.points
    if tried(setattr, lattice, "control_points", points) is None:
        assert np.isfinite(lattice.points).all()
    assert lattice.points.shape == before.shape


@hypothesis.given(ANYTHING, ANYTHING, st.one_of(st.none(), any_array()))
def test_places(cells, local, out):
    lattice = a_lattice("linear")
    result = tried(lattice.evaluate, cells, local, out=out)
    assert result is None or (result.shape[1] == 3 and np.isfinite(result).all())


@hypothesis.given(st.sampled_from(sorted(FAMILIES)),
                  st.one_of(ANYTHING, st.tuples(ANYTHING, ANYTHING, ANYTHING)), ANYTHING,
                  st.one_of(st.none(), st.sampled_from(["model", "reference", "rtl"]), TEXTS))
def test_gradients(family, places, gradient, device):
    lattice = a_lattice(family)
    pulled = tried(lattice.pull_back, places, gradient, device=device)
    assert pulled is None or (pulled.shape == lattice.control_points.shape and np.isfinite(pulled).all())


@hypothesis.given(TEXTS, TEXTS, TEXTS, TEXTS, st.integers(-2**40, 2**40),
                  st.integers(-2**40, 2**40))
def test_texts(deformation, outside, device, org, pages, axis_points):
    lattice = a_lattice("bspline")
    lattice.set_device("reference")
    tried(lattice.deform, deformation)
    tried(lattice.set_outside, outside)
    tried(lattice.set_device, device, org, device, pages, axis_points)
    tried(lattice.set_device, "model", org, device)
    tried(hwffd.deform, lattice, [[0.1, 0.2, 0.3], [3, 3, 3]])
    tried(hwffd.Lattice.read, deformation)
    assert repr(pickle.loads(pickle.dumps(lattice))) == repr(lattice)


@hypothesis.given(st.lists(ANYTHING, max_size=9).map(tuple))
def test_pickles(state):
    for kind in hwffd.Lattice, hwffd.Embedding:
        instance = kind.__new__(kind)
        try:
            instance.__setstate__(state)
        except hwffd.Error as error:
            assert "\n" not in str(error), error
