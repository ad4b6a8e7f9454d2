"""Theorems of a few cases with their planted bugs, and what they stand on: terms beside Icarus, and
circuits that are refused.

SPDX-License-Identifier: Apache-2.0
"""

import dataclasses
import pathlib
import random
import subprocess

import pytest

from lab.theorems import fixed, floating, ieee, lemmas, netlist, powers, prove, scatter, seams, terms

ROOT = pathlib.Path(__file__).resolve().parents[3]

WORDS = 300
UNITS = (("ffd_fp_add", {"LATENCY": 3}), ("ffd_fp_mul", {"LATENCY": 2}), ("ffd_fp_fma", {"LATENCY": 4}),
         ("ffd_num_step", {"FORMAT": 32, "MUL_LATENCY": 3, "ADD_LATENCY": 1}))


def named(name):
    return next(theorem for theorem in (*lemmas.LEMMAS, *fixed.THEOREMS, *powers.THEOREMS, *scatter.THEOREMS, *seams.THEOREMS,
                                    *floating.THEOREMS) if theorem.name == name)


@pytest.mark.parametrize("name", ("fx.round", "num.add", "fx.sixth", "seam.powers", "num.less",
                                  "scatter.expand", "num.widen", "num.step"))
def test_a_theorem_is_proved_and_its_planted_bug_refuted(name, tmp_path):
    theorem = named(name)
    row = prove.Prover(tmp_path).row(dataclasses.replace(theorem, cases=theorem.cases[:3], also=()))
    assert (row["result"], row["negative_control"], row["cases"]) == ("proved", "refuted", 3)
    assert row["counterexample"]


def test_latencies_of_the_multiplier_are_one_circuit_and_another_unit_is_not(tmp_path):
    theorem, prover = named("fp32.mul"), prove.Prover(tmp_path)
    circuits = [prover.unit(case).outputs for case in (theorem.cases[0], theorem.also[3], theorem.also[6])]
    assert circuits[0] == circuits[1] == circuits[2]
    assert prover.unit(theorem.cases[0], theorem.bug).outputs != circuits[0]


@pytest.mark.parametrize("lemma", lemmas.LEMMAS, ids=lambda lemma: lemma.name)
def test_lemmas_hold_and_false_ones_do_not(lemma, tmp_path):
    row = prove.Prover(tmp_path).row(lemma)
    assert (row["result"], row["negative_control"]) == ("proved", "refuted")


def test_a_false_claim_is_open_and_says_where(tmp_path):
    def never(unit, _):
        return [], unit.outputs["sum_o"].ne(12345)

    theorem = named("num.add")
    case = dataclasses.replace(theorem.cases[0], claim=never)
    row = prove.Prover(tmp_path).row(dataclasses.replace(theorem, cases=(case,)))
    assert row["result"] == "open" and "sat" in row["left"][0]


def test_a_bug_whose_text_is_not_there_is_an_error(tmp_path):
    with pytest.raises(netlist.TheoremError, match="0 times"):
        netlist.read([("ffd_fx_round", {}, {})], tmp_path, netlist.Bug("ffd_fx_round", "no such text", ""))


def simulated(name, parameters, inputs, latency, folder):
    """What Icarus says of each of the words."""
    ports = "".join(f", .{port}(words[{place} +: {width}])" for port, (place, width) in inputs.items())
    size = sum(width for _, width in inputs.values())
    values = ", ".join(f".{key}({number})" for key, number in parameters.items())
    out = next(iter(OUTPUTS[name].items()))
    (folder / "bench.v").write_text(f"""module bench;
  reg clk = 0;
  reg [{size - 1}:0] words, all [0:{WORDS - 1}];
  wire [{out[1] - 1}:0] result;
  integer i;
  {name} #({values}) dut (.clk(clk){ports}, .{out[0]}(result));
  initial begin
    $readmemh("words.hex", all);
    for (i = 0; i < {WORDS}; i = i + 1) begin
      words = all[i];
      repeat ({latency + 1}) begin #1 clk = 1; #1 clk = 0; end
      #1 $display("%h", result);
    end
  end
endmodule
""")
    sources = [str(path) for part in ("number", "common") for path in sorted((ROOT / "rtl" / part).rglob("*.v"))]
    subprocess.run(["iverilog", "-g2005", "-I", ROOT / "rtl" / "common",
                    "-I", ROOT / "rtl" / "number", "-s", "bench", "-o", "run", "bench.v",
                    *sources], cwd=folder, check=True, capture_output=True)
    output = subprocess.run(["vvp", "run"], cwd=folder, check=True, capture_output=True, text=True).stdout
    return [int(line, 16) for line in output.split()]


