"""Fixed point: the units of rtl/number/fixed and of the number layer, for every width.

Each is compared with docs/numerics.md sections 3 and 10, in words so wide that nothing is lost.

SPDX-License-Identifier: Apache-2.0
"""

from lab.theorems.netlist import Bug
from lab.theorems.prove import Case, Theorem, shared
from lab.theorems.terms import concat, const, every, ite

FIXED, BLOCK = range(8, 33), range(72, 100)
FORMATS = (*FIXED, *BLOCK)
ALL_LATENCIES = (18, 32, 99)   # formats whose units are read at several latencies
BLOCK_W = 18                   # what one multiplier takes


def width(form):
    return form - 64 if form > 64 else form


def flags(form):
    return 3 if form > 64 else 1


def half_up(exact, drop):
    """floor(exact / 2^drop + 1/2)."""
    return (exact + (1 << drop >> 1)).ashr(drop)


def saturated(exact, bits):
    """(the nearest word of so many bits, whether it is another)."""
    top = (1 << (bits - 1)) - 1
    above, below = const(top, exact.width).slt(exact), exact.slt(-top - 1)
    return ite(above, const(top, bits), ite(below, const(-top - 1, bits), exact.bits(bits - 1, 0))), above | below


class Number:
    """A word of the number layer: its value, and flags in front."""

    def __init__(self, word, value_bits):
        self.value, self.all = word.bits(value_bits - 1, 0), word.bits(word.width - 1, value_bits)
        self.flag = self.all.bit(0)


def weight(word, form):
    return Number(word, width(form))


def total(word, form):
    return Number(word, 2 * width(form) + 6)


def product(a, b, latency):
    """(a b, what is known of its parts): one multiplier, or four of halves where they are too wide."""
    bits = a.width
    if bits <= BLOCK_W or latency < 2:
        return shared(a.sext(2 * bits), b.sext(2 * bits)), []
    low = (bits - 1) // 2
    part = 2 * (bits - low)
    halves = [(word.bits(low - 1, 0).zext(part), word.bits(bits - 1, low).sext(part)) for word in (a, b)]
    whole, assumed = const(0, 2 * bits), []
    for i, low_half in enumerate(halves[0]):
        for j, other in enumerate(halves[1]):
            partial = shared(low_half, other)
            whole = whole + (partial.sext(max(part, 2 * bits)).bits(2 * bits - 1, 0) << low * (i + j))
            if i + j == 0:
                assumed.append(partial < (1 << 2 * low))
    return whole, assumed


# ---- claims


def rounded(unit, p):
    wide = max(p["IN_W"], p["OUT_W"] + p["DROP"]) + 4
    exact = unit.inputs["addend_i"].sext(wide) + half_up(unit.inputs["value_i"].sext(wide), p["DROP"])
    value, flag = saturated(exact, p["OUT_W"])
    return [], every(unit.outputs["value_o"].eq(value), unit.outputs["saturated_o"].eq(flag))


def multiplied(unit, p):
    whole, assumed = product(unit.inputs["a_i"], unit.inputs["b_i"], p["LATENCY"])
    return assumed, every(unit.outputs["product_o"].eq(whole),
                          unit.outputs["flags_o"].eq(unit.inputs["flags_i"]))


def added(unit, p):
    a, b, out = (total(word, p["FORMAT"]) for word in (*(unit.inputs[k] for k in ("a_i", "b_i")),
                                                       unit.outputs["sum_o"]))
    wide = a.value.width + 1
    exact = a.value.sext(wide) + b.value.sext(wide)
    fits = exact.eq(exact.bits(wide - 2, 0).sext(wide))
    return [fits], every(out.value.sext(wide).eq(exact), out.all.eq(a.all | b.all))


def _term_flags(factor, point, form):
    """In block formats an infinity or a NaN stays one, by the signs; with a weight of 0 it is a NaN."""
    flag = factor.flag | point.flag
    if form <= 64:
        return flag
    plus, minus = point.all.bit(1), point.all.bit(2)
    special, nan = plus | minus, plus & minus
    zero, below = factor.value.eq(0), factor.value.slt(0)
    nan = nan | (special & zero)
    negative = minus ^ below
    plus, minus = nan | (special & ~negative), nan | (special & negative)
    return concat(minus, plus, flag)


def term(unit, p):
    form = p["FORMAT"]
    factor, point = weight(unit.inputs["weight_i"], form), weight(unit.inputs["point_i"], form)
    out = total(unit.outputs["term_o"], form)
    whole, assumed = product(factor.value, point.value, p["LATENCY"])
    return assumed, every(out.value.eq(whole.sext(out.value.width)),
                          out.all.eq(_term_flags(factor, point, form)))


