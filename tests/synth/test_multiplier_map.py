"""The multiplier of Gowin GW5A: synth/gw5a.ys and the model of the cell, against the product itself.

A product is mapped by the steps of the script, and what comes out is simulated with the model, for
factors at the ends of their range and at random.

SPDX-License-Identifier: Apache-2.0
"""

import random
import subprocess

import pytest

from tools.project_root import ROOT

SCRIPT, MAP = ROOT / "synth/gw5a.ys", ROOT / "synth/gw5a/multiplier.map"
MODEL = ROOT / "tb/cells/gw5a/MULTALU27X18.v"
PAIRS = 300


def design(width_a, width_b, word):
    return (f"module product (input {word} [{width_a - 1}:0] a, input {word} [{width_b - 1}:0] b, "
            f"output {word} [{width_a + width_b - 1}:0] p); assign p = a * b; endmodule\n")


def pairs(width_a, width_b):
    """Of bit patterns."""
    source = random.Random(1)
    ends = [[0, 1, 1 << (width - 1), (1 << (width - 1)) - 1, (1 << width) - 1]
            for width in (width_a, width_b)]
    return [(a, b) for a in ends[0] for b in ends[1]] + [
        (source.getrandbits(width_a), source.getrandbits(width_b)) for _ in range(PAIRS)]


def bench(width_a, width_b):
    return "\n".join([
        "module bench;", f"  reg [{width_a - 1}:0] a;", f"  reg [{width_b - 1}:0] b;",
        f"  wire [{width_a + width_b - 1}:0] p;", "  product u (.a(a), .b(b), .p(p));",
        "  initial begin",
        *(f"    a = {a}; b = {b}; #1 $display(\"%b\", p);" for a, b in pairs(width_a, width_b)),
        "  end", "endmodule", ""])


def value(bits, width, signed):
    return bits - (1 << width) if signed and bits >> (width - 1) else bits


def wrong(tmp_path, width_a, width_b, signed, map_file=MAP, model=MODEL):
    """How many products are."""
    (tmp_path / "product.v").write_text(design(width_a, width_b, "signed" if signed else ""))
    (tmp_path / "bench.v").write_text(bench(width_a, width_b))
    steps = SCRIPT.read_text().replace("synth/gw5a/multiplier.map", str(map_file)).splitlines()
    until = steps.index("script synth/gowin.ys")
    mapped = "\n".join([f"read_verilog {tmp_path}/product.v", "prep -top product", *steps[:until],
                        "select -assert-count 1 t:MULTALU27X18", "select -assert-none t:$mul",
                        f"write_verilog -noattr {tmp_path}/mapped.v", ""])
    (tmp_path / "map.ys").write_text(mapped)
    subprocess.run(["yosys", "-Q", "-T", "-q", "-s", tmp_path / "map.ys"], cwd=ROOT, check=True)
    subprocess.run(["iverilog", "-g2005", "-o", tmp_path / "bench", tmp_path / "bench.v",
                    tmp_path / "mapped.v", model], check=True)
    shown = subprocess.run(["vvp", tmp_path / "bench"], check=True, capture_output=True,
                           text=True).stdout.split()
    right = [format(value(a, width_a, signed) * value(b, width_b, signed)
                    & (1 << width_a + width_b) - 1, f"0{width_a + width_b}b")
             for a, b in pairs(width_a, width_b)]
    assert len(shown) == len(right)
    return sum(bit != wanted for bit, wanted in zip(shown, right))


@pytest.mark.parametrize("width_a, width_b, signed", (
    (18, 18, True), (18, 17, True), (9, 9, True), (27, 18, True), (18, 27, True), (17, 16, False)))
def test_products_are_exact(tmp_path, width_a, width_b, signed):
    assert wrong(tmp_path, width_a, width_b, signed) == 0


@pytest.mark.parametrize("path, right, fault", (
    (MAP, "assign Y = sum[44:0]", "assign Y = {sum[44:20], ~sum[19], sum[18:0]}"),
    (MAP, ".B(B)", ".B({B[17:1], 1'b0})"), (MAP, ".C(48'b0)", ".C(48'b1)"),
    (MODEL, "{30{B[17]}}", "{30{1'b0}}"), (MODEL, "a * b", "a * b ^ 48'h10000")))
def test_one_wrong_bit_is_found(tmp_path, path, right, fault):
    text = path.read_text()
    assert text.count(right) == 1
    faulty = tmp_path / path.name
    faulty.write_text(text.replace(right, fault))
    assert wrong(tmp_path, 18, 18, True, **{"map_file" if path == MAP else "model": faulty}) > 0
