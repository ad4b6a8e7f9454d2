"""Certificates of forms, with the theory that ties them to programs of the core.

SPDX-License-Identifier: Apache-2.0
"""

import dataclasses
import fractions
import json
import pathlib
import subprocess
import sys

import pytest

from lab.bounds import dyadic, forms, gappa, rows, weights

ROOT = pathlib.Path(__file__).resolve().parents[3]
pytestmark = pytest.mark.needs("gappa", "coqc")

WEIGHTS = {"weights": "bspline", "weight": 1e-4, "word": 1, "error": 2.7e-4, "distance": 6e-4, "reached": 6e-4,
           "pair": 6.3e-4, "bend": 0.0, "coordinates": 1, "all": True}
FACTS = {"weights": [{**WEIGHTS, "format": "fx16"},
                     {**WEIGHTS, "format": "fx12", "weights": "affine", "error": 4e-3, "distance": 1e-2, "pair": 0.0},
                     {**WEIGHTS, "format": "fx12", "weights": "powers", "error": 3e-3, "distance": 8e-3, "pair": 0.0},
                     {**WEIGHTS, "format": "fx12", "weights": "affine slopes", "error": 5e-3, "distance": 9e-3, "pair": 0.0},
                     {**WEIGHTS, "format": "fx12", "weights": "powers slopes", "error": 4e-3, "distance": 6e-3, "pair": 0.0},
                     {**WEIGHTS, "format": "bfp32", "error": 2e-9, "distance": 0.0, "pair": 0.0},
                     {**WEIGHTS, "format": "fp32-fused", "error": 2e-7, "distance": 0.0, "pair": 0.0}],
         "forms": [{"form": form, "format": name, "error": 1e-9} for form, name in (
             ("factored", "fx16"), ("product", "fx16"), ("product", "bfp32"), ("factored", "bfp32"),
             ("tree", "fp32-fused"), *((form, "fx12") for form in forms.SCATTERS))]}


@pytest.fixture(name="theory", scope="module")
def _theory(tmp_path_factory):
    return gappa.Theory(tmp_path_factory.mktemp("coq"))


COMPOSED = [row for row in rows.all_rows(FACTS) if not row.form.startswith("weights")]
SCATTER = {row.form: row for row in COMPOSED if row.form in forms.SCATTERS}


@pytest.mark.parametrize("row", COMPOSED, ids=rows.Row.certificate)
def test_a_form_is_certified(theory, row):
    result = row.prove(theory)
    assert result["checked_by"] == "gappa+coq" and result["smaller_refused"]
    assert rows.faults(result) == []


@pytest.mark.parametrize("row", (COMPOSED[0], SCATTER["scatter along u"]), ids=rows.Row.certificate)
def test_a_theorem_with_a_smaller_bound_is_refused(theory, row):
    script, bound = row.script[0], dyadic.above(gappa.upper_bound(row.script[0](None), row.name))
    smaller = dyadic.above(bound.value() * fractions.Fraction(98, 100))
    text = gappa.coq_of(script(bound), row.theorem(smaller))
    assert "Coq refuses" in theory.accepts("planted", text)


def test_a_theorem_from_the_words_on_with_another_rounding_is_refused(theory):
    row = next(row for row in COMPOSED if not row.hypothesis)
    assert row.prove(theory)["smaller_refused"]
    bound = rows.least(row.script[0], row.name)
    text = gappa.coq_of(row.script[0](bound), row.theorem(bound))
    planted = text.replace("horner_weight (half_up (-14))", "horner_weight (half_up (-13))")
    assert planted != text
    assert "Coq refuses" in theory.accepts("planted", planted)


ROUNDS = ("(half_up (-11))) (fun l m n =>", "(half_up (-10))) (fun l m n =>")


@pytest.mark.parametrize("form, words, others", (
    ("scatter", *ROUNDS), ("scatter", "S4 u = 1", "S4 u = 2"),
    ("scatter", "g * products bs bt bu l m n", "products bs bt bu l m n"),
    ("scatter along s", *ROUNDS), ("scatter along t", "S4 t = 0", "S4 t = 1"),
    ("scatter along u", "scatter_program true true false", "scatter_program true true true"),
    ("scatter powers along t", "S4 u = 1", "S4 u = 0"),
    ("scatter", "d <= 4 * length vertices", "d <= 5 * length vertices"),
    ("scatter along s", "row_distance false true true", "row_distance false true false")))
def test_a_theorem_of_scatter_with_another_rounding_or_premise_is_refused(theory, form, words, others):
    row = SCATTER[form]
    bound = rows.least(row.script[0], row.name)
    text = gappa.coq_of(row.script[0](bound), row.theorem(bound))
    assert theory.accepts("whole", text) is None
    planted = text.replace(words, others)
    assert planted != text
    assert "Coq refuses" in theory.accepts("planted", planted)


@pytest.mark.parametrize("form", forms.SCATTERS)
def test_an_error_of_scatter_above_its_bound_is_noticed(form):
    row = SCATTER[form]
    bound = rows.least(row.script[0], row.name)
    planted = dataclasses.replace(row, witness=float(bound) * 1.03)
    violations = rows.faults(planted.prove(None))
    assert any("is proved" in line for line in violations) and any("accepted too" in line for line in violations)


@pytest.mark.parametrize("axis", forms.AXES)
def test_a_derivative_needs_what_is_known_of_its_own_weights(axis):
    """The bound grows with the errors of the derivative's weights."""
    known = rows.known_of(rows.of(FACTS, "weights", weights="affine slopes"), FACTS)
    more = dataclasses.replace(known, slopes=dyadic.above(known.slopes.value() * 1000))
    rounds = forms.roundings(weights.FORMATS["fx12"])
    bounds = [gappa.upper_bound(forms.fixed_script(f"scatter along {axis}", rounds, k), "all") for k in (known, more)]
    assert bounds[0] < bounds[1]


def test_the_program_fails_where_nothing_was_measured(tmp_path):
    facts = tmp_path / "facts.json"
    facts.write_text(json.dumps({"weights": [], "forms": []}))
    result = subprocess.run([sys.executable, "-B", "-m", "lab.bounds", "--facts", facts, "--build", tmp_path],
                            capture_output=True, text=True, check=False)
    assert result.returncode == 1 and "nothing was measured" in result.stderr
