"""hwffd.core as its users run it: FuseSoC lints, simulates and maps the core, and writes nothing
outside build/.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import configurations  # noqa: E402

FUSESOC = pathlib.Path(sys.executable).parent / "fusesoc"
BUILT = ROOT / "build" / "fusesoc"


def row(name):
    """A row of the table as FuseSoC takes it."""
    found = configurations.find(configurations.read(), name)
    return [f"--{word}" for word in found.assignments()]


def outside():
    """Every file of the checkout that is not in a build folder."""
    found = set()
    for folder, folders, files in os.walk(ROOT):
        folders[:] = [name for name in folders if name not in ("build", "build-trace", ".git")]
        found.update(f"{folder}/{name}" for name in files)
    return found


class FuseSoC(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.home = pathlib.Path(folder.name)
        shutil.rmtree(BUILT, ignore_errors=True)
        self.before = outside()

    def fusesoc(self, target, *words, flags=()):
        """(exit status, what it printed); nothing but build/ may have changed."""
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith(("MAKE", "MFLAGS", "XDG_"))}
        done = subprocess.run(
            [FUSESOC, "run", *flags, f"--target={target}", "hwffd", *words], cwd=ROOT,
            env={**environment, "HOME": str(self.home)}, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(outside() - self.before, set())
        # yosys keeps a history in the home of whoever runs a script of Tcl.
        self.assertLessEqual({path.name for path in self.home.iterdir()}, {".yosys_history"})
        return done.returncode, done.stdout

    def test_lint(self):
        for flags, words in (((), ()), ((), row("factored3-fx18-overlapped")),
                             (("--flag", "axi"), row("basic-fp32-overlapped"))):
            with self.subTest(flags=flags, words=words):
                status, output = self.fusesoc("lint", *words, flags=flags)
                self.assertEqual((status, re.findall("%Warning.*", output)), (0, []), output)

    def test_lint_refuses_a_bad_parameter(self):
        status, output = self.fusesoc("lint", "--FORMAT=5")
        self.assertNotEqual(status, 0)
        self.assertIn("ERROR_", output)

    def test_sim(self):
        for name, words in (("basic-fx18-overlapped", "fixed-point"),
                            ("basic-fp32-overlapped", "binary32")):
            with self.subTest(name):
                status, output = self.fusesoc("sim", *row(name))
                self.assertEqual(status, 0, output)
                self.assertRegex(output, rf"hwffd_stream, {words} words: 27 of 27 results, "
                                         r"0 differ, \d+ clocks\n")

    def test_sim_can_fail(self):
        """Another row's evaluator ignores what is loaded: the B-spline is not Bezier's."""
        status, output = self.fusesoc("sim", *row("basic-fx18-overlapped-bspline"))
        self.assertNotEqual(status, 0)
        self.assertRegex(output, r"27 of 27 results, [1-9]\d* differ")

    def test_synth(self):
        status, output = self.fusesoc("synth")
        self.assertEqual(status, 0, output)
        netlists = list(BUILT.glob("*/synth/*.json"))
        self.assertEqual(len(netlists), 1)
        cells = json.loads(netlists[0].read_text())["modules"]["hwffd_stream"]["cells"]
        kinds = {cell["type"] for cell in cells.values()}
        self.assertGreaterEqual(kinds, {"LUT4", "TRELLIS_FF", "MULT18X18D"})
        self.assertEqual({kind for kind in kinds if kind.startswith("$")}, set())


if __name__ == "__main__":
    unittest.main(verbosity=2)
