"""Volumes in a lattice: where voxels come from is what ITK says, and values are those of SciPy and ITK.

SPDX-License-Identifier: Apache-2.0
"""

import dataclasses
import inspect
import warnings

import hwffd
import numpy as np
import pytest
import scipy.ndimage
import SimpleITK as sitk
from hwffd import volumes
from hwffd.volumes import warping
from phantom import COUNTS, around, deformed, in_voxels, itk_field, phantom

VOXELS = int(np.prod(COUNTS))
SMALL = {"first": (6.3, 4.2, 3.1), "counts": (25, 20, 11)}  # a lattice that holds a part
INTERPOLATORS = {0: sitk.sitkNearestNeighbor, 1: sitk.sitkLinear, 3: sitk.sitkBSpline}


@pytest.fixture(autouse=True)
def all_threads():
    yield
    hwffd.set_threads(0)


@pytest.mark.parametrize("part", [{}, SMALL])
def test_the_field_is_that_of_itks_bspline_transform(part):
    volume = phantom()
    lattice, transform = deformed(volume, **part)
    field = volumes.displacement_field(volume, lattice)
    expected = itk_field(volume, transform)
    assert field.values.shape == expected.shape == (*COUNTS[::-1], 3)
    moved = np.count_nonzero(np.abs(expected).max(-1) > 0)
    assert (moved == VOXELS) if not part else (0.1 * VOXELS < moved < 0.5 * VOXELS)
    assert in_voxels(volume, expected).max() > 1
    assert in_voxels(volume, field.values - expected).max() < 1e-6
    for name in "origin", "spacing", "direction":
        np.testing.assert_array_equal(getattr(field, name), getattr(volume, name))


def test_places_are_those_of_itk_point_by_point():
    volume = phantom()
    lattice, transform = deformed(volume)
    field = volumes.displacement_field(volume, lattice).values
    image = volumes.to_itk(volume)
    rng = np.random.default_rng(5)
    for index in rng.integers(0, COUNTS, (200, 3)).tolist():
        point = np.array(image.TransformIndexToPhysicalPoint(index))
        i, j, k = index
        moved = np.array(transform.TransformPoint(point))
        assert in_voxels(volume, point + field[k, j, i] - moved).max() < 1e-6


@pytest.mark.parametrize("order", [3, 1, 0])
def test_values_are_those_of_itk(order):
    volume = phantom()
    lattice, transform = deformed(volume, size=2.5)
    image = volumes.to_itk(volume)
    expected = sitk.GetArrayFromImage(
        sitk.Resample(image, image, transform, INTERPOLATORS[order], -3.0))
    warped = volumes.warp(image, lattice, order=order, default=-3.0)
    assert warped.GetSize() == COUNTS and warped.GetDirection() == image.GetDirection()
    got = sitk.GetArrayFromImage(warped)
    beyond = np.count_nonzero(expected == -3)
    assert 100 < beyond < VOXELS / 2 and np.array_equal(got == -3, expected == -3)
    np.testing.assert_allclose(got, expected, rtol=0, atol=1e-4 if order else 0)
    assert np.count_nonzero(np.abs(got - volume.values) > 1) > VOXELS / 10


def test_values_are_those_of_scipy():
    volume = phantom(np.float64)
    lattice, transform = deformed(volume)
    places = volume.points(np.argwhere(np.ones(COUNTS)).astype(float)).reshape(*COUNTS, 3)
    places += itk_field(volume, transform).transpose(2, 1, 0, 3)
    indices = volume.indices(places)
    inside = ((indices >= 0) & (indices <= np.array(COUNTS) - 1)).all(-1)
    assert 0.5 * VOXELS < np.count_nonzero(inside) < VOXELS
    expected = scipy.ndimage.map_coordinates(volume.values.transpose(2, 1, 0), indices[inside].T,
                                             order=3, mode="mirror")
    got = volumes.warp(volume, lattice).values.transpose(2, 1, 0)[inside]
    np.testing.assert_allclose(got, expected, rtol=0, atol=1e-9)


@pytest.mark.parametrize("shape", [(4, 5, 6), (1, 7, 30), (19, 2, 3)])
@pytest.mark.parametrize("kind", [np.float32, np.float64, np.int16])
def test_coefficients_are_those_of_scipy(shape, kind):
    values = (100 * np.random.default_rng(6).normal(size=shape)).astype(kind)
    got = volumes.coefficients(values)
    np.testing.assert_array_equal(
        got, scipy.ndimage.spline_filter(values, 3, np.float64, mode="mirror"))
    at_voxels = scipy.ndimage.map_coordinates(got, np.indices(shape), order=3, mode="mirror",
                                              prefilter=False)
    np.testing.assert_allclose(at_voxels, values, rtol=0, atol=1e-9)


