"""Files of volumes, and the program hwffd-warp: what they give, and what they refuse and how.

SPDX-License-Identifier: Apache-2.0
"""

import gzip
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

import hwffd
import numpy as np
import pytest
import SimpleITK as sitk
from hwffd import volumes
from hwffd.volumes.files import SUFFIXES
from phantom import deformed, phantom

from tests.support import forked

PROGRAM = pathlib.Path(hwffd.__file__).parents[1] / "hwffd-warp"
FAILURE, USAGE = 1, 2


def files(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


def call(folder, *words):
    return forked.run(folder, PROGRAM, *words)


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("kind", [np.int16, np.float32, "field"])
def test_files_come_back(suffix, kind, tmp_path):
    if kind == "field":
        volume = volumes.displacement_field(phantom(), deformed(phantom())[0])
    else:
        volume = phantom(kind)
    path = tmp_path / f"volume{suffix}"
    volumes.write(path, volume)
    volumes.write(path, volume)  # over what is there
    again = volumes.read(path)
    assert again.values.dtype == volume.values.dtype
    np.testing.assert_array_equal(again.values, volume.values)
    close = 1e-4 if ".nii" in suffix else 1e-12  # NIfTI has them in single precision
    for name in "origin", "spacing", "direction":
        np.testing.assert_allclose(getattr(again, name), getattr(volume, name), rtol=0, atol=close)
    assert not [entry for entry in tmp_path.iterdir() if entry.is_dir()]
    image = sitk.ReadImage(str(path))
    assert image.GetSize() == volume.counts


@pytest.mark.parametrize("stem", ["a" * 247, "\N{CJK UNIFIED IDEOGRAPH-6CE2}" * 82])
@pytest.mark.parametrize("suffix", [".nrrd", ".nii.gz"])
def test_names_may_be_as_long_as_they_can_be(stem, suffix, tmp_path):
    volume = phantom()
    volumes.write(tmp_path / f"{stem}{suffix}", volume)
    assert (volumes.read(tmp_path / f"{stem}{suffix}").values == volume.values).all()
    assert len(list(tmp_path.iterdir())) == 1


def test_any_order_of_bytes_and_what_itk_has_not(tmp_path):
    values = np.arange(60).reshape(3, 4, 5)
    for kind in ">i2", "<i2", ">f4", ">f8", ">u8":
        volumes.write(tmp_path / "a.nrrd", volumes.Volume(values.astype(kind)))
        again = volumes.read(tmp_path / "a.nrrd").values
        assert again.dtype == np.dtype(kind).newbyteorder("=")
        np.testing.assert_array_equal(again, values)
    with pytest.raises(hwffd.UsageError, match="^volume: voxels of float16, .* give integers, float32"):
        volumes.write(tmp_path / "a.nrrd", volumes.Volume(values.astype(np.float16)))
    assert volumes.read(tmp_path / "a.nrrd").values.dtype == np.uint64


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_directions_that_are_not_at_right_angles(suffix, tmp_path):
    volume = volumes.Volume(np.zeros((3, 4, 5)), direction=[[1, 0.6, 0], [0, 0.8, 0], [0, 0, 1]])
    path = tmp_path / f"volume{suffix}"
    if ".nii" not in suffix:
        volumes.write(path, volume)
        np.testing.assert_allclose(volumes.read(path).direction, volume.direction, rtol=0, atol=1e-12)
        return
    path.write_bytes(b"kept")
    with pytest.raises(hwffd.Error, match="right angles, .* write nrrd or mha"):
        volumes.write(path, volume)
    assert files(tmp_path) == {path.name: b"kept"}


def test_the_field_moves_points_in_itk(tmp_path):
    volume = phantom()
    lattice, transform = deformed(volume)
    for suffix in SUFFIXES:
        path = tmp_path / f"field{suffix}"
        volumes.write(path, volumes.displacement_field(volume, lattice))
        field = sitk.DisplacementFieldTransform(sitk.ReadImage(str(path), sitk.sitkVectorFloat64))
        for index in (3, 4, 5), (30, 20, 10), (12, 25, 7):
            point = volume.points(np.array(index, float))
            np.testing.assert_allclose(field.TransformPoint(point), transform.TransformPoint(point),
                                       rtol=0, atol=1e-3 if ".nii" in suffix else 1e-9)


def cut(path):
    """A file that ends early."""
    data = path.read_bytes()
    path.write_bytes(data[:len(data) - 100])


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_files_that_end_early_are_refused(suffix, tmp_path):
    path = tmp_path / f"volume{suffix}"
    for packed in (True, False):
        sitk.WriteImage(volumes.to_itk(phantom()), str(path), packed)
        volumes.read(path)
        voxels = [part for part in tmp_path.iterdir() if part.suffix not in (".nhdr", ".mhd")]
        assert len(voxels) == 1
        cut(voxels[0])
        with pytest.raises(hwffd.Error, match=path.name) as caught:
            volumes.read(path)
        assert "\n" not in str(caught.value)
        voxels[0].unlink()


def test_a_damaged_nifti_file_is_refused(tmp_path):
    path = tmp_path / "volume.nii.gz"
    volumes.write(path, phantom())
    short = gzip.decompress(path.read_bytes())[:-100]
    path.write_bytes(gzip.compress(short))
    with pytest.raises(hwffd.Error, match=rf"volume.nii.gz: ends after {len(short)} of"):
        volumes.read(path)
    data = bytearray(gzip.compress(short + bytes(100)))
    data[-6] ^= 1
    path.write_bytes(data)
    with pytest.raises(hwffd.Error, match="volume.nii.gz: (is damaged|cannot be read)"):
        volumes.read(path)


@pytest.fixture
def folder(tmp_path):
    """Volumes and lattices, good and bad."""
    volume = phantom(np.int16)
    volumes.write(tmp_path / "in.nrrd", volume)
    lattice, _ = deformed(volume)
    lattice.write(tmp_path / "rest.json", rest=True)
    lattice.write(tmp_path / "moved.json")
    (tmp_path / "words.nrrd").write_text("no volume")
    (tmp_path / "words.mha").write_text("NDims = many\n")
    sitk.WriteImage(volumes.to_itk(volume)[:, :, 3], str(tmp_path / "flat.nrrd"))
    sitk.WriteImage(sitk.Cast(volumes.to_itk(volume), sitk.sitkComplexFloat32),
                    str(tmp_path / "complex.nrrd"))
    volumes.write(tmp_path / "early.nii", volume)
    cut(tmp_path / "early.nii")
    volumes.write(tmp_path / "early.mha", volume)
    cut(tmp_path / "early.mha")
    sitk.WriteImage(volumes.to_itk(volume), str(tmp_path / "nan.mha"), False)
    data, changed = re.subn(rb"(?<=ElementSpacing = )\S+", b"nan",
                            (tmp_path / "nan.mha").read_bytes())
    assert changed == 1
    (tmp_path / "nan.mha").write_bytes(data)
    values = phantom().values
    values[3, 4, 5] = np.nan
    volumes.write(tmp_path / "holes.nrrd", volumes.Volume(values))
    volumes.write(tmp_path / "kept.nrrd", volume)
    (tmp_path / "kept.nrrd").chmod(0o444)
    (tmp_path / "box").mkdir()
    return tmp_path


def test_the_program_does_what_the_module_does(folder):
    words = ["in.nrrd", "rest.json", "out.mha", "--deform", "to:moved.json", "--device", "reference", "--field", "field.nrrd",
             "--default", "-5", "--outside", "clamp"]
    result = subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, text=True, check=False)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.splitlines()[1:] == ["reference", "wrote out.mha and field.nrrd"]
    assert result.stdout.startswith(f"lattice 8x6x5: {41 * 29 * 19} voxels, 0 outside it, ")
    volume = volumes.read(folder / "in.nrrd")
    lattice = hwffd.Lattice.read(folder / "rest.json")
    lattice.control_points = hwffd.Lattice.read(folder / "moved.json").control_points
    lattice.set_device("reference")
    lattice.set_outside("clamp")
    expected = volumes.warp(volume, lattice, default=-5)
    np.testing.assert_array_equal(volumes.read(folder / "out.mha").values, expected.values)
    np.testing.assert_array_equal(volumes.read(folder / "field.nrrd").values,
                                  volumes.displacement_field(volume, lattice).values)


