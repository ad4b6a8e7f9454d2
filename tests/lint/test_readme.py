"""What the README promises: one screen and a half, and Verilog that can be copied as it stands; and
that `make help` fits on a screen.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import subprocess
import tempfile
import unittest

from workspace import ROOT
README = (ROOT / "README.md").read_text()
LINES, HELP_LINES, HELP_GROUPS = 150, 7, 4

AROUND = """module readme (
  input wire clk, input wire rst,
  input wire command_valid, output wire command_ready, input wire [127:0] command,
  input wire command_last,
  output wire result_valid, input wire result_ready, output wire [127:0] result,
  output wire result_last
);
{}endmodule
"""


def elaborated(verilog):
    """(status, output) of Verilator on an instance, in a module with the signals that it names."""
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "readme.v"
        source.write_text(AROUND.format(verilog))
        done = subprocess.run(
            ["verilator", "--lint-only", "-Wall", "-Wno-PINCONNECTEMPTY", "--top-module", "readme",
             "-F", ROOT / "rtl" / "hwffd.f", source],
            cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        return done.returncode, done.stdout


class Readme(unittest.TestCase):
    def test_length(self):
        self.assertLessEqual(len(README.splitlines()), LINES)

    def test_verilog_elaborates(self):
        (verilog,) = re.findall(r"^```verilog\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)
        self.assertEqual(elaborated(verilog), (0, ""))
        self.assertNotEqual(elaborated(verilog.replace(".aresetn", ".areset"))[0], 0)

    def test_verilog_is_the_row_that_it_says(self):
        (row,) = set(re.findall(r"the row\s+`([\w-]+)`", README))
        printed = subprocess.run([ROOT / "scripts" / "configurations.py", "parameters", row],
                                 stdout=subprocess.PIPE, text=True, check=True).stdout.split()
        (verilog,) = re.findall(r"^```verilog\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)
        given = dict(re.findall(r"\.([A-Z_]+)\((\w+)\)", verilog))
        header = (ROOT / "rtl" / "top" / "hwffd_stream.v").read_text()
        for parameter in printed:
            name, value = parameter.split("=")
            if name not in given:  # then it is the default
                default = re.search(rf"parameter {name} *= *(\S+?),?\n", header).group(1)
                given[name] = {"`FFD_SCHEDULE_OVERLAPPED": "0",
                               "`FFD_EVALUATOR_PIPELINED": "0"}.get(default, default)
            self.assertEqual(given[name], value, name)


class Help(unittest.TestCase):
    def test_groups(self):
        text = subprocess.run(["make", "--no-print-directory", "help"], cwd=ROOT, text=True,
                              stdout=subprocess.PIPE, check=True).stdout.partition("\n\n")[0]
        groups = re.split(r"^(?=\S)", text, flags=re.MULTILINE)[1:]
        self.assertEqual(len(groups), HELP_GROUPS)
        for group in groups:
            self.assertLessEqual(len(group.splitlines()) - 1, HELP_LINES, group)

    def test_every_target_is_named(self):
        makefile = (ROOT / "Makefile").read_text()
        phony = re.search(r"^\.PHONY: (.*)$", makefile, re.MULTILINE).group(1).split()
        named = set(re.findall(r"^\t@echo '  make ([a-z-]+)", makefile, re.MULTILINE))
        documented = set(re.findall(r"`make ([a-z-]+)`", (ROOT / "docs" / "commands.md").read_text()))
        wanted = set(phony) - {"help", "install"}
        self.assertEqual(named, wanted)
        self.assertEqual(documented & wanted, wanted)


if __name__ == "__main__":
    unittest.main(verbosity=2)
