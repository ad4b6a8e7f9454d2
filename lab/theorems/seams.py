"""Seams: both sides of a face that two cells share get the same weights, docs/numerics.md section 5.

The lower cell evaluates at 1, the upper one at 0: function l of the one must give there what function
l - stride of the other gives, and 0 where there is none.

SPDX-License-Identifier: Apache-2.0
"""

import struct
from fractions import Fraction

from lab.theorems import terms
from lab.theorems.fixed import FIXED, FORMATS, width
from lab.theorems.netlist import Bug
from lab.theorems.prove import Case, Theorem
from lab.theorems.terms import concat, const, every, implies, ite
from lab.theorems.words import FP32, ONE32

FILE = "u_file."  # the coefficients of ffd_eval_poly_pipelined, as any words

# Functions of 1, x, x^2, x^3, and the stride at which they join (docs/numerics.md section 8).
FAMILIES = {
    "bspline": (1, None),
    "bernstein": (3, ((1, -3, 3, -1), (0, 3, -6, 3), (0, 0, 3, -3), (0, 0, 0, 1))),
    "hermite": (2, ((1, 0, -3, 2), (0, 1, -2, 1), (0, 0, 3, -2), (0, 0, -1, 1))),
    "catmull-rom": (1, ((0, -.5, 1, -.5), (1, 0, -2.5, 1.5), (0, .5, 2, -1.5), (0, 0, -.5, .5))),
    "linear": (1, ((0, 0, 0, 0), (1, -1, 0, 0), (0, 1, 0, 0), (0, 0, 0, 0))),
}
SHIFTS = {"bspline": 0, "bernstein": 2, "hermite": 1, "catmull-rom": 1, "linear": 0}


def _bits(form):
    return 32 if form == FP32 else width(form) + 1


def _end(form):
    """(the coordinate 1, the coordinate 0), never flagged."""
    one = ONE32 if form == FP32 else 1 << (width(form) - 2)
    return const(one, _bits(form)), const(0, _bits(form))


def _bspline(form):
    """With one sixth rounded once, to the unit of weights or of the words that are loaded."""
    places = 24 if form == FP32 else min(width(form) - 2, 30)
    a, half = Fraction(round(Fraction(2 ** places, 6)), 2 ** places), Fraction(1, 2)
    return ((a, -half, half, -a), (1 - 2 * a, 0, -1, 3 * a), (a, half, half, -3 * a), (0, 0, 0, a))


def _word(number, form, shift):
    """A coefficient, which must be exact, as the unit's word; binary32 ignores the shift."""
    if form == FP32:
        word, = struct.unpack(">I", struct.pack(">f", number))
        exact = Fraction(struct.unpack(">f", struct.pack(">f", number))[0]) == Fraction(number)
    else:
        scaled = Fraction(number) * 2 ** (width(form) - 2 - shift)
        word, exact = int(scaled) & ((1 << width(form)) - 1), scaled.denominator == 1
    if not exact:
        raise ValueError(f"{number} is no coefficient of format {form}")
    return word


def _joins(stride, function, end, begin):
    """What function l gives at 1 is what l - stride gives at 0; those without another give 0."""
    return every(end.eq(begin), implies(function < stride, end.eq(0)))


def of_powers(unit, p):
    """The evaluator from powers, by bank: the next cell's banks are turned by one."""
    residue, flag = unit.inputs["residue_i"], unit.inputs["coordinate_i"].bit(width(p["FORMAT"]))
    sides = [terms.substituted(unit.outputs["weights_o"], {
        "coordinate_i": concat(flag, x.bits(x.width - 2, 0)), "residue_i": place})
             for x, place in zip(_end(p["FORMAT"]), (residue, residue + 1))]
    unshared = [terms.substituted(sides[0], {"residue_i": const(place, 2)}).bits(
        place * _bits(p["FORMAT"]) + width(p["FORMAT"]) - 1, place * _bits(p["FORMAT"])).eq(0) for place in range(4)]
    return [], every(sides[0].eq(sides[1]), *unshared)