def test_a_spline_of_values_is_the_sum_that_a_core_evaluates():
    values = np.random.default_rng(7).normal(size=(8, 9, 10))
    ramp = np.stack(np.indices(values.shape), -1).astype(float)
    lattice = hwffd.Lattice.of(ramp)
    lattice.control_points = volumes.coefficients(values)[..., None] * [1, 0, 0] + ramp * [0, 1, 1]
    cells = np.argwhere(np.ones(lattice.cells)).astype(np.int32)
    local = np.random.default_rng(8).random(cells.shape)
    expected = scipy.ndimage.map_coordinates(values, (cells + local + 1).T, order=3, mode="mirror")
    for device, close in ("reference", 1e-12), ("model", 1e-5):
        lattice.set_device(device)
        np.testing.assert_allclose(lattice.evaluate(cells, local)[:, 0], expected, rtol=0, atol=close)


def test_a_voxel_takes_the_value_of_where_the_lattice_takes_it():
    volume = phantom(np.int16)
    lattice = volumes.lattice_over(volume, (4, 5, 6))
    lattice.set_device("reference")
    shift = (3, -2, 1)  # along i, j and k
    lattice.control_points = lattice.control_points + volume.steps @ shift
    warped = volumes.warp(volume, lattice, order=0, default=-99).values
    expected = np.full_like(warped, -99)
    expected[:-1, 2:, :-3] = volume.values[1:, :-2, 3:]
    np.testing.assert_array_equal(warped, expected)


@pytest.mark.parametrize("outside", ["keep", "clamp", "fade:5"])
def test_voxels_outside_the_lattice_do_what_it_says(outside):
    volume = phantom()
    lattice, _ = deformed(volume, **SMALL)
    lattice.set_outside(outside)
    resampled = volumes.resample(volume, lattice, order=1, with_field=True)
    assert 0.5 * VOXELS < resampled.outside_lattice < VOXELS
    corner = resampled.field.values[0, 0, 0]
    assert (np.abs(corner).max() > 0.1) == (outside == "clamp")
    points = volume.points(np.argwhere(np.ones(COUNTS))[::97].astype(float))
    with warnings.catch_warnings(record=True):
        moved = hwffd.deform(lattice, points)
    got = resampled.field.values.transpose(2, 1, 0, 3).reshape(-1, 3)[::97]
    np.testing.assert_allclose(got, moved - points, rtol=0, atol=1e-9)


def test_slabs_and_threads_change_no_bit(monkeypatch):
    volume = phantom()
    lattice, _ = deformed(volume)
    whole = volumes.resample(volume, lattice, with_field=True)
    for voxels, threads in (1, 1), (50, 2), (41 * 29 * 3, 5), (41 * 29 - 1, 1):
        monkeypatch.setattr(warping, "_VOXELS_AT_ONCE", voxels)
        hwffd.set_threads(threads)
        fractions = []
        part = volumes.resample(volume, lattice, with_field=True, progress=fractions.append)
        np.testing.assert_array_equal(part.volume.values, whole.volume.values)
        np.testing.assert_array_equal(part.field.values, whole.field.values)
        assert part.outside_volume == whole.outside_volume > 0
        assert fractions == sorted(fractions) and fractions[-1] == 1 and len(fractions) > 5


def where():
    volume = phantom()
    return volume.origin, volume.spacing, volume.direction


def test_types_of_voxels():
    lattice = volumes.lattice_over(phantom())
    lattice.set_device("reference")
    lattice.control_points = lattice.control_points + phantom().steps @ [0.4, 0.3, 0.2]
    exact = volumes.warp(phantom(np.float64), lattice, default=7).values
    for kind in np.uint8, np.int16, np.uint32, np.float32:
        got = volumes.warp(phantom(kind), lattice, default=7).values
        assert got.dtype == kind and np.abs(got - exact).max() < (1e-4 if kind == np.float32 else 2)
    steep = volumes.Volume(np.where(np.indices(COUNTS[::-1])[2] % 8 < 4, 255, 0).astype(np.uint8),
                           *where())
    curve = volumes.warp(volumes.Volume(steep.values.astype(float), *where()), lattice, default=300)
    assert curve.values.min() < -5 and (curve.values[curve.values != 300]).max() > 260
    np.testing.assert_array_equal(volumes.warp(steep, lattice, default=300).values,
                                  np.clip(np.rint(curve.values), 0, 255))
    colours = np.stack([phantom().values, -phantom().values, phantom().values ** 2], -1)
    got = volumes.warp(volumes.Volume(colours, *where()), lattice)
    for part in range(3):
        single = volumes.warp(volumes.Volume(colours[..., part], *where()), lattice)
        np.testing.assert_array_equal(got.values[..., part], single.values)


@pytest.mark.parametrize("order", [0, 1, 3])
@pytest.mark.parametrize("kind", [np.float16, np.longdouble])
def test_floats_that_scipy_has_not_are_interpolated(kind, order):
    volume = phantom(kind)
    same = dataclasses.replace(volume, values=volume.values.astype(np.float64))
    lattice = volumes.lattice_over(volume, (5, 5, 5))
    lattice.deform("twist:15")
    got = volumes.warp(volume, lattice, order=order).values
    assert got.dtype == kind
    np.testing.assert_array_equal(got, volumes.warp(same, lattice, order=order).values.astype(kind))


