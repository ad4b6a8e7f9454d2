"""What the README promises: Verilog that can be copied as it stands; and that `make help` fits on a
screen.

SPDX-License-Identifier: Apache-2.0
"""

import re
import subprocess

from tools.project_root import ROOT
from tools.rtl import module_header, rtl_sources
from tools.tables import configurations, organizations

README = (ROOT / "README.md").read_text()
(VERILOG,) = re.findall(r"^```verilog\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)
HELP_LINES = 48

AROUND = """module readme (
  input wire clk, input wire rst,
  input wire command_valid, output wire command_ready, input wire [127:0] command,
  input wire command_last,
  output wire result_valid, input wire result_ready, output wire [127:0] result,
  output wire result_last
);
{}endmodule
"""


def test_verilog_elaborates(checkout):
    def elaborated(verilog):
        """What Verilator says of an instance, in a module with the signals that it names."""
        checkout.put({"readme.v": AROUND.format(verilog)})
        return checkout.run("verilator", "--lint-only", "-Wall", "-Wno-PINCONNECTEMPTY",
                            "--top-module", "readme", "-F", ROOT / "rtl" / "hwffd.f", "readme.v")
    assert elaborated(VERILOG) == (0, "", "")
    assert elaborated(VERILOG.replace(".aresetn", ".areset"))[0] != 0


def test_verilog_is_the_row_that_it_says():
    (row,) = set(re.findall(r"the row\s+`([\w-]+)`", README))
    given = {name: int(value) for name, value in re.findall(r"\.([A-Z_]+)\((\d+)\)", VERILOG)}
    header = module_header.read(rtl_sources.Sources(), "hwffd_stream")
    (organization,) = (row for row in organizations.read().values() if row.number == given["ORG"])
    defaults = {**header.parameters, **{name: organization.n for name in header.of_org}}
    wanted = configurations.find(configurations.read(), row).parameters
    assert {**defaults, **given, **wanted} == {**defaults, **given}


def test_help_fits_on_a_screen():
    text = subprocess.run(["make", "--no-print-directory", "help"], cwd=ROOT, text=True,
                          stdout=subprocess.PIPE, check=True).stdout
    assert len(text.splitlines()) <= HELP_LINES


def test_help_names_every_target():
    makefile = (ROOT / "Makefile").read_text()
    phony = re.search(r"^\.PHONY: (.*)$", makefile, re.MULTILINE).group(1).split()
    phony += re.search(r"^FORWARDED = (.*)$", makefile, re.MULTILINE).group(1).split()
    documented = set(re.findall(r"`make ([a-z-]+)`", (ROOT / "docs" / "commands.md").read_text()))
    wanted = set(phony) - {"help"}
    assert set(re.findall(r"^\t@echo '  make ([a-z-]+)", makefile, re.MULTILINE)) == wanted
    assert documented >= wanted
