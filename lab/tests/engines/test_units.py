"""The parts of the study of engines.

SPDX-License-Identifier: Apache-2.0
"""

import shutil

import pytest

from lab.engines import answers, axi, icarus, measured, planted, registers
from tools.rtl import rtl_sources

BEATS = ("0_00000000_00000000_00000000_00000001", "1_00000004_00000003_00000002_00000001")
SOURCE = """module {top} (input wire aclk, input wire aresetn, input wire d_i, output wire q_o);
  wire rst = !aresetn;
  reg [1:0] state_q;
  reg       data_q;
  reg       late_q;
  wire      kept;
  {top}_data u_data (.aclk(aclk), .d_i(state_q[1]), .q_o(kept));
  always @(posedge aclk) state_q <= rst ? 2'd2 : {{state_q[0], d_i}};
  always @(posedge aclk) data_q <= d_i;
  always @(posedge aclk) late_q <= state_q[1];
  assign q_o = data_q ^ late_q ^ kept;
endmodule
module {top}_data (input wire aclk, input wire d_i, output reg q_o);
  always @(posedge aclk) q_o <= d_i;
endmodule
"""


def row(**fields):
    return {"engine": "icarus", "row": "a", "results": 2, "mismatches": 0, **fields}


def unknown(**fields):
    return {"top": "t", "of": "gates", "row": "a", "mismatches": 0, "unknown": 0, "names": [], **fields}


def report(rows=(), faults=()):
    return {"rows": list(rows), "planted": list(faults)}


def test_answers_differ_by_results_and_events():
    wanted = answers.Answers(BEATS, (1, 2))
    assert answers.mismatches(wanted, wanted) == 0
    assert answers.mismatches(answers.Answers(BEATS[:1], (1, 2)), wanted) == 1
    assert answers.mismatches(answers.Answers(BEATS[::-1], (1, 3)), wanted) == 3


@pytest.mark.parametrize("files, message", (
    ({"events.txt": "1\n"}, "no beats"), ({"results.txt": "// none\n", "events.txt": "1\n"}, "no beats"),
    ({"results.txt": BEATS[0]}, "no counts")))
def test_answers_that_are_not_there_are_none(tmp_path, files, message):
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    with pytest.raises(answers.AnswerError, match=message):
        answers.read(tmp_path)


def test_packets_lie_where_their_descriptors_say():
    job = axi.job(BEATS, 3)
    assert job.memory == ("@0", f"{32:016x}{axi.PACKETS:016x}", f"@{axi.PACKETS // 16:x}",
                          "00000000" * 3 + "00000001", "00000004000000030000000200000001")
    assert job.first * 16 >= axi.PACKETS + 32 and job.words == job.first + 4
    assert job.steps[0] == f"3000{axi.ID:08x}" and job.steps[-1] == "0" * 12
    with pytest.raises(axi.AxiError, match="no end"):
        axi.job(BEATS[:1], 1)


def test_registers_that_reset_clears(tmp_path):
    if not shutil.which("yosys"):
        pytest.skip("no yosys")
    (tmp_path / "rtl").mkdir()
    (tmp_path / "rtl" / "hwffd.f").write_text("top.v\n")
    (tmp_path / "rtl" / "top.v").write_text(SOURCE.format(top="top"))
    sources = rtl_sources.Sources(tmp_path)
    assert registers.find(sources, "top", {}, tmp_path) == {"late_q": [None], "state_q": [0, 1]}
    (tmp_path / "rtl" / "top.v").write_text(SOURCE.format(top="top").replace("rst ? 2'd2 :", ""))
    with pytest.raises(registers.RegisterError, match="no registers"):
        registers.find(rtl_sources.Sources(tmp_path), "top", {}, tmp_path)


def test_bits_beside_a_valid_are_watched_while_it_is_1():
    text = registers.watch({"u.u_a_valid.gen_stage[1].data_q": [0, 1, 2], "b_q": [None]},
                           "t", "clk", "on")
    assert 'k0 (clk, on, {t.u.u_a_valid.gen_stage[1].data_q[2]});' in text
    assert "k1 (clk, on && t.u.u_a_valid.gen_stage[1].data_q[2], {" in text
    assert "k2 (clk, on, {t.b_q});" in text


def test_a_bench_that_did_not_end_says_nothing():
    assert icarus.result_of("unknown a clock 3\nbroken b clock 4\nclocks 9 beats 1\n") == (
        9, ["unknown a clock 3", "broken b clock 4"])
    with pytest.raises(icarus.SimulationError, match="did not end"):
        icarus.result_of("unknown a clock 3\n")


@pytest.mark.parametrize("name", planted.CHANGES)
def test_each_change_is_made_once(name, tmp_path):
    change = planted.CHANGES[name]
    assert change.wrong in planted.copy(name, tmp_path).read_text()
    with pytest.raises(planted.PlantError, match="does not stand there once"):
        planted.changed(change, "")


@pytest.mark.parametrize("engines, unknowns, message", (
    (report([row(mismatches=1)]), report(), "1 of 2 results"),
    (report(), report([unknown(names=["unknown x clock 1"])]), "unknown x"),
    (report(), report([unknown(mismatches=2)]), "2 results differ"),
    (report(faults=[row(fault="lut")]), report(), "'lut' was not found"),
    (report(), report(faults=[unknown(fault="reset")]), "'reset' was not found")))
def test_what_does_not_hold_is_said(engines, unknowns, message):
    violations = measured.faults(engines, unknowns)
    assert len(violations) == 1 and message in violations[0]


def test_nothing_is_said_of_what_holds():
    assert not measured.faults(report([row()], [row(mismatches=1, fault="lut")]),
                               report([unknown()], [unknown(unknown=1, fault="reset")]))
