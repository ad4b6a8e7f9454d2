"""One sixth by shifts, and the weights of the B-spline from s^2 and s^3, for every width.

The sixth is compared with a bound of its error, the weights with the formulas of docs/numerics.md
section 5, in words so wide that nothing is lost.

SPDX-License-Identifier: Apache-2.0
"""

from fixed import FIXED, half_up, product
from netlist import Bug
from prove import Case, Theorem
from terms import concat, const, every, ite

GUARD = 3     # bits of a power behind a unit
BEHIND = 6    # bits behind a unit of what a weight is made of


def sixth(unit, p):
    """0 <= 8/6 value - eighth < a unit for each of the steps and 3 for the factors left out."""
    bits = p["W"]
    wide, steps = bits + 8, (bits - 2).bit_length() - 1
    value, eighth = (word.zext(wide) for word in (unit.inputs["value_i"], unit.outputs["eighth_o"]))
    left = value + value + value + value - (eighth + eighth + eighth)
    return [unit.inputs["value_i"] <= 1 << (bits - 1)], every(~left.slt(0), left.slt(3 * (steps + 3)))


def _sixth_of(cube, bits):
    """X, of a cube of units 2^-GUARD, in units 2^-BEHIND: a factor 1 + 2^-k for k = 2, 4, 8 ... to W, each cut."""
    found, places = cube, 2
    while places <= bits:
        found = found + (found >> places)
        places *= 2
    return found


def weights(unit, p):
    """The four weights, or those of the derivative, as words; all in units of 2^-BEHIND of a weight's unit."""
    bits = p["FORMAT"]
    fraction, wide, latency = bits - 2, bits + 12, p["MUL_LATENCY"]
    coordinate, one = unit.inputs["coordinate_i"].bits(bits - 1, 0), 1 << (bits - 2)
    square, parts = product(coordinate, coordinate, latency)
    rounded = half_up(square.sext(2 * bits + 2), fraction).bits(bits - 1, 0)
    cube, more = product(coordinate, ite(unit.inputs["derivative_i"], const(0, bits), rounded), latency)
    inside = [~coordinate.slt(0), coordinate.sle(one),
              *(truth for power in (square, cube) for truth in (~power.slt(0), power.sle(one * one)))]

    def cut(power):
        return power.bits(fraction - GUARD + wide - 1 if power.width > fraction - GUARD + wide else power.width - 1,
                          fraction - GUARD).sext(wide)

    s = coordinate.sext(wide) << BEHIND
    s2, s3 = cut(square) << (BEHIND - GUARD), cut(cube) << (BEHIND - GUARD)
    whole = one << BEHIND
    part, x = const(whole // 6, wide), _sixth_of(cut(cube), bits)
    two_thirds, rest = (2 * one + 1) // 3, one - 2 * ((one + 3) // 6)
    function = (half_up(part + (s2 - s).ashr(1) - x, BEHIND),
                half_up(part + (s + s2 - s3).ashr(1), BEHIND) + ite(coordinate.eq(one), const(rest - two_thirds, wide),
                                                                   const(0, wide)),
                half_up(x, BEHIND))
    slope = (half_up((s + s - s2 - whole).ashr(2), BEHIND), half_up((s + s - s2 - s2 - s2 + whole).ashr(2), BEHIND),
             half_up(s2.ashr(2), BEHIND))
    given = [ite(unit.inputs["derivative_i"], *pair) for pair in zip(slope, function)]
    left = ite(unit.inputs["derivative_i"], const(0, wide), const(one, wide)) - given[0] - given[1] - given[2]
    flag = unit.inputs["coordinate_i"].bit(bits)
    words = [concat(flag, one.bits(bits - 1, 0)) for one in (given[2], given[1], left, given[0])]
    return parts + more + inside, unit.outputs["weights_o"].eq(concat(*words))


_LATENCIES = ((2, 1), (1, 1), (3, 1), (4, 2))
THEOREMS = (
    Theorem("fx.sixth", "At most 8/6 of the value, and less below it than a unit for each step and 3 more.",
            "W 4 to 64", Bug("ffd_fx_sixth", "part >> (2 << k)", "part >> (3 << k)"),
            tuple(Case("ffd_fx_sixth", {"W": w, "LATENCY": latency}, latency, sixth)
                  for w in range(4, 65) for latency in ((0, 1, 2, 4) if w in (19, 34) else (0,))), control=15),
    Theorem("num.powers", "The four weights of the B-spline and of its derivative by the formulas of section 5, from s^2 "
            "and s^3; they sum to one, and to zero.", "W 8 to 32",
            Bug("ffd_num_powers", "square[CUT +: POWER_W], factor &", "square[CUT +: POWER_W], square[FRACTION +: W] &"),
            tuple(Case("ffd_num_powers", {"FORMAT": form, "MUL_LATENCY": mul, "ADD_LATENCY": add}, 3 * (mul + add), weights)
                  for form in FIXED for mul, add in (_LATENCIES if form in (17, 18, 32) else _LATENCIES[:1])),
            note="products shared; lemmas product.parts, product.low and product.unit"),
)
