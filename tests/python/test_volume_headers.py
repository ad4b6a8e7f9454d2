"""Volumes as their files have them: the file that is named, whole, with its numbers and its fields.

Files are written byte by byte here, and not by the library.

SPDX-License-Identifier: Apache-2.0
"""

import gzip
import os
import pathlib
import subprocess
import sys
import warnings
import zlib

import hwffd
import numpy as np
import pytest
from hwffd import volumes
from hwffd.volumes.files import SUFFIXES
from phantom import phantom

from tests.support import forked

PROGRAM = pathlib.Path(hwffd.__file__).parents[1] / "hwffd-warp"
SHAPE = (3, 4, 5)
VALUES = np.arange(60, dtype=np.int16).reshape(SHAPE)
NIFTI_CODES = {"u1": 2, "i2": 4, "f4": 16, "f8": 64, "rgb": 128, "rgba": 2304}

# Where fields are in a header of NIfTI: offset and type.
PLACES = {"sizeof_hdr": (0, "i4"), "db_name": (14, "S"), "dim": (40, "i2"), "intent_p1": (56, "f4"),
         "intent_code": (68, "i2"), "datatype": (70, "i2"), "bitpix": (72, "i2"), "pixdim": (76, "f4"),
         "vox_offset": (108, "f4"), "scl_slope": (112, "f4"), "scl_inter": (116, "f4"),
          "slice_code": (122, "u1"),
         "xyzt_units": (123, "u1"), "cal_max": (124, "f4"), "toffset": (136, "f4"),
         "descrip": (148, "S"), "aux_file": (228, "S"), "qform_code": (252, "i2"),
         "sform_code": (254, "i2"), "srow": (280, "f4"), "intent_name": (328, "S"),
         "magic": (344, "S")}

def nifti(values, kind=None, order="<", packed=False, **more):
    """The bytes of a NIfTI file; values (nz, ny, nx) or (nz, ny, nx, c)."""
    colours = kind in ("rgb", "rgba")
    kind = kind or values.dtype.str[1:]
    components = values.shape[3] if values.ndim == 4 else 1
    dims = [3, *values.shape[2::-1], 1, 1, 1, 1]
    if components > 1 and not colours:
        dims = [5, *values.shape[2::-1], 1, components, 1, 1]
        values = np.moveaxis(values, -1, 0)
    fields = {"sizeof_hdr": 348, "dim": dims, "datatype": NIFTI_CODES[kind],
              "bitpix": 8 * values.itemsize * (components if colours else 1), "pixdim": [1] * 8,
              "vox_offset": 352, "sform_code": 1, "srow": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0],
              "intent_code": 1007 if dims[0] == 5 else 0, "magic": b"n+1\0", **more}
    header = bytearray(352)
    for name, value in fields.items():
        offset, form = PLACES[name]
        data = value if form == "S" else np.array(value, order + form).tobytes()
        header[offset:offset + len(data)] = data
    data = bytes(header) + values.astype(values.dtype.newbyteorder(order)).tobytes()
    return gzip.compress(data, mtime=0) if packed else data


def nrrd(values, lines=(), space="left-posterior-superior", encoding="raw", data=""):
    """The bytes of a NRRD file, or its header alone if its data are in other files."""
    head = ["NRRD0005", "type: int16", "dimension: 3", f"space: {space}",
            "sizes: {2} {1} {0}".format(*values.shape), "space directions: (1,0,0) (0,1.5,0) (0,0,2)",
            "kinds: domain domain domain", "endian: little", f"encoding: {encoding}",
            "space origin: (3.25,4,5)", *lines]
    voxels = values.astype("<i2").tobytes()
    if encoding == "gzip":
        voxels = gzip.compress(voxels)
    if data:
        return "\n".join([*head, f"data file: {data}", ""]).encode()
    return "\n".join([*head, "", ""]).encode() + voxels


