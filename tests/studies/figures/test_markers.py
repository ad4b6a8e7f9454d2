"""Figures between markers: what is put in, and what is wrong with a text.

SPDX-License-Identifier: Apache-2.0
"""

import shutil
import subprocess
import sys
import unittest

from checkout import ROOT, Checkout
from figures import check, markers

RUNS = {"model": "cat.3ds", "runs": [
    {"org": "basic", "format": "fp32", "deform": "twist:90", "max_error": 1.5994e-07, "checked": 7340,
     "ok": True, "operators": {"mul": 8}, "used": [63, 128]},
    {"org": "basic", "format": "fx18", "deform": "random:1", "max_error": 1.01e-04, "checked": 7340,
     "ok": False, "operators": {"mul": 9}, "used": [1, 2]},
    {"org": "a b, c", "format": "fx18", "deform": "none", "max_error": None, "checked": 12,
     "ok": True, "operators": {"mul": 7}, "used": [1, 2]}]}

DEFAULT = {"model": "cat.3ds", "runs": [row for row in RUNS["runs"][:2] for _ in range(6)]}


class Inline(Checkout):
    def setUp(self):
        super().setUp()
        self.data = self.reports(sim=RUNS)

    def written(self, what, before="?"):
        text, faults = markers.fill(f"x <!--= {what} -->{before}<!--/--> y", self.data)
        if faults:
            return faults[0].message
        return text.removeprefix(f"x <!--= {what} -->").removesuffix("<!--/--> y")

    def test_what_is_written(self):
        for what, wanted in (
                ("sim.model", "cat.3ds"),
                ("sim.max_error[format=fp32]", "1.6e-07"),
                ("sim.max_error[format=fp32]:.2e", "1.60e-07"),
                ("sim.checked[org=basic]", "7,340"),
                ("sim.max_error[deform=none]:.2e", "-"),
                ("sim.ok[deform=none]", "yes"),
                ('sim.checked[org="a b, c"]', "12"),
                ("sim.checked[format=fp32,fx18 org!=basic]", "12"),
                ("sim.operators.mul[deform=twist:90]", "8"),
                ("sim.used.0[format=fp32] / sim.used.1[format=fp32]:.0%", "49%"),
                ("sum(sim.checked)", "14,692"), ("count(sim.checked[format=fx18])", "2"),
                ("max(sim.max_error[format=fx18]):.1e", "1.0e-04"),
                ("sim.checked[deform=none] / sim.checked[format=fp32]:.4f", "0.0016")):
            with self.subTest(what):
                self.assertEqual(self.written(what), wanted)
                self.assertEqual(self.written(what, wanted), wanted)

    def test_what_is_refused(self):
        for what, complaint in (
                ("sim.nothing", "sim.json has no nothing"),
                ("sim.nothing[format=fp32]", "rows of sim have no nothing"),
                ("sim.checked[format=fx18]", "2 rows that differ"),
                ("sim.checked[format]", "'format' is not KEY=VALUE"),
                ("sum(sim.checked", "a bracket is missing"),
                ("nothing.model", "nothing has no model"), ("sim", "is not REPORT.FIELD"),
                ("sim.model:.2f", "does not write"), ("sim.model * 2", "what is ' * 2'")):
            with self.subTest(what):
                self.assertIn(complaint, self.written(what))
        self.assertIn("no report yet: make words", self.written("words.max_error"))
        self.assertIn("no report yet: make sim", self.written("sim.checked[format=fx99]"))

    def test_markers_that_are_none(self):
        for text, complaint in (("a <!--= sim.model --> never closed", "other half"),
                                ("a <!--/--> b", "other half"),
                                ("<!-- figures: sim.runs -->\nno end\n", "other half"),
                                ("<!--= sim.model -->cat.3ds<!--/--> first", "begin a line")):
            with self.subTest(text):
                after, faults = markers.fill(f"\n{text}\n", self.data)
                self.assertEqual(after, f"\n{text}\n")
                self.assertEqual([fault.line for fault in faults], [2])
                self.assertIn(complaint, faults[0].message)


    def test_an_example_between_fences_stays(self):
        text = "```markdown\n<!--= sim.model -->?<!--/-->\n<!-- figures: sim.runs -->\n```\n"
        self.assertEqual(markers.fill(text, self.data), (text, []))


