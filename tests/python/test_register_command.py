"""The program hwffd-register: what it writes, what it says, and what it refuses and how.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import pty
import re
import signal
import subprocess
import sys

import hwffd
import numpy as np
import pytest
import SimpleITK as sitk
from hwffd import volumes
from test_registration import small_pair

from tests.support import forked

PROGRAM = pathlib.Path(hwffd.__file__).parents[1] / "hwffd-register"
SMALL = ["--spacing", "8", "--levels", "2", "--iterations", "4"]


@pytest.fixture(name="folder", scope="module")
def folder_with_a_pair(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pair")
    fixed, moving, _ = small_pair()
    volumes.write(folder / "fixed.nii.gz", fixed)
    volumes.write(folder / "moving.mha", moving)
    return folder


def run(folder, *words):
    return forked.run(folder, PROGRAM, *words)


def pair_and(folder, *words):
    return run(folder, "fixed.nii.gz", "moving.mha", *SMALL, *words)


def test_everything_is_written(folder):
    outputs = {"-o": "warped.nii.gz", "--lattice-out": "l.json", "--transform": "t.tfm", "--field": "field.mha",
               "--jacobian": "j.nrrd", "--picture": "p.png", "--curve": "c.csv"}
    result = pair_and(folder, *(word for item in outputs.items() for word in item), "--no-folds", "--penalty", "0.01")
    assert result.returncode == 0, result.stderr
    assert re.search(r"metric [0-9.]+ -> [0-9.]+, \d+ evaluations of \d+ voxels", result.stdout)
    assert "folds: proved" in result.stdout and "wrote warped.nii.gz, l.json" in result.stdout
    assert "field.mha will have 3 float32 a voxel" in result.stderr
    assert all((folder / name).stat().st_size > 0 for name in outputs.values())

    fixed, moving = volumes.read(folder / "fixed.nii.gz"), volumes.read(folder / "moving.mha")
    lattice = hwffd.Lattice.read(folder / "l.json")
    warped = volumes.read(folder / "warped.nii.gz")
    np.testing.assert_array_equal(warped.values, volumes.warp(moving, lattice, like=fixed).values)
    field = volumes.read(folder / "field.mha")
    assert field.values.dtype == np.float32
    np.testing.assert_allclose(field.values, volumes.displacement_field(fixed, lattice).values, atol=1e-5)
    transform = sitk.ReadTransform(str(folder / "t.tfm"))
    place = fixed.points(np.array([5.0, 6.0, 7.0]))
    np.testing.assert_allclose(transform.TransformPoint(place.tolist()), hwffd.deform(lattice, [place])[0], atol=1e-9)
    jacobian = volumes.read(folder / "j.nrrd").values
    assert jacobian.shape == fixed.values.shape and 0 < jacobian.min() < 1 < jacobian.max()
    picture = sitk.GetArrayFromImage(sitk.ReadImage(str(folder / "p.png")))
    assert picture.ndim == 2 and picture.shape[0] >= 150 and picture.std() > 20
    lines = (folder / "c.csv").read_text().splitlines()
    assert lines[0].startswith("level,iteration,evaluations,metric") and len(lines) > 6
    assert float(lines[-1].split(",")[3]) < float(lines[1].split(",")[3])


@pytest.mark.parametrize("words, status, text", [
    (["--spacing", "none"], 2, "--spacing"),
    (["--spacing", "500"], 1, "spacing"),
    (["--levels", "9"], 1, "levels"),
    (["-o", "x.jpg"], 2, "x.jpg"),
    (["-o", "fixed.nii.gz"], 2, "the fixed volume"),
    (["-o", "x.mha", "--field", "x.mha"], 2, "--output goes there already"),
    (["--transform", "x.json"], 2, r"\.tfm or \.h5"),
    (["-o", "away/x.mha"], 1, "folder"),
    (["--mask", "away.mha"], 1, "is not there"),
    (["--start", "away.tfm"], 1, "is not there"),
    (["--start", "moving.mha"], 1, "no transform"),
    (["--metric", "joy"], 2, "mutual-information"),
    (["--format", "fx17"], 2, "requires --device"),
])
def test_bad_input_is_one_line_and_writes_nothing(folder, words, status, text):
    before = set(os.listdir(folder))
    result = pair_and(folder, *words)
    assert result.returncode == status and result.stderr.count("\n") == 1, result.stderr
    assert result.stderr.startswith("hwffd-register: ") and re.search(text, result.stderr)
    assert set(os.listdir(folder)) == before


def test_names_may_be_any_bytes(folder, tmp_path):
    odd = os.fsdecode(b"n\xe9\xff")
    sitk.WriteTransform(sitk.TranslationTransform(3, (0.1, 0, 0)), str(tmp_path / "shift.tfm"))
    (tmp_path / "shift.tfm").rename(tmp_path / f"{odd}.tfm")
    words = [word for option, suffix in (("--transform", ".h5"), ("--picture", ".png"), ("--curve", ".csv"),
                                         ("-o", ".nii.gz")) for word in (option, str(tmp_path / (odd + suffix)))]
    result = subprocess.run([sys.executable, PROGRAM, folder / "fixed.nii.gz", folder / "moving.mha", *SMALL, *words,
                             "--start", tmp_path / f"{odd}.tfm"], capture_output=True, check=False)
    assert result.returncode == 0, result.stderr
    assert sorted(os.listdir(tmp_path)) == sorted(odd + suffix for suffix in (".tfm", ".h5", ".png", ".csv", ".nii.gz"))


def test_a_file_that_ends_early_is_refused(folder):
    whole = (folder / "moving.mha").read_bytes()
    (folder / "cut.mha").write_bytes(whole[:len(whole) // 2])
    result = run(folder, "fixed.nii.gz", "cut.mha", *SMALL, "-o", "never.mha")
    assert result.returncode == 1 and "cut.mha" in result.stderr and result.stderr.count("\n") == 1
    assert not (folder / "never.mha").exists()


def test_interrupted_it_leaves_the_best_so_far(tmp_path):
    k, j, i = np.indices((128, 128, 128), np.float32, sparse=True)
    fixed = np.sin(i / 7) + np.sin(j / 9) * np.sin(k / 11)
    for name, values in ("fixed", fixed), ("moving", np.roll(fixed, 3, 2)):
        volumes.write(tmp_path / f"{name}.mha", volumes.Volume(values))
    words = [sys.executable, PROGRAM, "fixed.mha", "moving.mha", "-o", "w.mha", "--lattice-out", "l.json",
             "--iterations", "100000", "--tolerance", "0", "--levels", "1", "--order", "1"]
    mine, terminal = pty.openpty()
    with subprocess.Popen(words, cwd=tmp_path, stdout=subprocess.DEVNULL, stderr=terminal) as running:
        os.close(terminal)
        errors = b""
        while b" iteration " not in errors:  # the registration shows its progress on a terminal
            errors += os.read(mine, 4096)
        running.send_signal(signal.SIGINT)
        errors += until_closed(mine)
    assert running.returncode == 128 + signal.SIGINT, errors
    assert b"the best lattice so far" in errors
    assert hwffd.Lattice.read(tmp_path / "l.json").dims == [11, 11, 11]
    assert volumes.read(tmp_path / "w.mha").values.shape == (128, 128, 128)


def until_closed(terminal):
    """What else comes from a terminal until its last writer ends."""
    text = b""
    while True:
        try:
            text += os.read(terminal, 4096)
        except OSError:  # Linux says EIO there
            os.close(terminal)
            return text
