"""The rules that no compiler checks: each takes the tree and yields (file, line, message).

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re

from tools.checks import include_rules, links
from tools.rtl.rtl_sources import WAIVERS, line_of, listed, read_include_folders, strip_comments

WIDTH = 100
OPERATORS = tuple("+-*/%&|^~<>=!?:")
CPP_SUFFIXES = (".cpp", ".hpp", ".h", ".c")
TEXT_SUFFIXES = CPP_SUFFIXES + (
    ".v", ".vh", ".vlt", ".f", ".py", ".sh", ".cmake", ".csv", ".md", ".txt", ".json", ".ys",
    ".sdc", ".xdc", ".lpf", ".pcf",
)

MODULE_NAME = re.compile(r"(ffd_[a-z0-9]+(_[a-z0-9]+)+|hwffd_[a-z0-9]+(_[a-z0-9]+)*)\Z")

# Cells of vendors' libraries and their tools' megafunctions.
VENDOR = re.compile(
    r"\b(DSP48\w*|DSP58\w*|RAMB(16|18|36)\w*|URAM288\w*|BUFG\w*|BUFR|IBUFG?\w*|OBUF\w*|IOBUF\w*"
    r"|LUT[1-6](_\w+)?|FD[RSCP]E|SRL(16|C32)E?|CARRY[48]|MMCM\w+|PLLE\d\w*|xpm_\w+"
    r"|altsyncram|altmult_\w+|altera_\w+|lpm_\w+|altpll\w*|cyclone\w+|stratix\w+|arria\w+"
    r"|MULT(9|18|36)X(9|18|36)\w*|ALU(24|54)\w+|DP16K\w+|PDPW16K\w+|EHXPLL\w+|TRELLIS_\w+|CCU2\w+"
    r"|SB_\w+|DPR16X4\w*|EFX_\w+|MULTALU\w+|MULTADDALU\w+|SDPB|DPB|pROM|sky130_\w+|sg13g2_\w+"
    r"|gf180mcu_\w+|NangateOpenCell\w*)\b"
)

_FORMAT = r"(?:\b\w*FORMAT\b|`FFD_FORMAT_\w+)"
_COMPARE = r"(?:[=!]==?|[<>]=?)"
FORMAT_TEST = re.compile(
    rf"{_FORMAT}\s*\)*\s*(?:{_COMPARE}|\?|&&|\|\|)|(?:{_COMPARE}|&&|\|\||!)\s*\(*\s*{_FORMAT}"
)
FORMAT_WORD = re.compile(_FORMAT)
CONDITION = re.compile(r"\b(if|while|case[xz]?)\s*\(")
FORMAT_DIRECTIVE = re.compile(r"`(ifn?def|elsif)\s+\w*FORMAT\w*")


# Folders at the top that are not the project's.
_OTHERS = re.compile(r"build|\.(?!ci$)")


class Tree:
    """The files of a checkout, read once."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self._text, self._code = {}, {}
        rtl = self.root / "rtl"
        self.verilog = sorted(rtl.rglob("*.v")) + sorted(rtl.rglob("*.sv"))
        self.headers = sorted(rtl.rglob("*.vh")) + sorted(rtl.rglob("*.svh"))
        self.folders = sorted(path.name for path in self.root.iterdir() if path.is_dir() and not _OTHERS.match(path.name))
        self.cpp = self._find(CPP_SUFFIXES)
        self.all = self._find(TEXT_SUFFIXES) + self._scripts()
        self.markdown = [path for path in self.all if path.suffix == ".md"]

    def _find(self, suffixes):
        return [
            path
            for folder in self.folders
            for path in sorted((self.root / folder).rglob("*"))
            if path.suffix in suffixes and path.is_file() and "__pycache__" not in path.parts
        ]

    def _scripts(self):
        """Files without a suffix in tools/ and .ci/, and those at the top."""
        paths = []
        for folder in (self.root / "tools", self.root / ".ci"):
            paths += [p for p in sorted(folder.glob("*")) if p.is_file() and not p.suffix]
        names = ("Makefile", "CMakeLists.txt", "README.md", "hwffd.core", "fusesoc.conf")
        return paths + [self.root / name for name in names if (self.root / name).is_file()]

    def name(self, path):
        return str(path.relative_to(self.root))

    def text(self, path):
        if path not in self._text:
            self._text[path] = path.read_text(errors="replace")
        return self._text[path]

    def lines(self, path):
        return enumerate(self.text(path).splitlines(), 1)

    def code(self, path):
        """The text without comments and strings, line for line."""
        if path not in self._code:
            self._code[path] = strip_comments(self.text(path))
        return self._code[path]