def _loaded(unit, coordinate, coefficients, shift):
    """The weight of coefficients of 1, x, x^2 and x^3."""
    return terms.substituted(unit.outputs["weight_o"], {
        "coordinate_i": coordinate, FILE + "coefficient_o": concat(*reversed(coefficients)), FILE + "shift_o": shift})


def loaded(unit, p):
    """Any coefficients whose sums by Horner's rule at 1 do not saturate: the weight there is that of
    functions which begin with their sum, also where it is flagged."""
    bits, shift = width(p["FORMAT"]), unit.inputs[FILE + "shift_o"]
    given = [terms.var(f"c{power}", bits) for power in range(4)]
    other = [terms.var(f"d{power}", bits) for power in range(1, 4)]
    total, inside = given[3].sext(bits + 2), []
    for one in reversed(given[:3]):
        total = total + one.sext(bits + 2)
        inside.append(total.eq(total.bits(bits - 1, 0).sext(bits + 2)))
    one, zero = _end(p["FORMAT"])
    end = _loaded(unit, one, [word.zext(bits + 1) for word in given], shift)
    begin = _loaded(unit, zero, [word.zext(bits + 1) for word in (total.bits(bits - 1, 0), *other)], shift)
    return inside, end.eq(begin)


class Family:
    """A family of the driver, its coefficients loaded."""

    def __init__(self, name):
        self.name = name

    def __call__(self, unit, p):
        form = p["FORMAT"]
        stride, matrix = FAMILIES[self.name]
        shift = 0 if form == FP32 else SHIFTS[self.name]
        words = [[const(_word(number, form, shift), _bits(form)) for number in function]
                 for function in matrix or _bspline(form)]
        which = terms.var("function", 2)

        def at(coordinate, function):
            chosen = [ite(function.bit(1), ite(function.bit(0), d, c), ite(function.bit(0), b, a))
                      for a, b, c, d in zip(*words)]
            return _loaded(unit, coordinate, chosen, const(shift, 2))

        one, zero = _end(form)
        return [], _joins(stride, which, at(one, which), at(zero, which - stride))

    def label(self):
        return self.name

    __str__ = label


def _poly(form, mul, add, claim, fma=0):
    step = fma or mul + add
    late = {FILE + "coefficient_o": (2 * step, step, 0, 0), FILE + "shift_o": 3 * step}
    return Case("ffd_eval_poly_pipelined", {"FORMAT": form, "MUL_LATENCY": mul, "ADD_LATENCY": add, "FMA_LATENCY": fma},
                3 * step, claim, late)


def _families():
    floats = [_poly(FP32, 4, 4, Family(name), fma) for fma in (0, 4) for name in FAMILIES]
    return (*(_poly(form, 2, 1, Family(name)) for name in FAMILIES for form in FORMATS), *floats)


THEOREMS = (
    Theorem("seam.loaded", "Coefficients, any whose sums by Horner's rule at 1 fit: the weight at 1 is that at 0 of "
            "functions that begin with their sum.", "W 8 to 35",
            Bug("ffd_num_step", ".addend_i   (coefficient[W-1:0])", ".addend_i   ({coefficient[W-1:1], 1'b0})"),
            tuple(_poly(form, 2, 1, loaded) for form in FORMATS),
            note="evaluator pipelined"),
    Theorem("seam.families", "bspline, bernstein, hermite, catmull-rom and linear, loaded: what function l gives at 1 "
            "is what l - stride gives at 0, and 0 where there is none.", "all formats, binary32 also fused",
            Bug("ffd_num_step", ".DROP (W - 2)", ".DROP (W - 3)"), _families(), note="evaluator pipelined"),
    Theorem("seam.powers", "Of weights from s^2 and s^3, by bank: those at 1 are those at 0 of the next cell, and 0 in "
            "the bank of the layers that only one of them has; of derivatives too.", "W 8 to 32",
            Bug("ffd_num_powers", "RIGHT = ABOVE ? ZERO - UNIT : UNIT", "RIGHT = ABOVE ? UNIT : ZERO - UNIT"),
            tuple(Case("ffd_eval_powers", {"FORMAT": form, "MUL_LATENCY": 2, "ADD_LATENCY": 1}, 9, of_powers)
                  for form in FIXED), note="evaluator powers", quick=True),
)
