"""synth/baseline.csv: what has grown or shrunk, by hand, and on a copy of the tree, where the
binary32 adder passes as it is and fails when it is made wider.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from workspace import ROOT, Workspace

import baseline
import configurations
import rtl
import synthesis

ADDER, LUTS = synthesis.Unit("add", 1), {"lut": 500, "lutram": 0, "ff": 32, "dsp": 0, "bram": 0}
SUBJECTS = [synthesis.Subject(ADDER, "ffd_fp_add", target) for target in synthesis.UNIT_TARGETS]
RESULTS = list(zip(SUBJECTS, ({**LUTS, "depth": 37},
                              {"area_um2": 50000, "cells": 2000, "ff": 32, "depth": 80})))


class ByHand(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "baseline.csv"
        self.path.write_text(baseline.text("Yosys 1", RESULTS))

    def compare(self, results=tuple(RESULTS), version="Yosys 1", everything=True):
        return baseline.compare(version, baseline.read(self.path), results, everything)

    def test_the_same_passes(self):
        self.assertEqual(self.compare(), ([], [], 10))

    def test_bounds(self):
        cases = ((515, 0, 0), (516, 1, 0), (485, 0, 0), (484, 0, 1), (0, 0, 1))
        for lut, grown, told in cases:
            with self.subTest(lut):
                found = self.compare([(SUBJECTS[0], {**RESULTS[0][1], "lut": lut}), RESULTS[1]])
                self.assertEqual((len(found[0]), len(found[1])), (grown, told), found)
        print(f"baseline: {len(cases)} bounds")

    def test_lines_name_the_thing(self):
        grown, _, _ = self.compare([(SUBJECTS[0], {**RESULTS[0][1], "lut": 550, "dsp": 1,
                                                   "depth": 38}), RESULTS[1]])
        self.assertEqual(grown, [
            "add-fp32-latency1, ffd_fp_add, ecp5: lut 500 -> 550 (+10.0 %)",
            "add-fp32-latency1, ffd_fp_add, ecp5: dsp 0 -> 1 (new)"])
        _, told, _ = self.compare([RESULTS[0], (SUBJECTS[1], {**RESULTS[1][1], "area_um2": 40000})])
        self.assertEqual(told, ["add-fp32-latency1, ffd_fp_add, osu018: area_um2 50000 -> 40000 "
                                "(-20.0 %): make synth-baseline"])

    def test_rows_come_and_go(self):
        grown, _, _ = self.compare(RESULTS[:1])
        self.assertEqual(grown, ["add-fp32-latency1, ffd_fp_add, osu018: only in the baseline: "
                                 "make synth-baseline"])
        self.assertEqual(self.compare(RESULTS[:1], everything=False)[0], [])
        new = synthesis.Subject(synthesis.Unit("add", 2), "ffd_fp_add", "ecp5")
        grown, told, _ = self.compare([*RESULTS, (new, RESULTS[0][1])], "Yosys 2")
        self.assertEqual(grown, [f"{new}: not in the baseline: make synth-baseline"])
        self.assertEqual(told, ["the baseline is of Yosys 1, this is Yosys 2"])

    def test_bad_files_name_the_cure(self):
        text = self.path.read_text()
        for broken in ("", "# Yosys 1\n", text.replace("500", "x"), text.replace("depth", "deep")):
            with self.subTest(broken[:40]):
                self.path.write_text(broken)
                with self.assertRaisesRegex(baseline.BaselineError, "make synth-baseline"):
                    self.compare()


class OnACopy(Workspace):
    """With one binary32 row, so that there are few units to map."""

    def setUp(self):
        super().setUp()
        for name in ("rtl", "synth"):
            shutil.copytree(ROOT / name, self.root / name)
        table = self.root / "rtl" / "configurations.csv"
        lines = table.read_text().splitlines()
        table.write_text("\n".join(
            line for line in lines if ",fp32," not in line
            or line.startswith("basic-fp32-overlapped,")) + "\n")

    def baseline(self, command, *words):
        done = subprocess.run(
            [sys.executable, "-B", str(ROOT / "scripts" / "synth_baseline"), command, "--root",
             str(self.root), *words], check=False, text=True, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE)
        return done.returncode, done.stdout.splitlines(), done.stderr.splitlines()

    def renew_for_this_yosys(self):
        """The baseline of another yosys says nothing here."""
        path = self.root / "synth" / "baseline.csv"
        version = rtl.run(["yosys", "-V"])[1].strip()
        if baseline.read(path)[0] == version:
            return
        work = synthesis.Synthesis(self.root)
        wanted = [subject for subject in synthesis.subjects(configurations.read(
            self.root / "rtl" / "configurations.csv"))
            if subject.row.org == "unit" and subject.target == "ecp5"]
        self.assertEqual(synthesis.run_all(work, wanted, 2), [])
        path.write_text(baseline.text(version, [(s, work.result(s)) for s in wanted]))

    def test_a_wider_adder_fails(self):
        units = ("--org", "unit", "--target", "ecp5")
        self.renew_for_this_yosys()
        status, lines, errors = self.baseline("check", *units)
        self.assertEqual((status, errors), (0, []), lines)
        self.assertIn(", 0 more than 3 % above", lines[-1])
        rows, figures = map(int, re.findall(r"(\d+) (?:rows|figures)", lines[-1]))
        self.assertEqual((rows, figures), (4, 4 * 6))

        adder = self.root / "rtl/number/float/ffd_fp_add.v"
        text = adder.read_text()
        self.assertEqual(text.count("SIG_W   = 24"), 1)
        adder.write_text(text.replace("SIG_W   = 24", "SIG_W   = 27"))
        status, lines, errors = self.baseline("check", *units)
        self.assertEqual(status, 1)
        self.assertTrue(all(", ffd_fp_add, ecp5: " in line for line in errors), errors)
        self.assertGreaterEqual(sum(": lut " in line for line in errors), 2)
        self.assertIn(f"{len(errors)} more than 3 % above", lines[-1])
        print(f"baseline: {figures} figures agree; a wider adder has {len(errors)} too large")

    def test_bad_requests(self):
        for words, status, message in (
                (("check", "--org", "x"), 2, "unknown ORG 'x'"),
                (("write", "--org", "unit"), 2, "write maps the whole set"),
                (("look",), 2, "argument command: invalid choice: 'look'")):
            with self.subTest(words):
                found, _, errors = self.baseline(*words)
                self.assertEqual((found, len(errors)), (status, 1), errors)
                self.assertTrue(errors[0].startswith(f"synth_baseline: {message}"), errors)


if __name__ == "__main__":
    unittest.main(verbosity=2)
