"""Volumes in files, by SimpleITK: NRRD, MetaImage and NIfTI.

SPDX-License-Identifier: Apache-2.0
"""

from __future__ import annotations

import contextlib
import dataclasses
import itertools
import os
import pathlib
import re
import shutil
import stat
import tempfile
import warnings
from collections.abc import Callable, Iterator, Mapping

from hwffd import Error, UsageError
from hwffd.volumes import metaimage, nifti, nrrd
from hwffd.volumes.itk import from_itk, simple_itk, to_itk
from hwffd.volumes.links import plain_link
from hwffd.volumes.locales import plain_numbers
from hwffd.volumes.volume import Volume

# The module that knows the headers of each format.
_FORMATS = {".nrrd": nrrd, ".nhdr": nrrd, ".mha": metaimage, ".mhd": metaimage, ".nii": nifti,
            ".nii.gz": nifti}
SUFFIXES = tuple(_FORMATS)


def check_suffix(path: os.PathLike[str] | str) -> None:
    """Refuses a name whose suffix is that of no format."""
    if not str(path).lower().endswith(SUFFIXES):
        raise UsageError(f"{path}: no format of volumes; one of {' '.join(SUFFIXES)}")


def _reason(error: RuntimeError) -> str:
    """What ITK says last, in a line without where in its sources that is."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    return re.sub(r"^(sitk::ERROR|ITK ERROR|Reason): *(\w+\(0x\w+\): *)?", "", lines[-1])[:160]


def _suffix_of(name: str) -> str:
    return next(suffix for suffix in SUFFIXES if name.lower().endswith(suffix))


def _is_utf8(path: pathlib.Path) -> bool:
    try:
        str(path).encode()
    except UnicodeEncodeError:
        return False
    return True


@contextlib.contextmanager
def _name_for_itk(path: pathlib.Path) -> Iterator[str]:
    """A name by which ITK reads a file and no other: of a.nii and a.nii.gz it takes the first, and it
    takes no name that is no UTF-8. Such a file is read through a link, which is alone or, where a
    header may name other files, among links to what lies beside it."""
    suffix = _suffix_of(path.name)
    alone = _FORMATS[suffix] is nifti
    if not alone and _is_utf8(path):
        yield str(path)
        return
    with tempfile.TemporaryDirectory(prefix="hwffd-") as folder:
        names = {path.name} if alone else set(os.listdir(path.absolute().parent))
        for name in names - {path.name}:
            os.symlink(path.absolute().with_name(name), os.path.join(folder, name))
        link = next(link for n in itertools.count() if (link := f"volume{n}{suffix}") not in names)
        os.symlink(path.absolute(), os.path.join(folder, link))
        yield os.path.join(folder, link)


def read(path: os.PathLike[str] | str) -> Volume:
    """The volume in a file: three dimensions of integers or floats, with components or without.

    What else its header says is in Volume.metadata."""
    check_suffix(path)
    path = pathlib.Path(path)
    if not path.is_file():
        raise Error(f"{path}: {'no file' if path.exists() else 'is not there'}; name a volume")
    itk = simple_itk()
    form = _FORMATS[_suffix_of(path.name)]
    name = str(path)
    try:
        header = form.read(path)
        if header.voxels:
            header.voxels.check(path)
        with _name_for_itk(path) as name, plain_numbers():
            reader = itk.ImageFileReader()
            reader.SetFileName(name)
            volume = from_itk(reader.Execute())
        if form is nifti:
            nifti.mend(path, volume.values)
        return dataclasses.replace(volume, metadata=header.fields)
    except UsageError as error:
        raise Error(f"{path}: {error}") from error
    except (OSError, RuntimeError) as error:
        if isinstance(error, Error):
            raise
        raise Error(f"{path}: cannot be read: {_reason(error).replace(name, str(path))}") from error


def check_writable(path: os.PathLike[str] | str) -> None:
    """Refuses a file of a volume that cannot be written, before there is work to lose."""
    check_suffix(path)
    check_place(path)


def check_place(path: os.PathLike[str] | str) -> None:
    """Refuses a file of any kind that cannot be written."""
    place = pathlib.Path(path).resolve()
    if not os.access(place.parent, os.W_OK | os.X_OK):
        raise Error(f"{path}: its folder cannot be written to; name another")
    if place.is_dir():
        raise Error(f"{path}: is a folder; name a file")
    if place.exists() and not place.stat().st_mode & stat.S_IWUSR:
        raise Error(f"{path}: is read-only; name another file, or make it writable")


def write(path: os.PathLike[str] | str, volume: Volume) -> None:
    """Writes a volume to a file whose suffix says in which format. It is there whole or not at all.

    A UserWarning names what of Volume.metadata the format does not hold."""
    write_all({path: volume})


def write_all(volumes: Mapping[os.PathLike[str] | str, Volume],
              others: Mapping[os.PathLike[str] | str, Callable[[str], None]] | None = None) -> None:
    """Writes several files, none of which takes its name before all are written.

    others: files that are no volumes, each with what writes it by the name of a new file."""
    folders: list[tuple[pathlib.Path, pathlib.Path]] = []
    dropped: dict[os.PathLike[str] | str, list[str]] = {}
    try:
        for path, volume in volumes.items():
            check_writable(path)
            place = pathlib.Path(path).resolve()
            if _FORMATS[_suffix_of(place.name)] is nifti:
                nifti.check_directions(path, volume.direction)
            folder = _folder_beside(place)
            folders.append((folder, place))
            _write_to(folder, place.name, volume)
            held = _FORMATS[_suffix_of(place.name)].read(folder / place.name).fields
            dropped[path] = [name for name, value in volume.metadata.items() if held.get(name) != value]
        for path, write_new in (others or {}).items():
            check_place(path)
            place = pathlib.Path(path).resolve()
            folder = _folder_beside(place)
            folders.append((folder, place))
            _write_other(folder, place.name, write_new)
        for folder, place in folders:
            _move(folder, place)
    except (OSError, RuntimeError) as error:
        if isinstance(error, Error):
            raise
        raise Error(f"{path}: cannot be written: {_reason(error)}") from error
    finally:
        for folder, _ in folders:
            shutil.rmtree(folder, ignore_errors=True)
    for path, names in dropped.items():
        if names:
            warnings.warn(f"{path}: dropped: {', '.join(names)}", UserWarning, stacklevel=3)


def _folder_beside(place: pathlib.Path) -> pathlib.Path:
    """A new folder beside a file, whose own name may be as long as names can be."""
    return pathlib.Path(tempfile.mkdtemp(prefix=f".{place.name[:50]}.", dir=place.parent))


def _write_to(folder: pathlib.Path, name: str, volume: Volume) -> None:
    """Writes a volume, and beside it its voxels where the format has them apart, into a folder.

    ITK knows them by a name that is UTF-8 and leads there by a link."""
    suffix = _suffix_of(name)
    form = _FORMATS[suffix]
    pack_later = suffix == ".nii.gz" and bool(volume.metadata)
    header = folder / f"volume{'.nii' if pack_later else suffix}"
    with plain_link(folder, "folder") as link, plain_numbers():
        simple_itk().WriteImage(to_itk(volume), os.path.join(link, header.name), True)
    stem = name[:-len(suffix)]
    if suffix in (".nhdr", ".mhd"):
        header.write_bytes(header.read_bytes().replace(b" volume.", b" " + os.fsencode(stem) + b"."))
    if volume.metadata:
        form.carry(header, volume.metadata)
    if pack_later:
        nifti.pack(header, folder / f"volume{suffix}")
    for part in list(folder.iterdir()):
        end = part.name.removeprefix("volume")
        part.rename(folder / (name if end == suffix else stem + end))


def _write_other(folder: pathlib.Path, name: str, write_new: Callable[[str], None]) -> None:
    """Has a file written under a name that any library takes, into a folder."""
    new = f"new{pathlib.PurePath(name).suffix}"
    with plain_link(folder, "folder") as link:
        write_new(os.path.join(link, new))
    (folder / new).rename(folder / name)


def _move(folder: pathlib.Path, place: pathlib.Path) -> None:
    """Gives what was written its name: voxels first, then the header that names them."""
    for part in sorted(folder.iterdir(), key=lambda part: part.name == place.name):
        target = place.with_name(part.name)
        if target.exists():
            part.chmod(stat.S_IMODE(target.stat().st_mode))
        os.replace(part, target)
