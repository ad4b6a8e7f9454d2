"""The programs of others evaluate what the oracle does, or say so.

SPDX-License-Identifier: Apache-2.0
"""

import dataclasses

import numpy
import pytest

from lab.compare import peers
from lab.compare.arrays.scene import evaluated

COUNT = 300


def written(folder, count=COUNT):
    """A scene as hwffd-compare writes it, with equation (1) straight from the paper."""
    random = numpy.random.default_rng(1)
    points = random.uniform(-1, 1, (16, 16, 16, 3))
    cells = random.integers(0, 13, (count, 3)).astype(numpy.int32)
    local = random.random((count, 3))
    exact = evaluated(points, cells + 1 + local)
    for name, values in (("points.f64", points), ("cells.i32", cells), ("local.f64", local),
                         ("exact.f64", exact)):
        values.tofile(folder / name)
    return peers.Scene.read(folder)


@pytest.fixture(autouse=True)
def quickly(monkeypatch):
    monkeypatch.setattr(peers, "ENOUGH", 0)
    monkeypatch.setattr(peers, "FEWEST_RUNS", 1)


@pytest.fixture
def scenes(tmp_path):
    return written(tmp_path)


def test_sorted_it_has_the_same_vertices_by_cell(scenes):
    random, in_order = scenes
    assert len(in_order.places) == COUNT
    cells = [tuple(cell) for cell in numpy.floor(in_order.places).astype(int)]
    assert cells == sorted(cells) != [tuple(c) for c in numpy.floor(random.places).astype(int)]
    assert in_order.exact.sum() == pytest.approx(random.exact.sum())


@pytest.mark.parametrize("peer", peers.PEERS, ids=lambda peer: f"{peer.package} {peer.numbers}")
def test_each_is_the_oracle_but_for_rounding(peer, scenes):
    measured = peers.rows(scenes, peers=[peer])
    assert [row["sorted"] for row in measured] == [False, True]
    for row in measured:
        assert 0 < row["error"] <= peers.BOUNDS[peer.numbers]
        assert row["vertices_per_s"] > 0


@pytest.mark.parametrize("peer", peers.PEERS, ids=lambda peer: f"{peer.package} {peer.numbers}")
def test_each_that_evaluates_something_else_is_refused(peer, scenes):
    exact = scenes[0].exact.copy()
    exact[COUNT // 2, 1] += 1e-5
    with pytest.raises(peers.PeerError, match="error 1.0.e-05, bound"):
        peers.row(peer, dataclasses.replace(scenes[0], exact=exact), False)


def test_nothing_to_evaluate_is_refused(tmp_path):
    with pytest.raises(peers.PeerError, match="no vertex"):
        peers.rows(written(tmp_path, 0))


def test_a_result_that_is_no_number_is_refused(scenes):
    def prepare(scene):
        return (lambda: None), lambda: numpy.full(scene.exact.shape, numpy.nan)
    peer = dataclasses.replace(peers.PEERS[0], prepare=prepare)
    with pytest.raises(peers.PeerError, match="error nan"):
        peers.row(peer, scenes[0], False)


def test_a_package_that_is_not_there_is_named(scenes):
    peer = dataclasses.replace(peers.PEERS[0], package="nowhere")
    with pytest.raises(peers.PeerError, match="nowhere is not in build/venv: run tools/install"):
        peers.row(peer, scenes[0], False)
