"""Headers of MetaImage files, .mha and .mhd.

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

import math
import pathlib
import re

from hwffd import Error
from hwffd.volumes.headers import Header, Voxels

# Of the grid and of how voxels are stored: what writes the file says these anew.
_STRUCTURE = {"ObjectType", "ObjectSubType", "NDims", "BinaryData", "BinaryDataByteOrderMSB",
              "ElementByteOrderMSB", "CompressedData", "CompressedDataSize", "CompressionLevel",
              "TransformMatrix", "Rotation", "Orientation", "Offset", "Position", "Origin",
              "CenterOfRotation", "AnatomicalOrientation", "ElementSpacing", "ElementSize", "DimSize",
              "HeaderSize", "HeaderSizePerSlice", "ElementNumberOfChannels", "ElementType",
              "ElementDataFile", "ElementMin", "ElementMax"}
# Of elements in a file, where a long has 4 bytes on every machine.
_SIZES = {"CHAR": 1, "UCHAR": 1, "SHORT": 2, "USHORT": 2, "INT": 4, "UINT": 4, "LONG": 4, "ULONG": 4,
          "LONG_LONG": 8, "ULONG_LONG": 8, "FLOAT": 4, "DOUBLE": 8}
_MOST_LINES = 100000


def _lines(path: pathlib.Path) -> tuple[list[tuple[str, str]], list[str], int]:
    """The fields of a header in their order, the lines behind them, and where its voxels begin."""
    fields: list[tuple[str, str]] = []
    with open(path, "rb") as stream:
        for _ in range(_MOST_LINES):
            name, equals, value = stream.readline(1 << 16).decode("utf-8", "surrogateescape").partition("=")
            if not equals:
                return [], [], 0
            fields.append((name.strip(), value.strip()))
            if fields[-1][0] == "ElementDataFile":
                begin = stream.tell()
                names = ([line.decode("utf-8", "surrogateescape").strip() for line in stream]
                         if value.strip().upper().startswith("LIST") else [])
                return fields, [name for name in names if name], begin
    return [], [], 0


def _is_true(text: str) -> bool:
    return text[:1].upper() in ("T", "1")


def _voxels(path: pathlib.Path, tags: dict[str, str], names: list[str], begin: int) -> Voxels | None:
    size = _SIZES.get(tags.get("ElementType", "").removeprefix("MET_").removesuffix("_ARRAY"))
    if size is None or not _is_true(tags.get("BinaryData", "True")):
        return None
    size *= math.prod(map(int, tags["DimSize"].split())) * int(tags.get("ElementNumberOfChannels", "1"))
    packed = "zlib" if _is_true(tags.get("CompressedData", "False")) else ""
    data = tags["ElementDataFile"]
    if data.upper() == "LOCAL":
        if packed and "CompressedDataSize" not in tags:
            raise Error(f"{path}: packed voxels without CompressedDataSize, which ITK reads wrongly; "
                        "write the file with it")
        return Voxels([path], begin, size, packed)
    if names:
        files = names
    elif "%" in data:
        pattern, first, last, *step = data.split()
        files = [pattern % number
                 for number in range(int(first), int(last) + 1, int(step[0]) if step else 1)]
    else:
        files = [data]
    skip = 0 if packed else max(0, int(tags.get("HeaderSize", "0")))
    return Voxels([path.parent / part for part in files], skip, size, packed)


def read(path: pathlib.Path) -> Header:
    """The header of a file; an empty one of what is none."""
    fields, names, begin = _lines(path)
    try:
        voxels = _voxels(path, dict(fields), names, begin)
    except (ValueError, KeyError, IndexError, TypeError):
        voxels = None  # a reader of the format says what is wrong
    return Header({name: value for name, value in fields
                   if name not in _STRUCTURE and (name, value) != ("Modality", "MET_MOD_UNKNOWN")},
                  voxels)


def carry(path: pathlib.Path, fields: dict[str, str]) -> None:
    """Adds to the header of a file what of such fields it can have."""
    lines = [f"{name} = {value}\n" for name, value in fields.items()
             if name not in _STRUCTURE and re.fullmatch(r"[^\s=%]+", name)
             and not re.search(r"[\r\n]|^\s|\s$|^$", value)
             and not (name == "Modality" and not value.startswith("MET_MOD_"))]
    data = path.read_bytes()
    at = re.search(rb"^DimSize", data, re.MULTILINE)
    if at and lines:
        added = "".join(lines).encode("utf-8", "surrogateescape")
        path.write_bytes(data[:at.start()] + added + data[at.start():])
