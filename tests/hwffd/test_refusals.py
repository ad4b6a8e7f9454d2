#!/usr/bin/env python3
"""The command hwffd: what it refuses, by a line that names it, and no file.

    test_refusals.py HWFFD

SPDX-License-Identifier: Apache-2.0
"""

import unittest

from tests.hwffd.command import CommandTest
from tests.support.program import FAILURE, USAGE

LONGEST_MESSAGE = 200

# Command line -> exit status and words of the one line on standard error. Nothing is written.
REFUSED = {
    "": (USAGE, "subcommand"),
    "melt solid.obj": (USAGE, "hwffd-melt", "PATH", "--help"),
    "../melt solid.obj": (USAGE, "--help"),
    "deform": (USAGE, "input"),
    "deform solid.obj -o out.ply --family melted": (USAGE, "melted", "catmull-rom"),
    "deform solid.obj -o out.ply --family linear --family bspline": (USAGE, "given twice"),
    "deform solid.obj -o out.ply --device model --org cg2": (USAGE, "device model: cg2 went with 0.3.0: take cg1"),
    "deform solid.obj -o out.ply --device uio:99999": (FAILURE, "uio99999/maps/map0/size", "uio_pdrv_genirq"),
    "deform solid.obj -o out.ply --device uio:one": (USAGE, "device uio", "uio:0"),
    "deform solid.obj -o out.ply --device uio:0 --org cg7": (USAGE, "device uio", "'cg7'"),
    "deform solid.obj -o out.ply --device serial": (USAGE, "'serial'", "serial:PATH", "uio:N"),
    "deform solid.obj -o out.ply --family bernstein --dims 5x5x5": (FAILURE, "bernstein", "4, 7, 10"),
    "completion csh": (USAGE, "csh"),
    "deform solid.obj": (USAGE, "--output", "-o out.ply"),
    "deform none.obj -o out.ply": (FAILURE, "none.obj"),
    "deform folder -o out.ply": (FAILURE, "folder"),
    "deform empty.obj -o out.ply": (FAILURE, "empty.obj"),
    "deform words.obj -o out.ply": (FAILURE, "words.obj"),
    "deform nan.obj -o out.ply": (FAILURE, "nan.obj"),
    "deform bad.xyz -o out.xyz": (FAILURE, "bad.xyz", "line 2"),
    "deform solid.obj -o out.txt": (USAGE, "out.txt", "ply"),
    "deform solid.obj -o out": (USAGE, "out", "extension"),
    "deform none.obj -o out.txt": (USAGE, "out.txt"),  # before any work
    "deform none.obj -o none/out.ply": (FAILURE, "none/out.ply"),
    "deform solid.obj -o read-only.obj": (FAILURE, "read-only.obj: is read-only"),
    "deform points.xyz -o out.obj": (USAGE, "out.obj", "ply"),
    "deform points.xyz -o out.glb": (USAGE, "out.glb", "ply"),
    "deform points.xyz --json -": (USAGE, "--json -", "--output"),
    "deform points.xyz -o same --json same": (USAGE, "--json same", "--output"),
    "deform solid.obj -o same.ply --json folder/../same.ply": (USAGE, "--json", "--output"),
    "deform solid.obj -o f.ply --keyframes 3 --json f-0002.ply": (USAGE, "--json", "--output"),
    "embed solid.obj -o same --json same": (USAGE, "--json same", "--output"),
    "deform solid.obj -o out.ply --json solid.obj": (USAGE, "--json solid.obj", "is read from"),
    "deform solid.obj -o out.ply --lattice few.json --json folder/../few.json": (USAGE, "--json", "is read from"),
    "deform points.xyz -o few.json --deform to:few.json": (USAGE, "--output few.json", "is read from"),
    "deform points.xyz -o bad.xyz --mask bad.xyz": (USAGE, "--output bad.xyz", "is read from"),
    "embed points.xyz -o points.xyz": (USAGE, "--output points.xyz", "is read from"),
    "info solid.obj --json solid.obj": (USAGE, "--json solid.obj", "is read from"),
    "check few.json --json few.json": (USAGE, "--json few.json", "is read from"),
    "lattice --around points.xyz -o points.xyz": (USAGE, "--output points.xyz", "is read from"),
    "fit points.xyz points.xyz -o points.xyz": (USAGE, "--output points.xyz", "is read from"),
    "fit points.xyz points.xyz -o few.json --deform to:few.json": (USAGE, "--output few.json", "is read from"),
    "embed none.obj -o none/places": (FAILURE, "none/places"),
    "check none.json --json none/report": (FAILURE, "none/report"),
    "info none.obj --json none/report": (FAILURE, "none/report"),
    "deform solid.obj -o none/out.ply": (FAILURE, "none"),
    "deform solid.obj -o -": (USAGE, "standard output"),
    "deform solid.obj -o out.ply --twist 90": (USAGE, "--twist", "--help"),
    "deform solid.obj -o out.ply --deform twirl": (USAGE, "twirl", "twist", "helix"),
    "deform solid.obj -o out.ply --deform twist:x": (USAGE, "twist:x"),
    "deform solid.obj -o out.ply --deform twist:1e308": (USAGE, "twist:1e308", "1e6"),
    "deform solid.obj -o out.ply --deform twist:90:w": (USAGE, "90:w", "x, y or z"),
    "deform solid.obj -o out.ply --deform scale:0": (USAGE, "scale:0", "other than 0"),
    "deform solid.obj -o out.ply --deform move:9,0,0:1,1,1": (FAILURE, "9,0,0", "4 x 4 x 4"),
    "deform solid.obj -o out.ply --deform to:none.json": (FAILURE, "none.json"),
    "deform solid.obj -o out.ply --lattice pyramid": (FAILURE, "pyramid", "no file", "sphere"),
    "deform solid.obj -o out.ply --lattice broken.json":
        (FAILURE, "broken.json", "line 1, column 35"),
    "deform solid.obj -o out.ply --lattice twice.json": (FAILURE, "twice.json", "'dims'", "twice"),
    "deform solid.obj -o out.ply --lattice junk.json": (FAILURE, "junk.json", "line 1, column"),
    "deform solid.obj -o out.ply --lattice /dev/zero": (FAILURE, "/dev/zero", "bytes"),
    "deform solid.obj -o out.ply --lattice huge.json": (FAILURE, "huge.json", "1e+100"),
    "check huge.json": (FAILURE, "huge.json", "1e+100"),
    "deform solid.obj -o out.ply --lattice folded.json --check-folds":
        (FAILURE, "folded.json", "folded at"),
    "embed solid.obj --lattice folded.json --check-folds": (FAILURE, "folded.json", "folded at"),
    "deform solid.obj -o out.ply --lattice flat.json": (FAILURE, "flat.json", "volume"),
    "embed solid.obj --lattice flat.json": (FAILURE, "flat.json", "volume"),
    "deform solid.obj -o out.ply --lattice sheet.json --check-folds": (FAILURE, "sheet.json", "volume"),
    "deform solid.obj -o out.ply --dims 4x4": (USAGE, "--dims 4x4"),
    "deform solid.obj -o out.ply --dims 4x4x65": (USAGE, "4 to 64"),
    "deform solid.obj -o out.ply --dims 3x4x4": (USAGE, "4 to 64"),
    "deform solid.obj -o out.ply --family linear --dims 1x4x4": (USAGE, "2 to 64"),
    "deform solid.obj -o out.ply --lattice few.json":
        (FAILURE, "few.json", "2 x 3 x 2", "4 to 64", "bspline", "catmull-rom"),
    "info few.json": (FAILURE, "few.json", "2 x 3 x 2"),
    "check few.json --family clamped": (FAILURE, "2 x 3 x 2", "4 to 64"),
    "deform solid.obj -o out.ply --lattice sphere --dims 4x4x4": (FAILURE, "4"),
    "deform solid.obj -o out.ply --region 0,0,0": (USAGE, "--region"),
    "deform solid.obj -o out.ply --region 0,0,0,0,0,0": (USAGE, "--region", "no volume"),
    "deform solid.obj -o out.ply --region 0,0,2,1,1,2": (USAGE, "--region", "no volume"),
    "deform solid.obj -o out.ply --outside away": (USAGE, "away", "fade"),
    "deform solid.obj -o out.ply --device fpga": (USAGE, "fpga", "rtl"),
    "deform solid.obj -o out.ply --device model --org cg9":
        (USAGE, "cg9", "basic", "cg3", "factored3"),
    "deform solid.obj -o out.ply --device model --format fp64": (USAGE, "fp64", "fx18"),
    "deform solid.obj -o out.ply --device model --org basic-fp32-overlapped-fma":
        (USAGE, "fma", "hwffd info"),
    "deform solid.obj -o out.ply --device model --org basic-fx18-overlapped --format fp32":
        (USAGE, "fx18"),
    "deform solid.obj -o out.ply --org cg1": (USAGE, "--org requires --device"),
    "deform solid.obj -o out.ply --format fx18": (USAGE, "--format requires --device"),
    "deform solid.obj -o out.ply --org factored/3 --device rtl --format fx99": (USAGE, "factored"),
    "deform solid.obj -o out.ply --keyframes 0": (USAGE, "--keyframes"),
    "deform points.xyz --keyframes 3": (USAGE, "--keyframes", "--output"),
    "embed solid.obj --deform twist": (USAGE, "--deform"),
    "embed solid.obj --lattice box --lattice sphere": (USAGE, "--lattice"),
    "lattice --lattice box --lattice box": (USAGE, "--lattice"),
    "lattice -o none/lattice.json": (FAILURE, "none"),
    "check": (USAGE, "lattices"),
    "check none.json": (FAILURE, "none.json"),
    "check solid.obj": (FAILURE, "solid.obj"),
    "info none.obj": (FAILURE, "none.obj"),
}


class Refusals(CommandTest):
    def test_bad_input(self):
        for line, (status, *words) in REFUSED.items():
            with self.subTest(line):
                result = self.call(*line.split())
                self.assert_refused(result, status, words)
                self.assertLess(len(result.stderr), LONGEST_MESSAGE)


if __name__ == "__main__":
    unittest.main(verbosity=2)
