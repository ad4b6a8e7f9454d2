"""The rows of the report: a form in a format, its scripts, and what they take for granted.

SPDX-License-Identifier: Apache-2.0
"""

import fractions
import re
from dataclasses import dataclass

import dyadic
import forms
import gappa
import powers
import weights

SMALLER = fractions.Fraction(98, 100)  # of an error that is reached: a bound that has to be refused
ROUNDOFF = 1e-14  # of what the search computes in double, relative

# What a proof takes for granted, if anything, in the words of docs/studies/bounds.md.
COORDINATES, PAIRS, TRIPLES = "coordinates", "pairs", "triples"


@dataclass(frozen=True)
class Row:
    """`scripts` gives the script of a bound, or the one that asks for it; `theorem` ends its proof."""

    form: str
    format: str
    hypothesis: str
    witness: float
    script: object
    name: str = "all"
    theorem: object = lambda _: ""
    added: fractions.Fraction = fractions.Fraction(0)  # by the theorem, to the bound of the script

    def prove(self, theory):
        bounds, accepted = [], True
        for number, script in enumerate(self.script):
            bound = dyadic.above(gappa.found(script(None), self.name))
            bounds.append(bound)
            if theory:
                file = re.sub(r"\W", "_", f"{self.form}_{self.format}_{self.hypothesis}_{number}")
                complaint = theory.accepts(file, gappa.coq_of(script(bound), self.theorem(bound)))
                if complaint:
                    raise gappa.BoundsError(complaint)
            else:
                accepted = accepted and gappa.proves(script(bound))
        bound = float(max(b.value() for b in bounds) + self.added)
        false = dyadic.above(max(fractions.Fraction(self.witness) * SMALLER - self.added, 0))
        refused = not all(gappa.proves(script(false)) for script in self.script)
        return {"form": self.form, "format": self.format, "bound": bound, "witness": self.witness,
                "ratio": round(bound / self.witness, 3) if self.witness else None,
                "checked_by": "gappa+coq" if theory else "gappa" if accepted else "nothing",
                "hypothesis": self.hypothesis, "smaller_refused": refused}


def faults(result):
    name = f"{result['form']} {result['format']}"
    found = []
    if not result["witness"]:
        found.append(f"{name}: no error was reached")
    if result["witness"] > result["bound"]:
        found.append(f"{name}: {result['witness']:.4g} is reached, {result['bound']:.4g} is proved")
    if not result["smaller_refused"]:
        found.append(f"{name}: a bound 2 % below what is reached is accepted too")
    if result["checked_by"] == "nothing":
        found.append(f"{name}: Gappa does not prove it")
    return found


def searched(form):
    """The form that the search knows a row's form by."""
    if form.startswith("weights"):
        return "weights"
    return form.split(" by ")[0]


def of(found, kind, **wanted):
    """The one entry of the facts, or None."""
    hits = [entry for entry in found[kind] if all(entry[key] == value for key, value in wanted.items())]
    return hits[0] if hits else None


def upwards(value, more=0.0):
    return dyadic.above(fractions.Fraction(value * (1 + ROUNDOFF)) + fractions.Fraction(more), 24)


def weight_rows(found):
    """Each family in each format: nothing is taken for granted."""
    for fact in found["weights"]:
        family, form = fact["weights"], weights.FORMATS[fact["format"]]
        if family == "powers":
            scripts = [lambda bound, n=n, one=one, form=form: powers.powers_script(n, form, one, bound)
                       for n in range(4) for one in (False, True)]
        elif family in weights.FAMILIES and fact["weight"] > 0:  # else nothing is rounded
            scripts = [lambda bound, n=n, family=family, form=form: weights.weight_script(family, n, form, bound)
                       for n in range(4) if weights.weight_script(family, n, form)]
        else:
            continue
        yield Row(f"weights {family}", form.name, "", fact["weight"], scripts, "w - e")


def known_of(fact):
    """What the search has looked at all of."""
    axis = upwards(fact["error"], fact["bend"])
    if not fact["distance"]:
        return forms.of_axes(axis)
    return forms.Known(axis, upwards(fact["distance"], 4 * fact["bend"]),
                       upwards(fact["pair"], 3 * fact["bend"]) if fact["pair"] else None)


def fixed_rows(found):
    """Fixed point and block floating point."""
    for fact in found["weights"]:
        form = weights.FORMATS[fact["format"]]
        if form.is_float() or not fact["all"]:
            continue
        known = known_of(fact)
        for name in {"bspline": ("factored", "product"), "affine": ("affine",), "powers": ("powers",),
                     "centred": ("nested",)}.get(fact["weights"], ()):
            reached = of(found, "forms", form=name, format=form.name)
            if reached:
                yield fixed_row(name, form, known, reached["error"], fact)


def fixed_row(name, form, known, witness, fact):
    rounds = forms.roundings(form, name == "nested")
    formula = "product by pairs" if name == "product" and known.pair else name
    hypothesis = (PAIRS if formula != name else TRIPLES if fact["distance"] else COORDINATES)
    added = fractions.Fraction(1, 2 ** 25) if form.name == "bfp32" else 0

    def theorem(bound):
        if name == "nested":
            return forms.nested_theorem(rounds, known, bound)
        return forms.fixed_theorem(formula if name == "product" else "factored", rounds, known, bound)

    return Row(name, form.name, hypothesis, witness,
               [lambda bound: forms.fixed_script(formula, rounds, known, bound)], "all", theorem,
               fractions.Fraction(added))


def float_rows(found):
    """binary32 in four orders."""
    for form in (weights.FORMATS["fp32"], weights.FORMATS["fp32-fused"]):
        fact = of(found, "weights", weights="bspline", format=form.name)
        if not fact or not fact["all"]:
            continue
        known = known_of(fact)
        for name, order in (forms.FUSED_ORDERS if form.fused else forms.ORDERS).items():
            reached = of(found, "forms", form=name, format=form.name)
            if reached:
                yield Row(name, form.name, COORDINATES, reached["error"],
                          [lambda bound, order=order, known=known: forms.float_script(order, known, bound)], "all",
                          lambda bound, order=order, known=known, fused=form.fused:
                          forms.float_theorem(order, fused, known, bound))


def all_rows(found):
    return [*weight_rows(found), *fixed_rows(found), *float_rows(found)]
