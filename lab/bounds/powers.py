"""The weights of the evaluator `powers`, and those of derivatives, as Gappa scripts (docs/numerics.md section 5).

Coordinates that are rounded to 1, where one weight of a position is put right by a unit, have a script of their own.

SPDX-License-Identifier: Apache-2.0
"""

import fractions

from lab.bounds import dyadic
from lab.bounds.weights import Script

PIECES = 4
GUARD = 3  # digits of a power behind those of a weight


def over(digits):
    """The units by which 2/3, rounded, is above what two sixths leave of 1 (1 or -1)."""
    unit = 1 << digits
    return (2 * unit + 1) // 3 - (unit - 2 * ((unit + 3) // 6))


def cut(script, name, exact, digits):
    script.lines.append(f"{name} = fixed<-{digits},dn>({exact});")


def sixth_of_cube(script, digits):
    """X: eight sixths of C by shifts and additions, each cut; then an eighth of that."""
    script.lines += ["k0 = C;", "f0 = 1;"]
    shift, last = 2, 0
    while shift < digits + GUARD:
        before, last = last, last + 1
        moved, factor = f"k{before} * 1b-{shift}", f"(1 + 1b-{shift})"
        cut(script, f"c{last}", moved, digits + GUARD)
        script.lines.append(f"k{last} = k{before} + c{last};")
        script.lines.append(f"f{last} = f{before} * {factor};" if before else f"f1 = {factor};")
        rest = f" + (k{before} - C * f{before}) * {factor}" if before else ""
        script.hints.append(f"k{last} - C * f{last} -> (c{last} - {moved}){rest};")
        shift *= 2
    script.lines.append(f"X = k{last} * 1b-3;")
    script.hints.append(f"X - e3 -> (k{last} - C * f{last}) * 1b-3 + C * (f{last} * 1b-3 - 1/6) + (C - cube) * (1/6);")


def powers_script(function, form, at_one, bound=None):
    """How far a weight may be off: of coordinates that are rounded to 1, or of all others."""
    digits = form.digits
    script = Script(form)
    if at_one:
        script.lines.append("x = 1;")
    else:
        script.rounded("x", "given")
    script.lines += ["square = given * given;", "cube = square * given;", "e3 = cube * (1/6);",
                     "e0 = 1/6 + (square - given) * 1b-1 - e3;", "e2 = 1/6 + (given + square - cube) * 1b-1;",
                     "e1 = 1 - e0 - e2 - e3;"]
    cut(script, "S", "x * x", digits + GUARD)
    script.rounded("R", "x * x")
    cut(script, "C", "x * R", digits + GUARD)
    sixth_of_cube(script, digits)
    sixth = dyadic.exact(fractions.Fraction((1 << (digits + 6)) // 6, 1 << (digits + 6))).gappa()
    script.lines.append(f"y0 = {sixth} + (S - x) * 1b-1 - X;")
    script.lines.append(f"y2 = {sixth} + (x + S - C) * 1b-1;")
    script.rounded("w0", "y0")
    script.rounded("v2", "y2")
    script.rounded("w3", "X")
    script.lines.append(f"w2 = v2 - {over(digits)}b-{digits};" if at_one else "w2 = v2;")
    mended = "(v2 - w2)" if at_one else "0"
    script.lines.append("w1 = 1 - w0 - w2 - w3;")
    script.lines.append(f"w = w{function};")
    script.lines.append(f"e = e{function};")
    script.hints += [
        "S - square -> (S - x * x) + (x * x - square);",
        "C - cube -> (C - x * R) + x * (R - x * x) + (x * x * x - cube);",
        f"w0 - e0 -> (w0 - y0) + ({sixth} - 1/6) + ((S - square) - (x - given)) * 1b-1 - (X - e3);",
        f"w2 - e2 -> (v2 - y2) + ({sixth} - 1/6) + ((x - given) + (S - square) - (C - cube)) * 1b-1 - {mended};",
        "w3 - e3 -> (w3 - X) + (X - e3);",
        f"w1 - e1 -> - ((w0 - y0) + (v2 - y2) + (w3 - X) + ({sixth} - 1/6) + ({sixth} - 1/6) "
        f"+ ((S - square) + (S - square) - (C - cube)) * 1b-1) + {mended};"]
    half = dyadic.power(-digits - 1)
    edge = dyadic.exact(1 - half.value()).gappa()
    wanted = f"[0,{bound.gappa()}]" if bound is not None else "?"
    where = f"given in [{edge},1]" if at_one else f"given in [0,{edge}]"
    return script.text(f"{where} -> |w - e| in {wanted}", "" if at_one else f"$ given in {PIECES};")


def slopes_script(function, form, bound=None):
    """How far a weight of half a derivative may be off, anywhere in [0, 1]."""
    script = Script(form)
    script.rounded("x", "given")
    script.lines += ["square = given * given;", "e0 = (given * 2 - 1 - square) * 1b-2;",
                     "e2 = (1 + given * 2 - square * 3) * 1b-2;", "e3 = square * 1b-2;", "e1 = - (e0 + e2 + e3);"]
    cut(script, "S", "x * x", form.digits + GUARD)
    script.lines += ["y0 = (x * 2 - 1 - S) * 1b-2;", "y2 = (1 + x * 2 - S * 3) * 1b-2;", "y3 = S * 1b-2;"]
    for number in (0, 2, 3):
        script.rounded(f"w{number}", f"y{number}")
    script.lines += ["w1 = - (w0 + w2 + w3);", f"w = w{function};", f"e = e{function};"]
    script.hints += [
        "S - square -> (S - x * x) + (x * x - square);",
        "w0 - e0 -> (w0 - y0) + ((x - given) * 2 - (S - square)) * 1b-2;",
        "w2 - e2 -> (w2 - y2) + ((x - given) * 2 - (S - square) * 3) * 1b-2;",
        "w3 - e3 -> (w3 - y3) + (S - square) * 1b-2;",
        "w1 - e1 -> - ((w0 - y0) + (w2 - y2) + (w3 - y3)) - ((x - given) * 4 - (S - square) * 3) * 1b-2;"]
    wanted = f"[0,{bound.gappa()}]" if bound is not None else "?"
    return script.text(f"given in [0,1] -> |w - e| in {wanted}", f"$ given in {PIECES};")
