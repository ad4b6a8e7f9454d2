"""What is measured of a field, against figures by hand.

SPDX-License-Identifier: Apache-2.0
"""

import numpy
import pytest

from lab.align import measures, pairs

SHAPE = (6, 7, 8)


def pair(truth, body=None, labels=None):
    zero = numpy.zeros(SHAPE, numpy.float32)
    return pairs.Pair("by hand", zero, zero, truth, numpy.ones(SHAPE, bool) if body is None else body, labels)


def test_an_error_is_the_mean_length_over_the_body_alone():
    truth = numpy.zeros((*SHAPE, 3))
    body = numpy.zeros(SHAPE, bool)
    body[2, 3, 4:6] = True
    field = numpy.full((*SHAPE, 3), 100.0)
    field[2, 3, 4], field[2, 3, 5] = (3, 4, 0), (0, 0, 1)
    assert measures.error(field, pair(truth, body)) == 3.0


def test_overlap_of_labels_that_are_moved_by_a_voxel():
    fixed, moving = numpy.zeros(SHAPE, numpy.uint8), numpy.zeros(SHAPE, numpy.uint8)
    fixed[2:4, 2:4, 2:4] = 1
    moving[2:4, 2:4, 3:5] = 1
    still = numpy.zeros((*SHAPE, 3))
    by_hand = pair(still, labels=(fixed, moving))
    assert measures.overlap(still, by_hand) == 0.5
    assert measures.overlap(still + (1, 0, 0), by_hand) == 1.0
    assert measures.overlap(still + (0, 0, 1), by_hand) == 0.25
    assert measures.overlap(still + (100, 0, 0), by_hand) == 0.0
    assert measures.overlap(still, pair(still)) is None


def test_the_mean_is_of_labels_and_a_lost_one_counts():
    fixed, moving = numpy.zeros(SHAPE, numpy.uint8), numpy.zeros(SHAPE, numpy.uint8)
    fixed[1], moving[1], fixed[3] = 1, 1, 2
    still = numpy.zeros((*SHAPE, 3))
    assert measures.overlap(still, pair(still, labels=(fixed, moving))) == 0.5


def test_det_j_of_maps_by_hand():
    places = pairs.voxels(SHAPE[::-1])
    stretched = places * (0.5, 1.0, -0.25)  # x + u is 1.5 x, 2 y, 0.75 z
    assert measures.jacobian(stretched) == pytest.approx(numpy.full(SHAPE, 2.25))
    sheared = numpy.zeros((*SHAPE, 3))
    sheared[..., 0] = 5 * places[..., 1]
    assert measures.jacobian(sheared) == pytest.approx(numpy.ones(SHAPE))


def test_folds_are_where_the_order_turns():
    field = numpy.zeros((*SHAPE, 3))
    assert measures.folds(field) == 0
    field[..., 0] = -2.0 * pairs.voxels(SHAPE[::-1])[..., 0]
    assert measures.folds(field) == 1
    field[..., 0] *= 0.5  # all of x at one place: det J is 0
    assert measures.folds(field) == 1
    field[..., 0] = 0
    field[:, :, 4, 0] = -3  # the central difference at the voxel before it is 1 - 3 / 2
    assert measures.folds(field) == 1 / 8


def test_differing_bits():
    first = numpy.zeros((*SHAPE, 3), numpy.float32)
    other = first.copy()
    assert measures.differing_bits(first, other) == 0
    other[0, 0, 0, 0] = -0.0
    other[5, 6, 7, 2] = numpy.float32(1.0)  # seven bits of its exponent
    assert measures.differing_bits(first, other) == 8
    with pytest.raises(ValueError, match="float64"):
        measures.differing_bits(first, first.astype(float))