def meta(values, lines=(), data="LOCAL", packed=False):
    """The bytes of a MetaImage file, or its header alone."""
    head = ["ObjectType = Image", "NDims = 3", "BinaryData = True", "BinaryDataByteOrderMSB = False",
            f"CompressedData = {packed}", "TransformMatrix = 1 0 0 0 1 0 0 0 1", "Offset = 3.25 4 5",
            "ElementSpacing = 1 1.5 2", *lines, "DimSize = {2} {1} {0}".format(*values.shape),
            "ElementType = MET_SHORT", f"ElementDataFile = {data}", ""]
    voxels = values.astype("<i2").tobytes()
    return "\n".join(head).encode() + ((zlib.compress(voxels) if packed else voxels)
                                       if data == "LOCAL" else b"")


def warped(folder, *words, **environment):
    """The program, whose output is bytes since names may be no UTF-8."""
    return subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, check=False,
                          env={**os.environ, **environment})


@pytest.mark.parametrize("name", ["scan.nii", "scan.nii.gz", "SCAN.NII", "SCAN.NII.GZ"])
def test_the_file_that_is_named_is_read(name, tmp_path):
    stem = name[:4]
    for number, suffix in enumerate((".nii", ".nii.gz", ".NII", ".NII.GZ", ".hdr", ".img")):
        (tmp_path / f"{stem}{suffix}").write_bytes(
            nifti(np.full(SHAPE, number, np.int16), packed=suffix.lower().endswith("gz")))
    number = (".nii", ".nii.gz", ".NII", ".NII.GZ").index(name[4:])
    assert (volumes.read(tmp_path / name).values == number).all()


@pytest.mark.parametrize("packed", [False, True])
@pytest.mark.parametrize("kind, components", [("rgb", 3), ("rgba", 4)])
def test_colours_are_components(kind, components, packed, tmp_path):
    values = np.arange(60 * components, dtype=np.uint8).reshape(*SHAPE, components)
    path = tmp_path / f"a.nii{'.gz' if packed else ''}"
    path.write_bytes(nifti(values, kind, packed=packed))
    np.testing.assert_array_equal(volumes.read(path).values, values)
    data = nifti(values, kind)[:-1]
    path.write_bytes(gzip.compress(data) if packed else data)
    with pytest.raises(hwffd.Error, match=f"ends after {len(data)} of {len(data) + 1} bytes"):
        volumes.read(path)


# Name of the header -> its bytes, and the other files by name.
PIECES = {f"s{k}.raw": VALUES[k].astype("<i2").tobytes() for k in range(3)}
IN_PARTS = {
    "a.mha": (meta(VALUES), {}),
    "packed.mha": (meta(VALUES, [f"CompressedDataSize = {len(zlib.compress(VALUES.tobytes()))}"],
                        packed=True), {}),
    "packed.mhd": (meta(VALUES, data="a.zraw", packed=True), {"a.zraw": zlib.compress(VALUES.tobytes())}),
    "a.mhd": (meta(VALUES, data="a.raw"), {"a.raw": VALUES.tobytes()}),
    "skip.mhd": (meta(VALUES, ["HeaderSize = 7"], "a.raw"), {"a.raw": b"headers" + VALUES.tobytes()}),
    "list.mhd": (meta(VALUES, data="LIST") + b"s0.raw\ns1.raw\ns2.raw\n", PIECES),
    "pattern.mhd": (meta(VALUES, data="s%d.raw 0 2 1"), PIECES),
    "a.nrrd": (nrrd(VALUES), {}),
    "packed.nrrd": (nrrd(VALUES, encoding="gzip"), {}),
    "a.nhdr": (nrrd(VALUES, data="a.raw"), {"a.raw": VALUES.tobytes()}),
    "skip.nhdr": (nrrd(VALUES, ["byte skip: 7"], data="a.raw"), {"a.raw": b"headers" + VALUES.tobytes()}),
    "packed.nhdr": (nrrd(VALUES, encoding="gzip", data="a.raw.gz"),
                    {"a.raw.gz": gzip.compress(VALUES.tobytes())}),
    "pattern.nhdr": (nrrd(VALUES, data="s%d.raw 0 2 1"), PIECES),
    "list.nhdr": (nrrd(VALUES, data="LIST") + b"s0.raw\ns1.raw\ns2.raw\n", PIECES),
    "a.nii": (nifti(VALUES), {}),
    "big.nii": (nifti(VALUES, order=">"), {}),
    "a.nii.gz": (nifti(VALUES, packed=True), {}),
}


