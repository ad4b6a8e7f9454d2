"""Pickles and copies of every class, in every protocol; those of subclasses keep class and attributes.

SPDX-License-Identifier: Apache-2.0
"""

import copy
import copyreg
import functools
import pickle

import hwffd
import numpy as np
import pytest

CORNERS = np.array([[-1.0, -1, -1], [1, 1, 1]])
POINTS = np.random.default_rng(2).uniform(-1.3, 1.3, (20, 3))
WAYS = [copy.copy, copy.deepcopy]
WAYS += [functools.partial(lambda protocol, thing: pickle.loads(pickle.dumps(thing, protocol)), protocol)
         for protocol in range(pickle.HIGHEST_PROTOCOL + 1)]
NAMES = ["copy", "deepcopy"] + [f"protocol {number}" for number in range(pickle.HIGHEST_PROTOCOL + 1)]


class Named(hwffd.Lattice):
    """A subclass with attributes of both kinds."""

    __slots__ = ("slot", "__dict__")

    def __init__(self, name, dims, points):
        super().__init__(dims, points)
        self.name = name


class Kept(hwffd.Embedding):
    """What a program might make of an embedding."""


def lattice_of(kind=None):
    rest = hwffd.Lattice.around("cylinder", CORNERS, (4, 5, 9))
    lattice = kind("a name", rest.dims, rest.points) if kind else rest
    lattice.deform("bend:30")
    lattice.set_device("model", "cg3", "fx18")
    lattice.set_outside("fade:0.5")
    return lattice


@pytest.mark.parametrize("twin", WAYS, ids=NAMES)
def test_lattices(twin):
    lattice = lattice_of()
    moved = hwffd.deform(lattice, POINTS)
    other = twin(lattice)
    assert type(other) is hwffd.Lattice and repr(other) == repr(lattice)
    np.testing.assert_array_equal(hwffd.deform(other, POINTS), moved)
    other.deform("twist:20")
    np.testing.assert_array_equal(hwffd.deform(lattice, POINTS), moved)


@pytest.mark.parametrize("twin", WAYS, ids=NAMES)
def test_embeddings(twin):
    lattice = lattice_of()
    embedding = lattice.embed(POINTS.astype(np.float32).reshape(4, 5, 3))
    other = twin(embedding)
    assert type(other) is hwffd.Embedding and repr(other) == repr(embedding)
    moved = other.deform(lattice)
    assert moved.dtype == np.float32 and moved.shape == (4, 5, 3)
    np.testing.assert_array_equal(moved, embedding.deform(lattice))


@pytest.mark.parametrize("twin", WAYS, ids=NAMES)
def test_subclasses_keep_class_and_attributes(twin):
    lattice = lattice_of(Named)
    lattice.slot = [1, 2]
    lattice.itself = lattice
    other = twin(lattice)
    assert type(other) is Named and other.name == "a name" and other.slot == [1, 2]
    assert (other.slot is lattice.slot) == (twin is copy.copy)
    assert other.itself is (lattice if twin is copy.copy else other)
    np.testing.assert_array_equal(hwffd.deform(other, POINTS), hwffd.deform(lattice, POINTS))
    state = lattice.embed(POINTS).__getstate__()
    embedding = Kept.__new__(Kept)
    embedding.__setstate__(state)
    embedding.note = "n"
    other = twin(embedding)
    assert type(other) is Kept and other.note == "n"
    np.testing.assert_array_equal(other.deform(lattice), embedding.deform(lattice))


@pytest.mark.parametrize("twin", WAYS, ids=NAMES)
def test_exceptions_and_arrays(twin):
    for kind in hwffd.Error, hwffd.UsageError:
        other = twin(kind("a text"))
        assert type(other) is kind and str(other) == "a text"
    points = lattice_of().control_points
    np.testing.assert_array_equal(twin(points), points)


def test_pickles_of_before_are_read():
    """Those had the state of the C++ object alone."""
    lattice = lattice_of()
    embedding = lattice.embed(POINTS)
    for thing in lattice, embedding:
        other = copyreg.__newobj__(type(thing))
        *state, attributes = thing.__getstate__()
        assert attributes == {}
        other.__setstate__(tuple(state))
        assert repr(other) == repr(thing)


def test_what_is_no_pickle_is_refused():
    for kind, what in (hwffd.Lattice, "lattice"), (hwffd.Embedding, "embedding"):
        for state in ((), (1,), (1, 2, 3, 4, 5), (POINTS,) * 9, ({},)):
            with pytest.raises(hwffd.Error, match=f"^this pickle holds no {what}; pickle one again$"):
                kind.__new__(kind).__setstate__(state)