@pytest.mark.parametrize("words, dims", [
    ("box --deform twist:20", "4x4x4"), ("box --dims 5x6x7 --deform bend:10:z --order 0", "5x6x7"),
    ("sphere --deform twist:20 --outside fade:3", None),
    ("cylinder --device model --org cg1 --format fx32 --order 1", None)])
def test_shapes_and_options(folder, words, dims):
    lattice, *more = words.split()
    result = call(folder, "in.nrrd", lattice, "out.nii.gz", *more)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.startswith(f"lattice {dims}: " if dims else "lattice ")
    changed = volumes.read(folder / "out.nii.gz").values != volumes.read(folder / "in.nrrd").values
    assert np.count_nonzero(changed) > (1000 if "deform" in words else -1)


# Command line -> exit status and words of the one line on standard error. Nothing is written.
REFUSED = {
    "": (USAGE, "input", "--help"),
    "in.nrrd box out.nrrd --twist 9": (USAGE, "--twist", "--help"),
    "in.nrrd box out.nrrd --dims 4x4": (USAGE, "4x4", "6x6x6"),
    "in.nrrd box out.nrrd --dims 4x4x3": (USAGE, "4 to 64"),
    "in.nrrd rest.json out.nrrd --dims 4x4x4": (USAGE, "--dims", "leave it out"),
    "in.nrrd box out.nrrd --order 2": (USAGE, "--order", "3"),
    "in.nrrd box out.nrrd --default nan": (USAGE, "default nan"),
    "in.nrrd box out.nrrd --device fpga": (USAGE, "fpga", "reference"),
    "in.nrrd box out.nrrd --deform twirl": (USAGE, "twirl"),
    "in.nrrd box out.nrrd --outside far": (USAGE, "far"),
    "in.nrrd box out.nrrd --org cg1": (USAGE, "--org requires --device"),
    "in.nrrd box out.nrrd --format fx18": (USAGE, "--format requires --device"),
    "in.nrrd box out.png": (USAGE, "out.png", ".nii.gz"),
    "in.nrrd box out": (USAGE, "out:", ".nrrd"),
    "in.nrrd box out.nrrd --field ./out.nrrd": (USAGE, "--field", "output"),
    "in.nrrd box out.nrrd --field ./in.nrrd": (USAGE, "--field ./in.nrrd", "the input"),
    "in.nrrd box words.nrrd --like words.nrrd": (USAGE, "output words.nrrd", "--like"),
    "in.nrrd box none/out.nrrd": (FAILURE, "none/out.nrrd", "folder"),
    "in.nrrd box kept.nrrd": (FAILURE, "kept.nrrd: is read-only"),
    "in.nrrd box out.nrrd --field none/f.mha": (FAILURE, "none/f.mha"),
    "none.nrrd box out.nrrd": (FAILURE, "none.nrrd", "not there"),
    "rest.json box out.nrrd": (USAGE, "rest.json", ".nrrd"),
    "words.nrrd box out.nrrd": (FAILURE, "words.nrrd", "cannot be read"),
    "words.mha box out.nrrd": (FAILURE, "words.mha", "cannot be read"),
    "flat.nrrd box out.nrrd": (FAILURE, "flat.nrrd", "2 dimensions"),
    "complex.nrrd box out.nrrd": (FAILURE, "complex.nrrd", "complex64"),
    "early.nii box out.nrrd": (FAILURE, "early.nii", "ends after"),
    "early.mha box out.nrrd": (FAILURE, "early.mha", "copy it again"),
    "nan.mha box out.nrrd": (FAILURE, "nan.mha", "spacing"),
    "holes.nrrd box out.nrrd": (FAILURE, "1 voxels are not finite"),
    "in.nrrd none.json out.nrrd": (FAILURE, "none.json"),
    "in.nrrd words.mha out.nrrd": (FAILURE, "words.mha"),
    "in.nrrd box out.nrrd --like flat.nrrd": (FAILURE, "flat.nrrd", "2 dimensions"),
    "in.nrrd box out.nrrd --deform to:none.json": (FAILURE, "none.json"),
    "in.nrrd box out.nrrd --deform scale:1e30 --device model --deform scale:1e30":
        (FAILURE, "not finite", "reference"),
}


