"""The program hwffd-warp, which `hwffd warp` runs.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
from collections.abc import Sequence

from hwffd import Lattice, UsageError, shapes
from hwffd.volumes.files import SUFFIXES, check_writable, write_all
from hwffd.volumes.program import (Parser, check_outputs, printed_warnings, read_quietly, run_program,
                                   set_device, show, word)
from hwffd.volumes.splines import ORDERS
from hwffd.volumes.volume import Volume
from hwffd.volumes.warping import Warped, lattice_over, resample

NAME = "hwffd-warp"

_EXAMPLES = """examples:
  hwffd warp head.nrrd box turned.nrrd --dims 6x6x6 --deform twist:30
  hwffd warp head.nii.gz rest.json moved.nii.gz --deform to:moved.json --field field.mha
  hwffd warp labels.mha box out.mha --deform bend:20:z --order 0 --device model --format fx32
"""


def _dims(text: str) -> tuple[int, ...]:
    try:
        dims = tuple(int(part) for part in text.split("x"))
    except ValueError:
        dims = ()
    if len(dims) != 3:
        raise argparse.ArgumentTypeError(f"'{text}'; give NSxNTxNU, such as 6x6x6")
    return dims


def _options(words: Sequence[str]) -> argparse.Namespace:
    parser = Parser(
        "warp",
        "Resamples an image volume through a deformed lattice: each voxel of the output "
        "has the value of the input where the deformation takes it.",
        _EXAMPLES)
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
    parser.add_device()
    return parser.parse(words)


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
    set_device(lattice, options)
    lattice.set_outside(word(options.outside))
    for deformation in options.deform:
        lattice.deform(word(deformation))
    return lattice


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
    check_outputs({"output": options.output, "--field": options.field}, {"--like": options.like},
                  lambda option, path: check_writable(path))
    check_outputs({"--field": options.field}, {"the input": options.input})
    volume = read_quietly(options.input)
    like = read_quietly(options.like) if options.like else None
    lattice = _lattice(options, volume)
    warped = resample(volume, lattice, like=like, order=options.order, default=options.default,
                      with_field=options.field is not None,
                      progress=lambda done: show(f"{'warp':<32} {100 * done:3.0f} %", done >= 1))
    outputs = {options.output: warped.volume}
    if warped.field is not None:
        outputs[options.field] = warped.field
    with printed_warnings(NAME):
        write_all(outputs)
    print(_report(options, lattice, warped), flush=True)


def main() -> int:
    """The program; its exit status."""
    return run_program(NAME, run)
