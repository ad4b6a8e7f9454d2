"""Two volumes aligned: what register() finds, with which bits, and what it refuses.

SPDX-License-Identifier: Apache-2.0
"""

import hwffd
import numpy as np
import pytest
import SimpleITK as sitk
from hwffd import volumes
from phantom import in_voxels, phantom

COUNTS = (40, 32, 28)  # along i, j and k


@pytest.fixture(autouse=True)
def all_threads():
    yield
    hwffd.set_threads(0)


def blobs(counts=COUNTS, seed=1):
    """A volume with something to see everywhere, of voxels of three lengths."""
    rng = np.random.default_rng(seed)
    k, j, i = np.meshgrid(*(np.arange(n, dtype=np.float64) for n in counts[::-1]), indexing="ij")
    values = np.zeros(k.shape)
    for _ in range(60):
        centre = rng.uniform(0, 1, 3) * counts
        size = rng.uniform(2.5, 5)
        distance = (i - centre[0]) ** 2 + (j - centre[1]) ** 2 + (0 if counts[2] == 1 else (k - centre[2]) ** 2)
        values += rng.uniform(20, 100) * np.exp(-distance / (2 * size * size))
    return volumes.Volume(values.astype(np.float32), (5, -7, 11), (1.0, 1.5, 0.8))


def pair(counts=COUNTS, size=1.5, cells=(3, 3, 2)):
    """A fixed volume, a larger moving one and the lattice that takes one to the other, which leaves the moving
    one nowhere: fixed(x) = moving(T(x))."""
    around = [0 if n == 1 else 6 for n in counts]
    moving = blobs([n + 2 * more for n, more in zip(counts, around)])
    fixed = volumes.Volume(np.zeros(counts[::-1], np.float32), moving.points(np.array(around, float)), moving.spacing)
    truth = volumes.lattice_over(fixed, [n + 3 for n in cells])
    moves = np.random.default_rng(2).uniform(-size, size, truth.rest_points.shape)
    if counts[2] == 1:
        moves[..., 2] = 0
    truth.control_points = truth.rest_points + moves
    return volumes.warp(moving, truth, like=fixed), moving, truth


def off(volume, lattice, truth):
    """How far from each other two lattices take the voxels of a volume, but for four at the border, in voxels."""
    fields = [volumes.displacement_field(volume, one).values for one in (lattice, truth)]
    inner = tuple(slice(4, -4) if n > 8 else slice(None) for n in volume.values.shape)
    return np.linalg.norm(in_voxels(volume, fields[0] - fields[1])[inner], axis=-1)


SMALL = {"spacing": 8, "levels": 2, "iterations": 4}


def small_pair():
    return pair((20, 16, 12), 1.0)


@pytest.mark.parametrize("counts, size", [(COUNTS, 1.5), ((64, 48, 1), 2.0)])
@pytest.mark.parametrize("metric", ["mean-squares", "correlation"])
def test_a_known_deformation_is_recovered(counts, size, metric):
    fixed, moving, truth = pair(counts, size, (3, 3, 2 if counts[2] > 1 else 1))
    rest = volumes.lattice_over(fixed, truth.dims)
    before = off(fixed, rest, truth).mean()
    result = hwffd.register(fixed, moving, spacing=10, levels=2, metric=metric)
    after = off(fixed, result.lattice, truth).mean()
    assert before > 0.4 and after < 0.1, (before, after)
    assert result.metric_end < 0.1 * result.metric_start
    assert result.folds == "proved" and 0 < result.jacobian[0] < 1 < result.jacobian[1]
    assert result.evaluations >= len(result.history) and result.voxels > fixed.values.size
    assert not result.stopped and result.overlap > 0.9
    assert {step["level"] for step in result.history} == {0, 1}


def test_mutual_information_aligns_what_has_other_brightness():
    fixed, moving, truth = pair()
    other = volumes.Volume(200 - np.sqrt(moving.values), moving.origin, moving.spacing)
    result = hwffd.register(fixed, other, spacing=10, levels=2, metric="mutual-information", iterations=60)
    before = off(fixed, volumes.lattice_over(fixed, truth.dims), truth).mean()
    assert off(fixed, result.lattice, truth).mean() < 0.5 * before


def test_bits_do_not_depend_on_threads():
    fixed, moving, _ = small_pair()
    points = []
    for threads in 1, 2, 5:
        hwffd.set_threads(threads)
        result = hwffd.register(fixed, moving, **SMALL, penalty=0.01)
        points.append(result.lattice.control_points.tobytes())
    assert len(set(points)) == 1
    assert result.metric_end < result.metric_start


