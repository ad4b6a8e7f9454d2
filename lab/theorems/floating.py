"""binary32: the adder and the multiplier on all operands at every latency, the fused unit by cases.

The adder is compared with `fp.add` of SMT-LIB's theory of floating point. Multiplications are cut:
the products of halves, or the whole product, are any words for which `lemmas` hold, the same for the
unit and for what it should compute.

SPDX-License-Identifier: Apache-2.0
"""

from lab.theorems import ieee, lemmas
from lab.theorems.netlist import Bug
from lab.theorems.prove import Case, Theorem, shared
from lab.theorems.terms import const, either, every, ite, raw

LATENCIES = tuple(range(1, 13))
_SUM = "(fp.add RNE ((_ to_fp 8 24) {0}) ((_ to_fp 8 24) {1}))"


def _truth(text, *words):
    return raw(f"(ite {text} #b1 #b0)", 1, *words)


def added(unit, _):
    a, b, result = unit.inputs["a_i"], unit.inputs["b_i"], unit.outputs["result_o"]
    same = _truth(f"(= ((_ to_fp 8 24) {{2}}) {_SUM})", a, b, result)
    return [], ite(_truth(f"(fp.isNaN {_SUM})", a, b), result.eq(ieee.BINARY32.nan),
                   ite(_truth(f"(fp.isZero {_SUM})", a, b), result.eq(0), same))


def _halves(number):
    return number.significand.bits(11, 0), number.significand.bits(23, 12)


def multiplied(unit, _):
    a, b = ieee.number(unit.inputs["a_i"]), ieee.number(unit.inputs["b_i"])
    whole, assumed = const(0, 48), []
    for i, one in enumerate(_halves(a)):
        for j, other in enumerate(_halves(b)):
            part = shared(one.zext(26), other.zext(26))
            assumed.append(part < (1 << 24))
            whole = whole + (part.zext(48) << 12 * (i + j))
    assumed += lemmas.truths_of(whole, a, b, 24)
    return assumed, unit.outputs["result_o"].eq(ieee.product(a, b, whole))


class Fused:
    """a b + c where the product's last bit is worth 2^distance of that of c."""

    NEAR = range(-52, 31)   # below, c is all above the product; above, the product above c

    def __init__(self, distance):
        self.distance = distance

    def __call__(self, unit, _):
        a, b, c = (ieee.number(unit.inputs[port]) for port in ("a_i", "b_i", "c_i"))
        product = shared(a.significand.zext(48), b.significand.zext(48))
        apart = a.place.zext(12) + b.place.zext(12) + const(ieee.BINARY32.lowest, 12) - c.place.zext(12)
        if self.distance in self.NEAR:
            chosen, word = apart.eq(self.distance), self.near(a, b, c, product)
        elif self.distance > 0:
            chosen, word = ~apart.slt(self.distance), self.small(product, self.place(a, b), a.sign ^ b.sign,
                                                                 c.significand, c.sign)
            word = ite(product.eq(0), ieee.rounded(c.sign, c.significand, self.exponent(c)), word)
        else:
            chosen, word = apart.sle(self.distance), self.small(c.significand, self.exponent(c), c.sign,
                                                                product, a.sign ^ b.sign)
        return [*lemmas.truths_of(product, a, b, 24), chosen], \
            unit.outputs["result_o"].eq(self.special(a, b, c, word))

    @staticmethod
    def exponent(c):
        return c.place.zext(14) + const(ieee.BINARY32.lowest, 14)

    @staticmethod
    def place(a, b):
        return a.place.zext(14) + b.place.zext(14) + const(2 * ieee.BINARY32.lowest, 14)

    def near(self, a, b, c, product):
        """The exact sum, rounded once."""
        left, right = max(self.distance, 0), max(-self.distance, 0)
        size = max(48 + left, 24 + right) + 2
        one, other = product.zext(size) << left, c.significand.zext(size) << right
        total = ite(a.sign ^ b.sign, -one, one) + ite(c.sign, -other, other)
        exponent = self.exponent(c) if left else self.place(a, b)
        sign = total.bit(size - 1)
        return ieee.rounded(sign, ite(sign, -total, total), exponent)

    @staticmethod
    def small(large, exponent, sign, other, other_sign):
        """A sum with a part that is below a quarter of the large one's last bit, wherever that is the
        last bit of a result or half of it: how small it is does not matter, since no number and no
        middle between numbers lies between. Where the large one is zero, what is left rounds to 0."""
        size = large.width + 3
        one = large.zext(size) << 2
        total = ite(other.eq(0), one, ite((sign ^ other_sign) & one.any(), one - 1, one + 1))
        return ieee.rounded(sign, total, exponent - 2)

    @staticmethod
    def special(a, b, c, word):
        infinite, sign = either(a.infinite, b.infinite), a.sign ^ b.sign
        nan = either(a.nan, b.nan, c.nan, every(a.infinite, b.zero), every(a.zero, b.infinite),
                     every(infinite, c.infinite, sign ^ c.sign))
        word = ite(infinite, ieee.infinity(sign), ite(c.infinite, ieee.infinity(c.sign), word))
        return ite(nan, const(ieee.BINARY32.nan, 32), word)


    def label(self):
        return f"distance {self.distance}"

    __str__ = label


def _cases(name, *claims, solver="bitwuzla"):
    return {"cases": tuple(Case(name, {"LATENCY": 1}, 1, claim, solver=solver) for claim in claims),
            "also": tuple(Case(name, {"LATENCY": latency}, latency, claims[0]) for latency in LATENCIES)}


_DISTANCES = (-48, Fused.NEAR.start - 1, *Fused.NEAR, Fused.NEAR.stop)

THEOREMS = (
    Theorem("fp32.add", "a + b rounded to nearest, ties to even, for all pairs of words: NaN is 0x7FC00000, "
            "a zero is +0.", "binary32, latencies 1 to 12",
            Bug("ffd_fp_add", "|p6_normal[2:0]", "|p6_normal[2:1]"),
            **_cases("ffd_fp_add", added, solver="z3"), note="against fp.add of SMT-LIB"),
    Theorem("fp32.mul", "a b rounded to nearest, ties to even, for all pairs of words: NaN is 0x7FC00000, "
            "a zero is +0.", "binary32, latencies 1 to 12",
            Bug("ffd_fp_mul", "p3_product >> (SIG_W - 1)", "p3_product >> SIG_W"),
            **_cases("ffd_fp_mul", multiplied),
            note="against whole numbers; products of halves shared; lemmas product.*"),
    Theorem("fp32.fma", "a b + c exactly, rounded once to nearest, ties to even, for all triples of words.",
            "binary32, latencies 1 to 12",
            Bug("ffd_fp_fma", "p5_bit | (p5_negative & ~p5_rest)", "p5_bit"),
            **_cases("ffd_fp_fma", *map(Fused, _DISTANCES)), nightly=True, heavy=True,
            note="by the distance of product and c; the product shared; lemmas product.*"),
)
