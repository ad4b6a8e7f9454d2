"""The program hwffd-register, which `hwffd register` runs.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import math
import pathlib
import re
import signal
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from hwffd import Lattice, UsageError, set_threads
from hwffd.volumes import pictures, transforms
from hwffd.volumes.files import SUFFIXES, check_place, check_writable, write_all
from hwffd.volumes.program import (Parser, check_outputs, printed_warnings, quiet, read_quietly,
                                   run_program,
                                   show, word)
from hwffd.volumes.registration import METRICS, Registration, register
from hwffd.volumes.splines import ORDERS
from hwffd.volumes.volume import Volume
from hwffd.volumes.warping import determinants, displacement_field, warp

NAME = "hwffd-register"
_STOPPED = 128 + signal.SIGINT
_FIELD_TYPES = {"float32": np.float32, "float64": np.float64}

_EXAMPLES = """examples:
  hwffd register fixed.nii.gz moving.nii.gz -o warped.nii.gz --lattice-out field.json
  hwffd register a.mha b.mha -o w.mha --spacing 10mm --metric mutual-information --penalty 0.1 --no-folds
  hwffd register a.nrrd b.nrrd --start rigid.tfm --transform out.tfm --picture seen.png
"""


def _spacing(text: str) -> tuple[list[float], str]:
    match = re.fullmatch(r"([0-9.ex+]+?)(mm)?", text)
    try:
        numbers = [float(part) for part in match[1].split("x")] if match else []
    except ValueError:
        numbers = []
    if len(numbers) not in (1, 3) or not all(0 < number < math.inf for number in numbers):
        raise argparse.ArgumentTypeError(f"'{text}'; give voxels, 16 or 16x16x8, or lengths, 20mm")
    return numbers * (3 // len(numbers)), "length" if match and match[2] else "voxels"


def _options(words: Sequence[str]) -> argparse.Namespace:
    parser = Parser(
        "register",
        "Aligns a moving volume with a fixed one: finds the deformed lattice over the fixed one "
        "that takes each of its points to the point of the moving one with the same content.",
        _EXAMPLES)
    add = parser.add_argument
    volume = f"one of {' '.join(SUFFIXES)}"
    add("fixed", help=f"volume that stays, {volume}")
    add("moving", help="volume that is moved")
    add("-o", "--output", metavar="FILE", help="the moving volume as the fixed one has it")
    add("--lattice-out", metavar="FILE", help="lattice, at rest and deformed, .json")
    add("--transform", metavar="FILE", help=f"the same as ITK reads it, {' or '.join(transforms.SUFFIXES)}")
    add("--field", metavar="FILE", help=f"displacement field, {volume}")
    add("--field-type", choices=_FIELD_TYPES, default="float32", help="of its numbers (default float32)")
    add("--jacobian", metavar="FILE", help="map of det J, below 1 where volume shrinks")
    add("--picture", metavar="FILE", help="fixed, before, after, checkerboard and grid, .png")
    add("--curve", metavar="FILE", help="metric and penalties of each iteration, .csv")
    add("--spacing", type=_spacing, default=(None, "voxels"), metavar="N[xNxN][mm]",
        help="of control points, in voxels of the fixed volume or in mm (default 16, or what there is)")
    add("--levels", type=int, default=0, help="of the image pyramid (default: up to 3)")
    add("--sharp", action="store_true", help="do not smooth the volumes of the finest level")
    add("--metric", choices=METRICS, default=METRICS[0], help=f"default {METRICS[0]}")
    add("--bins", type=int, default=32, help="of mutual-information, a side (default 32)")
    add("--penalty", type=float, default=0.0, metavar="WEIGHT", help="of the bending energy (default 0)")
    add("--no-folds", action="store_true", help="allow no fold, which is proved")
    add("--mask", metavar="FILE", help="voxels of the fixed volume that count, those not 0")
    add("--moving-mask", metavar="FILE", help="the same of the moving volume")
    add("--start", metavar="FILE", help="affine transform of ITK (.tfm, .txt, .h5, .mat), or a lattice "
        "(.json) of an earlier registration")
    add("--iterations", type=int, default=50, help="most a level (default 50)")
    add("--tolerance", type=float, default=1e-4, help="ends a level (default 1e-4)")
    add("--order", type=int, choices=ORDERS, default=3, help="of the output's values: 3, 1 or 0")
    add("--default", type=float, default=0.0, metavar="NUMBER",
        help="of output voxels that come from beyond the moving volume (default 0)")
    add("--threads", type=int, default=0, help="no result depends on it (default: all cores)")
    parser.add_device("walk in fx17")
    return parser.parse(words)


def _check(option: str, path: str) -> None:
    suffixes = {"--transform": transforms.SUFFIXES, "--picture": (".png",), "--curve": (".csv",),
                "--lattice-out": (".json",)}.get(option)
    if suffixes is None:
        check_writable(path)
        return
    if not path.endswith(suffixes):
        raise UsageError(f"{option} {path}: give a name that ends with {' or '.join(suffixes)}")
    check_place(path)


class _Progress:
    """A line on a terminal; Ctrl-C ends the registration with the best lattice so far, twice the program."""

    def __init__(self) -> None:
        self.stopped = False
        self.shown = 0.0
        self.before = signal.signal(signal.SIGINT, self.stop)

    def stop(self, *_: object) -> None:
        self.stopped = True
        signal.signal(signal.SIGINT, self.before)

    def __call__(self, state: dict[str, Any]) -> bool:
        now = time.monotonic()
        if now - self.shown > 0.1:
            self.shown = now
            rate = state["voxels"] / max(state["seconds"], 1e-9) / 1e6
            show(f"level {state['level'] + 1}/{state['levels']} iteration {state['iteration']:3d} "
                 f"metric {state['metric']:.6f} {rate:6.1f} million voxels/s")
        return not self.stopped

    def end(self) -> None:
        show("", last=True)
        signal.signal(signal.SIGINT, self.before)


def _start(path: str | None) -> "Lattice | np.ndarray | None":
    if path is None:
        return None
    if pathlib.Path(path).suffix.lower() == ".json":
        return Lattice.read(word(path))
    with quiet():
        return transforms.read_affine(path)


def _report(result: Registration, written: Sequence[str]) -> str:
    dims = "x".join(map(str, result.lattice.dims))
    rate = result.voxels / max(result.seconds, 1e-9) / 1e6
    least, most = result.jacobian
    return (f"lattice {dims}: metric {result.metric_start:.6f} -> {result.metric_end:.6f}, "
            f"{result.evaluations} evaluations of {result.voxels} voxels in {result.seconds:.2f} s, "
            f"{rate:.1f} million/s\n"
            f"det J {least:.3f} to {most:.3f}, folds: {result.folds}; {100 * result.overlap:.1f} % of the fixed "
            f"volume counted\n{result.lattice.device}\n"
            + (f"wrote {', '.join(written)}" if written else "wrote nothing: name a file, such as -o FILE"))


def _others(options: argparse.Namespace, fixed: Volume, moving: Volume,
            result: Registration) -> dict[str, Callable[[str], None]]:
    lattice = result.lattice
    writers = {options.lattice_out: lattice.write,
               options.transform: lambda path: transforms.write_transform(path, lattice),
               options.picture: lambda path: pictures.write_picture(path, fixed, moving, lattice),
               options.curve: lambda path: pictures.write_curve(path, result.history)}
    return {path: write for path, write in writers.items() if path is not None}


def run(words: Sequence[str]) -> int:
    """The program, which throws what it does not do."""
    options = _options(words)
    outputs = {"--output": options.output, "--lattice-out": options.lattice_out,
               "--transform": options.transform, "--field": options.field,
               "--jacobian": options.jacobian, "--picture": options.picture, "--curve": options.curve}
    inputs = {"the fixed volume": options.fixed, "the moving volume": options.moving,
              "--mask": options.mask, "--moving-mask": options.moving_mask, "--start": options.start}
    check_outputs(outputs, inputs, _check)
    set_threads(options.threads)
    fixed, moving = read_quietly(options.fixed), read_quietly(options.moving)
    if moving.values.dtype.kind != "f" and not math.isfinite(options.default):
        raise UsageError(f"--default {options.default}: no integer; give a number that voxels can have")
    masks = [read_quietly(path) if path else None for path in (options.mask, options.moving_mask)]
    kind = _FIELD_TYPES[options.field_type]
    if options.field:
        size = 3 * np.dtype(kind).itemsize * math.prod(fixed.counts) / 1e6
        print(f"{NAME}: {options.field} will have 3 {options.field_type} a voxel, {size:.1f} MB", file=sys.stderr)
    progress = _Progress()
    try:
        result = register(
            fixed, moving, spacing=options.spacing[0], unit=options.spacing[1], levels=options.levels,
            smooth=not options.sharp,
            metric=options.metric, bins=options.bins, penalty=options.penalty, no_folds=options.no_folds,
            mask=masks[0], moving_mask=masks[1], start=_start(options.start), iterations=options.iterations,
            tolerance=options.tolerance, device=word(options.device or "reference"),
            org=word(options.org or ""), format=word(options.format or ""), progress=progress)
    finally:
        progress.end()
    for warning in result.warnings:
        print(f"{NAME}: warning: {warning}", file=sys.stderr)
    volumes = {}
    with printed_warnings(NAME):
        if options.output:
            volumes[options.output] = warp(moving, result.lattice, like=fixed, order=options.order,
                                           default=options.default)
        if options.field:
            volumes[options.field] = displacement_field(fixed, result.lattice, kind=kind)
        if options.jacobian:
            volumes[options.jacobian] = determinants(fixed, result.lattice)
        write_all(volumes, _others(options, fixed, moving, result))
    print(_report(result, [path for path in outputs.values() if path]), flush=True)
    if result.stopped:
        print(f"{NAME}: stopped; this is the best lattice so far", file=sys.stderr)
        return _STOPPED
    return 0


def main() -> int:
    """The program; its exit status."""
    return run_program(NAME, run)
