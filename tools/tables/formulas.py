"""Formulas in the cells of a table: numbers, named terms, + - * /, max, min and log2.

A formula is checked against the terms that it may name, computed here, or written as C++, where the
terms are members of `t`.

SPDX-License-Identifier: Apache-2.0
"""

import ast
import math
import operator

from tools.csv_table import TableError

_OPERATORS = {ast.Add: ("+", operator.add), ast.Sub: ("-", operator.sub),
              ast.Mult: ("*", operator.mul), ast.Div: ("/", operator.truediv)}
# name -> (how many arguments, C++, Python)
_FUNCTIONS = {"max": (2, "std::max<double>", max), "min": (2, "std::min<double>", min),
              "log2": (1, "std::log2", math.log2)}


class Formula:
    """One formula of those terms. Raises TableError, which says what is accepted."""

    def __init__(self, text, terms, where):
        self.text = text
        try:
            self._tree = ast.parse(text, mode="eval").body
            self._check(self._tree, terms)
        except (SyntaxError, ValueError) as error:
            known = ", ".join([*terms, *_FUNCTIONS])
            raise TableError(f"{where}: '{text}' is not a formula of numbers, + - * / and {known}"
                             ) from error

    def _check(self, node, terms):
        if isinstance(node, ast.BinOp) and type(node.op) in _OPERATORS:
            self._check(node.left, terms)
            self._check(node.right, terms)
        elif isinstance(node, ast.Call):
            name = getattr(node.func, "id", "")
            if node.keywords or len(node.args) != _FUNCTIONS.get(name, (None,))[0]:
                raise ValueError(name)
            for argument in node.args:
                self._check(argument, terms)
        elif isinstance(node, ast.Name):
            if node.id not in terms:
                raise ValueError(node.id)
        elif not isinstance(node, ast.Constant) or type(node.value) not in (int, float):
            raise ValueError(type(node).__name__)

    def value(self, **terms):
        def of(node):
            if isinstance(node, ast.BinOp):
                return _OPERATORS[type(node.op)][1](of(node.left), of(node.right))
            if isinstance(node, ast.Call):
                return _FUNCTIONS[node.func.id][2](*map(of, node.args))
            return terms[node.id] if isinstance(node, ast.Name) else node.value

        return of(self._tree)

    def cpp(self):
        """An expression of doubles."""
        def of(node):
            if isinstance(node, ast.BinOp):
                return f"({of(node.left)} {_OPERATORS[type(node.op)][0]} {of(node.right)})"
            if isinstance(node, ast.Call):
                return f"{_FUNCTIONS[node.func.id][1]}({', '.join(map(of, node.args))})"
            return f"t.{node.id}" if isinstance(node, ast.Name) else repr(float(node.value))

        return of(self._tree)
