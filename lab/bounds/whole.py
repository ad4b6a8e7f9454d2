"""Theorems that take nothing for granted: from the words of a vertex to its result.

They join what is proved of the weights of B-splines (weights.py) to what is proved of a form
(forms.py), and say of coordinates in [0, 1] and points of at most 1 how far the result may be off.

SPDX-License-Identifier: Apache-2.0
"""

import fractions

from lab.bounds import dyadic, forms, weights

FAMILY = "bspline"


def constant(value):
    """A constant as Gappa writes it for Coq."""
    value = fractions.Fraction(value)
    if value.denominator == 1:
        return f"(Float1 ({value.numerator}))"
    if value.denominator & (value.denominator - 1) == 0:
        return dyadic.exact(value).coq()
    return f"(Float1 ({value.numerator}) / Float1 ({value.denominator}))"


def cases(name, of_function):
    lines = " | ".join(f"{number}%nat => {of_function(number)}" if number < 3 else f"_ => {of_function(number)}"
                       for number in range(4))
    return f"Definition {name} (i : nat) (x : R) : R := match i with {lines} end.\n"


def definitions(form):
    """Weights as the core computes them, and the functions."""
    if form.is_float():
        rounding, product, at = "nearest", "(fun v => v)" if form.fused else "nearest", "x"
    else:
        rounding, product = f"(half_up (-{form.digits}))", "(fun v => v)"
        at = f"(half_up (-{form.digits}) x)"

    def weight(number):
        held, _ = weights.loaded(FAMILY, number, form)
        return f"horner_weight {rounding} {product} {' '.join(map(constant, held))} {at}"

    def function(number):
        return f"horner_exact {' '.join(map(constant, weights.FAMILIES[FAMILY][number]))} x"

    return cases("weight", weight) + cases("function", function)


def axis_lemma(files, axis):
    """The four certificates of weights, as one sum."""
    proofs = "\n".join(
        f"  assert (H{number} : Rabs (weight {number} x - function {number} x) <= {bound.coq()})\n"
        f"    by exact (proj2 ({file}.certificate x ltac:(unfold BND, lower, upper, float2R, Defs.F2R; simpl; lra)))."
        for number, (file, bound) in enumerate(files))
    return (f"Lemma axis x : 0 <= x <= 1 -> norm (fun i => weight i x - function i x) <= {axis.coq()}.\n"
            f"Proof.\n  intro X.\n{proofs}\n  unfold norm, S4.\n"
            f"  eapply Rle_trans; [repeat apply Rplus_le_compat; [exact H0|exact H1|exact H2|exact H3]|{forms.NUMBERS}].\n"
            "Qed.\n"
            "Lemma functions x : 0 <= x <= 1 -> norm (fun i => function i x) <= 1.\n"
            "Proof.\n  intro X; apply (bspline_norm _ x X); unfold function, horner_exact, float2R, Defs.F2R, Float1;\n"
            "    simpl; lra.\nQed.\n")


def text(form, files, known, bound):
    """The theorem `whole`, which follows from that of the form, `bound`, with these weights.

    @param files  (name, bound) of the certificate of each of the four weights
    """
    weight, function = (" ".join(f"(fun i => {what} i {v})" for v in "xyz") for what in ("weight", "function"))

    def here(statement):
        return statement.replace(" s t u P", f" {weight} P").replace("eq1 bs bt bu P", f"eq1 {function} P")

    e = known.axis.coq()
    others = bound.premises[1:]  # behind what is known of weights
    return ("".join(f"Require {file}.\n" for file, _ in files) + definitions(form) + axis_lemma(files, known.axis) +
            "Theorem whole : forall x y z P, 0 <= x <= 1 -> 0 <= y <= 1 -> 0 <= z <= 1 ->\n"
            "  (forall l m n, Rabs (P l m n) <= 1) ->\n  "
            + "".join(f"{here(premise)} ->\n  " for premise in others) + f"{here(bound.conclusion)}.\n"
            f"Proof.\n  intros x y z P X Y Z Points{' Small' if others else ''}.\n"
            f"  apply (bound {weight} {function} P){'; [|exact Small]' if others else ''}.\n"
            f"  apply (whole_vertex {e}); try (apply functions; assumption); try (apply axis; assumption);\n"
            f"    [{forms.NUMBERS}|exact Points|{forms.NUMBERS}].\nQed.\n")