class Blocks(Checkout):
    def filled(self, opening, inside=""):
        text = f"before\n\n<!-- figures: {opening} -->\n{inside}<!-- end figures -->\nafter\n"
        after, faults = markers.fill(text, self.reports(sim=RUNS))
        if faults:
            return faults[0].message
        self.assertEqual(markers.fill(after, self.reports())[0], after)
        return after.split("-->\n", 1)[1].split("<!-- end", 1)[0]

    def test_rows_of_a_report(self):
        opening = "sim.rows org=basic\nformat | format\nerror | max_error:.1e\n"
        text, faults = markers.fill(f"<!-- figures: {opening}-->\n| old |\n<!-- end figures -->\n",
                                    self.reports(sim=RUNS))
        self.assertEqual(faults, [])
        self.assertEqual(text, f"<!-- figures: {opening}-->\n| format | error |\n| --- | --: |\n"
                         "| fp32 | 1.6e-07 |\n| fx18 | 1.0e-04 |\n<!-- end figures -->\n")

    def test_what_is_refused(self):
        for opening, complaint in (("sim.nothing", "sim has no table 'nothing'"),
                                   ("nothing.runs", "is not REPORT.TABLE"),
                                   ("sim.rows org=x\na | org\n", "no rows of sim"),
                                   ("sim.rows", "each column is a line"),
                                   ("words.lengths", "no report yet: make words")):
            with self.subTest(opening):
                end = "-->" if "\n" in opening else " -->"
                _, faults = markers.fill(f"<!-- figures: {opening}{end}\n<!-- end figures -->\n",
                                         self.reports(sim=RUNS))
                self.assertEqual(len(faults), 1)
                self.assertIn(complaint, faults[0].message)

    def test_for_a_terminal(self):
        streams = {"rows": [{"mesh": "cat.3ds", "arrangement": "resident", "order": "file",
                             "lattice": "4x4x4", "words_per_vertex": 4.0468}]}
        text, faults = markers.fill("<!-- figures: streams.words text -->\n<!-- end figures -->\n",
                                    self.reports(streams=streams))
        self.assertEqual(faults, [])
        self.assertIn("\n    arrangement  order of vertices  4x4x4\n"
                      "    resident     file                4.05\n", text)


class OfTheRtl(unittest.TestCase):
    """Ports and parameters of the tops, with the meanings that the text gives them."""

    def fault(self, opening, *lines):
        text = "\n".join([f"<!-- figures: {opening}", *lines, "-->", "<!-- end figures -->", ""])
        _, faults = markers.fill(text, check.Reports(ROOT))
        return faults[0].message if faults else ""

    def test_every_port_needs_a_meaning(self):
        ports = ("a*: clock, reset", "s_axis_*: in", "m_axis_*: out", "event_*: event",
                 "vertex_o: vertex", "idle_o: idle")
        self.assertEqual(self.fault("rtl.ports hwffd_stream", *ports), "")
        self.assertIn("hwffd_stream.aresetn has no meaning",
                      self.fault("rtl.ports hwffd_stream", "aclk: clock"))
        self.assertIn("hwffd_stream has no nothing_i",
                      self.fault("rtl.ports hwffd_stream", *ports, "nothing_i: x"))
        self.assertIn("has no LATENCY",
                      self.fault("rtl.parameters hwffd_stream", "*: any", "LATENCY: x"))


class Gate(Checkout):
    def lint(self, *words):
        """The warnings of scripts/lint --text that are about figures, and its exit status."""
        done = subprocess.run(
            [sys.executable, "-B", ROOT / "scripts/lint", "--text", "--root", self.root, *words],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(done.stderr, "")
        return [line for line in done.stdout.splitlines() if "figures" in line
                or "README.md" in line or "stale" in line], done.returncode

    def setUp(self):
        super().setUp()
        for name in ("rtl", "geometry", "apps"):
            (self.root / name).symlink_to(ROOT / name)
        for name in ("scripts", "docs"):
            (self.root / name).mkdir()
        shutil.copy(ROOT / "VERSION", self.root)
        key = check.sources.key(ROOT, check.REPORTS["sim"].sources)
        self.reports(sim={"measured": {"command": "make sim", "sources": key}, **DEFAULT})
        self.readme("1.60e-07")

    def readme(self, figure, what="sim.max_error[format=fp32]:.2e"):
        self.put("README.md", f"# t\n\nat most <!--= {what} -->{figure}<!--/-->\n")

    def test_a_wrong_number_is_a_warning(self):
        self.assertEqual(self.lint()[0], [])
        self.readme("1.61e-07")
        (line,), status = self.lint()
        self.assertTrue(line.startswith("README.md:3: not what the report says: "), line)
        self.assertIn("1.60e-07", line)
        self.assertEqual(status, 1)

    def test_a_marker_that_names_nothing_is_a_warning(self):
        self.readme("1", "sim.speed")
        self.assertEqual(self.lint()[0], ["README.md:3: sim.json has no speed"])

    def test_what_is_not_measured_is_named_with_its_command(self):
        self.readme("1", "words.max_error[format=fx18]")
        self.assertEqual(self.lint()[0],
                         ["lint: README.md: no report yet: make words, in 1 places"])
        self.assertIn("README.md: no report yet: make words, in 1 places", self.lint("--strict")[0])

    def test_a_stale_report_is_named_with_its_command(self):
        self.reports(sim={"measured": {"command": "make sim", "sources": "0" * 16}, **DEFAULT})
        line = "docs/reports/sim.json is stale: make sim && scripts/figures adopt sim"
        self.assertEqual(self.lint()[0], [f"lint: {line}"])
        found, status = self.lint("--strict")
        self.assertEqual((found, status), ([line], 1))


if __name__ == "__main__":
    unittest.main(verbosity=2)