@pytest.mark.parametrize("name", IN_PARTS)
def test_files_are_read_whole_or_refused(name, tmp_path):
    header, others = IN_PARTS[name]
    for part, data in {name: header, **others}.items():
        (tmp_path / part).write_bytes(data)
    path = tmp_path / name
    np.testing.assert_array_equal(volumes.read(path).values, VALUES)
    last = tmp_path / [name, *others][-1]
    whole = last.read_bytes()
    for cut in 1, 9:
        last.write_bytes(whole[:-cut])
        with pytest.raises(hwffd.Error, match=rf"{name}: (ends after \d+ of \d+ bytes|is damaged or ends "
                                              "early); copy it again$"):
            volumes.read(path)
    for part in others:
        (tmp_path / part).unlink()
        with pytest.raises(hwffd.Error, match=f"{name}: its voxels are in {part}, which is not there"):
            volumes.read(path)
        (tmp_path / part).write_bytes(others[part])


@pytest.mark.parametrize("name, kind", [("LONG", "<i4"), ("ULONG", "<u4"), ("LONG_LONG", "<i8"),
                                        ("UINT", "<u4"), ("DOUBLE", "<f8")])
def test_types_of_metaimage_have_the_sizes_that_itk_reads(name, kind, tmp_path):
    path = tmp_path / "a.mha"
    header = meta(VALUES).replace(b"MET_SHORT", b"MET_" + name.encode())[:-VALUES.nbytes]
    path.write_bytes(header + VALUES.astype(kind).tobytes())
    assert volumes.read(path).values.tolist() == VALUES.tolist()
    path.write_bytes(path.read_bytes()[:-1])
    with pytest.raises(hwffd.Error, match="ends after"):
        volumes.read(path)


def test_packed_voxels_without_a_size_are_refused(tmp_path):
    (tmp_path / "a.mha").write_bytes(meta(VALUES, packed=True))
    with pytest.raises(hwffd.Error, match="a.mha: packed voxels without CompressedDataSize"):
        volumes.read(tmp_path / "a.mha")


@pytest.fixture(name="comma", scope="module")
def comma_fixture(tmp_path_factory):
    """The environment of a locale in which numbers have a comma."""
    folder = tmp_path_factory.mktemp("locales")
    subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", folder / "de_DE.UTF-8"], check=True,
                   capture_output=True)
    return {"LOCPATH": str(folder), "LC_ALL": "de_DE.UTF-8"}


IN_A_LOCALE = """
import locale, sys
locale.setlocale(locale.LC_ALL, "")
assert locale.localeconv()["decimal_point"] == ","
import hwffd
from hwffd import volumes
lattice = hwffd.Lattice.read("in.json")
lattice.deform("move:1,1,1:0.25,0.5,0.75")
lattice.write("out.json")
for suffix in sys.argv[1:]:
    volume = volumes.read(f"in{suffix}")
    volumes.write(f"out{suffix}", volume)
    print(*volume.spacing, *volume.origin)
assert locale.localeconv()["decimal_point"] == "," and locale.str(1.5) == "1,5"
"""


def test_numbers_have_points_in_every_locale(comma, tmp_path):
    volume = phantom(np.int16)
    for suffix in SUFFIXES:
        volumes.write(tmp_path / f"in{suffix}", volume)
    lattice = hwffd.Lattice.around("box", [[0.5, 0.25, 0.125], [1.5, 1.25, 1.125]])
    lattice.write(tmp_path / "in.json")
    result = subprocess.run([sys.executable, "-c", IN_A_LOCALE, *SUFFIXES], cwd=tmp_path, capture_output=True, text=True,
                            check=False, env={**os.environ, **comma})
    assert (result.returncode, result.stderr) == (0, "")
    lines = result.stdout.splitlines()
    assert len(lines) == len(SUFFIXES)
    for suffix, line in zip(SUFFIXES, lines):
        numbers = np.array([float(x) for x in line.split()])
        np.testing.assert_allclose(numbers, [*volume.spacing, *volume.origin], rtol=1e-6)
        again = volumes.read(tmp_path / f"out{suffix}")
        np.testing.assert_allclose([*again.spacing, *again.origin], numbers, rtol=1e-6)
        np.testing.assert_array_equal(again.values, volume.values)
    lattice.deform("move:1,1,1:0.25,0.5,0.75")
    np.testing.assert_array_equal(hwffd.Lattice.read(tmp_path / "out.json").control_points,
                                  lattice.control_points)