# One file at a time ------------------------------------------------------------------------------


def default_nettype(tree, path):
    lines = [(n, line.strip()) for n, line in enumerate(tree.code(path).splitlines(), 1)]
    lines = [(n, line) for n, line in lines if line]
    if not lines or lines[0][1] != "`default_nettype none":
        yield lines[0][0] if lines else 1, "does not open with `default_nettype none"
    if not lines or lines[-1][1] != "`default_nettype wire":
        yield lines[-1][0] if lines else 1, "does not close with `default_nettype wire"


def columns(tree, path):
    for number, line in tree.lines(path):
        if len(line) > WIDTH:
            yield number, f"{len(line)} columns, at most {WIDTH} wanted"


def tabs(tree, path):
    for number, line in tree.lines(path):
        if "\t" in line:
            yield number, "tab"


def indentation(tree, path):
    """Two spaces a level; a line that continues an expression may be aligned with it."""
    before, braces = "", 0
    for number, line in enumerate(tree.code(path).splitlines(), 1):
        code = line.strip()
        if not code:
            continue
        continues = braces > 0 or code[0] in OPERATORS or before[-1:] in OPERATORS
        if (len(line) - len(line.lstrip(" "))) % 2 and not continues:
            yield number, "indentation is not a multiple of two spaces"
        braces += code.count("{") - code.count("}")
        before = code


def module_name(tree, path):
    names = [
        (line_of(tree.code(path), match.start()), match.group(1))
        for match in re.finditer(r"\bmodule\s+([A-Za-z_]\w*)", tree.code(path))
    ]
    if path.suffix != ".v":
        yield 1, "Verilog-2005 sources end in .v"
    if len(names) != 1:
        yield (names[1][0] if names else 1), f"{len(names)} modules, one wanted"
    for number, name in names[:1]:
        if name != path.stem:
            yield number, f"module {name} in a file named {path.name}"
        if not MODULE_NAME.match(name):
            yield number, f"module {name} is not named ffd_<family>_<noun> or hwffd_<noun>"


def licence(tree, path):
    text = tree.text(path)
    module = re.search(r"^module\b", text, re.MULTILINE)
    header = text[: module.start()] if module else text
    if not re.search(r"^// SPDX-License-Identifier: Apache-2\.0$", header, re.MULTILINE):
        yield 1, "no line '// SPDX-License-Identifier: Apache-2.0' in the header"


def vendor_primitive(tree, path):
    for match in VENDOR.finditer(tree.code(path)):
        number = line_of(tree.code(path), match.start())
        yield number, f"{match.group(0)} belongs to one vendor: describe what it does"


def format_test(tree, path):
    """FORMAT may be passed on, but not tested: what it means stays in number/."""
    if (tree.root / "rtl" / "number") in path.parents:
        return
    code = tree.code(path)
    numbers = {line_of(code, match.start()) for match in FORMAT_TEST.finditer(code)}
    numbers |= {line_of(code, match.start()) for match in FORMAT_DIRECTIVE.finditer(code)}
    for match in CONDITION.finditer(code):
        depth, end = 1, match.end()
        while depth and end < len(code):
            depth += {"(": 1, ")": -1}.get(code[end], 0)
            end += 1
        word = FORMAT_WORD.search(code, match.end(), end)
        if word:
            numbers.add(line_of(code, word.start()))
    for number in sorted(numbers):
        yield number, "tests the number format outside rtl/number/"


def lint_pragma(tree, path):
    for number, line in tree.lines(path):
        if re.search(r"lint_off\b|verilator\s+lint_save", line):
            yield number, "lint_off in a source: cure the warning"


def generate_arms(tree, path):
    from tools.rtl.generate_arms import problems  # here: needs a package, which other rules do not
    return problems(tree.text(path))