OUTPUTS = {"ffd_fp_add": {"result_o": 32}, "ffd_fp_mul": {"result_o": 32}, "ffd_fp_fma": {"result_o": 32},
           "ffd_num_step": {"weight_o": 33}}


@pytest.mark.parametrize("name,parameters", UNITS, ids=lambda value: value if isinstance(value, str) else "")
def test_terms_say_what_icarus_says(name, parameters, tmp_path):
    unit, = netlist.read([(name, parameters, {})], tmp_path)
    out = next(iter(OUTPUTS[name]))
    chosen, inputs, place, numbers = random.Random(1), {}, 0, []
    for port, word in unit.inputs.items():
        if port != "clk":
            inputs[port] = place, word.width
            place += word.width
    for _ in range(WORDS):
        word = chosen.getrandbits(place)
        if chosen.random() < 0.5:  # near each other, so that sums cancel
            word = sum((word & 0x800FFFFF | chosen.randrange(125, 130) << 23) << 32 * i for i in range(3)) % (1 << place)
        numbers.append(word)
    (tmp_path / "words.hex").write_text("\n".join(f"{word:x}" for word in numbers))
    wanted = [terms.value(unit.outputs[out], {port: word >> at & ((1 << width) - 1)
                                              for port, (at, width) in inputs.items()}) for word in numbers]
    assert simulated(name, parameters, inputs, unit.depths[out], tmp_path) == wanted
    assert len(set(wanted)) > WORDS / 4


@pytest.mark.parametrize("text,complaint", (
    ("always @(posedge clk) out_o <= out_o + a_i;", "feedback"),
    ("reg [7:0] a_q; always @(posedge clk) a_q <= a_i; always @* out_o = a_q + a_i;", "meet"),
))
def test_what_is_no_pipeline_is_refused(text, complaint, tmp_path, monkeypatch):
    (tmp_path / "rtl").mkdir()
    (tmp_path / "rtl" / "small.v").write_text(
        f"module small (input clk, input [7:0] a_i, output reg [7:0] out_o);\n{text}\nendmodule\n")
    monkeypatch.setattr(netlist, "ROOT", tmp_path)
    monkeypatch.setattr(netlist, "FOLDERS", ("rtl",))
    with pytest.raises(netlist.TheoremError, match=complaint):
        netlist.read([("small", {}, {})], tmp_path / "made")


def test_what_a_number_rounds_to_is_what_the_host_says():
    """The specification of rounding on products and sums of random binary32 words, by numpy."""
    numpy = pytest.importorskip("numpy")
    chosen = random.Random(2)
    a, b, magnitude = terms.var("a", 32), terms.var("b", 32), terms.var("m", 48)
    product = ieee.product(ieee.number(a), ieee.number(b), magnitude)
    for _ in range(WORDS):
        x, y = (chosen.getrandbits(32) & 0x807FFFFF | chosen.choice((0, 1, 60, 64, 127, 190, 254, 255)) << 23 for _ in "ab")
        with numpy.errstate(all="ignore"):
            wanted = numpy.array([x], "uint32").view("float32") * numpy.array([y], "uint32").view("float32")
        expected = int(wanted.view("uint32")[0])
        expected = 0x7FC00000 if numpy.isnan(wanted[0]) else 0 if wanted[0] == 0 else expected
        significands = [(word & 0x7FFFFF) | (0x800000 if word >> 23 & 255 else 0) for word in (x, y)]
        assert terms.value(product, {"a": x, "b": y, "m": significands[0] * significands[1]}) == expected
