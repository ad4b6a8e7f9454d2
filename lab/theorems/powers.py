"""One sixth by shifts, and the weights of the B-spline from s^2 and s^3, for every width.

Both are compared with the formulas of docs/numerics.md section 5, weights in words so wide that nothing
is lost.

SPDX-License-Identifier: Apache-2.0
"""

from lab.theorems.fixed import FIXED, half_up, product
from lab.theorems.netlist import Bug
from lab.theorems.prove import Case, Theorem
from lab.theorems.terms import const, every, ite

GUARD = 3     # bits of a power behind a unit
BEHIND = 6    # bits behind a unit of what a weight is made of


def _sixth_of(value, places):
    """Times 4/3, a factor 1 + 2^-k for k = 2, 4, 8 ... to so many places, each product cut."""
    place = 2
    while place <= places:
        value, place = value + (value >> place), 2 * place
    return value


def sixth(unit, p):
    """By the lemma sixth.error no step of it leaves the word."""
    bits = p["W"]
    return [unit.inputs["value_i"] <= 1 << (bits - 1)], unit.outputs["eighth_o"].eq(
        _sixth_of(unit.inputs["value_i"], bits - 2))


def _given(s, square, cube, one, derivative):
    """w_0, w_2 and w_3, or those of the derivative, in words so wide that nothing is lost; by the lemma sixth.error a
    word for 0 to 2 of the cube's unit holds its sixth at every step."""
    bits = s.width
    fraction, wide = bits - 2, bits + 12

    def cut(power):
        return power.bits(power.width - 1, fraction - GUARD).sext(2 * wide).bits(wide - 1, 0)

    at_one = s.eq(one)
    s, s2, s3 = s.sext(wide) << BEHIND, cut(square) << (BEHIND - GUARD), cut(cube) << (BEHIND - GUARD)
    whole = one << BEHIND
    if derivative:
        return [half_up(exact.ashr(2), BEHIND) for exact in (s + s - s2 - whole, s + s - s2 - s2 - s2 + whole, s2)]
    part, x = const(whole // 6, wide), _sixth_of(cut(cube).bits(bits + 1, 0), bits).zext(wide)
    off = one - 2 * ((one + 3) // 6) - (2 * one + 1) // 3   # of 1-2a from 2/3 rounded
    return [half_up(part + s2.ashr(1) - s.ashr(1) - x, BEHIND),
            half_up(part + s.ashr(1) + s2.ashr(1) - s3.ashr(1), BEHIND) + ite(at_one, const(off, wide), const(0, wide)),
            half_up(x, BEHIND)]


class Weight:
    """One of the four, of the functions or of their derivatives."""

    def __init__(self, place, derivative):
        self.place, self.derivative = place, derivative

    def __call__(self, unit, p):
        bits, latency = p["FORMAT"], p["MUL_LATENCY"]
        s, one = unit.inputs["coordinate_i"].bits(bits - 1, 0), 1 << (bits - 2)
        words = [unit.outputs["weights_o"].bits(place * (bits + 1) + bits, place * (bits + 1)) for place in range(4)]
        weights = [word.bits(bits - 1, 0) for word in words]
        square, assumptions = product(s, s, latency)
        rounded = half_up(square.sext(2 * bits + 2), bits - 2).bits(bits - 1, 0)
        cube, more = product(s, const(0, bits) if self.derivative else rounded, latency)
        assumed = [unit.inputs["derivative_i"].eq(int(self.derivative)), ~s.slt(0), s.sle(one), *assumptions, *more,
                   *(truth for power in (square, cube) for truth in (~power.slt(0), power.sle(one * one)))]
        if self.derivative:
            assumed.append(cube.eq(0))
        if self.place == 1:  # what the others leave
            goal = weights[1].eq(const(0 if self.derivative else one, bits) - weights[0] - weights[2] - weights[3])
        else:
            given = _given(s, square, cube, one, self.derivative)[(0, None, 1, 2)[self.place]]
            goal = weights[self.place].sext(given.width).eq(given)
        return assumed, every(goal, words[self.place].bit(bits).eq(unit.inputs["coordinate_i"].bit(bits)))

    def label(self):
        return f"w_{self.place}{' of the derivative' if self.derivative else ''}"

    __str__ = label


_WEIGHTS = tuple(Weight(place, derivative) for derivative in (False, True) for place in range(4))
# One multiplier at latency 1; how products of halves are put together is fx.product.
_LATENCIES = ((1, 1), (2, 1), (3, 1), (4, 2))
THEOREMS = (
    Theorem("fx.sixth", "The value, at most 2^(W-1), times 1 + 2^-k for k = 2, 4, 8 ... below W - 1, each product cut.",
            "W 4 to 64", Bug("ffd_fx_sixth", "part >> (2 << k)", "part >> (3 << k)"),
            tuple(Case("ffd_fx_sixth", {"W": w, "LATENCY": latency}, latency, sixth)
                  for w in range(4, 65) for latency in ((0, 1, 2, 4) if w in (19, 34) else (0,))),
            quick=True, note="how far off a sixth: lemma sixth.error"),
    Theorem("num.powers", "The four weights of the B-spline and of its derivative by the formulas of section 5, from s^2 "
            "and s^3; they sum to one, and to zero.", "W 8 to 32",
            Bug("ffd_num_powers", "square[CUT +: POWER_W], factor &", "square[CUT +: POWER_W], square[FRACTION +: W] &"),
            tuple(Case("ffd_num_powers", {"FORMAT": form, "MUL_LATENCY": mul, "ADD_LATENCY": add}, 3 * (mul + add), weight)
                  for weight in _WEIGHTS for form in FIXED for mul, add in (_LATENCIES if form in (17, 18) else _LATENCIES[:1])),
            note="products shared; lemmas product.unit and product.zero, theorem fx.product"),
)
