"""Docstrings of the Python module, read from the C++ that binds it, so that nothing has to be built for them.

SPDX-License-Identifier: Apache-2.0
"""

import ast
import re

_STRING = re.compile(r'"(?:\\.|[^"\\])*"')
_CALL = re.compile(r'(?:\bmodule\.|\.|\btype\.)def(?:_\w+)?\(\s*(?:"(\w+)"|(py::init))')
_CLASS = re.compile(r'py::class_<[^;{]*?\(\s*\w+,\s*"(\w+)"')
_GIVEN = re.compile(r'\(py::class_<Py(\w+)>& type\)')  # in a file that adds to a class of another
# Calls within docstrings, and the words that stand for what they give.
_CALLS = {'shape_list(" or ")': '"A lattice of one of shapes()"'}


def arguments(text, start):
    """The arguments of a call whose opening bracket stands before `start`."""
    pieces, depth, begin, at = [], 0, start, start
    while True:
        letter = text[at]
        if letter == '"':
            at = _STRING.match(text, at).end()
            continue
        if letter in ")]}" and depth == 0:
            return [*pieces, text[begin:at].strip()]
        depth += (letter in "([{") - (letter in ")]}")
        if letter == "," and depth == 0:
            pieces.append(text[begin:at].strip())
            begin = at + 1
        at += 1


def _docstring(text, start):
    """The last of the arguments if it is a text, but for the first, which is a name; else nothing."""
    last = arguments(text, start)[1:][-1:]
    if not last or last[0][0] not in '("':
        return ""
    for call, words in _CALLS.items():
        last[0] = last[0].replace(call, words)
    return "".join(ast.literal_eval(part) for part in _STRING.findall(last[0]))


def docstrings(paths):
    """{name: text}, methods and properties as "Class.name"; a file binds or adds to one class, or functions alone."""
    texts = {}
    for path in paths:
        text = path.read_text(encoding="utf-8")
        bound = _CLASS.search(text)
        if bound:
            texts[bound.group(1)] = _docstring(text, text.rindex("(", 0, bound.end()) + 1)
        owner = bound or _GIVEN.search(text)
        for match in _CALL.finditer(text):
            name = match.group(1) or "__init__"
            key = f"{owner.group(1)}.{name}" if owner and not match.group(0).startswith("module") else name
            texts[key] = _docstring(text, text.index("(", match.start()) + 1) or texts.get(key, "")
    return texts