def test_the_model_and_the_simulated_hardware_give_the_same_bits():
    """A whole registration, of 32 x 32 x 32 voxels."""
    row = "walk-fx17-overlapped"
    if row not in hwffd.devices("rtl"):
        pytest.skip(f"no simulated {row} in this build")
    fixed, moving, truth = pair((32, 32, 32), 1.5, (2, 2, 2))
    model, rtl = (hwffd.register(fixed, moving, spacing=16, levels=1, iterations=10, device=device)
                  for device in ("model", "rtl"))
    assert model.lattice.control_points.tobytes() == rtl.lattice.control_points.tobytes()
    assert model.history == rtl.history and len(model.history) == 11
    assert rtl.lattice.device == f"rtl {row}" and rtl.voxels > 10 * 32 ** 3
    assert off(fixed, rtl.lattice, truth).mean() < 0.1 < off(fixed, volumes.lattice_over(fixed, truth.dims), truth).mean()


def test_the_model_is_near_the_reference():
    fixed, moving, truth = small_pair()
    exact = hwffd.register(fixed, moving, **SMALL)
    model = hwffd.register(fixed, moving, **SMALL, device="model")
    assert model.lattice.device == "model walk-fx17-overlapped"
    assert off(fixed, model.lattice, exact.lattice).max() < 0.2
    assert model.metric_end < 0.5 * model.metric_start


def test_itk_has_the_same_map(tmp_path):
    fixed = phantom()
    lattice = volumes.lattice_over(fixed, (8, 6, 5))
    lattice.control_points = lattice.rest_points + np.random.default_rng(4).normal(0, 1, lattice.rest_points.shape)
    for suffix in ".tfm", ".h5":
        path = tmp_path / f"map{suffix}"
        volumes.write_transform(path, lattice)
        transform = sitk.ReadTransform(str(path))
        places = fixed.points(np.random.default_rng(5).uniform(0, 1, (100, 3)) * (np.array(fixed.counts) - 1))
        there = np.array([transform.TransformPoint(place) for place in places.tolist()])
        assert np.abs(there - hwffd.deform(lattice, places)).max() < 1e-9


def test_an_affine_start_is_taken_from_itks_file(tmp_path):
    fixed, moving, _ = small_pair()
    affine = sitk.AffineTransform(3)
    affine.SetMatrix([1, 0.1, 0, 0, 1, 0, 0, 0, 1.1])
    affine.SetTranslation([1, 2, 3])
    affine.SetCenter([4, 5, 6])
    sitk.WriteTransform(affine, str(tmp_path / "start.tfm"))
    matrix = volumes.read_affine(tmp_path / "start.tfm")
    place = [7.0, -2.0, 9.0]
    assert np.allclose(matrix @ [*place, 1], [*affine.TransformPoint(place), 1], atol=1e-12)
    result = hwffd.register(fixed, moving, spacing=8, levels=1, iterations=0, start=matrix)
    corner = result.lattice.rest_points[0, 0, 0]
    assert np.allclose(result.lattice.control_points[0, 0, 0], affine.TransformPoint(corner.tolist()), atol=1e-9)


def test_a_lattice_continues():
    fixed, moving, _ = small_pair()
    first = hwffd.register(fixed, moving, spacing=8, levels=1, iterations=3)
    second = hwffd.register(fixed, moving, spacing=8, levels=1, iterations=3, start=first.lattice)
    assert second.metric_start == first.metric_end > second.metric_end


def test_no_folds_are_found_where_none_are_allowed():
    fixed, moving, _ = pair((32, 28, 24), 6.0, (4, 4, 3))
    free = hwffd.register(fixed, moving, spacing=6, levels=1, iterations=40)
    held = hwffd.register(fixed, moving, spacing=6, levels=1, iterations=40, no_folds=True)
    assert held.folds == "proved" and held.jacobian[0] > 0
    assert free.folds != "proved" or free.jacobian[0] <= held.jacobian[0]
    assert held.metric_end < held.metric_start


def test_masks_leave_voxels_out():
    fixed, moving, truth = pair()
    spoiled = fixed.values.copy()
    spoiled[:, :, :8] = 500 * np.random.default_rng(7).random(spoiled[:, :, :8].shape)
    mask = np.ones(spoiled.shape, np.uint8)
    mask[:, :, :8] = 0
    bad = volumes.Volume(spoiled, fixed.origin, fixed.spacing)
    options = {"spacing": 8, "levels": 1, "iterations": 40, "penalty": 0.001}
    clean = hwffd.register(bad, moving, mask=mask, **options)
    errors = off(fixed, clean.lattice, truth)[:, :, 8:].mean()
    assert errors < 0.5 * off(fixed, volumes.lattice_over(fixed, truth.dims), truth)[:, :, 8:].mean()
    assert clean.overlap < 33 / 40


def test_progress_sees_and_stops():
    fixed, moving, _ = small_pair()
    seen = []

    def look(state):
        seen.append(state)
        return len(seen) < 5

    result = hwffd.register(fixed, moving, spacing=8, levels=2, progress=look)
    assert result.stopped and len(seen) == 5
    assert {"level", "iteration", "metric", "voxels", "seconds", "dims"} <= set(seen[0])
    assert result.metric_end <= result.metric_start

    def fail(state):
        raise ZeroDivisionError(state["level"])

    with pytest.raises(ZeroDivisionError):
        hwffd.register(fixed, moving, spacing=8, levels=2, progress=fail)


