"""Composed bounds as Gappa scripts, and the theorem that each of them ends in.

A script takes what is known of the weights of an axis (`e`), of those of a derivative (`d`), of the
products of three axes (`a`) or of two (`r`), and bounds the formula that coq/Fixed.v, Float.v and
Scatter.v prove of a form.

SPDX-License-Identifier: Apache-2.0
"""

import fractions
from dataclasses import dataclass

from lab.bounds import dyadic

CONTRACTED = ("a + given*(g*g*g) + half*(g*g + g) + last", ("e", "a"))
AXES = "stu"
SLOPES_SIZE = dyadic.exact(fractions.Fraction(3, 4))  # no sum of magnitudes of half the derivatives is larger


def scattered(along=""):
    """Of the sums of magnitudes of the weights of s, t, u: g, or n along an axis whose derivative is wanted."""
    s, t, u = ("n" if axis == along else "g" for axis in AXES)
    return (f"a + given*({s}*{t}*{u}) + half*(6*({t}*{u}) + 24*{u} + 96)", ("e", "d", "a") if along else ("e", "a"))


# Of scatter, positions and derivatives by either evaluator: the axis along which, and what weights the search has.
SCATTERS = {f"{form} along {axis}" if axis else form: (axis, f"{of_form} slopes" if axis else of_form)
            for form, of_form in (("scatter", "affine"), ("scatter powers", "powers")) for axis in ("", *AXES)}
FORMULAS = {
    "factored": CONTRACTED, "affine": CONTRACTED, "powers": CONTRACTED,
    "product": ("q + (1 + q)*given + last", ("e", "a")),
    "product by pairs": ("q + (1 + q)*given + last", ("e", "r")),
    **{form: scattered(along) for form, (along, _) in SCATTERS.items()},
}
DISTANCES = {"product": "a + 16*unit2*g + 64*unit2", "product by pairs": "64*unit2 + r*g + e"}
ORDERS = {"sequence": (False, 65, 128), "tree": (True, 7, 127)}
FUSED_ORDERS = {"sequence": (False, 64, 64), "tree": (True, 7, 95)}
# Of a form of fixed point the weights that the search calls so; and all forms in the order of the report.
WEIGHTS = {"product": "bspline", "factored": "bspline", "affine": "affine", "powers": "powers",
           **{form: of_form for form, (_, of_form) in SCATTERS.items()}}
NAMES = (*WEIGHTS, *ORDERS)

BLOCK_WEIGHT = -33  # what weights of bfp32 are rounded to multiples of, as a power of two


@dataclass(frozen=True)
class Rounding:
    """One rounding of the core: to multiples of 2^exponent, or none, where a number is one already."""

    exponent: int | None

    def half(self):
        return dyadic.Dyadic(0, 0) if self.exponent is None else dyadic.power(self.exponent - 1)

    def coq(self):
        return "exactly" if self.exponent is None else f"(half_up ({self.exponent}))"

    def half_coq(self):
        return "0" if self.exponent is None else f"(half ({self.exponent}))"

    def proof(self):
        return "exactly_error" if self.exponent is None else f"(half_up_error ({self.exponent}))"


@dataclass(frozen=True)
class Roundings:
    """What a fixed-point format rounds: weights, points as given, narrowed sums, the result."""

    weight: Rounding
    point: Rounding
    narrow: Rounding
    last: Rounding


def roundings(form):
    """Words of points and results have 31 digits: `fx32` takes points as they are, and a sum of up to
    31 digits goes out as it is."""
    width = form.width()
    point = Rounding(1 - width)
    if form.name == "bfp32":
        last = Rounding(None)  # rounded to binary32 afterwards
    else:
        last = Rounding(None if 2 * width - 3 <= 31 else -31)
    return Roundings(Rounding(2 - width), Rounding(None) if width == 32 else point, point, last)


@dataclass(frozen=True)
class Known:
    """What is known of weights: sums of magnitudes of errors on one axis, of three, and of two; and of one
    axis with the weights of a derivative, which is then among the three."""

    axis: dyadic.Dyadic
    triple: dyadic.Dyadic
    pair: dyadic.Dyadic | None = None
    slopes: dyadic.Dyadic | None = None


