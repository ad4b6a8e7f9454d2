"""The datasheet: what is committed against the sources, and how figures are put in.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import datasheet  # noqa: E402
import module_header  # noqa: E402
import reports  # noqa: E402
import rtl  # noqa: E402
import version  # noqa: E402

REPORT = {"rows": [
    {"name": "basic-fx18-overlapped", "top": "a", "target": "ecp5", "lut": 1234, "fmax_mhz": 80.25},
    {"name": "basic-fx18-overlapped", "top": "b", "target": "ecp5", "lut": 5, "fmax_mhz": None},
]}
TEMPLATE = """\
# {{version}}
{{synth lut top=a}} LUTs, {{synth fmax_mhz:.1f top=a}} MHz, {{synth fmax_mhz top=b}},
{{synth lut top=a / synth lut top=b}} times.

{{rows format=fx18 org=basic schedule=overlapped plain
row | name
N | n
LUT | synth lut top=b
}}

{{ports hwffd_stream
aclk: clock
a*: reset
s_axis_*: in
m_axis_t*: out
event_o: event
event_*: where
vertex_o: vertex
idle_o: idle
}}

{{registers}}
"""


class Committed(unittest.TestCase):
    def test_it_is_what_the_sources_say(self):
        self.assertEqual(datasheet.stale(), [])
        text = (ROOT / datasheet.DOCUMENT).read_text(encoding="utf-8")
        self.assertNotIn("{{", text)
        found = 0
        for top in ("hwffd_stream", "hwffd_axi"):
            header = module_header.read(rtl.Sources(), top)
            for port in header.ports:
                self.assertIn(f"| `{port.name}` | {port.direction} | {port.width} | ", text)
            for name, value in header.parameters.items():
                self.assertIn(f"| `{name}` | {value} | ", text)
            found += len(header.ports) + len(header.parameters)
        print(f"datasheet: {found} ports and parameters of {text.count(chr(10))} lines agree")

    def test_chapters(self):
        text = (ROOT / datasheet.DOCUMENT).read_text(encoding="utf-8")
        for number, name in enumerate((
                "Features", "Unsupported", "Standards", "Performance", "Resources", "Parameters",
                "Ports", "Registers", "Programming sequence", "Clocking and reset",
                "Example design", "Test bench", "Change log"), 1):
            self.assertIn(f"\n## {number}. {name}", text)


class Made(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        shutil.copytree(ROOT / "rtl", self.root / "rtl")
        shutil.copy(ROOT / "VERSION", self.root)
        self.put(datasheet.TEMPLATE, TEMPLATE)
        self.put("build/reports/synth.json", json.dumps(REPORT))

    def put(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def run_it(self, *words):
        """(exit status, complaints, the document or None)"""
        done = subprocess.run(
            [sys.executable, "-B", ROOT / "scripts/datasheet.py", "--root", self.root, *words],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        path = self.root / datasheet.DOCUMENT
        return (done.returncode, done.stderr.splitlines(),
                path.read_text() if path.is_file() else None)

    def test_figures_and_tables(self):
        status, complaints, text = self.run_it("write")
        self.assertEqual((status, complaints), (0, []))
        for line in (f"# {version.read(ROOT)}", "1,234 LUTs, 80.2 MHz, -,", "247 times.",
                     "| row | N | LUT |", "| --- | --: | --: |", "| basic-fx18-overlapped | 1 | 5 |",
                     "| `aclk` | input | 1 | clock |", "| `aresetn` | input | 1 | reset |",
                     "| `m_axis_tdata` | output | 128 | out |",
                     "| `event_o` | output | 10 | event |", "| 0x000 | `ID` | `value` |"):
            self.assertIn(line + "\n", text)
        self.assertEqual(text.count("\n| basic-"), 1)
        self.assertEqual(self.run_it("check")[:2], (0, []))

    def test_a_change_of_the_sources_makes_it_stale(self):
        self.run_it("write")
        changes = {"rtl/top/hwffd_stream.v": ("[31:0]  event_beat_o", "[15:0]  event_beat_o"),
                   "rtl/bus/registers.csv": ("ID,value,", "ID,letters,"),
                   "VERSION": ("0.", "7."),
                   datasheet.TEMPLATE: ("times.", "times as many.")}
        for name, (before, after) in changes.items():
            with self.subTest(name):
                text = (self.root / name).read_text()
                self.assertIn(before, text)
                self.put(name, text.replace(before, after))
                status, complaints, _ = self.run_it("check")
                self.assertEqual((status, len(complaints)), (1, 1))
                self.assertTrue(complaints[0].endswith("run make docs"), complaints)
                self.put(name, text)
        text = (self.root / datasheet.DOCUMENT).read_text()
        self.put(datasheet.DOCUMENT, text.replace("1,234", "1,235"))
        self.assertEqual(self.run_it("check")[:2], (0, []))

    def test_missing_figures_name_the_command(self):
        (self.root / "build/reports/synth.json").unlink()
        status, complaints, text = self.run_it("write")
        self.assertEqual((status, text), (1, None))
        self.assertEqual(complaints, [
            "datasheet.py: figures are missing: make synth",
            "datasheet.py: docs/datasheet.md left as it was"])
        self.assertEqual(self.run_it("--keep", "write")[0], 0)
        status, _, text = self.run_it("--partial", "write")
        self.assertEqual(status, 0)
        self.assertIn("(`make synth`) LUTs", text)
        self.assertEqual(reports.command("synth", {"format": "fx18", "target": "ecp5", "top": "x"}),
                         "make synth TARGET=ecp5 FORMAT=fx18")

    def test_faults_of_the_template_are_one_line(self):
        for place, complaint in (
                ("{{synth area top=a}}", "rows of synth.json have no area"),
                ("{{synth lut target=ecp5}}", "2 rows that differ"),
                ("{{nothing lut}}", "no report 'nothing'"),
                ("{{synth lut top}}", "'top' is not KEY=VALUE"),
                ("{{rows org=none\nrow | name\n}}", "no rows are org=none"),
                ("{{ports hwffd_stream\naclk: clock\n}}", "hwffd_stream.aresetn has no meaning"),
                ("{{parameters hwffd_stream\n*: any\nLATENCY: x\n}}", "has no LATENCY")):
            with self.subTest(place):
                self.put(datasheet.TEMPLATE, place + "\n")
                status, complaints, text = self.run_it("write")
                self.assertEqual((status, len(complaints), text), (1, 1, None), complaints)
                self.assertIn(complaint, complaints[0])


if __name__ == "__main__":
    unittest.main(verbosity=2)
