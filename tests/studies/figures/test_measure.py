"""Running a study, stamping its report, and taking it into the folder that is committed.

SPDX-License-Identifier: Apache-2.0
"""

import json
import subprocess
import sys
import unittest

from checkout import ROOT, Checkout
from figures import measure, sources
from figures.catalogue import REPORTS

WRITE = """import json, pathlib, sys
path = pathlib.Path("build/reports/{name}.json")
path.parent.mkdir(parents=True, exist_ok=True)
path.write_text(json.dumps({report!r}))
sys.exit({status})
"""
PLATES = {"plates": [{"file": f"plate{i}.png", "vertices": 1000 + i, "mismatches": 0}
                     for i in range(10)]}


class Study(Checkout):
    def setUp(self):
        super().setUp()
        for name in ("rtl", "geometry", "apps"):
            (self.root / name).symlink_to(ROOT / name)

    def measure(self, report=None, status=0, name="plates"):
        """Exit status and what is printed, of a program that writes a report and ends so."""
        program = self.put("program.py", WRITE.format(name=name, report=report, status=status)
                           if report else f"import sys; sys.exit({status})")
        return self.command("measure", "--quiet", "plates", "--", sys.executable, program)

    def command(self, *words):
        done = subprocess.run(
            [sys.executable, "-B", ROOT / "scripts/figures", "--root", self.root, *words],
            cwd=self.root, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def fresh(self):
        return json.loads((self.root / "build/reports/plates.json").read_text())

    def test_a_run_that_ends_well_is_stamped_and_can_be_taken(self):
        self.assertEqual(self.measure(PLATES), (0, ""))
        self.assertEqual(self.fresh()["measured"], {
            "command": "make plates",
            "sources": sources.key(ROOT, REPORTS["plates"].sources)})
        self.assertEqual(self.command("adopt", "plates"), (0, "wrote docs/reports/plates.json\n"))
        text = (self.root / "docs/reports/plates.json").read_text()
        self.assertEqual(json.loads(text), self.fresh())
        self.assertIn('\n    {"file": "plate0.png", "vertices": 1000, "mismatches": 0},\n', text)

    def test_a_run_that_fails_is_not(self):
        self.assertEqual(self.measure(PLATES, 3)[0], 3)
        self.assertNotIn("measured", self.fresh())
        status, text = self.command("adopt", "plates")
        self.assertEqual((status, text.count("\n")), (1, 1))
        self.assertIn("is not of a run that ended well: make plates", text)

    def test_a_run_that_writes_nothing_leaves_the_old_report(self):
        self.measure(PLATES)
        before = (self.root / "build/reports/plates.json").read_bytes()
        self.assertEqual(self.measure(status=2)[0], 2)
        self.assertEqual((self.root / "build/reports/plates.json").read_bytes(), before)

    def test_what_is_not_whole_or_old_is_not_taken(self):
        self.measure({"plates": PLATES["plates"][:3]})
        self.assertIn("is not whole: plates: make plates", self.command("adopt", "plates")[1])
        self.assertEqual(self.command("adopt", "--part", "plates"),
                         (0, "wrote docs/reports/plates.json\n"))
        self.assertIn("docs/reports/plates.json lacks plates: make plates", self.command("check")[1])
        self.measure(PLATES)
        report = self.fresh()
        report["measured"]["sources"] = "0" * 16
        self.put("build/reports/plates.json", report)
        self.assertIn("is older than its sources: make plates", self.command("adopt", "plates")[1])
        self.assertIn("there is no report yet: make words", self.command("adopt", "words")[1])
        self.assertIn("no report 'x'", self.command("adopt", "x")[1])


class Form(unittest.TestCase):
    def test_what_differs_from_run_to_run_is_not_committed(self):
        report = {"wanted": 1, "rows": [{"name": "a", "lut": 3, "seconds": 1.5, "kinds": {"X": 1}}]}
        self.assertEqual(json.loads(measure.committed_form(report, "synth")),
                         {"wanted": 1, "rows": [{"name": "a", "lut": 3}]})


if __name__ == "__main__":
    unittest.main(verbosity=2)
