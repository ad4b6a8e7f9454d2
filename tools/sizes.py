"""How long functions may be, and that no six lines of code stand twice.

Generated files, which say so in their first lines, do not count. Of the six lines blank ones,
comments and lone brackets do not count; ports, named connections with the wires between them and
includes end a run.

SPDX-License-Identifier: Apache-2.0
"""

import ast
import re

from rtl import line_of

FUNCTION_LINES = 60
EQUAL_LINES = 6

_KINDS = {".cpp": "cpp", ".hpp": "cpp", ".h": "cpp", ".c": "cpp", ".v": "verilog",
          ".vh": "verilog", ".py": "python", ".cmake": "cmake"}
_GENERATED = re.compile(r"\A(.*\n){0,5}?.*\bMade from .* by ")
_NO_CODE = {
    "cpp": re.compile(r'R"(\w*)\((?:.|\n)*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\''
                      r"|//.*|/\*(?:.|\n)*?\*/"),
    "verilog": re.compile(r'"(?:\\.|[^"\\\n])*"|//.*|/\*(?:.|\n)*?\*/'),
    "python": re.compile(r"^[ \t]*#.*", re.MULTILINE),
    "cmake": re.compile(r"#.*"),
}
_DIRECTIVE = re.compile(r"^[ \t]*#(?:.*\\\n)*.*", re.MULTILINE)
_BRACKET = re.compile(r"[{};]")
_SPAN = {
    "cmake": re.compile(r"^ *(function|macro) *\((?:.|\n)*?^ *end\1 *\(", re.MULTILINE),
    "verilog": re.compile(r"^ *(function|task)\b(?:.|\n)*?^ *end\1\b", re.MULTILINE),
}
# Lines that do not count among the six, and those that end a run.
_THIN = re.compile(r"[\W_]*\Z|\W*\b(end\w*|begin|else|return|default_nettype \w+)\b[\w :]*[;)]*\Z"
                   r"|SPDX-License")
_LISTED = {
    "cpp": re.compile(r"# *include\b|using [\w:]+;"),
    "python": re.compile(r"(import|from)\b"),
    "cmake": re.compile(r"include\b"),
    # with the wires between named connections
    "verilog": re.compile(r"(input|output|inout|parameter)\b|\.\w+ *\(|`include\b"
                          r"|(\(\* hierconn \*\) )?wire\b[^=]*;"),
}


def _kind(tree, path):
    text = tree.text(path)
    if _GENERATED.match(text):
        return None
    if path.name == "CMakeLists.txt":
        return "cmake"
    script = not path.suffix and re.match(r"#!.*python", text)
    return "python" if script else _KINDS.get(path.suffix)


def files(tree):
    return [path for path in dict.fromkeys(tree.all) if _kind(tree, path)]


def _blank(match):
    return re.sub(r"[^\n]", " ", match.group(0))


def long_function(tree, path):
    kind, text = _kind(tree, path), tree.text(path)
    find = {"cpp": _cpp_functions, "python": _python_functions}.get(kind, _spans)
    for first, last in find(text, kind):
        lines = last - first + 1
        if lines > FUNCTION_LINES:
            yield first, f"a function of {lines} lines, at most {FUNCTION_LINES} wanted"


def _spans(text, kind):
    for match in _SPAN[kind].finditer(text):
        yield line_of(text, match.start()), line_of(text, match.end())


def _python_functions(text, _):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.lineno, node.end_lineno


def _cpp_functions(text, kind):
    """What stands in curly brackets behind a whole list of arguments, the outermost only."""
    code = _DIRECTIVE.sub(_blank, _NO_CODE[kind].sub(_blank, text))
    starts, before = [], 0  # of what is open: where it began, or None where it is no function
    for match in _BRACKET.finditer(code):
        at, head = match.start(), code[before:match.start()]
        if match.group(0) == "{":
            whole = 0 < head.count("(") == head.count(")") and not head.rstrip().endswith("=")
            starts.append(before + len(head) - len(head.lstrip()) if whole else None)
        elif match.group(0) == "}" and starts:
            start = starts.pop()
            if start is not None and not any(starts):
                yield line_of(code, start), line_of(code, at)
        before = match.end()


def _runs(tree, path):
    """Lists of (line's number, what stands there), of nothing but what counts."""
    kind, run = _kind(tree, path), []
    code = _NO_CODE[kind].sub(  # strings do count
        lambda match: match.group(0) if match.group(0)[0] in "R\"'" else _blank(match),
        tree.text(path))
    for number, line in enumerate(code.splitlines(), 1):
        line = " ".join(line.split())
        if _LISTED[kind].match(line):
            yield run
            run = []
        elif not _THIN.match(line):
            run.append((number, line))
    yield run


def equal_lines(tree):
    """Where lines stand that stand elsewhere too: each run of them once, at its second place."""
    seen = {}  # six lines -> where they stand first: file, run, line of the run, line's number
    for path in files(tree):
        for index, run in enumerate(_runs(tree, path)):
            end = 0  # what was reported reaches up to here
            for first in range(len(run) - EQUAL_LINES + 1):
                place = (tree.name(path), index, first, run[first][0])
                other = seen.setdefault(
                    tuple(line for _, line in run[first:first + EQUAL_LINES]), place)
                if other[:2] == place[:2] and first - other[2] < EQUAL_LINES:
                    continue  # itself, or what overlaps with it
                if first >= end:
                    yield (tree.name(path), run[first][0],
                           f"{EQUAL_LINES} lines or more as in {other[0]}:{other[3]}")
                end = first + EQUAL_LINES
