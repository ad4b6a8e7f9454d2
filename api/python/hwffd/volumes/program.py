"""What the programs hwffd-warp and hwffd-register have in common.

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
from collections.abc import Callable, Iterator, Mapping, Sequence

from hwffd import Error, Lattice, UsageError, __version__
from hwffd.volumes.files import check_place, read
from hwffd.volumes.volume import Volume

FAILURE, USAGE = 1, 2


class Parser(argparse.ArgumentParser):
    """Of `hwffd NAME`, whose errors are UsageErrors."""

    def __init__(self, name: str, description: str, examples: str) -> None:
        super().__init__(prog=f"hwffd {name}", description=description, epilog=examples,
                         formatter_class=argparse.RawDescriptionHelpFormatter)

    def error(self, message: str) -> typing.NoReturn:
        raise UsageError(f"{message}; see {self.prog} --help")

    def add_device(self, default: str = "fp32") -> None:
        """The options that choose a device, and --version. default: of model and rtl."""
        self.add_argument("--device", help="reference (default), model, rtl")
        self.add_argument("--org", help="organization or row of model or rtl, as for hwffd deform")
        self.add_argument("--format", help=f"number format of model or rtl: fp32, bfp32, fx18, fx32, ... (default {default})")
        self.add_argument("--version", action="version", version=__version__)

    def parse(self, words: Sequence[str]) -> argparse.Namespace:
        """What words say, with --org and --format for a device alone."""
        options = self.parse_args(words)
        for option in "org", "format":
            if getattr(options, option) is not None and options.device is None:
                self.error(f"--{option} requires --device, model or rtl")
        return options


def word(text: str) -> str:
    """A word of the command line as the library takes it: the bytes where it is no UTF-8, such as to:FILE."""
    given = os.fsencode(text)
    try:
        return given.decode()
    except UnicodeDecodeError:
        return typing.cast(str, given)


@contextlib.contextmanager
def quiet() -> Iterator[None]:
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


def read_quietly(path: str) -> Volume:
    """A volume of a file."""
    with quiet():
        return read(path)


def show(line: str, last: bool = False) -> None:
    """Progress, on a terminal."""
    if sys.stderr.isatty():
        print(f"\r\033[K{line}", end="\r\033[K" if last else "", file=sys.stderr, flush=True)


def check_outputs(outputs: Mapping[str, str | None], inputs: Mapping[str, str | None],
                  check: Callable[[str, str], None] = lambda option, path: check_place(path)) -> None:
    """Refuses, before there is work to lose, files that cannot be written, two of one name, and inputs.

    outputs, inputs: by option, the files; None: not wanted."""
    places = {}
    read_from = {pathlib.Path(path).resolve(): option for option, path in inputs.items() if path}
    for option, path in outputs.items():
        if path is None:
            continue
        check(option, path)
        place = pathlib.Path(path).resolve()
        other = places.setdefault(place, option)
        if other != option:
            raise UsageError(f"{option} {path}: {other} goes there already; name another file")
        if place in read_from:
            raise UsageError(f"{option} {path}: is {read_from[place]}; name another file")


@contextlib.contextmanager
def printed_warnings(name: str) -> Iterator[None]:
    """Prints warnings of the library, a line each, when it is done."""
    with quiet(), warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", UserWarning)
        yield
    for warning in caught:
        print(f"{name}: warning: {' '.join(str(warning.message).split())}", file=sys.stderr)


def set_device(lattice: Lattice, options: argparse.Namespace) -> None:
    """The device that the options say."""
    lattice.set_device(word(options.device or "reference"), word(options.org or "basic"),
                       word(options.format or ""))


def run_program(name: str, run: Callable[[Sequence[str]], "int | None"]) -> int:
    """The exit status of a program, whose errors are a line on standard error."""
    for number, stream in (1, "stdout"), (2, "stderr"):
        if getattr(sys, stream) is None:  # it was closed
            os.dup2(os.open(os.devnull, os.O_WRONLY), number)
            setattr(sys, stream, open(number, "w", encoding="utf-8", closefd=False))  # pylint: disable=consider-using-with
    sys.stdout.reconfigure(errors="surrogateescape")  # names as they were given
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    try:
        return run(sys.argv[1:]) or 0
    except (Error, MemoryError, OSError) as error:
        text = " ".join(str(error).split()) or "out of memory; take a smaller volume"
        print(f"{name}: {text}", file=sys.stderr)
        return USAGE if isinstance(error, UsageError) else FAILURE
    except UnicodeDecodeError as error:  # a message of the library with a name that is no UTF-8
        print(f"{name}: {os.fsdecode(error.object)}", file=sys.stderr)
        return FAILURE
    except KeyboardInterrupt:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        os.kill(os.getpid(), signal.SIGINT)
        return FAILURE