@pytest.mark.parametrize("components", [1, 3])
@pytest.mark.parametrize("kind", ["f4", "f8"])
@pytest.mark.parametrize("how", [{}, {"packed": True}, {"order": ">"}, {"scl_slope": 2.0}])
def test_what_is_no_number_stays_so(kind, components, how, tmp_path):
    values = np.arange(60 * components, dtype=kind).reshape(*SHAPE, components)
    if components > 1:
        how = how | {"scl_slope": 1.0}
    values[1, 2, 3, components - 1] = np.nan
    values[2, 0, 4, 0] = np.inf
    values[0, 1, 0, 0] = -np.inf
    values = values if components > 1 else values[..., 0]
    path = tmp_path / f"a.nii{'.gz' if how.get('packed') else ''}"
    path.write_bytes(nifti(values, **how))
    volume = volumes.read(path)
    np.testing.assert_array_equal(volume.values, values * how.get("scl_slope", 1))
    for suffix in SUFFIXES:
        volumes.write(tmp_path / f"b{suffix}", volume)
        np.testing.assert_array_equal(volumes.read(tmp_path / f"b{suffix}").values, volume.values)
    lattice = volumes.lattice_over(volume)
    np.testing.assert_array_equal(volumes.warp(volume, lattice, order=0).values, volume.values)
    wrong = ~np.isfinite(volume.values)
    linear = volumes.warp(volume, lattice, order=1).values
    assert not np.isfinite(linear[wrong]).any() and np.isfinite(linear).sum() > wrong.sum()
    with pytest.raises(hwffd.Error, match="not finite, and a spline would spread them"):
        volumes.warp(volume, lattice)


@pytest.mark.parametrize("kind", ["u1", "i2", "f4", "f8"])
def test_a_scale_is_that_of_all_voxels_or_refused(kind, tmp_path):
    values = np.arange(60 * 3).astype(kind).reshape(*SHAPE, 3)
    path = tmp_path / "a.nii"
    path.write_bytes(nifti(values[..., 0], scl_slope=0.5, scl_inter=3))
    np.testing.assert_array_equal(volumes.read(path).values, values[..., 0] * 0.5 + 3)
    path.write_bytes(nifti(values))
    np.testing.assert_array_equal(volumes.read(path).values, values)
    path.write_bytes(nifti(values, scl_slope=0.5, scl_inter=3))
    with pytest.raises(hwffd.Error, match="a.nii: components with a scale, scl_slope"):
        volumes.read(path)


NAME = os.fsdecode(b"v\xe9")  # no UTF-8


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_names_are_bytes(suffix, tmp_path):
    folder = tmp_path / f"{NAME} folder"
    folder.mkdir()
    volume = phantom(np.int16)
    path = folder / f"{NAME}{suffix}"
    volumes.write(path, volume)
    volumes.write(folder / f"plain{suffix}", volume)
    for file in path, folder / f"plain{suffix}":
        np.testing.assert_array_equal(volumes.read(file).values, volume.values)
    result = warped(folder, path.name, "box", f"{NAME}out{suffix}", "--field", f"{NAME}field{suffix}",
                    "--order", "0", "--like", path.name)
    assert (result.returncode, result.stderr) == (0, b"")
    assert os.fsencode(f"wrote {NAME}out{suffix} and {NAME}field{suffix}\n") in result.stdout
    np.testing.assert_array_equal(volumes.read(folder / f"{NAME}out{suffix}").values, volume.values)
    assert {os.fsencode(entry.name)[:2] for entry in folder.iterdir()} <= {b"v\xe9", b"pl"}
    result = forked.run(folder, PROGRAM, f"{NAME}none{suffix}", "box", f"{NAME}out{suffix}")
    assert result.returncode == 1 and result.stderr.count("\n") == 1 and "is not there" in result.stderr


