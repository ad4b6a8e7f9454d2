"""Certificates of weights: accepted as they are, refused where they claim too much.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import fractions

import pytest

from lab.bounds import __main__ as study, dyadic, forms, gappa, powers, rows, weights

FX16 = weights.FORMATS["fx16"]
NEEDS_GAPPA = pytest.mark.needs("gappa")
NEEDS_COQ = pytest.mark.needs("gappa", "coqc")


SEARCH = """#!/bin/sh
echo "$@" >> {ran}
mkdir -p "$2/reports"
echo '{{}}' > "$2/reports/bounds_facts.json"
exit $(cat {status} 2> /dev/null || echo 0)
"""


def test_what_has_been_searched_is_not_searched_again(tmp_path):
    program, ran, status = (tmp_path / name for name in ("lab/bounds/hwffd-bounds", "ran", "status"))
    program.parent.mkdir(parents=True)
    program.write_text(SEARCH.format(ran=ran, status=status))
    program.chmod(0o755)
    options = argparse.Namespace(build=tmp_path, form="")

    def searches(name="fx16"):
        ran.unlink(missing_ok=True)
        study.search(options, name)
        return len(ran.read_text().splitlines()) if ran.exists() else 0

    assert [searches(), searches(), searches("fx17")] == [1, 0, 1]
    options.form = "scatter along s"
    assert [searches(), searches()] == [1, 0]
    program.write_text(program.read_text() + "# another\n")
    status.write_text("1")
    with pytest.raises(gappa.BoundsError, match="has failed"):
        searches()
    status.write_text("0")
    assert [searches(), searches()] == [1, 0]


def linear(bound=None):
    return weights.weight_script("linear", 1, FX16, bound)


def bound_of(script, name="w - e"):
    return dyadic.above(gappa.upper_bound(script(None), name))


def less(bound, share):
    return dyadic.above(bound.value() * fractions.Fraction(share))


@NEEDS_GAPPA
@pytest.mark.parametrize("family", sorted(set(weights.FAMILIES) - {"constant"}))
@pytest.mark.parametrize("name", ["fx17", "bfp32", "fp32", "fp32-fused"])
def test_a_weight_is_bounded_and_2_percent_less_are_refused(family, name):
    def script(bound):
        return weights.weight_script(family, 2, weights.FORMATS[name], bound)

    bound = bound_of(script)
    assert gappa.proves(script(bound))
    assert not gappa.proves(script(less(bound, "0.98")))


@NEEDS_GAPPA
@pytest.mark.parametrize("function", range(4))
def test_a_weight_of_a_derivative_by_powers_is_bounded_and_another_cut_is_noticed(function):
    def script(bound):
        return powers.slopes_script(function, weights.FORMATS["fx17"], bound)

    bound = bound_of(script)
    assert gappa.proves(script(bound))
    # A square of six digits less.
    planted = script(bound).replace("S = fixed<-18,dn>", "S = fixed<-12,dn>")
    assert planted != script(bound) and not gappa.proves(planted)


@NEEDS_GAPPA
def test_a_rounding_that_is_forgotten_is_noticed():
    bound = bound_of(linear)
    assert gappa.proves(linear(bound))
    # Downwards instead of half up.
    half = dyadic.power(-FX16.digits - 1).gappa()
    planted = linear(bound).replace(f" + {half});", ");")
    assert planted != linear(bound) and not gappa.proves(planted)


@NEEDS_COQ
def test_coq_accepts_a_certificate_and_refuses_another_bound(tmp_path):
    theory = gappa.Theory(tmp_path, ())
    bound = bound_of(linear)
    text = gappa.coq_of(linear(bound))
    assert theory.accepts("linear", text) is None
    assert (tmp_path / "linear.vo").exists()
    # The number in the claim alone.
    claim = f"Float2 ({bound.mantissa}) ({bound.exponent})"
    assert claim in text
    smaller = less(bound, "0.98")
    planted = text.replace(claim, f"Float2 ({smaller.mantissa}) ({smaller.exponent})")
    assert "Coq refuses" in theory.accepts("planted", planted)


@NEEDS_COQ
def test_what_was_accepted_is_not_looked_at_again_and_all_else_is(tmp_path, monkeypatch):
    theory = gappa.Theory(tmp_path, ())
    bound = bound_of(linear)
    assert theory.certified("linear", linear(bound)) is None
    monkeypatch.setattr(theory, "compile", lambda name: f"Axioms:\nlooked_at_{name} : False\n")
    assert theory.certified("linear", linear(bound)) is None
    for script, ending in ((linear(less(bound, 2)), ""), (linear(bound), "Theorem bound : True.")):
        assert "rests on looked_at_linear" in theory.certified("linear", script, ending)
    assert "rests on looked_at_linear" in theory.certified("linear", linear(bound))  # what is there now is none


@NEEDS_COQ
def test_a_proof_that_rests_on_what_it_says_is_none(tmp_path):
    theory = gappa.Theory(tmp_path, ())
    text = "Axiom wished : 1 = 2.\nPrint Assumptions wished.\n"
    assert "rests on wished" in theory.accepts("wished", text)


@NEEDS_GAPPA
@pytest.mark.parametrize("form", sorted(forms.FORMULAS))
def test_a_composed_bound_is_no_larger_than_its_formula(form):
    known = forms.Known(dyadic.power(-14), dyadic.power(-12), dyadic.power(-12), dyadic.power(-13))
    rounds = forms.roundings(FX16)

    def script(bound):
        return forms.fixed_script(form, rounds, known, bound)

    bound = bound_of(script, "all")
    assert gappa.proves(script(bound))
    assert not gappa.proves(script(less(bound, "0.98")))


RESULT = {"form": "factored", "format": "fx16", "bound": 2e-4, "witness": 1e-4, "ratio": 2.0,
          "checked_by": "gappa+coq", "hypothesis": "", "smaller_refused": True}


@pytest.mark.parametrize("change, message", [
    ({}, None), ({"witness": 2.1e-4}, "is reached"), ({"witness": 0}, "no error was reached"),
    ({"smaller_refused": False}, "accepted too")])
def test_what_does_not_hold_is_said(change, message):
    violations = rows.faults({**RESULT, **change})
    assert (violations == []) if message is None else any(message in line for line in violations)


def test_dyadic_numbers_are_no_smaller():
    for value in (fractions.Fraction(1, 6), fractions.Fraction(3, 2 ** 40), 5):
        above = dyadic.above(value).value()
        assert value <= above <= fractions.Fraction(value) * (1 + fractions.Fraction(1, 2 ** 15))
    with pytest.raises(ValueError, match="no multiple"):
        dyadic.exact(fractions.Fraction(1, 3))


def test_tools_that_are_absent_are_named():
    with pytest.raises(gappa.BoundsError, match="no-such-prover"):
        gappa.require("no-such-prover")
