"""The rows of the report: a form in a format, its scripts, and what they take for granted.

SPDX-License-Identifier: Apache-2.0
"""

import fractions
import re
from dataclasses import dataclass

from lab.bounds import dyadic, forms, gappa, powers, weights, whole

SMALLER = fractions.Fraction(98, 100)  # of an error that is reached: a bound that has to be refused
ROUNDOFF = 1e-14  # of what the search computes in double, relative

# What a proof takes for granted, if anything, in the words of lab/docs/bounds.md.
COORDINATES, PAIRS, TRIPLES = "coordinates", "pairs", "triples"
SLOPES = " slopes"  # behind the name of weights: those of a derivative


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
    before: tuple = ()  # certificates that the theorem rests on: file, script, bound

    def certificate(self):
        return certificate_name(self.form, self.format, self.hypothesis)

    def prove(self, theory):
        bounds = []
        for file, script, limit in self.before if theory else ():
            accepted(theory, file, script(limit))
        for number, script in enumerate(self.script):
            bound = least(script, self.name)
            bounds.append(bound)
            if theory:
                accepted(theory, f"{self.certificate()}_{number}", script(bound), self.theorem(bound))
        bound = float(max(b.value() for b in bounds) + self.added)
        false = dyadic.above(max(fractions.Fraction(self.witness) * SMALLER - self.added, 0))
        refused = not all(gappa.proves(script(false)) for script in self.script)
        return {"form": self.form, "format": self.format, "bound": bound, "witness": self.witness,
                "ratio": round(bound / self.witness, 3) if self.witness else None,
                "checked_by": "gappa+coq" if theory else "gappa", "certificate": self.certificate(),
                "hypothesis": self.hypothesis, "smaller_refused": refused}


def certificate_name(*words):
    """Of the Coq files of a row, but for their number."""
    return re.sub(r"\W", "_", "_".join(part for part in words if part))


def accepted(theory, file, script, ending=""):
    complaint = theory.certified(file, script, ending)
    if complaint:
        raise gappa.BoundsError(complaint)


def least(script, name):
    """The bound that Gappa finds; a little more where what it can write for Coq does not reach that."""
    reached = gappa.upper_bound(script(None), name)
    for percent in (0, 1, 2, 5):
        bound = dyadic.above(reached * (100 + percent) / 100)
        if gappa.certifies(script(bound)):
            return bound
    raise gappa.BoundsError(f"Gappa does not prove what it finds:\n{script(None)}")


def faults(result):
    name = f"{result['form']} {result['format']}"
    violations = []
    if not result["witness"]:
        violations.append(f"{name}: no error was reached")
    if result["witness"] > result["bound"]:
        violations.append(f"{name}: {result['witness']:.4g} is reached, {result['bound']:.4g} is proved")
    if not result["smaller_refused"]:
        violations.append(f"{name}: a bound 2 % below what is reached is accepted too")
    return violations


def searched(form):
    """The form that the search knows a row's form by."""
    for several in ("weights", "scatter"):
        if form.startswith(several):
            return several
    return form.split(" by ")[0]


def of(entries, kind, **wanted):
    """The one entry of the facts, or None."""
    hits = [entry for entry in entries[kind] if all(entry[key] == value for key, value in wanted.items())]
    return hits[0] if hits else None


def upwards(value, more=0.0):
    return dyadic.above(fractions.Fraction(value * (1 + ROUNDOFF)) + fractions.Fraction(more), 24)


def weight_rows(measured):
    """Each family in each format: nothing is taken for granted."""
    for fact in measured["weights"]:
        family, form = fact["weights"], weights.FORMATS[fact["format"]]
        if family == "powers slopes":
            scripts = [lambda bound, n=n, form=form: powers.slopes_script(n, form, bound) for n in range(4)]
        elif family == "powers":
            scripts = [lambda bound, n=n, at_end=at_end, form=form: powers.powers_script(n, form, at_end, bound)
                       for n in range(4) for at_end in (False, True)]
        elif family in weights.FAMILIES and fact["weight"] > 0:  # else nothing is rounded
            scripts = [lambda bound, n=n, family=family, form=form: weights.weight_script(family, n, form, bound)
                       for n in range(4) if weights.weight_script(family, n, form)]
        else:
            continue
        yield Row(f"weights {family}", form.name, "", fact["weight"], scripts, "w - e")