def unexplained_todo(tree, path):
    word = re.compile(r"\b(T[O]DO|F[I]XME|X[X]X)\b(.*)")
    for number, line in tree.lines(path):
        match = word.search(line)
        if match and not re.match(r"(\([^)]+\))?: *(\S+ +){2,}\S+", match.group(2)):
            yield number, f"{match.group(1)} without a reason ('{match.group(1)}: what and why')"


def trailing_blanks(tree, path):
    for number, line in tree.lines(path):
        if line != line.rstrip():
            yield number, "blank at the end of the line"
    text = tree.text(path)
    if text and not text.endswith("\n"):
        yield text.count("\n") + 1, "no newline at the end of the file"


# The tree as a whole -----------------------------------------------------------------------------


def file_list(tree):
    name = "rtl/hwffd.f"
    path = tree.root / name
    if not path.is_file():
        yield name, 1, "missing"
        return
    entries = listed(path.parent)
    for entry in entries:
        if entries.count(entry) > 1:
            yield name, 1, f"{entry} is listed twice"
        if not (tree.root / "rtl" / entry).is_file():
            yield name, 1, f"{entry} does not exist"
    for source in tree.verilog:
        if str(source.relative_to(tree.root / "rtl")) not in entries:
            yield tree.name(source), 1, "not listed in rtl/hwffd.f or rtl/boards.f"
    folders = read_include_folders(path)
    for folder in folders:
        if not (tree.root / "rtl" / folder).is_dir():
            yield name, 1, f"folder {folder} does not exist"
    for header in tree.headers:
        if str(header.parent.relative_to(tree.root / "rtl")) not in folders:
            yield tree.name(header), 1, "its folder is not listed in rtl/hwffd.f (+incdir+)"


def empty_waivers(tree):
    """Of a time unit, which no module has, there is nothing to cure."""
    name = f"rtl/{WAIVERS}"
    path = tree.root / name
    if not path.is_file():
        yield name, 1, "missing"
        return
    for number, line in enumerate(tree.code(path).splitlines(), 1):
        if "lint_off" in line and "-rule TIMESCALEMOD " not in line:
            yield name, number, "a waiver: cure the warning"


# rule -> the files it looks at, and the function for one file
PER_FILE = {
    "default-nettype": (lambda tree: tree.verilog, default_nettype),
    "columns": (lambda tree: tree.verilog + tree.headers, columns),
    "tabs": (lambda tree: tree.verilog + tree.headers, tabs),
    "indentation": (lambda tree: tree.verilog + tree.headers, indentation),
    "module-name": (lambda tree: tree.verilog, module_name),
    "licence": (lambda tree: tree.verilog + tree.headers, licence),
    "vendor-primitive": (lambda tree: tree.verilog + tree.headers, vendor_primitive),
    "format-test": (lambda tree: tree.verilog + tree.headers, format_test),
    "lint-pragma": (lambda tree: tree.verilog + tree.headers, lint_pragma),
    "generate-arm": (lambda tree: tree.verilog, generate_arms),
    "reason": (lambda tree: tree.all, unexplained_todo),
    "trailing-blank": (lambda tree: tree.all, trailing_blanks),
    "link": (lambda tree: tree.markdown, links.dead_links),
    "section": (lambda tree: tree.all, links.missing_sections),
    "laboratory": (include_rules.of_product, include_rules.laboratory),
}
# Those that want a Python package.
PARSED = ("generate-arm",)
WHOLE_TREE = {"file-list": file_list, "empty-waivers": empty_waivers, "one-way": include_rules.arrows}


def check(root, parsed=True):
    """(number of checks, list of 'file:line: message [rule]'); without the rules of PARSED if so wanted."""
    tree = Tree(root)
    checks, warnings = 0, []
    for rule, (files, function) in PER_FILE.items():
        if rule in PARSED and not parsed:
            continue
        for path in files(tree):
            checks += 1
            for number, message in function(tree, path):
                warnings.append(f"{tree.name(path)}:{number}: {message} [{rule}]")
    for rule, function in WHOLE_TREE.items():
        checks += 1
        for name, number, message in function(tree):
            warnings.append(f"{name}:{number}: {message} [{rule}]")
    return checks, warnings