def test_labels_of_64_bits_stay():
    labels = volumes.Volume(np.arange(VOXELS).reshape(COUNTS[::-1]) + 2**60, *where())
    lattice = volumes.lattice_over(labels)
    np.testing.assert_array_equal(volumes.warp(labels, lattice, order=0).values, labels.values)


def test_another_grid():
    volume = phantom()
    lattice, transform = deformed(volume)
    grid = volumes.Volume(np.zeros((7, 11, 13)), volume.points(np.array([5.0, 4, 3])), (1.9, 2.3, 3.1))
    got = volumes.warp(volume, lattice, like=grid)
    expected = sitk.Resample(volumes.to_itk(volume), volumes.to_itk(grid), transform, sitk.sitkBSpline)
    np.testing.assert_allclose(got.values, sitk.GetArrayFromImage(expected), rtol=0, atol=1e-4)
    assert got.values.shape == grid.values.shape and np.count_nonzero(got.values) > 100


@pytest.mark.parametrize("org, form, close", [("basic", "fp32", 1e-4), ("cg1", "fx32", 1e-4)])
def test_the_model_is_close_to_double(org, form, close):
    volume = phantom()
    lattice = around(volume)
    lattice.deform("twist:20")
    lattice.set_device("reference")
    exact = volumes.displacement_field(volume, lattice).values
    lattice.set_device("model", org, form)
    model = volumes.displacement_field(volume, lattice).values
    assert 0 < in_voxels(volume, model - exact).max() < close
    assert in_voxels(volume, exact).max() > 2


def test_what_is_no_volume_is_refused():
    volume, lattice = phantom(), around(phantom())
    good = np.zeros((3, 4, 5))
    cases = (
        (lambda: volumes.Volume(np.zeros((3, 4))), "2 dimensions"),
        (lambda: volumes.Volume(np.zeros((3, 4, 5), complex)), "complex128"),
        (lambda: volumes.Volume(np.zeros((3, 0, 5))), "with voxels"),
        (lambda: volumes.Volume(good, spacing=(1, np.nan, 1)), "spacing .* finite"),
        (lambda: volumes.Volume(good, spacing=(1, 0, 1)), "spacing .* above 0"),
        (lambda: volumes.Volume(good, origin=(1, 2)), "origin"),
        (lambda: volumes.Volume(good, direction=np.ones((3, 3))), "spans no space"),
        (lambda: volumes.warp(good, lattice), "a ndarray; give a Volume"),
        (lambda: volumes.warp(volumes.to_itk(volume)[:, :, 3], lattice), "2 dimensions"),
        (lambda: volumes.warp(volume, lattice, order=2), "order 2; one of 0"),
        (lambda: volumes.warp(phantom(np.int16), lattice, default=np.nan), "default nan"),
        (lambda: volumes.lattice_over(volume, (4, 4)), "dims"),
        (lambda: volumes.lattice_over(volume, (4, 4, 65)), "4 to 64"),
        (lambda: volumes.lattice_over(volume, (4.5, 5, 5)), "whole numbers"),
        (lambda: volumes.displacement_field(volume, lattice, kind="i4"), "kind i4: no floats"),
        (lambda: volumes.warp(volume, lattice, default="dark"), "default 'dark'"),
        (lambda: volumes.displacement_field(volume, lattice, kind="joy"), "kind joy: no floats"),
        (lambda: volumes.warp(volume, lattice, default=10 ** 400), "default: beyond what a double holds"),
        (lambda: volumes.Volume(good, metadata={"echo": 1}), "no text"),
        (lambda: volumes.Volume(good, metadata=3), "metadata 3"),
        (lambda: volumes.Volume([[[1, 2], [3]]]), "volume: no array"),
        (lambda: volumes.Volume(np.ma.masked_array(good)), "volume: a masked array"),
        (lambda: volumes.Volume([np.ma.masked_array(good[0])]), "volume: a masked array"),
        (lambda: volumes.coefficients(np.ma.masked_array(good)), "values: a masked array"),
        (lambda: hwffd.register(good, np.ma.masked_array(good)), "moving: a masked array"),
        (lambda: volumes.write_transform("none.foo", lattice), "none.foo: .* .tfm or .h5"),
        (lambda: volumes.write_transform("none/none.tfm", lattice), "none.tfm: cannot be written"),
        (lambda: volumes.coefficients(np.zeros((3, 4))), "2 dimensions"),
        (lambda: volumes.coefficients(np.full((3, 4, 5), np.nan)), "60 voxels are not finite"),
    )
    for call, text in cases:
        with pytest.raises(hwffd.Error, match=text) as caught:
            call()
        assert "\n" not in str(caught.value)


def test_everything_of_volumes_has_types():
    checked = 0
    for name in volumes.__all__:
        entity = getattr(volumes, name)
        for function in [entity, *(vars(entity).values() if inspect.isclass(entity) else ())]:
            function = function.fget if isinstance(function, property) else function
            if not inspect.isfunction(function) or function.__name__.startswith("__"):
                continue
            signature = inspect.signature(function)
            for argument in signature.parameters.values():
                assert argument.name == "self" or argument.annotation is not argument.empty, (name, argument)
            assert signature.return_annotation is not signature.empty, (name, function)
            checked += 1
    assert checked > 12
