"""What products of whole numbers have that the units rely on. The solvers of words take a product for
any word that has this; here it is proved of the products themselves.

SPDX-License-Identifier: Apache-2.0
"""

from lab.theorems import terms
from lab.theorems.prove import Lemma


def _script(names, assumed, claimed):
    lines = ["(set-logic ALL)", *(f"(declare-const {name} Int)" for name in names),
             *(f"(assert {hypothesis})" for hypothesis in assumed), f"(assert (not {claimed}))", "(check-sat)", ""]
    return "\n".join(lines)


_HALVES = ("ah", "al", "bh", "bl", "n")
_PARTS = "(= (* (+ (* ah n) al) (+ (* bh n) bl)) (+ (* ah bh n n) (* (+ (* ah bl) {0}) n) (* al bl)))"
_LOW = ("(>= n 1)", "(>= al 0)", "(< al n)", "(>= bl 0)", "(< bl n)")
_UNIT = ("(>= a 0)", "(<= a n)", "(>= b 0)", "(<= b n)")

# For significands a and b below 2^p that are whole numbers, with 2^(p-1) called h.
_BOUND = ("(>= h 1)", "(>= a 0)", "(>= b 0)", "(< a (* 2 h))", "(< b (* 2 h))")


def _sixth(tenths):
    """Chains of 1 to 5 steps v_k+1 = v_k + floor(v_k / 2^(2^(k+1))) of a value of at most 2^(2^(n+1)), n the steps:
    no v_k is above 4/3 of it, and the last is less below that than so many tenths of a unit for each step and 3."""
    names = [f"v{k}" for k in range(6)] + [f"r{k}" for k in range(5)]
    assumed, claimed = ["(>= v0 0)"], []
    for k in range(5):
        places = 2 ** (2 ** (k + 1))
        assumed += [f"(>= r{k} 0)", f"(< r{k} {places})", f"(= (* {places} v{k + 1}) (- (* {places + 1} v{k}) r{k}))"]
        claimed += [f"(<= (* 3 v{k + 1}) (* 4 v0))", f"(=> (<= v0 {2 ** 2 ** (k + 2)}) "
                    f"(< (* 10 (- (* 4 v0) (* 3 v{k + 1}))) {3 * (tenths * (k + 1) + 30)}))"]
    return _script(names, assumed, f"(and {' '.join(claimed)})")


LEMMAS = (
    Lemma("product.parts", "A product is the sum of the four products of its factors' halves.",
          _script(_HALVES, (), _PARTS.format("(* al bh)")),
          _script(_HALVES, (), _PARTS.format("(* ah bh)"))),
    Lemma("product.low", "The product of two lower halves, each below n, is below n^2 and not negative.",
          _script(_HALVES, _LOW, "(and (>= (* al bl) 0) (< (* al bl) (* n n)))"),
          _script(_HALVES, _LOW, "(and (>= (* al bl) 0) (< (* al bl) (- (* n n) (* 2 n))))")),
    Lemma("product.normal", "A significand with its hidden bit times one that is not zero has its leading one "
          "at the hidden bit or above.",
          _script("abh", (*_BOUND, "(>= a h)", "(>= b 1)"), "(>= (* a b) h)"),
          _script("abh", (*_BOUND, "(>= b 1)"), "(>= (* a b) h)")),
    Lemma("product.zero", "A product is zero exactly where a factor is.",
          _script("ab", (), "(= (= (* a b) 0) (or (= a 0) (= b 0)))"),
          _script("ab", (), "(= (= (* a b) 0) (and (= a 0) (= b 0)))")),
    Lemma("product.largest", "The product of two significands is at most that of the two largest.",
          _script("abh", _BOUND, "(<= (* a b) (* (- (* 2 h) 1) (- (* 2 h) 1)))"),
          _script("abh", _BOUND, "(< (* a b) (* (- (* 2 h) 1) (- (* 2 h) 1)))")),
    Lemma("product.unit", "The product of two numbers from 0 to n is from 0 to n^2.",
          _script("abn", _UNIT, "(and (>= (* a b) 0) (<= (* a b) (* n n)))"),
          _script("abn", _UNIT, "(and (>= (* a b) 0) (< (* a b) (* n n)))")),
    Lemma("sixth.error", "Times 1 + 2^-k for k = 2, 4 ... 2^n, each product cut, a value of at most 2^(2^(n+1)) is at no "
          "step above 4/3 of it, and at the last less below that than n units and 3.", _sixth(10), _sixth(-20),
          widths="n 1 to 5"),
)


def truths_of(product, left, right, width):
    """`product.normal`, `product.zero` and `product.largest` of the product of two significands."""
    zeros = left.significand.eq(0), right.significand.eq(0)
    hidden = [number.significand.bit(width - 1) for number in (left, right)]
    least = 1 << (width - 1)
    return [terms.implies(hidden[0] & ~zeros[1], product >= least),
            terms.implies(hidden[1] & ~zeros[0], product >= least),
            product.eq(0).eq(zeros[0] | zeros[1]), product <= ((1 << width) - 1) ** 2]
