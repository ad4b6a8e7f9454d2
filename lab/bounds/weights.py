"""The weights of an axis as Gappa scripts: Horner's rule as the core rounds it.

SPDX-License-Identifier: Apache-2.0
"""

import fractions
from dataclasses import dataclass

from lab.bounds import dyadic

F = fractions.Fraction
PIECES = 4  # of [0, 1], of which Gappa takes each by itself: more would gain 4 % and double a proof

# Functions by their coefficients of 1, x, x^2, x^3 (docs/numerics.md section 8).
SIXTH = F(1, 6)
FAMILIES = {
    "bspline": [[SIXTH, F(-1, 2), F(1, 2), -SIXTH], [1 - 2 * SIXTH, 0, -1, 3 * SIXTH],
                [SIXTH, F(1, 2), F(1, 2), -3 * SIXTH], [0, 0, 0, SIXTH]],
    "bernstein": [[1, -3, 3, -1], [0, 3, -6, 3], [0, 0, 3, -3], [0, 0, 0, 1]],
    "hermite": [[1, 0, -3, 2], [0, 1, -2, 1], [0, 0, 3, -2], [0, 0, -1, 1]],
    "catmull-rom": [[0, F(-1, 2), 1, F(-1, 2)], [1, 0, F(-5, 2), F(3, 2)], [0, F(1, 2), 2, F(-3, 2)],
                    [0, 0, F(-1, 2), F(1, 2)]],
    "linear": [[0, 0, 0, 0], [1, -1, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0]],
    "constant": [[1, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 0]],
    # Half the derivatives of B-splines (section 9).
    "slopes": [[F(-1, 4), F(1, 2), F(-1, 4), 0], [0, -1, F(3, 4), 0], [F(1, 4), F(1, 2), F(-3, 4), 0], [0, 0, F(1, 4), 0]],
}
SHIFTS = {"bspline": 0, "bernstein": 2, "hermite": 1, "catmull-rom": 1, "linear": 0, "constant": 0, "slopes": 0}


@dataclass(frozen=True)
class Format:
    """A number format; `digits` of a weight behind the point, 0 in binary32."""

    name: str
    digits: int
    word_digits: int  # of a coefficient's word: of its one sixth
    fused: bool = False

    def is_float(self):
        return self.digits == 0

    def width(self):
        return self.digits + 2


FORMATS = {f.name: f for f in (
    *(Format(f"fx{width}", width - 2, width - 2) for width in range(12, 17)), Format("fx17", 15, 15), Format("fx18", 16, 16), Format("fx32", 30, 30),
    Format("bfp32", 33, 30), Format("fp32", 0, 24), Format("fp32-fused", 0, 24, True))}


def loaded(family, function, form):
    """The coefficients of a function as the core holds them."""
    sixth = F(round(SIXTH * 2 ** form.word_digits), 2 ** form.word_digits)
    shift = 0 if form.is_float() else SHIFTS[family]
    row = FAMILIES[family][function]
    if family == "bspline":
        row = [[sixth, F(-1, 2), F(1, 2), -sixth], [1 - 2 * sixth, 0, -1, 3 * sixth],
               [sixth, F(1, 2), F(1, 2), -3 * sixth], [0, 0, 0, sixth]][function]
    return [F(c) / 2 ** shift for c in row], shift


class Script:
    """Lines of a script, with the rounding of a format."""

    def __init__(self, form):
        self.form = form
        self.lines, self.hints = [], []

    def rounded(self, name, exact):
        """name = the exact expression, rounded."""
        if self.form.is_float():
            self.lines.append(f"{name} = float<ieee_32,ne>({exact});")
            return
        # Half up is downwards of what is half a unit more: Gappa's own name for it has no Coq.
        half = dyadic.power(-self.form.digits - 1).gappa()
        self.lines.append(f"{name} = fixed<-{self.form.digits},dn>(({exact}) + {half});")
        self.hints.append(f"{name} - ({exact}) -> ({name} - (({exact}) + {half})) + {half};")

    def text(self, goal, split=""):
        return "\n".join([*self.lines, "{ " + goal + " }", *self.hints, split]) + "\n"


def number(value):
    value = F(value)
    if value.denominator & (value.denominator - 1) == 0:
        return dyadic.exact(value).gappa()
    return f"({value.numerator}/{value.denominator})"


def horner(script, coefficients, shift):
    """Computes `w`; False where nothing is computed, as all of it is a constant."""
    held = number(coefficients[3])
    script.lines.append(f"w3 = {held};")
    for power in (2, 1, 0):
        coefficient, before = number(coefficients[power]), f"w{power + 1}"
        if all(c == 0 for c in coefficients[power + 1:]):
            script.lines.append(f"w{power} = {coefficient};")
            continue
        product = f"x * {before}"
        if script.form.is_float() and not script.form.fused:
            script.lines.append(f"p{power} = float<ieee_32,ne>({product});")
            product = f"p{power}"
        script.rounded(f"w{power}", f"{coefficient} + {product}")
    script.lines.append(f"w = w0 * {1 << shift};")
    return any(c != 0 for c in coefficients[1:])


def exact_function(script, coefficients, shift):
    """The same of the family's own coefficients, at the coordinate as given, step by step."""
    scaled = [F(c) / 2 ** shift for c in coefficients]
    script.lines.append(f"e3 = {number(scaled[3])};")
    for power in (2, 1, 0):
        if all(c == 0 for c in scaled[power + 1:]):
            script.lines.append(f"e{power} = {number(scaled[power])};")
        else:
            script.lines.append(f"e{power} = {number(scaled[power])} + given * e{power + 1};")
    script.lines.append(f"e = e0 * {1 << shift};")


def weight_script(family, function, form, bound=None):
    """How far a weight may be off, anywhere in [0, 1]: `bound`, or what Gappa finds."""
    script = Script(form)
    coefficients, shift = loaded(family, function, form)
    if form.is_float():
        script.lines.append("x = given;")
    else:
        script.rounded("x", "given")
    if not horner(script, coefficients, shift):
        return None
    exact_function(script, FAMILIES[family][function], shift)
    wanted = f"[0,{bound.gappa()}]" if bound is not None else "?"
    return script.text(f"given in [0,1] -> |w - e| in {wanted}", f"$ given in {PIECES};")
