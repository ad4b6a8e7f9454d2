"""Words of bits as terms: what a circuit computes, and what it should, in the language of SMT solvers.

A term is a word of a fixed width; a truth value is a word of one bit. Equal terms are one object, so
that two circuits that are the same but for their registers are the same term. Constants are folded.

SPDX-License-Identifier: Apache-2.0
"""

import hashlib

_KNOWN = {}


class Term:
    """A word. Made by the functions below only."""

    __slots__ = ("op", "width", "args", "info", "digest")

    def bits(self, high, low):
        return bits(self, high, low)

    def bit(self, place):
        return bits(self, place, place)

    def zext(self, width):
        return concat(const(0, width - self.width), self) if width > self.width else _same(self, width)

    def sext(self, width):
        return _make("sext", width, (self,)) if width > self.width else _same(self, width)

    def eq(self, other):
        return _make("eq", 1, (self, _as(other, self.width)))

    def ne(self, other):
        return ~self.eq(other)

    def slt(self, other):
        return _make("slt", 1, (self, _as(other, self.width)))

    def sle(self, other):
        return ~_as(other, self.width).slt(self)

    def ashr(self, other):
        return _make("ashr", self.width, (self, _as(other, self.width)))

    def any(self):
        return self.ne(0)

    def __lt__(self, other):
        return _make("ult", 1, (self, _as(other, self.width)))

    def __gt__(self, other):
        return _as(other, self.width) < self

    def __le__(self, other):
        return ~(self > other)

    def __ge__(self, other):
        return ~(self < other)

    def __add__(self, other):
        return _binary("add", self, other)

    def __sub__(self, other):
        return _binary("sub", self, other)

    def __mul__(self, other):
        return _binary("mul", self, other)

    def __and__(self, other):
        return _binary("and", self, other)

    def __or__(self, other):
        return _binary("or", self, other)

    def __xor__(self, other):
        return _binary("xor", self, other)

    def __lshift__(self, other):
        return _binary("shl", self, other)

    def __rshift__(self, other):
        return _binary("lshr", self, other)

    def __invert__(self):
        return self.args[0] if self.op == "not" else _make("not", self.width, (self,))

    def __neg__(self):
        return _make("neg", self.width, (self,))


def _same(term, width):
    if term.width != width:
        raise ValueError(f"a word of {term.width} bits is no word of {width}")
    return term


def _as(value, width):
    return const(value, width) if isinstance(value, int) else _same(value, width)


def _binary(name, left, right):
    return _make(name, left.width, (left, _as(right, left.width)))


def _signed(value, width):
    return value - (value >> (width - 1) << width)


FOLDED = {
    "not": lambda width, a: ~a, "neg": lambda width, a: -a,
    "add": lambda width, a, b: a + b, "sub": lambda width, a, b: a - b,
    "mul": lambda width, a, b: a * b, "and": lambda width, a, b: a & b,
    "or": lambda width, a, b: a | b, "xor": lambda width, a, b: a ^ b,
    "shl": lambda width, a, b: a << b if b < width else 0,
    "lshr": lambda width, a, b: a >> b if b < width else 0,
}


def folded(op, width, info, words):
    """The value of an operation on words given as (value, width)."""
    values = [value for value, _ in words]
    if op in FOLDED:
        result = FOLDED[op](width, *values)
    elif op == "ashr":
        result = _signed(values[0], width) >> min(values[1], width - 1)
    elif op == "eq":
        result = values[0] == values[1]
    elif op == "ult":
        result = values[0] < values[1]
    elif op == "slt":
        result = _signed(*words[0]) < _signed(*words[1])
    elif op == "sext":
        result = _signed(*words[0])
    elif op == "ite":
        result = values[1] if values[0] else values[2]
    elif op == "extract":
        result = values[0] >> info[1]
    elif op == "concat":
        result = 0
        for value, size in words:
            result = result << size | value
    else:
        raise ValueError(f"{op} has no value")
    return int(result) & ((1 << width) - 1)


def _make(op, width, args, info=None):
    if args and all(arg.op == "const" for arg in args) and op not in ("apply", "raw"):
        return const(folded(op, width, info, [(arg.info, arg.width) for arg in args]), width)
    key = (op, width, tuple(map(id, args)), info)
    term = _KNOWN.get(key)
    if term is None:
        term = Term()
        term.op, term.width, term.args, term.info = op, width, args, info
        text = f"{op} {width} {info} " + " ".join(arg.digest for arg in args)
        term.digest = hashlib.sha256(text.encode()).hexdigest()[:24]
        _KNOWN[key] = term
    return term


def const(value, width):
    return _make("const", width, (), value & ((1 << width) - 1)) if width else None


def var(name, width):
    """Any word: what is proved holds for all of them."""
    return _make("var", width, (), name)


def apply(name, width, *args):
    """A function of which nothing is known but that equal arguments give equal words."""
    return _make("apply", width, args, name)


def raw(text, width, *args):
    """SMT-LIB as it stands, with {0}, {1} and so on for the arguments."""
    return _make("raw", width, args, text)


def ite(condition, yes, no):
    if isinstance(yes, int):
        yes = const(yes, no.width)
    no = _as(no, yes.width)
    if condition.op == "const":
        return yes if condition.info else no
    return yes if yes is no else _make("ite", yes.width, (condition, yes, no))