def of_axes(axis):
    """What the errors of single axes say of three."""
    e = axis.value()
    return Known(axis, dyadic.above((1 + e) ** 3 - 1, 40))


def fixed_script(form, rounds, known, bound=None):
    formula, names = FORMULAS[form]
    lines = [f"given = {rounds.point.half().gappa()};", f"half = {rounds.narrow.half().gappa()};",
             f"last = {rounds.last.half().gappa()};", f"unit2 = {rounds.weight.half().gappa()};",
             "g = 1 + e;"]
    if known.slopes:
        lines.append(f"n = {SLOPES_SIZE.gappa()} + d;")
    if form in DISTANCES:
        lines.append(f"q = {DISTANCES[form]};")
    lines.append(f"all = {formula};")
    values = {"e": known.axis, "d": known.slopes, "a": known.triple, "r": known.pair}
    given = " /\\ ".join(f"{name} in [0,{values[name].gappa()}]" for name in names)
    return "\n".join(lines) + "\n" + goal(given, bound)


def goal(given, bound):
    wanted = f"[0,{bound.gappa()}]" if bound is not None else "?"
    return f"{{ {given} -> |all| in {wanted} }}\n" if bound is None else f"{{ {given} -> all in {wanted} }}\n"


def float_script(order, known, bound=None):
    """The formula of Float.v, whose power is written out."""
    _, depth, count = order
    lines = ["eps = 1b-24;", "eta = 1b-150;", "g = 1 + e;", "c = 1 + eps;", "k0 = 1;"]
    lines += [f"k{n + 1} = c * k{n};" for n in range(depth)]
    lines += ["k = c * c - 1;", "q = a + k*(g*g*g) + (16*c*g + 64)*eta;",
              f"all = q + (k{depth} - 1)*(1 + q) + {count}*k{depth}*eta;"]
    given = f"e in [0,{known.axis.gappa()}] /\\ a in [0,{known.triple.gappa()}]"
    return "\n".join(lines) + "\n" + goal(given, bound)


QUANTIFIED = "forall (s t u bs bt bu : nat -> R) (P : nat -> nat -> nat -> R)"
IMPORTS = "Require Import Sums Fixed Float Programs Certified Scatter.\nOpen Scope R_scope.\n"
NUMBERS = "numbers"


@dataclass(frozen=True)
class Theorem:
    """What a certificate ends in: premises, a conclusion, and tactics that prove it."""

    premises: tuple
    conclusion: str
    proof: str
    quantified: str = QUANTIFIED

    def text(self):
        return (f"{IMPORTS}Theorem bound : {self.quantified},\n  "
                + "".join(f"{premise} ->\n  " for premise in self.premises)
                + f"{self.conclusion}.\nProof.\n{self.proof}Qed.\n")


def certificate_of(values):
    """The use of Gappa's theorem at the ends of what it takes."""
    ends = " ".join(value.coq() for value in values)
    return f"apply (proj2 (certificate {ends} ltac:({NUMBERS})))"


def within(result, bound):
    return f"Rabs ({result} - eq1 bs bt bu P) <= {bound.coq()}"


