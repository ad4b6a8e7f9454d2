"""Headers of NRRD files (teem.sourceforge.net/nrrd/format.html).

Fields of the format have the prefix NRRD_ among the fields of a volume, as ITK names them; pairs of
key and value do not.

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

import math
import pathlib
import re

from hwffd.volumes.headers import Header, Voxels

PREFIX = "NRRD_"

# Of the grid and of how voxels are stored: what writes the file says these anew.
_STRUCTURE = {"type", "block size", "dimension", "space", "space dimension", "sizes", "spacings",
              "axis mins", "axis maxs", "space directions", "space origin", "kinds", "endian",
              "encoding", "byte skip", "line skip", "data file", "number"}
# Of the others, those that hold of a volume that was resampled.
_CARRIED = {"content", "space units", "measurement frame", "sample units", "old min", "old max"}
_SPELLINGS = {"datafile": "data file", "blocksize": "block size", "byteskip": "byte skip",
              "lineskip": "line skip", "axismins": "axis mins", "axismaxs": "axis maxs",
              "centerings": "centers", "oldmin": "old min", "oldmax": "old max",
              "sampleunits": "sample units"}
_SIZES = {"char": 1, "short": 2, "int": 4, "long long": 8, "float": 4, "double": 8}
# Which axes of a space point against ITK's.
_TURNED = {"right-anterior-superior": (0, 1), "ras": (0, 1), "left-anterior-superior": (1,), "las": (1,)}
_PACKED = {"raw": "", "gzip": "gzip", "gz": "gzip"}
_MOST_LINES = 100000


def _size_of(kind: str) -> int | None:
    if bits := re.fullmatch(r"u?int(8|16|32|64)(_t)?", kind):
        return int(bits[1]) // 8
    plain = re.sub(r"^(signed|unsigned|u) ?| ?int$(?<!^int)", "", kind) or "int"
    return _SIZES.get({"longlong": "long long"}.get(plain, plain))


def _lines(path: pathlib.Path) -> tuple[list[str], int]:
    """The lines of the header, and where its voxels begin."""
    lines: list[str] = []
    with open(path, "rb") as stream:
        if not stream.read(8).startswith(b"NRRD000"):
            return [], 0
        stream.seek(0)
        for _ in range(_MOST_LINES):
            line = stream.readline()
            text = line.decode("utf-8", "surrogateescape").rstrip("\r\n")
            if not line or not text:
                break
            lines.append(text)
        return lines, stream.tell()


def _in_space_of_itk(frame: str, space: str) -> str:
    """A measurement frame, whose vectors are of the file's space, in that of ITK."""
    turned = _TURNED.get(space.lower(), ())
    vectors = [[float(number) for number in vector.split(",")]
               for vector in re.findall(r"\(([^)]*)\)", frame)]
    for vector in vectors if turned else []:
        for axis in turned:
            vector[axis] = -vector[axis] or 0.0
    return " ".join(f"({','.join(f'{x:.17g}' for x in vector)})" for vector in vectors)


def _voxels(path: pathlib.Path, tags: dict[str, str], begin: int, names: list[str]) -> Voxels | None:
    size = _size_of(tags.get("type", "").lower())
    packed = _PACKED.get(tags.get("encoding", "").lower())
    if size is None or packed is None or int(tags.get("line skip", "0")):
        return None
    size *= math.prod(map(int, tags["sizes"].split()))
    skip = max(0, int(tags.get("byte skip", "0")))
    data = tags.get("data file")
    if data is None:
        return Voxels([path], begin + (0 if packed else skip), size, packed)
    if data.split()[0] == "LIST":
        files = names
    elif numbered := re.fullmatch(r"(.*%.*d.*) (-?\d+) (-?\d+) (-?\d+)( \d+)?", data):
        first, last, step = map(int, numbered.group(2, 3, 4))
        files = [numbered[1] % number for number in range(first, last + (1 if step > 0 else -1), step)]
    else:
        files = [data]
    return Voxels([path.parent / part for part in files], 0 if packed else skip, size, packed)


def read(path: pathlib.Path) -> Header:
    """The header of a file; an empty one of what is none."""
    lines, begin = _lines(path)
    tags: dict[str, str] = {}
    fields: dict[str, str] = {}
    names: list[str] = []
    for line in lines[1:]:
        if tags.get("data file", "").startswith("LIST"):
            names.append(line)
        elif line.startswith("#"):
            continue
        elif ":=" in line:
            key, value = line.split(":=", 1)
            fields[key] = re.sub(r"\\(n|\\)", lambda pair: "\n" if pair[1] == "n" else "\\", value)
        elif ": " in line:
            name, value = line.split(": ", 1)
            tags[_SPELLINGS.get(name.lower(), name.lower())] = value.strip()
    try:
        voxels = _voxels(path, tags, begin, names)
        if "measurement frame" in tags:
            tags["measurement frame"] = _in_space_of_itk(tags["measurement frame"],
                                                         tags.get("space", ""))
    except (ValueError, KeyError, IndexError, TypeError, ZeroDivisionError):
        voxels = None  # a reader of the format says what is wrong
    return Header(fields | {PREFIX + name: value for name, value in tags.items()
                            if name not in _STRUCTURE}, voxels)


def carry(path: pathlib.Path, fields: dict[str, str]) -> None:
    """Adds to the header of a file what of such fields it can have."""
    lines = []
    for key, value in fields.items():
        name = key.removeprefix(PREFIX)
        if name != key:
            if name in _CARRIED and not re.search(r"[\r\n]", value):
                lines.append(f"{name}: {value}")
        elif not re.search(r":=|[\r\n]|^#", key) and "\r" not in value:
            escaped = value.replace("\\", "\\\\").replace("\n", "\\n")
            lines.append(f"{key}:={escaped}")
    data = path.read_bytes()
    end = re.search(rb"\r?\n(?=\r?\n|\Z)", data)
    if end and lines:
        added = "".join(f"\n{line}" for line in lines).encode("utf-8", "surrogateescape")
        path.write_bytes(data[:end.start()] + added + data[end.start():])