def _weight_is(unit, port, form, exact, flag):
    value, over = saturated(exact, width(form))
    out = weight(unit.outputs[port], form)
    return every(out.value.eq(value), out.flag.eq(flag | over))


def mul(unit, p):
    form = p["FORMAT"]
    a, b = weight(unit.inputs["a_i"], form), weight(unit.inputs["b_i"], form)
    whole, assumed = product(a.value, b.value, p["LATENCY"] - 1)
    exact = half_up(whole.sext(2 * width(form) + 2), width(form) - 2)
    return assumed, _weight_is(unit, "product_o", form, exact, a.flag | b.flag)


def step(unit, p):
    form = p["FORMAT"]
    c, x, w = (weight(unit.inputs[f"{name}_i"], form) for name in ("coefficient", "coordinate", "weight"))
    whole, assumed = product(x.value, w.value, p["MUL_LATENCY"])
    wide, drop = 2 * width(form) + 4, width(form) - 2
    exact = half_up((c.value.sext(wide) << drop) + whole.sext(wide), drop)
    return assumed, _weight_is(unit, "weight_o", form, exact, c.flag | x.flag | w.flag)


def scale(unit, p):
    form, given = p["FORMAT"], weight(unit.inputs["weight_i"], p["FORMAT"])
    wide = width(form) + 4
    exact = given.value.sext(wide) << unit.inputs["shift_i"].zext(wide)
    return [], _weight_is(unit, "weight_o", form, exact, given.flag)


def _point_is(unit, form, exact, flags_in):
    value, over = saturated(exact, width(form))
    out = weight(unit.outputs["point_o"], form)
    return every(out.value.eq(value), out.all.eq(flags_in | over.zext(flags(form))))


def narrow(unit, p):
    given = total(unit.inputs["sum_i"], p["FORMAT"])
    exact = half_up(given.value.sext(given.value.width + 2), width(p["FORMAT"]) - 2 + p.get("SHIFT", 0))
    return [], _point_is(unit, p["FORMAT"], exact, given.all)


def widen(unit, p):
    form, given = p["FORMAT"], weight(unit.inputs["point_i"], p["FORMAT"])
    out = total(unit.outputs["sum_o"], form)
    exact = given.value.sext(out.value.width) << (width(form) - 2)
    return [], every(out.value.eq(exact), out.all.eq(given.all))


def negate(unit, p):
    given, out = total(unit.inputs["sum_i"], p["FORMAT"]), total(unit.outputs["negative_o"], p["FORMAT"])
    wide, flags = given.value.width + 1, given.all
    if p["FORMAT"] > 64:
        flags = concat(flags.bit(1), flags.bit(2), flags.bit(0))
    lowest = const(1 << (wide - 2), wide - 1)
    return [given.value.ne(lowest)], every(out.value.sext(wide).eq(-given.value.sext(wide)), out.all.eq(flags))


def out_word(unit, p):
    form, given = p["FORMAT"], total(unit.inputs["sum_i"], p["FORMAT"])
    wide, fraction = given.value.width + 40, 2 * width(p["FORMAT"]) - 3 + p["SHIFT"]
    exact = given.value.sext(wide)
    exact = half_up(exact, fraction - 31) if fraction > 31 else exact << (31 - fraction)
    value, over = saturated(exact, 32)
    return [], every(unit.outputs["word_o"].eq(value), unit.outputs["saturated_o"].eq(given.flag | over),
                     unit.outputs["nan_o"].eq(0), const(form < 64, 1))


# ---- theorems


def _cases(unit, claim, formats, latencies, more=None, latency=None):
    """A case for each format at the first latency, and at all of them for some formats."""
    cases = []
    for form in formats:
        for clocks in latencies if form in ALL_LATENCIES else latencies[:1]:
            parameters = {"FORMAT": form, **({} if clocks is None else {"LATENCY": clocks}), **(more or {})}
            cases.append(Case(unit, parameters, 0 if clocks is None else clocks if latency is None else latency(clocks),
                              claim))
    return tuple(cases)


def _steps():
    return tuple(Case("ffd_num_step", {"FORMAT": form, "MUL_LATENCY": mul_latency, "ADD_LATENCY": 1}, mul_latency + 1, step)
                 for form in FORMATS for mul_latency in ((1, 2, 3, 4, 5) if form in ALL_LATENCIES else (1, 3)))


_ROUND = tuple(Case("ffd_fx_round", {"IN_W": a, "DROP": d, "OUT_W": o}, 0, rounded)
               for w in range(4, 41) for a, d, o in
               ((2 * w, w - 2, w), (w + 3, 1, w), (2 * w + 6, w - 2, w + 9), (w + 9, 0, w), (w, 0, 2 * w)))
