"""scripts/configurations.py: what it reads, writes and refuses.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parent.parent.parent / "scripts" / "configurations.py"
sys.path.insert(0, str(SCRIPT.parent))

import configurations  # noqa: E402

HEADER = ",".join(configurations.COLUMNS)
GOOD = "good-row,basic,1,fx18,overlapped,pipelined,2,1,0,1,stream,test"

# what is wrong -> (table, line of the fault or None, word of the message)
BAD = {
    "no file": (None, None, "cannot be read"),
    "empty file": ("", 1, "first line"),
    "wrong header": ("name,org\n" + GOOD, 1, "first line"),
    "no rows": (HEADER + "\n", None, "no configurations"),
    "column missing": (f"{HEADER}\n{GOOD.rsplit(',', 1)[0]}\n", 2, "columns"),
    "column too many": (f"{HEADER}\n{GOOD},x\n", 2, "columns"),
    "name twice": (f"{HEADER}\n{GOOD}\n{GOOD}\n", 3, "twice"),
    "name twice after a blank line": (f"{HEADER}\n{GOOD}\n\n{GOOD}\n", 4, "twice"),
}
FIELDS = {
    "name": ("Good", "good_row", "1-row", "good-", "", "two words", "a;b"),
    "org": ("", "Basic", "nothing", "tree/", "tree/x", "/3"),
    "n": ("", "0", "65", "-1", "x", "1.0", "8"),
    "format": ("", "fp64", "fx", "fx11", "fx33", "fx018", "18", "FX18"),
    "schedule": ("", "late"),
    "evaluator": ("", "none"),
    "mul_latency": ("", "-1", "two", "100"),
    "add_latency": ("", "-1", "1 "),
    "fma_latency": ("", "-1", "x", "3"),
    "convert_latency": ("", "-1", "0x1"),
    "top": ("", "1", "stream axi"),
    "tier": ("", "test-all", "nightly"),
}
for column, values in FIELDS.items():
    for value in values:
        fields = dict(zip(configurations.COLUMNS, GOOD.split(",")), **{column: value})
        BAD[f"{column} '{value}'"] = (f"{HEADER}\n{','.join(fields.values())}\n", 2, column)


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.table = self.folder / "table.csv"

    def run_script(self, *arguments, text=None):
        if text is not None:
            self.table.write_text(text)
        return subprocess.run(
            [sys.executable, "-B", str(SCRIPT), "--table", str(self.table), *arguments],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False,
        )


class Refused(Folder):
    def test_bad_tables(self):
        refused = 0
        for what, (text, line, word) in BAD.items():
            with self.subTest(what):
                done = self.run_script("list", text=text)
                self.assertEqual((done.returncode, done.stdout), (1, ""))
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertIn(word, done.stderr)
                if line is not None:
                    self.assertIn(f"{self.table}:{line}: ", done.stderr)
                refused += 1
        print(f"configurations: {refused} of {len(BAD)} bad tables refused")

    def test_unknown_name(self):
        done = self.run_script("parameters", "other", text=f"{HEADER}\n{GOOD}\n")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no configuration named 'other'", done.stderr)

    def test_unknown_command(self):
        self.assertEqual(self.run_script("nothing", text=f"{HEADER}\n{GOOD}\n").returncode, 2)

    def test_bad_table_leaves_the_output_alone(self):
        out = self.folder / "out.cmake"
        out.write_text("before")
        self.assertEqual(self.run_script("cmake", str(out), text=HEADER).returncode, 1)
        self.assertEqual(out.read_text(), "before")


class Accepted(Folder):
    ROWS = (
        f"{HEADER}\n"
        "small,basic,1,fp32,overlapped,pipelined,2,1,0,1,stream,sim\n"
        "good-row,tree,4,fx18,paper,iterative,5,4,0,3,axi,test\n"
        "large,parallel,64,fx32,overlapped,pipelined,2,1,0,1,evaluator,all\n"
    )

    def test_committed_table(self):
        rows = configurations.read()
        self.assertTrue(configurations.of_tier(rows, "test"))

    def test_tiers_include_smaller_ones(self):
        for tier, names in (("sim", "small\n"), ("test", "small\ngood-row\n"),
                            ("all", "small\ngood-row\nlarge\n")):
            self.assertEqual(self.run_script("list", "--tier", tier, text=self.ROWS).stdout, names)

    def test_parameters(self):
        words = ("ORG=4 N=4 FORMAT=18 SCHEDULE=1 EVALUATOR=1 MUL_LATENCY=5 ADD_LATENCY=4 FMA_LATENCY=0 "
                 "CONVERT_LATENCY=3")
        done = self.run_script("parameters", "good-row", text=self.ROWS)
        self.assertEqual(done.stdout, words + "\n")
        done = self.run_script("parameters", "--fusesoc", "good-row")
        self.assertTrue(done.stdout.startswith("--ORG=4 --N="), done.stdout)
        done = self.run_script("parameters", "--verilator", "good-row")
        self.assertEqual(done.stdout, " ".join("-G" + word for word in words.split()) + "\n")

    def test_cmake(self):
        out = self.folder / "out.cmake"
        self.run_script("cmake", str(out), "--tier", "test", text=self.ROWS)
        text = out.read_text()
        self.assertIn("set(HWFFD_CONFIGURATION_IDENTIFIERS small good_row large)\n", text)
        self.assertIn("set(HWFFD_TIER_IDENTIFIERS small good_row)\n", text)
        self.assertIn("set(HWFFD_SELECTED_IDENTIFIERS small good_row large)\n", text)
        self.assertIn("set(HWFFD_CONFIGURATION_PARAMETERS_good_row ORG=4 N=4 FORMAT=18 ", text)
        self.assertIn("set(HWFFD_STREAM_IDENTIFIERS small good_row)\n", text)
        self.assertIn("set(HWFFD_AXI_IDENTIFIERS good_row)\n", text)

    def test_many_float_units_are_wide(self):
        wide = {row.name: row.wide for row in configurations.read()}
        for name in ("tree16-fp32-overlapped", "nested3-fp32-overlapped", "factored-fp32-overlapped",
                     "parallel-fp32-paper-fmac"):
            self.assertTrue(wide[name], name)
        for name in ("tree8-fp32-overlapped", "cg3-fp32-paper", "nested-fx18-overlapped"):
            self.assertFalse(wide[name], name)

    def test_selection(self):
        wanted = self.run_script("list", "--n", "4", "--format", "fx18", text=self.ROWS)
        self.assertEqual(wanted.stdout, "good-row\n")
        refused = self.run_script("list", "--n", "3")
        self.assertEqual(refused.returncode, 1)
        self.assertRegex(refused.stderr, r"^configurations.py: N=3: unknown here: one of [0-9, ]+\n$")

    def test_cpp_has_all_rows_and_the_factory_those_of_its_tier(self):
        table, factory = self.folder / "table.cpp", self.folder / "factory.cpp"
        self.run_script("cpp", str(table), text=self.ROWS)
        self.run_script("factory", str(factory), "--tier", "test")
        self.assertIn(
            '{"good-row", "tree", 4, "fx18", "paper", "iterative", 5, 4, 0, 3, "test"},',
            table.read_text())
        self.assertIn('"large"', table.read_text())
        self.assertIn('#include "Vgood_row.h"', factory.read_text())
        self.assertNotIn("large", factory.read_text())
        self.run_script("factory", str(factory), "--core", "axi", "--suffix", "_axi")
        self.assertIn('#include "Vgood_row_axi.h"', factory.read_text())
        self.assertNotIn("Vsmall", factory.read_text())

    def test_output_is_written_only_when_changed(self):
        for command in ("cmake", "cpp", "factory"):
            out = self.folder / f"{command}.out"
            self.run_script(command, str(out), text=self.ROWS)
            os.utime(out, (1, 1))
            self.run_script(command, str(out))
            self.assertEqual(out.stat().st_mtime, 1, command)
            self.run_script(command, str(out), text=self.ROWS.replace(",4,fx18", ",8,fx18"))
            changed = out.stat().st_mtime != 1
            self.assertEqual(changed, command != "factory", command)


if __name__ == "__main__":
    unittest.main(verbosity=2)