@pytest.mark.parametrize("line", REFUSED)
def test_the_program_refuses_in_a_line(folder, line):
    before = files(folder)
    result = call(folder, *line.split())
    status, *words = REFUSED[line]
    if line == "in.nrrd none.json out.nrrd":  # as it is called
        alone = subprocess.run([PROGRAM, *line.split()], cwd=folder, capture_output=True, text=True, check=False)
        assert (alone.returncode, alone.stdout, alone.stderr) == (result.returncode, result.stdout, result.stderr)
    assert (result.returncode, result.stdout) == (status, ""), result.stderr
    assert result.stderr.startswith("hwffd-warp: ") and result.stderr.count("\n") == 1
    assert len(result.stderr) < 250
    for word in words:
        assert word in result.stderr
    assert files(folder) == before and len(list(folder.iterdir())) == len(before) + 1


def test_the_program_says_what_is_missing_and_a_cure(folder, tmp_path):
    words = [PROGRAM, "in.nrrd", "box", "out.nrrd"]
    result = subprocess.run([sys.executable, "-S", *words], cwd=folder, capture_output=True, text=True,
                            check=False)
    assert (result.returncode, result.stdout) == (FAILURE, "")
    assert re.fullmatch(r"hwffd-warp: [^\n]*numpy[^\n]*python3 -m venv DIR && DIR/bin/pip install numpy scipy "
                        r"SimpleITK, then put DIR/bin first on PATH\n", result.stderr)
    for package in "scipy", "SimpleITK":
        (tmp_path / "without" / package).mkdir(parents=True)
        (tmp_path / "without" / package / "__init__.py").write_text("raise ImportError('not here')")
        result = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False,
                                env={**os.environ, "PYTHONPATH": str(tmp_path / "without")})
        assert (result.returncode, result.stdout, result.stderr.count("\n")) == (FAILURE, "", 1)
        assert f"{package} is missing in {sys.executable}: " in result.stderr
        assert f"{sys.executable} -m pip install {package}" in result.stderr
        (tmp_path / "without" / package / "__init__.py").unlink()
        (tmp_path / "without" / package).rmdir()
    other = tmp_path / "other"
    shutil.copytree(PROGRAM.parent / "hwffd", other / "hwffd", ignore=shutil.ignore_patterns("_core*"))
    (other / "hwffd" / "_core.cpython-27-other.so").write_bytes(b"")
    shutil.copy(PROGRAM, other)
    result = subprocess.run([other / PROGRAM.name, "--version"], capture_output=True, text=True, check=False)
    assert (result.returncode, result.stdout, result.stderr.count("\n")) == (FAILURE, "", 1)
    assert "_core.cpython-27-other.so: put that Python first on PATH" in result.stderr


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_leaves_nothing_behind(folder, number):
    volumes.write(folder / "large.nrrd", volumes.Volume(np.zeros((200, 300, 300), np.uint8)))
    before = files(folder)
    with subprocess.Popen([PROGRAM, "large.nrrd", "box", "out.nrrd", "--device", "model"], cwd=folder,
                          stderr=subprocess.PIPE, text=True) as program:
        time.sleep(2)
        assert program.poll() is None
        program.send_signal(number)
        errors = program.communicate()[1]
    assert program.returncode in (-number, 128 + number) and errors == ""
    assert files(folder) == before and len(list(folder.iterdir())) == len(before) + 1


def test_a_link_stays_a_link_and_a_mode_stays(folder):
    target = folder / "target.nrrd"
    target.write_bytes(b"")
    target.chmod(0o640)
    (folder / "out.nrrd").symlink_to(target.name)
    assert call(folder, "in.nrrd", "box", "out.nrrd", "--order", "0").returncode == 0
    assert (folder / "out.nrrd").is_symlink() and target.stat().st_mode & 0o777 == 0o640
    np.testing.assert_array_equal(volumes.read(target).values, volumes.read(folder / "in.nrrd").values)
