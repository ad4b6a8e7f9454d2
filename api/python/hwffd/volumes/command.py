"""The program hwffd-warp, which `hwffd warp` runs.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import contextlib
import os
import pathlib
import signal
import sys
import typing
import warnings
from collections.abc import Iterator, Sequence

from hwffd import Error, Lattice, UsageError, __version__, shapes
from hwffd.volumes.files import SUFFIXES, check_writable, read, write_all
from hwffd.volumes.splines import ORDERS
from hwffd.volumes.volume import Volume
from hwffd.volumes.warping import Warped, lattice_over, resample

NAME = "hwffd-warp"
FAILURE, USAGE = 1, 2

_EXAMPLES = """examples:
  hwffd warp head.nrrd box turned.nrrd --dims 6x6x6 --deform twist:30
  hwffd warp head.nii.gz rest.json moved.nii.gz --deform to:moved.json --field field.mha
  hwffd warp labels.mha box out.mha --deform bend:20:z --order 0 --device model --format fx32
"""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str):
        raise UsageError(f"{message}; see hwffd warp --help")


def _dims(text: str) -> tuple[int, ...]:
    try:
        dims = tuple(int(part) for part in text.split("x"))
    except ValueError:
        dims = ()
    if len(dims) != 3:
        raise argparse.ArgumentTypeError(f"'{text}'; give NSxNTxNU, such as 6x6x6")
    return dims


def _options(words: Sequence[str]) -> argparse.Namespace:
    parser = _Parser(
        prog="hwffd warp", epilog=_EXAMPLES, formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Resamples an image volume through a deformed lattice: each voxel of the output "
                    "has the value of the input where the deformation takes it.")
    add = parser.add_argument
    add("input", help=f"volume to read, one of {' '.join(SUFFIXES)}")
    add("lattice", help=f"lattice at rest: {', '.join(shapes())}, around the volume, or a file")
    add("output", help="volume to write, in the format that its suffix says")
    add("--dims", type=_dims, metavar="NSxNTxNU", help="control points of a shape along its axes")
    add("--deform", action="append", default=[], metavar="TEXT",
        help="twist:30, bend:20:z, random:1, to:FILE, ..., in order; see docs/lattice.md section 6")
    add("--outside", default="keep", metavar="TEXT",
        help="voxels outside the lattice: keep (default), clamp, fade:WIDTH")
    add("--order", type=int, choices=ORDERS, default=3,
        help="3: cubic splines (default), 1: linear, 0: nearest voxel")
    add("--default", type=float, default=0.0, metavar="NUMBER",
        help="value of voxels that come from beyond the input (default 0)")
    add("--field", metavar="FILE", help="displacement field to write, as ITK reads it")
    add("--like", metavar="FILE", help="volume whose grid the output has; else that of the input")
    add("--device", help="reference (default), model, rtl")
    add("--org", help="organization or row of model or rtl, as for hwffd deform")
    add("--format", help="number format of model or rtl: fp32 (default), bfp32, fx18, "
        "fx32, ...")
    add("--version", action="version", version=__version__)
    options = parser.parse_args(words)
    for option in "org", "format":
        if getattr(options, option) is not None and options.device is None:
            parser.error(f"--{option} requires --device, model or rtl")
    return options


def _lattice(options: argparse.Namespace, volume: Volume) -> Lattice:
    if options.lattice == "box":
        lattice = lattice_over(volume, options.dims or (4, 4, 4))
    elif options.lattice in shapes():
        last = [count - 0.5 for count in volume.counts]
        corners = [[x, y, z] for x in (-0.5, last[0]) for y in (-0.5, last[1])
                   for z in (-0.5, last[2])]
        lattice = Lattice.around(options.lattice, volume.points(corners), options.dims)
    elif options.dims:
        raise UsageError("--dims: a lattice file has its own; leave it out")
    else:
        lattice = Lattice.read(options.lattice)
    lattice.set_device(_word(options.device or "reference"), _word(options.org or "basic"),
                       _word(options.format or ""))
    lattice.set_outside(_word(options.outside))
    for deformation in options.deform:
        lattice.deform(_word(deformation))
    return lattice


def _word(text: str) -> str:
    """A word of the command line as the library takes it: the bytes where it is no UTF-8, such as to:FILE."""
    word = os.fsencode(text)
    try:
        return word.decode()
    except UnicodeDecodeError:
        return typing.cast(str, word)


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Keeps what readers print beside their errors from standard error."""
    saved = os.dup(2)
    nothing = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nothing, 2)
        yield
    finally:
        os.dup2(saved, 2)
        os.close(saved)
        os.close(nothing)


def _read(path: str) -> Volume:
    with _quiet():
        return read(path)


def _show(fraction: float) -> None:
    if sys.stderr.isatty():
        print(f"\r\033[K{'warp':<32} {100 * fraction:3.0f} %", end="\r\033[K" if fraction >= 1 else "",
              file=sys.stderr, flush=True)


def _check_outputs(options: argparse.Namespace) -> None:
    places = {}
    for option, path in ("output", options.output), ("--field", options.field):
        if path is None:
            continue
        check_writable(path)
        other = places.setdefault(pathlib.Path(path).resolve(), option)
        if other != option:
            raise UsageError(f"{option} {path}: {other} goes there already; name another file")


def _report(options: argparse.Namespace, lattice: Lattice, warped: Warped) -> str:
    dims = "x".join(map(str, lattice.dims))
    count = warped.volume.values.shape
    written = " and ".join(filter(None, (options.output, options.field)))
    return (f"lattice {dims}: {count[0] * count[1] * count[2]} voxels, {warped.outside_lattice} "
            f"outside it, {warped.outside_volume} from beyond the input\n"
            f"{lattice.device}\nwrote {written}")


def run(words: Sequence[str]) -> None:
    """The program, which throws what it does not do."""
    options = _options(words)
    _check_outputs(options)
    volume = _read(options.input)
    like = _read(options.like) if options.like else None
    lattice = _lattice(options, volume)
    warped = resample(volume, lattice, like=like, order=options.order, default=options.default,
                      with_field=options.field is not None, progress=_show)
    outputs = {options.output: warped.volume}
    if warped.field is not None:
        outputs[options.field] = warped.field
    with _quiet(), warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", UserWarning)
        write_all(outputs)
    for warning in caught:
        print(f"{NAME}: warning: {' '.join(str(warning.message).split())}", file=sys.stderr)
    print(_report(options, lattice, warped), flush=True)


def main() -> int:
    """The program; its exit status."""
    sys.stdout.reconfigure(errors="surrogateescape")  # names as they were given
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    try:
        run(sys.argv[1:])
        return 0
    except (Error, MemoryError, OSError) as error:
        text = " ".join(str(error).split()) or "out of memory; take a smaller volume"
        print(f"{NAME}: {text}", file=sys.stderr)
        return USAGE if isinstance(error, UsageError) else FAILURE
    except UnicodeDecodeError as error:  # a message of the library with a name that is no UTF-8
        print(f"{NAME}: {os.fsdecode(error.object)}", file=sys.stderr)
        return FAILURE
    except KeyboardInterrupt:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        os.kill(os.getpid(), signal.SIGINT)
        return FAILURE
