"""Lattices fitted to points: what fit() finds, with which bits, and what it refuses.

SPDX-License-Identifier: Apache-2.0
"""

import copy
import signal

import hwffd
import numpy as np
import pytest


def scene(count=400, dims=(5, 6, 4)):
    """Points, a lattice around them, and where its deformation takes them."""
    points = np.random.default_rng(1).random((count, 3))
    rest = hwffd.Lattice.around("box", points, dims, padding=0.02)
    truth = copy.copy(rest)
    truth.control_points = rest.rest_points + np.random.default_rng(2).normal(0, 0.03, rest.rest_points.shape)
    return points, rest, hwffd.deform(truth, points)


def test_targets_of_a_lattice_are_reached():
    points, lattice, targets = scene()
    seen = []
    result = hwffd.fit(lattice, points, targets, progress=lambda iteration, value: seen.append((iteration, value)))
    assert result["rms_start"] > 0.01 and result["rms_end"] < 2e-3 * result["rms_start"]
    assert result["distances"].shape == (400,) and result["distances"].max() == result["largest"]
    np.testing.assert_allclose(np.linalg.norm(hwffd.deform(lattice, points) - targets, axis=-1),
                               result["distances"], atol=1e-12)
    assert result["outside"] == 0 and result["folds"] == "proved" and not result["stopped"]
    assert [iteration for iteration, _ in seen] == list(range(1, result["iterations"] + 1))


def test_it_comes_near_the_least_squares():
    points, lattice, targets = scene(300, (4, 4, 4))
    targets = targets + np.random.default_rng(3).normal(0, 0.01, targets.shape)
    weights = lattice.embed(points).weights().toarray()
    best, *_ = np.linalg.lstsq(weights, targets, rcond=None)
    least = np.sqrt((np.linalg.norm(weights @ best - targets, axis=-1) ** 2).mean())
    result = hwffd.fit(lattice, points, targets, tolerance=1e-14, iterations=3000, ridge=0)
    assert least <= result["rms_end"] < 1.01 * least


@pytest.mark.parametrize("loss", ["huber", "geman-mcclure"])
def test_outliers_hardly_pull(loss):
    points, lattice, targets = scene(600, (4, 4, 4))
    spoiled = targets.copy()
    spoiled[::10] += 0.5
    plain = copy.copy(lattice)
    hwffd.fit(plain, points, spoiled)
    result = hwffd.fit(lattice, points, spoiled, loss=loss, scale=0.01)
    good = np.ones(600, bool)
    good[::10] = False
    errors = [np.linalg.norm(hwffd.deform(one, points) - targets, axis=-1)[good].mean() for one in (plain, lattice)]
    assert errors[1] < 0.2 * errors[0]
    assert (result["distances"][~good] > 0.4).all()


@pytest.mark.parametrize("family", ["bspline", "bernstein", "linear"])
@pytest.mark.parametrize("shape", ["cylinder", "sphere"])
def test_joints_stay_closed(shape, family):
    random = np.random.default_rng(5)
    points = random.uniform(-1, 1, (400, 3))
    targets = points + 0.1 * np.sin(3 * points[:, ::-1]) + random.normal(0, 0.02, points.shape)
    dims = (7, 7, 13) if family == "bernstein" else (5, 6, 9)
    lattice = hwffd.Lattice.around(shape, dims=dims, family=family, region=[[-1, -1, -1], [1, 1, 1]])
    result = hwffd.fit(lattice, points, targets, iterations=100)
    assert result["rms_end"] < 0.7 * result["rms_start"]
    # On both sides of the seam, and around the axis.
    seam = np.stack([random.uniform(0.1, 0.9, 100), random.uniform(-0.8, 0.8, 100), np.full(100, 1e-9)], -1)
    turn = np.linspace(0, 6, 50)
    axis = np.stack([1e-9 * np.cos(turn), np.full(50, 0.3), 1e-9 * np.sin(turn)], -1)
    assert np.abs(hwffd.deform(lattice, seam) - hwffd.deform(lattice, seam * [1, 1, -1])).max() < 1e-4
    assert np.ptp(hwffd.deform(lattice, axis), axis=0).max() < 1e-4


