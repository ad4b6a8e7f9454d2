"""Headers of NIfTI files, of version 1, which is the one that ITK reads (nifti.nimh.nih.gov).

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

import gzip
import math
import os
import pathlib
import shutil
import struct
import zlib

import numpy as np
from numpy.typing import NDArray

from hwffd import Error
from hwffd.volumes.headers import Header, Voxels

_HEADER = np.dtype([
    ("sizeof_hdr", "i4"), ("data_type", "S10"), ("db_name", "S18"), ("extents", "i4"),
    ("session_error", "i2"), ("regular", "S1"), ("dim_info", "u1"), ("dim", "i2", 8),
    ("intent_p1", "f4"), ("intent_p2", "f4"), ("intent_p3", "f4"), ("intent_code", "i2"),
    ("datatype", "i2"), ("bitpix", "i2"), ("slice_start", "i2"), ("pixdim", "f4", 8),
    ("vox_offset", "f4"), ("scl_slope", "f4"), ("scl_inter", "f4"), ("slice_end", "i2"),
    ("slice_code", "u1"), ("xyzt_units", "u1"), ("cal_max", "f4"), ("cal_min", "f4"),
    ("slice_duration", "f4"), ("toffset", "f4"), ("glmax", "i4"), ("glmin", "i4"),
    ("descrip", "S80"), ("aux_file", "S24"), ("qform_code", "i2"), ("sform_code", "i2"),
    ("quatern", "f4", 3), ("qoffset", "f4", 3), ("srow", "f4", 12), ("intent_name", "S16"),
    ("magic", "S4")])
_CARRIED = ("descrip", "aux_file", "db_name", "intent_name", "intent_code", "intent_p1", "intent_p2",
            "intent_p3", "cal_max", "cal_min", "toffset", "qform_code", "sform_code")
# Of slices as they were acquired, which those of a volume that was resampled are not.
_OF_SLICES = ("slice_code", "slice_start", "slice_end", "slice_duration", "dim_info")
_WRITTEN = {"qform_code": "1", "sform_code": "1"}  # whatever else is said
_FLOATS = {16: "f4", 64: "f8"}
_OBLIQUE = 1e-3  # cosine between two directions from which on ITK writes others


def _header(path: pathlib.Path):
    """The record of a header, and whether extensions are behind it; None for what is none."""
    with (gzip.open if path.name.lower().endswith(".gz") else open)(path, "rb") as stream:
        data = stream.read(_HEADER.itemsize + 1)
    for order in "<>":
        if len(data) > _HEADER.itemsize and struct.unpack(order + "i", data[:4])[0] == _HEADER.itemsize:
            record = np.frombuffer(data[:-1], _HEADER.newbyteorder(order))[0]
            return record, data[-1] != 0
    return None


def _text(value) -> str:
    if isinstance(value, bytes):
        return value.split(b"\0")[0].decode("utf-8", "surrogateescape").strip()
    return f"{value:g}" if isinstance(value, np.floating) and value == 0 else str(value)


def _is_scaled(record) -> bool:
    slope, shift = float(record["scl_slope"]), float(record["scl_inter"])
    return math.isfinite(slope) and math.isfinite(shift) and slope != 0 and (slope, shift) != (1, 0)


def read(path: pathlib.Path) -> Header:
    """The header of a file; an empty one of what is none."""
    try:
        header = _header(path)
    except (OSError, EOFError, zlib.error):
        return Header()  # a reader of the format says what is wrong
    if header is None:
        return Header()
    record, extended = header
    fields = {}
    for name in _CARRIED + _OF_SLICES:
        text = _text(record[name])
        if text not in ("", "0", _WRITTEN.get(name)):
            fields[name] = text
    if extended:
        fields["extension"] = "1"
    dims = record["dim"]
    bits = int(record["bitpix"])
    count = int(dims[0])
    voxels = None
    if not 0 <= record["vox_offset"] < 2**62:
        return Header(fields)
    if count >= 5 and dims[5] > 1 and _is_scaled(record):
        raise Error(f"{path}: components with a scale, scl_slope, which ITK reads wrongly; write them "
                    "without one")
    if 1 <= count <= 7 and bits % 8 == 0 and bytes(record["magic"]).startswith(b"n+1"):
        size = math.prod(int(n) for n in dims[1:count + 1]) * bits // 8
        packed = "gzip" if path.name.lower().endswith(".gz") else ""
        voxels = Voxels([path], 0, int(record["vox_offset"]) + size, packed)
    return Header(fields, voxels)


def check_directions(path: os.PathLike[str] | str, direction: NDArray[np.float64]) -> None:
    """Refuses directions in whose place ITK writes others, which are at right angles."""
    if np.abs(direction.T @ direction - np.eye(3)).max() > _OBLIQUE:
        raise Error(f"{path}: NIfTI has directions at right angles, of length 1, and these are others; "
                    "write nrrd or mha")


def mend(path: pathlib.Path, values: NDArray[np.generic]) -> None:
    """Puts back into the values of a file what is not finite, of which ITK's reader makes zeros."""
    header = _header(path)
    voxels = read(path).voxels
    if header is None or voxels is None or values.dtype.kind != "f":
        return
    record, _ = header
    kind = _FLOATS.get(int(record["datatype"]))
    if kind is None:
        return
    order = record.dtype["sizeof_hdr"].byteorder
    raw = np.frombuffer(b"".join(voxels.chunks()), np.dtype(kind).newbyteorder(order), values.size,
                        int(record["vox_offset"]))
    original = np.moveaxis(raw.reshape(-1, *values.shape[:3]), 0, -1).reshape(values.shape)
    wrong = ~np.isfinite(original)
    values[wrong] = original[wrong] * (float(record["scl_slope"]) if _is_scaled(record) else 1.0)


def carry(path: pathlib.Path, fields: dict[str, str]) -> None:
    """Writes into the header of a file what of such fields it can have. The file is not packed."""
    header = _header(path)
    if header is None:
        return
    record = header[0].copy()
    for name in _CARRIED:
        if name not in fields:
            continue
        kind = record.dtype[name]
        text = fields[name].encode("utf-8", "surrogateescape")
        try:
            value = text if kind.kind == "S" else kind.type(float(text))
        except (ValueError, OverflowError):
            continue
        if kind.kind != "S" or len(text) < kind.itemsize:
            record[name] = value
    with open(path, "r+b") as stream:
        stream.write(record.tobytes())


def pack(path: pathlib.Path, to: pathlib.Path) -> None:
    """Makes a .nii.gz of a .nii, which goes."""
    with open(path, "rb") as source, open(to, "wb") as target:
        with gzip.GzipFile(filename="", fileobj=target, mode="wb", compresslevel=6, mtime=0) as stream:
            shutil.copyfileobj(source, stream, 1 << 20)
    path.unlink()
