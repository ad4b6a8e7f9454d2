"""Pairs whose truth is known: where the fixed volume has a voxel, the moving one has it displaced.

SPDX-License-Identifier: Apache-2.0
"""

import numpy
import pytest

from lab.align import measures, pairs
from lab.compare.arrays.scene import evaluated

SIDE = 24


def test_the_spline_of_the_truth_is_equation_1():
    random = numpy.random.default_rng(1)
    control, counts = random.normal(size=(6, 7, 5, 3)), (10, 9, 8)
    cells = numpy.array(control.shape[:3]) - 3
    places = (pairs.voxels(counts) + 0.5) / counts * cells
    field = pairs.spread(control, counts)
    assert field.shape == (8, 9, 10, 3)
    assert abs(field - evaluated(control, places.reshape(-1, 3) + 1).reshape(field.shape)).max() < 1e-13


def test_the_truth_takes_one_volume_to_the_other():
    pair = pairs.phantom_pair(SIDE)
    places = pairs.voxels((SIDE,) * 3)
    values, labels = pairs.phantom(places + pair.truth, (SIDE,) * 3)
    assert (pair.fixed == values.astype(numpy.float32)).all() and (pair.labels[0] == labels).all()
    assert (pair.moving == pairs.phantom(places, (SIDE,) * 3)[0].astype(numpy.float32)).all()
    # Not the other way round: the difference is larger there.
    assert abs(pairs.phantom(places - pair.truth, (SIDE,) * 3)[0] - pair.fixed).mean() > 1
    assert measures.error(pair.truth, pair) == 0 and measures.folds(pair.truth) == 0


def test_the_mean_displacement_is_as_told():
    pair = pairs.phantom_pair(SIDE)
    assert measures.error(0 * pair.truth, pair) == pytest.approx(pairs.MEAN, rel=0.1)
    assert 0.2 < pair.body.mean() < 0.4


def test_noise_is_another_in_each_volume_and_the_same_each_time():
    first, again, clean = (pairs.phantom_pair(SIDE, noise) for noise in (pairs.NOISE, pairs.NOISE, 0))
    assert (first.fixed == again.fixed).all() and (first.moving == again.moving).all()
    draws = [noisy - plain for noisy, plain in ((first.fixed, clean.fixed), (first.moving, clean.moving))]
    assert [draw.std() for draw in draws] == pytest.approx([pairs.NOISE] * 2, rel=0.05)
    assert abs(numpy.corrcoef(draws[0].ravel(), draws[1].ravel())[0, 1]) < 0.05


def test_every_ellipsoid_is_a_label_that_can_be_seen():
    labels = pairs.phantom(pairs.voxels((48,) * 3), (48,) * 3)[1]
    assert numpy.bincount(labels.ravel(), minlength=len(pairs.ELLIPSOIDS) + 1).min() > 100
    assert all((labels != numpy.flip(labels, axis)).any() for axis in range(3))
