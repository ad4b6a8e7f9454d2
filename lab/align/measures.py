"""What is measured of a displacement field, whoever found it.

SPDX-License-Identifier: Apache-2.0
"""

import numpy


def error(field, pair):
    """The mean distance between where a field takes the voxels of the body and where they belong."""
    return float(numpy.linalg.norm(field - pair.truth, axis=-1)[pair.body].mean())


def overlap(field, pair):
    """The mean Dice coefficient of the labels, those of the moving volume taken from the nearest voxel; None without
    labels. A label of both volumes together counts, so that one that is lost counts as 0."""
    if pair.labels is None:
        return None
    fixed, moving = pair.labels
    counts = numpy.array(fixed.shape[::-1])
    places = numpy.stack(numpy.meshgrid(*map(numpy.arange, fixed.shape), indexing="ij"), -1)[..., ::-1] + field
    nearest = numpy.rint(places).astype(int)
    inside = ((nearest >= 0) & (nearest < counts)).all(-1)
    warped = numpy.zeros_like(fixed)
    warped[inside] = moving[tuple(nearest[inside].T[::-1])]
    names = numpy.union1d(numpy.unique(fixed), numpy.unique(moving))
    return float(numpy.mean([2 * numpy.sum((fixed == name) & (warped == name))
                             / (numpy.sum(fixed == name) + numpy.sum(warped == name)) for name in names if name]))


def jacobian(field):
    """det J of x + u(x) at each voxel, by central differences; at the border by those of one side."""
    rows = [numpy.stack(numpy.gradient(field[..., component].astype(float), axis=(2, 1, 0)), -1)
            for component in range(3)]
    return numpy.linalg.det(numpy.stack(rows, -2) + numpy.eye(3))


def folds(field):
    """The share of voxels where det J is 0 or less."""
    return float((jacobian(field) <= 0).mean())


def differing_bits(first, other):
    """How many bits of two fields differ. Their shapes and types must agree."""
    if first.shape != other.shape or first.dtype != other.dtype:
        raise ValueError(f"{first.shape} of {first.dtype} and {other.shape} of {other.dtype}")
    bits = numpy.bitwise_xor(numpy.ascontiguousarray(first).view(numpy.uint8),
                             numpy.ascontiguousarray(other).view(numpy.uint8))
    return int(numpy.unpackbits(bits).sum())