def test_words_of_the_command_are_bytes(tmp_path):
    volumes.write(tmp_path / "in.nrrd", phantom(np.int16))
    volumes.lattice_over(phantom()).write(tmp_path / f"{NAME}.json")
    result = warped(tmp_path, "in.nrrd", f"{NAME}.json", "out.nrrd", "--deform", f"to:{NAME}.json")
    assert (result.returncode, result.stderr) == (0, b"")
    for words in ([f"{NAME}none.json"], ["box", "--deform", f"to:{NAME}none.json"], ["box", "--deform", NAME],
                  ["box", "--device", NAME], ["box", "--outside", NAME],
                  ["box", "--device", "model", "--org", NAME], ["box", "--field", f"{NAME}/a.nrrd"],
                  ["box", "--dims", NAME]):
        lattice, *more = words
        result = forked.run(tmp_path, PROGRAM, "in.nrrd", lattice, "out.nrrd", *more)
        assert result.returncode in (1, 2) and result.stderr.startswith("hwffd-warp: "), result.stderr
        assert result.stderr.count("\n") == 1 and result.stdout == ""


KEYS = ["Segment0_Name:=liver", "modality:=CT", r"text:=two\nlines and a \\ more", "empty:=",
        r"folder:=C:\\new\\n", 'space units: "mm" "mm" "mm"', "content: a head", "old min: -1024"]
HELD = {"Segment0_Name": "liver", "modality": "CT", "text": "two\nlines and a \\ more", "empty": "",
        "folder": r"C:\new\n", "NRRD_space units": '"mm" "mm" "mm"', "NRRD_content": "a head", "NRRD_old min": "-1024"}


def lost(folder, source, target):
    """What hwffd warp says is dropped on the way from one file to another, and what is not."""
    result = forked.run(folder, PROGRAM, source, "box", target, "--order", "0")
    assert result.returncode == 0, result.stderr
    errors = result.stderr
    before = volumes.read(folder / source).metadata
    after = volumes.read(folder / target).metadata
    names = errors.removeprefix(f"hwffd-warp: warning: {target}: dropped: ").split(", ") if errors else []
    names = [name.strip() for name in names]
    assert errors.count("\n") == bool(names)
    assert {name for name, value in before.items() if after.get(name) != value} == set(names)
    return names, after


@pytest.mark.parametrize("name", ["a.nrrd", "a.nhdr"])
def test_keys_of_nrrd(name, tmp_path):
    lines = [*KEYS, "measurement frame: (0,1,0) (1,0,0) (0,0,1)"]
    (tmp_path / "a.raw").write_bytes(VALUES.tobytes())
    (tmp_path / name).write_bytes(nrrd(VALUES, lines, data="a.raw" if name == "a.nhdr" else ""))
    held = HELD | {"NRRD_measurement frame": "(0,1,0) (1,0,0) (0,0,1)"}
    assert volumes.read(tmp_path / name).metadata == held
    for target in "b.nrrd", "b.nhdr":
        assert lost(tmp_path, name, target) == ([], held)
    for target in "b.mha", "b.mhd":  # whose fields are a word and what is in a line
        names, after = lost(tmp_path, name, target)
        assert after == {"Segment0_Name": "liver", "modality": "CT", "folder": r"C:\new\n",
                         "NRRD_content": "a head"}
        assert sorted(names) == sorted(held.keys() - after.keys())
        assert lost(tmp_path, target, f"{target}.nrrd") == ([], after)
    for target in "b.nii", "b.nii.gz":
        assert sorted(lost(tmp_path, name, target)[0]) == sorted(held)


@pytest.mark.parametrize("space, frame", [("right-anterior-superior", "(-1,-2,3) (0,-1,0) (-4,0,1)"),
                                          ("RAS", "(-1,-2,3) (0,-1,0) (-4,0,1)"),
                                          ("left-anterior-superior", "(1,-2,3) (0,-1,0) (4,0,1)"),
                                          ("left-posterior-superior", "(1,2,3) (0,1,0) (4,0,1)")])