def fixed_theorem(form, rounds, known, bound):
    """The program of the form is within the bound of eq. (1)."""
    e, a = known.axis.coq(), known.triple.coq()
    point, narrow, last, weight = rounds.point, rounds.narrow, rounds.last, rounds.weight
    premises, names = [f"vertex {e} {a} s t u bs bt bu P"], "V"
    if form.startswith("product"):
        by_pair = form == "product by pairs"
        program = f"product_program s t u P {weight.coq()} {point.coq()} {last.coq()}"
        if by_pair:
            premises.append(f"pair_distance bs bt (fun l m => {weight.coq()} (s l * t m)) <= {known.pair.coq()}")
            names += " R"
        lemma = (f"(product_by_{'pair' if by_pair else 'triple'} {e} {a} {bound.coq()} s t u bs bt bu P "
                 f"{point.coq()} {weight.coq()} {last.coq()} {point.half_coq()} {weight.half_coq()} "
                 f"{last.half_coq()} V {point.proof()} {last.proof()} {weight.proof()}"
                 + (f" {known.pair.coq()} R)" if by_pair else ")"))
        values = [known.axis, known.pair if by_pair else known.triple]
    else:
        program = f"factored_program s t u P {point.coq()} {narrow.coq()} {last.coq()}"
        lemma = (f"(factored_certified {e} {a} {bound.coq()} s t u bs bt bu P {point.coq()} {narrow.coq()} "
                 f"{last.coq()} {point.half_coq()} {narrow.half_coq()} {last.half_coq()} V "
                 f"{point.proof()} {narrow.proof()} {last.proof()})")
        values = [known.axis, known.triple]
    proof = f"  apply {lemma}.\n  {certificate_of(values)}.\n"
    if weight.exponent == BLOCK_WEIGHT:
        # A result of the block is rounded to binary32 at last; all is relative to the block's 2^e.
        premises.append(f"Rabs ({program}) <= 1")
        names += " Small"
        program = f"nearest ({program})"
        total = dyadic.exact(bound.value() + fractions.Fraction(1, 2 ** 25))
        proof = f"  apply (rounded_at_last _ _ {bound.coq()}); [|exact Small|{NUMBERS}].\n" + proof
        bound = total
    return Theorem(tuple(premises), within(program, bound), f"  intros s t u bs bt bu P {names}.\n{proof}")


def scatter_theorem(form, rounds, known, bound):
    """The 64 parts of a gradient of at most 1 are together within the bound of those of eq. (1); and what n of them add
    as a row, in no more layers than they have by themselves, within n times the bound."""
    along, _ = SCATTERS[form]
    point, narrow = rounds.point, rounds.narrow
    sizes = " ".join(SLOPES_SIZE.coq() if axis == along else "1" for axis in AXES)
    errors = " ".join((known.slopes if axis == along else known.axis).coq() for axis in AXES)
    to_one = " ".join("false" if axis == along else "true" for axis in AXES)
    weights = f"{sizes} {errors} {known.triple.coq()}"
    rounded = f"{point.coq()} {narrow.coq()}"
    roundings = f"{point.proof()} {narrow.proof()}"
    halves = f"{point.half_coq()} {narrow.half_coq()}"
    certificate = certificate_of([known.axis, *([known.slopes] if along else []), known.triple])
    proof = ("  intros s t u bs bt bu g V S T U G; split.\n"
             f"  - apply (scatter_certified {weights} {bound.coq()} {to_one} s t u bs bt bu g {rounded} {halves} "
             f"V S T U G {roundings}).\n    {certificate}.\n"
             "  - intros d vertices Good D.\n"
             f"    apply (rows_certified {weights} {bound.coq()} {to_one} t u bt bu {rounded} {halves} d vertices Good T U "
             f"{roundings}); [destruct V; apply norm_within with bu; assumption | exact D |].\n    {certificate}.\n")
    rows = (f"forall d vertices, List.Forall (good {weights} {to_one.split()[0]} t u bt bu d) vertices ->\n  "
            "(d <= 4 * length vertices)%nat ->\n  "
            f"row_distance {to_one} t u bt bu {rounded} d vertices <= INR (length vertices) * {bound.coq()}")
    return Theorem((f"weighted {weights} s t u bs bt bu",
                    *(f"S4 {axis} = {0 if axis == along else 1}" for axis in AXES), "Rabs g <= 1"),
                   f"distance (scatter_program {to_one} s t u g {rounded}) (fun l m n => g * products bs bt bu l m n)"
                   f" <= {bound.coq()} /\\\n  ({rows})", proof,
                   "forall (s t u bs bt bu : nat -> R) (g : R)")


def float_theorem(order, fused, known, bound):
    e, a = known.axis.coq(), known.triple.coq()
    what = f"{'true' if order[0] else 'false'} {'true' if fused else 'false'}"
    proof = ("  intros s t u bs bt bu P V.\n"
             f"  apply (float_certified {what} {e} {a} {bound.coq()} s t u bs bt bu P V).\n"
             f"  {certificate_of([known.axis, known.triple])}.\n")
    return Theorem((f"vertex {e} {a} s t u bs bt bu P",), within(f"float_program {what} s t u P", bound), proof)