def known_of(fact, measured):
    """What the search has looked at all of. Weights of a derivative are known beside those of the other axes."""
    axis = upwards(fact["error"], fact["bend"])
    if fact["weights"].endswith(SLOPES):
        others = of(measured, "weights", weights=fact["weights"].removesuffix(SLOPES), format=fact["format"])
        return forms.Known(upwards(others["error"], others["bend"]), upwards(fact["distance"], 4 * fact["bend"]),
                           slopes=axis)
    if not fact["distance"]:
        return forms.of_axes(axis)
    return forms.Known(axis, upwards(fact["distance"], 4 * fact["bend"]),
                       upwards(fact["pair"], 3 * fact["bend"]) if fact["pair"] else None)


def fixed_rows(measured):
    """Fixed point and block floating point."""
    for fact in measured["weights"]:
        form = weights.FORMATS[fact["format"]]
        if form.is_float() or not fact["all"]:
            continue
        known = known_of(fact, measured)
        for name in sorted(name for name, of_form in forms.WEIGHTS.items() if of_form == fact["weights"]):
            reached = of(measured, "forms", form=name, format=form.name)
            if reached:
                yield fixed_row(name, form, known, reached["error"], fact)


def added(form):
    """By the rounding of a result of the block, of at most 1, to binary32."""
    return fractions.Fraction(int(form.name == "bfp32"), 2 ** 25)


def fixed_row(name, form, known, witness, fact):
    rounds = forms.roundings(form)
    formula = "product by pairs" if name == "product" and known.pair else name
    hypothesis = (PAIRS if formula != name else TRIPLES if fact["distance"] else COORDINATES)

    def theorem(bound):
        if name in forms.SCATTERS:
            return forms.scatter_theorem(name, rounds, known, bound).text()
        return forms.fixed_theorem(formula if name == "product" else "factored", rounds, known, bound).text()

    return Row(name, form.name, hypothesis, witness,
               [lambda bound: forms.fixed_script(formula, rounds, known, bound)], "all", theorem, added(form))


def float_rows(measured):
    """binary32 in four orders."""
    for form in (weights.FORMATS["fp32"], weights.FORMATS["fp32-fused"]):
        fact = of(measured, "weights", weights="bspline", format=form.name)
        if not fact or not fact["all"]:
            continue
        known = known_of(fact, measured)
        for name, order in (forms.FUSED_ORDERS if form.fused else forms.ORDERS).items():
            reached = of(measured, "forms", form=name, format=form.name)
            if reached:
                yield Row(name, form.name, COORDINATES, reached["error"],
                          [lambda bound, order=order, known=known: forms.float_script(order, known, bound)], "all",
                          lambda bound, order=order, known=known, fused=form.fused:
                          forms.float_theorem(order, fused, known, bound).text())


def whole_rows(measured):
    """Forms again, from the words on: their weights are those that have certificates."""
    for fact in measured["forms"]:
        form, name = weights.FORMATS[fact["format"]], fact["form"]
        if name not in ("factored", "product", *forms.ORDERS):
            continue
        scripts = [lambda bound, n=n, form=form: weights.weight_script(whole.FAMILY, n, form, bound)
                   for n in range(4)]
        limits = [least(script, "w - e") for script in scripts]
        known = forms.of_axes(dyadic.above(sum(limit.value() for limit in limits), 24))
        name_of = certificate_name(f"weights {whole.FAMILY}", form.name)
        files = [(f"{name_of}_{n}", limit) for n, limit in enumerate(limits)]
        before = [(file, script, limit) for (file, limit), script in zip(files, scripts)]
        yield whole_row(form, name, known, (files, before), fact["error"])


def whole_row(form, name, known, of_weights, witness):
    files, before = of_weights
    if form.is_float():
        order = (forms.FUSED_ORDERS if form.fused else forms.ORDERS)[name]

        def script(bound):
            return forms.float_script(order, known, bound)

        def theorem(bound):
            return forms.float_theorem(order, form.fused, known, bound)
    else:
        rounds = forms.roundings(form)

        def script(bound):
            return forms.fixed_script(name, rounds, known, bound)

        def theorem(bound):
            return forms.fixed_theorem(name, rounds, known, bound)

    def ending(bound):
        return theorem(bound).text() + whole.text(form, files, known, theorem(bound))

    return Row(name, form.name, "", witness, [script], "all", ending, added(form), tuple(before))


def all_rows(measured):
    return [*weight_rows(measured), *fixed_rows(measured), *float_rows(measured), *whole_rows(measured)]
