"""What the header of a volume's file says: where its voxels are, so that a file that ends early is
found, and its fields, so that they can be carried to another file.

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

import dataclasses
import gzip
import pathlib
import zlib
from collections.abc import Iterator, Sequence

from hwffd import Error

_AT_ONCE = 1 << 20


@dataclasses.dataclass(frozen=True)
class Voxels:
    """The bytes of a file's voxels."""

    parts: Sequence[pathlib.Path]  #: one file, or one for each of the slices
    skip: int                      #: bytes before them in each part
    size: int                      #: of all, unpacked
    packed: str = ""               #: "gzip", "zlib", or not at all

    def chunks(self) -> Iterator[bytes]:
        """The unpacked bytes in turn; EOFError or zlib.error where packed ones are damaged."""
        for part in self.parts:
            with open(part, "rb") as stream:
                stream.seek(self.skip)
                if self.packed == "zlib":
                    yield from _inflated(stream)
                    continue
                source = gzip.GzipFile(fileobj=stream) if self.packed else stream
                while chunk := source.read(_AT_ONCE):
                    yield chunk

    def check(self, path: pathlib.Path) -> None:
        """Refuses a file whose voxels are not there or end early, of which readers make zeros."""
        for part in self.parts:
            if not part.is_file():
                raise Error(f"{path}: its voxels are in {part.name}, which is not there; copy that, too")
        try:
            available = (sum(map(len, self.chunks())) if self.packed else
                         sum(max(0, part.stat().st_size - self.skip) for part in self.parts))
        except (EOFError, zlib.error, gzip.BadGzipFile) as error:
            raise Error(f"{path}: is damaged or ends early; copy it again") from error
        if available < self.size:
            raise Error(f"{path}: ends after {available + self.skip} of {self.size + self.skip} bytes; "
                        "copy it again")


@dataclasses.dataclass(frozen=True)
class Header:
    """A header, as far as this package reads it itself."""

    fields: dict[str, str] = dataclasses.field(default_factory=dict)
    #: What it says beyond the grid of voxels and how they are stored.
    voxels: Voxels | None = None
    #: None where only a reader of the format knows.


def _inflated(stream) -> Iterator[bytes]:
    inflate = zlib.decompressobj(wbits=zlib.MAX_WBITS | 32)
    while not inflate.eof:
        chunk = stream.read(_AT_ONCE)
        if not chunk:
            raise EOFError
        yield inflate.decompress(chunk)