def bits(term, high, low):
    if low == 0 and high == term.width - 1:
        return term
    if term.op == "extract":
        return bits(term.args[0], high + term.info[1], low + term.info[1])
    if term.op == "concat":
        upper, lower = term.args
        if low >= lower.width:
            return bits(upper, high - lower.width, low - lower.width)
        if high < lower.width:
            return bits(lower, high, low)
    return _make("extract", high - low + 1, (term,), (high, low))


def concat(*words):
    """The first part highest; absent ones (None) are left out."""
    joined = None
    for part in words:
        if part is None:
            continue
        if joined is None:
            joined = part
        elif (joined.op == part.op == "extract" and joined.args == part.args
              and joined.info[1] == part.info[0] + 1):
            joined = bits(part.args[0], joined.info[0], part.info[1])
        else:
            joined = _make("concat", joined.width + part.width, (joined, part))
    return joined


def every(*truths):
    conjunction = const(1, 1)
    for truth in truths:
        conjunction = truth if conjunction.op == "const" and conjunction.info else conjunction & truth
    return conjunction


def either(*truths):
    return ~every(*(~truth for truth in truths))


def implies(premise, conclusion):
    return ~premise | conclusion


# ---- SMT-LIB

_PLAIN = {"not": "bvnot", "neg": "bvneg", "add": "bvadd", "sub": "bvsub", "mul": "bvmul",
          "and": "bvand", "or": "bvor", "xor": "bvxor", "shl": "bvshl", "lshr": "bvlshr",
          "ashr": "bvashr", "concat": "concat"}
_TRUTHS = {"eq": "=", "ult": "bvult", "slt": "bvslt"}


def ordered(roots):
    """Every term below, arguments first."""
    order, seen, stack = [], set(), [(root, False) for root in reversed(roots)]
    while stack:
        term, expanded = stack.pop()
        if expanded:
            order.append(term)
        elif id(term) not in seen:
            seen.add(id(term))
            stack.append((term, True))
            stack += [(arg, False) for arg in reversed(term.args)]
    return order


def _text(term, names):
    args = [names[arg] for arg in term.args]
    if term.op in _PLAIN:
        return f"({_PLAIN[term.op]} {' '.join(args)})"
    if term.op in _TRUTHS:
        return f"(ite ({_TRUTHS[term.op]} {' '.join(args)}) #b1 #b0)"
    if term.op == "ite":
        return f"(ite (= {args[0]} #b1) {args[1]} {args[2]})"
    if term.op == "sext":
        return f"((_ sign_extend {term.width - term.args[0].width}) {args[0]})"
    if term.op == "extract":
        return f"((_ extract {term.info[0]} {term.info[1]}) {args[0]})"
    if term.op == "apply":
        return f"({term.info} {' '.join(args)})"
    return term.info.format(*args)


def script(hypotheses, goal):
    """A script that is unsatisfiable exactly where the hypotheses imply the goal."""
    names, lines, functions = {}, ["(set-logic ALL)"], {}
    for place, term in enumerate(ordered([*hypotheses, goal])):
        sort = f"(_ BitVec {term.width})"
        if term.op == "const":
            names[term] = f"(_ bv{term.info} {term.width})"
        elif term.op == "var":
            names[term] = f"|{term.info}|"
            lines.append(f"(declare-const {names[term]} {sort})")
        else:
            if term.op == "apply" and term.info not in functions:
                functions[term.info] = " ".join(f"(_ BitVec {arg.width})" for arg in term.args)
                lines.append(f"(declare-fun {term.info} ({functions[term.info]}) {sort})")
            names[term] = f"t{place}"
            lines.append(f"(define-fun t{place} () {sort} {_text(term, names)})")
    lines += [f"(assert (= {names[hypothesis]} #b1))" for hypothesis in hypotheses]
    lines += [f"(assert (= {names[goal]} #b0))", "(check-sat)", ""]
    return "\n".join(lines)


_REBUILT = {"ite": lambda term, args: ite(*args), "concat": lambda term, args: concat(*args),
            "extract": lambda term, args: bits(args[0], *term.info)}


def substituted(root, given):
    """A term with other terms in place of variables, {name: term}; what is left unknown of products is
    put back."""
    replaced = {}
    for term in ordered([root]):
        args = tuple(replaced[arg] for arg in term.args)
        if term.op == "var":
            replaced[term] = _same(given.get(term.info, term), term.width)
        elif term.op == "apply" and term.info.startswith("product"):
            replaced[term] = args[0] * args[1]
        elif term.op in _REBUILT:
            replaced[term] = _REBUILT[term.op](term, args)
        else:
            replaced[term] = _make(term.op, term.width, args, term.info)
    return replaced[root]


def value(root, given):
    """The word that a term is for given words of its variables, {name: number}."""
    computed = {}
    for term in ordered([root]):
        if term.op == "const":
            computed[term] = term.info
        elif term.op == "var":
            computed[term] = given[term.info]
        elif term.op == "apply":
            computed[term] = given[term.info](*(computed[arg] for arg in term.args))
        else:
            computed[term] = folded(term.op, term.width, term.info,
                                    [(computed[arg], arg.width) for arg in term.args])
    return computed[root]