_PRODUCT = tuple(Case("ffd_fx_product", {"W": w, "LATENCY": latency}, latency, multiplied)
                 for w in range(2, 36) for latency in ((0, 1, 2, 3, 4, 5, 6) if w in (18, 32, 35) else (1, 2)))
_SHIFTS = (0, 1, 2, 3, 4, 5, 6, 7)
_W, _ALL = "W 8 to 35", "W 8 to 32"

THEOREMS = (
    Theorem("fx.round", "saturate(addend + floor(value / 2^DROP + 1/2)), flagged exactly where it saturates.",
            "W 4 to 40, in the five shapes that units use",
            Bug("ffd_fx_round", "{sign, {(OUT_W - 1) {!sign}}}", "{sign, {(OUT_W - 1) {1'b1}}}"), _ROUND, quick=True),
    Theorem("fx.product", "The product of two signed words, all bits of it.", "W 2 to 35, latencies 0 to 6",
            Bug("ffd_fx_product", "{{(2*W-PART_W-1-LOW_W) {crossed[PART_W]}}", "{{(2*W-PART_W-1-LOW_W) {1'b0}}"),
            _PRODUCT, control=next(i for i, case in enumerate(_PRODUCT) if case.parameters == {"W": 20, "LATENCY": 2}),
            note="products of halves shared; lemmas product.parts and product.low"),
    Theorem("num.add", "The exact sum where it fits Q9, and both operands' flags.", _W,
            Bug("ffd_num_add", "| b_i[VALUE_W +: FLAGS_W]", "& b_i[VALUE_W +: FLAGS_W]"),
            _cases("ffd_num_add", added, FORMATS, (1, 2, 3)), quick=True),
    Theorem("num.term", "weight x point, exact; infinities and NaN as IEEE-754 multiplies them.", _W,
            Bug("ffd_num_term", "minus || (zero && plus) : plus", "minus : plus"),
            _cases("ffd_num_term", term, FORMATS, (1, 2, 3, 4, 5)), control=-1,
            note="products shared"),
    Theorem("num.mul", "weight x weight, rounded half up once, saturated and flagged.", _W,
            Bug("ffd_num_mul", "{flag | saturated, rounded}", "{saturated, rounded}"),
            _cases("ffd_num_mul", mul, FORMATS, (3, 1, 2, 4, 5)), note="products shared"),
    Theorem("num.step", "coefficient + coordinate x weight, rounded half up once, saturated and flagged.", _W,
            Bug("ffd_num_step", ".addend_i   (coefficient[W-1:0])", ".addend_i   ({coefficient[W-1:1], 1'b0})"),
            _steps(), note="products shared"),
    Theorem("num.scale", "weight x 2^shift, saturated and flagged.", _W,
            Bug("ffd_num_scale", "shift_i > 2'd2 && lost[0]", "1'b0"), _cases("ffd_num_scale", scale, FORMATS, (0, 1, 2))),
    Theorem("num.narrow", "sum x 2^-SHIFT, rounded half up once, saturated and flagged.",
            f"{_W}, SHIFT 0 and 2; of three formats SHIFT 0 to 7",
            Bug("ffd_fx_narrow", "late_flags[0] | saturated", "saturated"),
            tuple(case for shift in _SHIFTS
                  for case in _cases("ffd_num_narrow", narrow, FORMATS if shift in (0, 2) else ALL_LATENCIES,
                                     (0, 1, 2, 3), {"SHIFT": shift}))),
    Theorem("num.widen", "point as a sum, exact.", _ALL,
            Bug("ffd_num_widen", "{8{point_i[W-1]}}", "{8{1'b0}}"), _cases("ffd_num_widen", widen, FIXED, (None,))),
    Theorem("num.negate", "-sum, exact but of the lowest sum, which no vertex has; infinities change sign.", _W,
            Bug("ffd_num_negate", "{VALUE_W{1'b0}} - sum_i[VALUE_W-1:0]", "~sum_i[VALUE_W-1:0]"),
            _cases("ffd_num_negate", negate, FORMATS, (None,))),
    Theorem("num.out", "sum x 2^-SHIFT as a word of Q1.31, rounded half up once, saturated and flagged.",
            f"{_ALL}, SHIFT 0 to 7",
            Bug("ffd_num_out", "2 * FORMAT - 3 + SHIFT", "2 * FORMAT - 3 + (SHIFT & 3)"),
            tuple(case for shift in (7, *_SHIFTS[:7])
                  for case in _cases("ffd_num_out", out_word, FIXED, (0, 1, 2), {"SHIFT": shift}))),
)
