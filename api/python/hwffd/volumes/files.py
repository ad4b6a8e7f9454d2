"""Volumes in files, by SimpleITK: NRRD, MetaImage and NIfTI.

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

import gzip
import os
import pathlib
import re
import shutil
import stat
import tempfile
import zlib
from collections.abc import Mapping

from hwffd import Error, UsageError
from hwffd.volumes.itk import from_itk, simple_itk, to_itk
from hwffd.volumes.volume import Volume

SUFFIXES = (".nrrd", ".nhdr", ".mha", ".mhd", ".nii", ".nii.gz")
_AT_ONCE = 1 << 20


def check_suffix(path: os.PathLike[str] | str) -> None:
    """Refuses a name whose suffix is that of no format."""
    if not str(path).lower().endswith(SUFFIXES):
        raise UsageError(f"{path}: no format of volumes; one of {' '.join(SUFFIXES)}")


def _reason(error: RuntimeError) -> str:
    """What ITK says last, in a line without where in its sources that is."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    return re.sub(r"^(sitk::ERROR|ITK ERROR|Reason): *(\w+\(0x\w+\): *)?", "", lines[-1])[:160]


def _check_length(path: pathlib.Path, reader) -> None:
    """Refuses a NIfTI file that ends early, of which ITK makes a volume with zeros at its end."""
    if not reader.HasMetaDataKey("vox_offset"):
        return
    size = reader.GetNumberOfComponents()
    for count in reader.GetSize():
        size *= count
    wanted = int(float(reader.GetMetaData("vox_offset")))
    wanted += size * int(reader.GetMetaData("bitpix")) // 8
    found = path.stat().st_size
    if path.name.lower().endswith(".gz"):
        found = 0
        try:
            with gzip.open(path) as stream:
                while part := stream.read(_AT_ONCE):
                    found += len(part)
        except (EOFError, zlib.error) as error:
            raise Error(f"{path}: is damaged or ends early; copy it again") from error
    if found < wanted:
        raise Error(f"{path}: ends after {found} of {wanted} bytes; copy it again")


def read(path: os.PathLike[str] | str) -> Volume:
    """The volume in a file: three dimensions of integers or floats, with components or without."""
    check_suffix(path)
    path = pathlib.Path(path)
    if not path.is_file():
        raise Error(f"{path}: {'no file' if path.exists() else 'is not there'}; name a volume")
    reader = simple_itk().ImageFileReader()
    reader.SetFileName(str(path))
    try:
        reader.ReadImageInformation()
        if reader.GetDimension() == 3:
            _check_length(path, reader)
        return from_itk(reader.Execute())
    except UsageError as error:
        raise Error(f"{path}: {error}") from error
    except (OSError, RuntimeError) as error:
        if isinstance(error, Error):
            raise
        raise Error(f"{path}: cannot be read: {_reason(error)}") from error


def check_writable(path: os.PathLike[str] | str) -> None:
    """Refuses a file that cannot be written, before there is work to lose."""
    check_suffix(path)
    place = pathlib.Path(path).resolve()
    if not os.access(place.parent, os.W_OK | os.X_OK):
        raise Error(f"{path}: its folder cannot be written to; name another")
    if place.is_dir():
        raise Error(f"{path}: is a folder; name a file")
    if place.exists() and not place.stat().st_mode & stat.S_IWUSR:
        raise Error(f"{path}: is read-only; name another file, or make it writable")


def write(path: os.PathLike[str] | str, volume: Volume) -> None:
    """Writes a volume to a file whose suffix says in which format. It is there whole or not at all."""
    write_all({path: volume})


def write_all(volumes: Mapping[os.PathLike[str] | str, Volume]) -> None:
    """Writes several files, none of which takes its name before all are written."""
    itk = simple_itk()
    folders = []
    try:
        for path, volume in volumes.items():
            check_writable(path)
            place = pathlib.Path(path).resolve()
            folders.append((tempfile.mkdtemp(prefix=f".{place.name}.", dir=place.parent), place))
            itk.WriteImage(to_itk(volume), os.path.join(folders[-1][0], place.name), True)
        for folder, place in folders:
            _move(pathlib.Path(folder), place)
    except (OSError, RuntimeError) as error:
        if isinstance(error, Error):
            raise
        raise Error(f"{path}: cannot be written: {_reason(error)}") from error
    finally:
        for folder, _ in folders:
            shutil.rmtree(folder, ignore_errors=True)


def _move(folder: pathlib.Path, place: pathlib.Path) -> None:
    """Gives what was written its name: voxels first, then the header that names them."""
    for part in sorted(folder.iterdir(), key=lambda part: part.name == place.name):
        target = place.with_name(part.name)
        if target.exists():
            part.chmod(stat.S_IMODE(target.stat().st_mode))
        os.replace(part, target)