def test_what_lies_elsewhere_is_refused():
    fixed, moving, _ = small_pair()
    elsewhere = volumes.Volume(fixed.values, fixed.origin + 50, fixed.spacing)
    with pytest.raises(hwffd.Error, match="mask: its voxels lie elsewhere"):
        hwffd.register(fixed, moving, **SMALL, mask=elsewhere)
    lattice = hwffd.register(fixed, moving, **SMALL).lattice
    with pytest.raises(hwffd.Error, match="start: not a lattice of B-splines"):
        hwffd.register(elsewhere, moving, **SMALL, start=lattice)
    linear = hwffd.Lattice.of(lattice.rest_points, family="linear")
    with pytest.raises(hwffd.Error, match="start: not a lattice of B-splines"):
        hwffd.register(fixed, moving, **SMALL, start=linear)


def test_thin_volumes_need_no_options():
    fixed, moving, _ = small_pair()
    result = hwffd.register(fixed, moving, iterations=3)
    assert result.lattice.dims == [4, 4, 4] and result.metric_end < result.metric_start


def test_smoothing_keeps_noise_from_drawing():
    fixed, moving, truth = pair()
    rng = np.random.default_rng(11)
    noisy = [volumes.Volume(one.values + rng.normal(0, 8, one.values.shape).astype(np.float32), one.origin, one.spacing)
             for one in (fixed, moving)]
    errors = [off(fixed, hwffd.register(*noisy, spacing=13, levels=1, smooth=smooth).lattice, truth).mean()
              for smooth in (True, False)]
    assert errors[0] < 0.8 * errors[1], errors


NOTHING = np.zeros((12, 16, 20), np.float32)


@pytest.mark.parametrize("changes, text", [
    ({"fixed": NOTHING + 1}, "fixed image: all voxels are 1"),
    ({"moving": NOTHING + 1}, "moving image: all voxels are 1"),
    ({"fixed": np.where(np.indices(NOTHING.shape)[0] == 3, np.nan, 1.0)}, "NaN"),
    ({"mask": NOTHING}, "mask"),
    ({"mask": np.ones((3, 3, 3))}, "mask: "),
    ({"mask": np.where(np.indices(NOTHING.shape)[0] == 3, np.nan, 1.0)}, "mask: 320 voxels are NaN"),
    ({"moving_mask": np.full((24, 28, 32), np.nan)}, "moving_mask: 21504 voxels are NaN"),
    ({"spacing": 50}, "spacing"),
    ({"spacing": -1}, "spacing"),
    ({"spacing": (1, 2)}, "spacing"),
    ({"spacing": 0.2}, "64"),
    ({"levels": 9}, "levels"),
    ({"metric": "joy"}, "mean-squares, correlation, mutual-information"),
    ({"unit": "miles"}, "voxels or length"),
    ({"start": np.eye(3)}, r"\(4, 4\)"),
    ({"start": np.diag([1.0, 1, 1, 2])}, "0 0 0 1"),
    ({"start": np.array([[1, 0, 0, 1e4], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])}, "overlap"),
    ({"device": "abacus"}, "device"),
    ({"device": None}, "device: a NoneType"),
    ({"penalty": "a"}, "penalty: 'a'"),
    ({"penalty": -1}, "weight -1"),
    ({"iterations": 10 ** 11}, "iterations: 100000000000"),
    ({"iterations": 10 ** 8}, "give 0 to 1000000"),
    ({"start": "x"}, "start: no numbers"),
    ({"progress": 3}, "progress: a int"),
    ({"fixed": np.ones((4, 4, 4, 3))}, "components"),
])
def test_bad_input_is_one_line(changes, text):
    fixed, moving, _ = small_pair()
    given = {"fixed": fixed, "moving": moving, "spacing": 8, "levels": 2, "iterations": 2} | changes
    with pytest.raises(hwffd.Error, match=text) as refused:
        hwffd.register(given.pop("fixed"), given.pop("moving"), **given)
    assert "\n" not in str(refused.value) and len(str(refused.value)) < 250


def test_memory_stays_below_six_times_the_fixed_volume():
    import subprocess
    import sys
    code = """
import resource, hwffd, numpy as np
from hwffd import volumes
n = 160
k, j, i = np.indices((n, n, n), np.float32, sparse=True)
moving = np.sin(i / 7) + np.sin(j / 9) * np.sin(k / 11)
fixed = np.roll(moving, 1, 2)
def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
hwffd.register(fixed[:16, :16, :16], moving[:16, :16, :16], spacing=8, levels=1, iterations=1)
before = peak()
hwffd.register(fixed, moving, spacing=20, levels=2, iterations=2)
print((peak() - before) / fixed.nbytes)
"""
    output = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout
    assert float(output) < 4, output  # beside the two volumes