def test_a_penalty_smooths():
    points, lattice, targets = scene()
    noisy = targets + np.random.default_rng(4).normal(0, 0.02, targets.shape)
    smooth = copy.copy(lattice)
    hwffd.fit(lattice, points, noisy)
    hwffd.fit(smooth, points, noisy, penalty=1e-4)
    assert smooth.bending_energy() < 0.5 * lattice.bending_energy()


def test_bits_do_not_depend_on_threads_or_order():
    points, lattice, targets = scene()
    found = set()
    for threads in 1, 3:
        hwffd.set_threads(threads)
        one = copy.copy(lattice)
        hwffd.fit(one, points, targets, iterations=20)
        found.add(one.control_points.tobytes())
    hwffd.set_threads(0)
    assert len(found) == 1


def test_a_fit_stops_and_weights_count():
    points, lattice, targets = scene()
    assert hwffd.fit(lattice, points, targets, progress=lambda iteration, _: iteration < 3)["stopped"]
    weights = np.zeros(400)
    weights[0] = 1
    result = hwffd.fit(lattice, points, targets, weights=weights)
    assert result["largest"] == result["distances"][0] < 1e-6 < result["distances"].max()


def test_progress_that_uses_the_lattice_is_refused():
    """It would wait for the fit that waits for it."""
    points, lattice, targets = scene()
    with pytest.raises(hwffd.Error, match="at work in a call of this thread"):
        hwffd.fit(lattice, points, targets, progress=lambda *_: lattice.folds())
    np.testing.assert_array_equal(lattice.control_points, lattice.rest_points)


def test_ctrl_c_leaves_the_lattice_as_it_was():
    """Also while it is looked at whether the lattice folds, which takes seconds here."""
    points = scene()[0]
    lattice = hwffd.Lattice.around("box", points, (32, 32, 32))
    lattice.deform("random:3")
    before = lattice.control_points

    def later(*_):
        signal.setitimer(signal.ITIMER_REAL, 0.3)

    handler = signal.signal(signal.SIGALRM, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            hwffd.fit(lattice, points, points + 0.1, iterations=1, progress=later)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, handler)
    np.testing.assert_array_equal(lattice.control_points, before)


def test_model_fits_too():
    points, lattice, targets = scene(100, (4, 4, 4))
    lattice.set_device("model", "affine", "fx17")
    result = hwffd.fit(lattice, points, targets, iterations=30)
    assert result["rms_end"] < 0.1 * result["rms_start"]


@pytest.mark.parametrize("changes, text", [
    ({"targets": np.zeros((3, 3))}, "targets: another shape than points"),
    ({"targets": np.full((400, 3), np.nan)}, "finite"),
    ({"loss": "joy"}, "squares, huber, geman-mcclure"),
    ({"loss": "huber"}, "scale 0"),
    ({"weights": [1.0]}, "1 weights for 400 points"),
    ({"weights": [-1.0] * 400}, "weight -1"),
    ({"weights": [1e308] * 400}, "the sum of the weights"),
    ({"points": np.full((400, 3), 9.0)}, "no point"),
])
def test_bad_input_is_one_line(changes, text):
    points, lattice, targets = scene()
    given = {"points": points, "targets": targets} | changes
    before = lattice.control_points
    with pytest.raises(hwffd.Error, match=text) as refused:
        hwffd.fit(lattice, given.pop("points"), given.pop("targets"), **given)
    assert "\n" not in str(refused.value)
    np.testing.assert_array_equal(lattice.control_points, before)


def test_a_penalty_wants_a_box():
    points, _, targets = scene()
    with pytest.raises(hwffd.Error, match="box"):
        hwffd.fit(hwffd.Lattice.around("sphere", points), points, targets, penalty=1.0)