def test_a_measurement_frame_is_of_the_space_that_is_written(space, frame, tmp_path):
    (tmp_path / "a.nrrd").write_bytes(nrrd(VALUES, ["measurement frame: (1,2,3) (0,1,0) (4,0,1)"], space))
    assert lost(tmp_path, "a.nrrd", "b.nrrd") == ([], {"NRRD_measurement frame": frame})
    assert f"measurement frame: {frame}\n".encode() in (tmp_path / "b.nrrd").read_bytes()


def test_axes_of_nrrd_are_said_to_be_lost(tmp_path):
    (tmp_path / "a.nrrd").write_bytes(nrrd(VALUES, ['labels: "x" "y" "z"', "centerings: cell cell cell"]))
    assert lost(tmp_path, "a.nrrd", "b.nrrd") == (["NRRD_labels", "NRRD_centers"], {})


@pytest.mark.parametrize("name", ["a.mha", "a.mhd"])
def test_fields_of_metaimage(name, tmp_path):
    held = {"Comment": "a head of wax", "Modality": "MET_MOD_CT", "Scanner": "none = any"}
    (tmp_path / "a.raw").write_bytes(VALUES.tobytes())
    (tmp_path / name).write_bytes(meta(VALUES, [f"{k} = {v}" for k, v in held.items()],
                                       "a.raw" if name == "a.mhd" else "LOCAL"))
    for target in "b.mha", "b.mhd", "b.nrrd", "b.nhdr":
        assert lost(tmp_path, name, target) == ([], held)
    assert sorted(lost(tmp_path, name, "b.nii")[0]) == sorted(held)
    # A key with the name of a field that says how voxels are stored does not become one.
    (tmp_path / "c.nrrd").write_bytes(nrrd(VALUES, ["NDims:=7", "Modality:=CT", "two words:=1"]))
    assert lost(tmp_path, "c.nrrd", "c.mha") == (["NDims", "Modality", "two words"], {})


@pytest.mark.parametrize("order", "<>")
def test_fields_of_nifti(order, tmp_path):
    more = {"descrip": b"a head", "aux_file": b"a.lut", "intent_name": b"labels", "intent_code": 1002,
            "intent_p1": 0.5, "cal_max": 80.25, "toffset": 1.5, "qform_code": 2, "sform_code": 4}
    held = {name: value.decode() if isinstance(value, bytes) else str(value)
            for name, value in more.items()}
    (tmp_path / "a.nii").write_bytes(nifti(VALUES, None, order, **more))
    for target in "b.nii", "b.nii.gz":
        assert lost(tmp_path, "a.nii", target) == ([], held)
    for target in "b.nrrd", "b.mha":  # as pairs of key and value, and back
        assert lost(tmp_path, "a.nii", target) == ([], held)
        assert lost(tmp_path, target, f"{target}.nii") == ([], held)


def test_extensions_and_slices_of_nifti_are_said_to_be_lost(tmp_path):
    data = bytearray(nifti(VALUES, slice_code=3, vox_offset=368))
    data[348] = 1
    data[352:352] = (16).to_bytes(4, "little") + (6).to_bytes(4, "little") + b"comment\0"
    (tmp_path / "c.nii").write_bytes(data)
    np.testing.assert_array_equal(volumes.read(tmp_path / "c.nii").values, VALUES)
    assert lost(tmp_path, "c.nii", "d.nii") == (["slice_code", "extension"], {})


def test_values_that_a_line_of_nrrd_cannot_have_are_lost(tmp_path):
    for key in "text", "NRRD_content":
        with pytest.warns(UserWarning, match=rf"a\.nrrd: dropped: {key}"):
            volumes.write(tmp_path / "a.nrrd", volumes.Volume(VALUES, metadata={key: "one\rtwo"}))
        np.testing.assert_array_equal(volumes.read(tmp_path / "a.nrrd").values, VALUES)


def test_the_library_warns_of_what_is_lost(tmp_path):
    volume = volumes.Volume(VALUES, metadata={"kept": "1", "two\nlines": "2"})
    with pytest.warns(UserWarning, match=r"a\.nii: dropped: kept, two\nlines"):
        volumes.write(tmp_path / "a.nii", volume)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        volumes.write(tmp_path / "a.nrrd", volumes.Volume(VALUES, metadata={"kept": "1"}))
    assert volumes.read(tmp_path / "a.nrrd").metadata == {"kept": "1"}
