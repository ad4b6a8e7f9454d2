"""What comes in and what goes out: words of the stream and numbers, in binary32, fixed point and blocks.

SPDX-License-Identifier: Apache-2.0
"""

from lab.theorems import ieee
from lab.theorems.fixed import FORMATS, flags, half_up, saturated, total, width
from lab.theorems.netlist import Bug
from lab.theorems.prove import Case, Theorem
from lab.theorems.terms import concat, const, every, ite

FP32 = 0
COORDINATE, COEFFICIENT, POINT = 0, 1, 2
ONE32 = 0x3F800000


def is_float(form):
    return form == FP32 or form > 64


# ---- range


class Range:
    """A word as a coordinate: whether it is a number, below 0 or above 1."""

    def __init__(self, word, form):
        if is_float(form):
            number = ieee.number(word)
            above_one = word.bits(30, 0) > ONE32
            self.nan = number.nan | number.infinite
            self.above = every(~self.nan, ~number.sign, above_one)
            self.below = every(~self.nan, number.sign, ~number.zero)
            self.upper = ~number.sign            # the end nearer to what is no number
        else:
            self.nan = const(0, 1)
            self.below = word >= 0xC0000000
            self.above = ~self.below & (word > 0x80000000)
            self.upper = ~self.below
        self.outside = self.above | self.below


def ranged(unit, p):
    word, one = unit.inputs["word_i"], const(ONE32 if is_float(p["FORMAT"]) else 0x80000000, 32)
    span, out = Range(word, p["FORMAT"]), unit.outputs
    right = ite(span.above, one, ite(span.below, const(0, 32), word))
    return [], every(out["nan_o"].eq(span.nan), out["outside_o"].eq(span.outside),
                     span.nan | out["clamped_o"].eq(right))


# ---- in


def _aligned(word, places, bits):
    """(value, whether it saturates) of a binary32 word times 2^places, rounded half up to so many bits."""
    number, wide = ieee.number(word), 12
    shift = number.place.zext(wide) + const(ieee.BINARY32.lowest, wide) + places
    # So far down all is below half a unit, so far up all that is not zero saturates.
    shift = ite(shift.slt(-26), const(-26, wide), ite(shift.slt(bits + 1), shift, const(bits + 1, wide)))
    size = 24 + 26 + bits + 4
    exact = number.significand.zext(size) << (shift + 26).sext(size)
    exact = half_up(ite(number.sign, -exact, exact), 26)
    return saturated(exact, bits)


def _fixed_word(word, drop, bits):
    wide = 80
    exact = word.sext(wide)
    return saturated(half_up(exact, drop) if drop > 0 else exact << -drop, bits)


def entered(unit, p):
    form = p["FORMAT"]
    word, role = unit.inputs["word_i"], unit.inputs["role_i"]
    clear, clamp, one = (unit.inputs[f"{name}_i"] for name in ("clear", "clamp", "one"))
    span, coordinate = Range(word, form), role.eq(COORDINATE)
    asked = every(coordinate, clamp, one)
    off = every(coordinate, span.nan | span.outside, clamp if form == FP32 else const(1, 1))
    out = unit.outputs
    seen = every(out["nan_o"].eq(span.nan), out["outside_o"].eq(span.outside))
    if form == FP32:
        end = ite(asked | span.upper, const(ONE32, 32), const(0, 32))
        right = ite(clear, const(0, 32), ite(asked | off, end, word))
        return [role.ne(3)], seen & out["number_o"].eq(right)
    bits = width(form)
    number = ite(coordinate, _coordinate(word, form), _coefficient(word, form))
    end = ite(asked | span.upper, const(1 << (bits - 2), bits), const(0, bits))
    flag = ~asked & ~clamp
    number = ite(asked | off, concat(const(0, flags(form) - 1) if flags(form) > 1 else None, flag, end), number)
    number = ite(role.eq(POINT), _point(word, unit.inputs["exponent_i"], form), number)
    return [role.ne(3)], seen & out["number_o"].eq(ite(clear, const(0, bits + flags(form)), number))


def _coordinate(word, form):
    """One inside [0, 1]."""
    bits = width(form)
    if form > 64:
        value, _ = _aligned(word, const(bits - 2, 12), bits)
        return value.zext(bits + 3)
    return half_up(word.zext(40), 33 - bits).bits(bits - 1, 0).zext(bits + 1)


def _coefficient(word, form):
    bits = width(form)
    value, over = _fixed_word(word, 32 - bits, bits)
    return concat(over, value).zext(bits + flags(form))


def _point(word, exponent, form):
    bits = width(form)
    if form <= 64:
        value, over = _fixed_word(word, 32 - bits, bits)
        return concat(over, value)
    number = ieee.number(word)
    value, over = _aligned(word, const(bits - 1, 12) - exponent.sext(12), bits)
    special = number.nan | number.infinite
    plus, minus = number.nan | (number.infinite & ~number.sign), number.nan | (number.infinite & number.sign)
    return concat(minus, plus, over & ~special, ite(special, const(0, bits), value))


# ---- out


def left(unit, p):
    """A sum of a block as a word of binary32."""
    form, given = p["FORMAT"], total(unit.inputs["sum_i"], p["FORMAT"])
    bits, out = width(form), unit.outputs
    plus, minus = given.all.bit(1), given.all.bit(2)
    exponent = unit.inputs["exponent_i"].sext(14)
    if p.get("POWER", 1) == 3:
        exponent = exponent + exponent + exponent
    exponent = exponent - (p.get("SHIFT", 0) + 2 * bits - 3)
    sign = given.value.bit(given.value.width - 1)
    word = ieee.rounded(sign, ite(sign, -given.value, given.value), exponent)
    word = ite(plus | minus, ieee.infinity(minus), word)
    word = ite(plus & minus, const(ieee.BINARY32.nan, 32), word)
    return [], every(out["word_o"].eq(word), out["saturated_o"].eq(given.flag), out["nan_o"].eq(plus & minus))


def left_fp32(unit, _):
    word, out = unit.inputs["sum_i"], unit.outputs
    return [], every(out["word_o"].eq(word), out["saturated_o"].eq(0), out["nan_o"].eq(ieee.number(word).nan))


def given_words(unit, p):
    """A coordinate in units of 2^-24 as a word."""
    given, out = unit.inputs["coordinate_i"], unit.outputs["word_o"]
    if not is_float(p["FORMAT"]):
        largest = const(0xBFFFFFFF, 32)
        return [], out.eq(ite(given >= (3 << 23), largest, given.zext(32) << 7))
    exact = ite(given.bit(24), given & ~const(1, 25), given)
    return [], out.eq(ieee.rounded(const(0, 1), exact, const(-24, 10)))


def _in():
    cases = []
    for form in (FP32, *FORMATS):
        for latency in (0, 1, 2, 4) if form in (FP32, 18, 32, 99) else (0,):
            cases.append(Case("ffd_num_in", {"FORMAT": form, "LATENCY": latency}, latency, entered))
    return tuple(cases)


class Leading:
    """`left` of the sums whose magnitude has its leading one at one place, or is zero (place -1)."""

    def __init__(self, place):
        self.place = place

    def __call__(self, unit, p):
        assumed, goal = left(unit, p)
        value = total(unit.inputs["sum_i"], p["FORMAT"]).value
        size = ite(value.bit(value.width - 1), -value, value)
        if self.place < 0:
            return [*assumed, size.eq(0)], goal
        top = size.bits(size.width - 1, self.place)
        return [*assumed, top.eq(1)], goal

    def label(self):
        return f"leading one at {self.place}"

    __str__ = label


def _out(width_of, claims, power=1, shift=0):
    parameters = {"FORMAT": 64 + width_of, "POWER": power, "SHIFT": shift}
    return tuple(Case("ffd_num_out", {**parameters, "LATENCY": 0}, 0, claim) for claim in claims)


# Two words of other lengths whole; the one that rows have, with each of the 76 places of a leading one.
_OUT35 = _out(35, map(Leading, range(-1, 2 * 35 + 6)))
_OUT_LATER = tuple(Case("ffd_num_out", {"FORMAT": 99, "POWER": 1, "SHIFT": 0, "LATENCY": latency}, latency, left)
                   for latency in range(1, 13))

THEOREMS = (
    Theorem("num.range", "Whether a word is no number, below 0 or above 1, and the nearest word in [0, 1].",
            "all formats", Bug("ffd_num_range", "&word_i[31:30]", "word_i[31] && |word_i[30:29]"),
            tuple(Case("ffd_num_range", {"FORMAT": form}, 0, ranged) for form in (8, FP32, *FORMATS)), quick=True),
    Theorem("num.in", "A word of the stream as a coordinate, a coefficient or a point: rounded half up once, clamped "
            "or saturated, flagged; in blocks times 2^-exponent, infinities and NaN beside the number.", "all formats",
            Bug("ffd_bfp_align", "negate2 ? !(half && rest) : half", "negate2 ? !half : half"), _in(), control=-1),
    Theorem("num.out.block", "sum x 2^exponent rounded once to binary32, ties to even; infinities and NaN are those "
            "beside the sum.", "W 35, latencies 0 to 12",
            Bug("ffd_bfp_normalise", "p4_significand[0] || p4_sticky", "p4_significand[0]"), _OUT35, also=_OUT_LATER,
            control=40, heavy=True, note="by the place of the leading one"),
    Theorem("num.out.block.narrow", "The same of narrow words at once, also times 2^(3 exponent - SHIFT), as of det J.",
            "W 8, SHIFT 0, 2 and 7", Bug("ffd_num_out", "total[WIDE_W-2] != sign || ", ""),
            (*_out(8, (left,), 3, 2), *_out(8, (left,)), *_out(8, (left,), 3, 7))),
    Theorem("num.out.fp32", "The sum is the word; a NaN is told.", "binary32",
            Bug("ffd_num_out", "&sum_i[30:23] & |sum_i[22:0]", "&sum_i[30:23]"),
            tuple(Case("ffd_num_out", {"FORMAT": FP32, "LATENCY": latency}, latency, left_fp32) for latency in (0, 1))),
    Theorem("num.coordinate", "A coordinate in units of 2^-24 as a word, exact; in fixed point at most 0xBFFFFFFF.",
            "all formats", Bug("ffd_num_coordinate", "&coordinate_i[24:23]", "&coordinate_i[24:22]"),
            tuple(Case("ffd_num_coordinate", {"FORMAT": form}, 0, given_words) for form in (8, FP32, *FORMATS))),
)
