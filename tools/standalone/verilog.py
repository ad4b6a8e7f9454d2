"""The one Verilog file of a standalone core: its modules, without includes and macros, under names of its own.

Arms of generates that no value of its free parameters takes are left out; what is left of them stops
elaboration by its name, as the guards of the RTL do.

SPDX-License-Identifier: Apache-2.0
"""

import re

from pyslang import parsing
from pyslang.parsing import TriviaKind
from pyslang.syntax import SyntaxKind

from tools.standalone import elaboration
from tools.standalone.configuration import Refused

WIDTH = 100
# Where a long line is broken first: in front of an operator, or behind a comma.
_BREAK = re.compile(r" (?=(?:&&|\|\||[?:+]) )|(?<=,) ")
# A name in brackets of its own, as arguments of macros have them.
_BRACKETED = re.compile(r"(?:(?<=[(,])|(?<=[-+*/<>=&|?:!] ))\(([A-Z]\w*)\)")
_COMMENT = re.compile(r"//[^\n]*")
_WORD = re.compile(r"\b(?:ERROR_)?h?w?ffd_[a-z0-9_]+\b")


def new_names(modules, top, prefix):
    """old name -> new name of each module: the top is called as the prefix."""
    names = {name: f"{prefix}_{re.sub('^h?w?ffd_', '', name)}" for name in modules if name != top}
    if len({*names.values(), prefix}) <= len(names):
        raise ValueError("two modules would have one name")
    return {top: prefix, **names}


class _Renaming:
    """Words of the sources as the folder has them."""

    def __init__(self, names):
        self.names = names
        self.longest = sorted(names, key=len, reverse=True)

    def _word(self, match):
        word = match[0]
        if word in self.names:
            return self.names[word]
        if word.startswith("ERROR_"):
            for name in self.longest:
                if word.startswith(f"ERROR_{name}_"):
                    return f"ERROR_{self.names[name]}{word[len('ERROR_' + name):]}"
        return word

    def __call__(self, text):
        return _WORD.sub(self._word, text) if "ffd_" in text else text


def _comments(trivia):
    """Blanks and comments in front of a token, those of directives too, as text; of a file that is
    included its own header is left out, and what it is before it, since its text is a part of another now."""
    text = ""
    for piece in trivia:
        if piece.kind == TriviaKind.Directive:
            text += _comments_of_directive(piece.syntax())
        elif piece.kind in (TriviaKind.LineComment, TriviaKind.BlockComment):
            comment = piece.getRawText()
            text += comment
            if "SPDX-License-Identifier" in comment:
                text = ""
        elif piece.kind in (TriviaKind.Whitespace, TriviaKind.EndOfLine):
            text += piece.getRawText()
    return text


def _comments_of_directive(node):
    return _comments(node.getFirstToken().trivia)


class _Writer:
    """The text of one module."""

    def __init__(self, design, name, renamed):
        self.design, self.name, self.renamed = design, name, renamed
        self.main = None  # the buffer of its file
        self.text = []
        self.arms = []  # what is left out: where its mention of constants goes, and the words of each

    def module(self, node):
        self.main = elaboration.place(node)[0]
        self._node(node)
        self._mention(_constants(node))
        return _without_idle_genvars("".join(self.text))

    def _mention(self, constants):
        """Constants that nothing but what is left out has used are named there: tools look whether they are used."""
        uses = {}
        used = re.findall(r"\b[A-Z]\w*", _COMMENT.sub("", "".join(self.text)))
        for name in constants:
            if used.count(name) != 1:
                continue
            for at, words in self.arms:
                if name in words:
                    uses.setdefault(at, []).append(f"{name} != 0")
                    break
        for at, words in uses.items():
            self.text[at] = f"{self.text[at]}wire unused_ok = {' || '.join(words)};{self.text[at]}"

    def _node(self, node):
        if isinstance(node, parsing.Token):
            self._token(node)
            return
        if node.kind == SyntaxKind.GenerateBlock and self._is_left_out(node):
            self._left_out(node)
            return
        value = self._value(node)
        for child in node:
            if child is None:
                continue
            if value is not None and not isinstance(child, parsing.Token) and child.kind == SyntaxKind.EqualsValueClause:
                self.text.append(f"{_comments(child.equals.trivia)}= {value}")
            else:
                self._node(child)

    def _value(self, node):
        """That of a parameter in the core, which is its default here: a tool may look at a module by itself."""
        if node.kind != SyntaxKind.Declarator or node.parent.kind != SyntaxKind.ParameterDeclaration:
            return None
        name = node.name.valueText
        if not self._in_header(node) or name in self.design.relied[self.name]:
            return None
        return self.design.modules[self.name].get(name)

    def _in_header(self, node):
        return node.parent.parent.kind == SyntaxKind.ParameterPortList

    def _token(self, token):
        if token.kind == parsing.TokenKind.EndOfFile or token.isMissing:
            return
        self._before(token)
        self.text.append(self.renamed(token.rawText))

    def _before(self, token):
        before = _comments(token.trivia)
        place = token.location
        manager = self.design.manager
        if manager.isMacroLoc(place):
            before = " " if before else ""
        elif manager.isFileLoc(place) and place.buffer.id != self.main:
            # What is included begins its lines at their first column.
            before = re.sub(r"\n(?=\S|$)", "\n  ", before)
            if "\n" not in before:
                before = "\n  " + before.lstrip() if self._line_begins(token) else before
        self.text.append(self.renamed(before))

    def _line_begins(self, token):
        return self.design.manager.getColumnNumber(token.location) == 1

    def _is_left_out(self, node):
        if elaboration.place(node) in self.design.arms:
            return False
        # A guard stays as it is.
        return not (len(node.members) == 1 and str(node.members[0].getFirstToken().rawText).startswith("ERROR_"))

    def _left_out(self, node):
        arm = node.beginName.name.valueText
        column = len("".join(self.text[-200:]).rsplit("\n", maxsplit=1)[-1])
        line = "".join(self.text[-200:]).rsplit("\n", maxsplit=1)[-1]
        indent = " " * (len(line) - len(line.lstrip()) if line.strip() else column)
        self.text += [f" begin : {arm}", f"\n{indent}  ",
                      f"ERROR_{self.renamed(self.name)}_{arm}_is_left_out u_error ();\n{indent}end"]
        self.arms.append((len(self.text) - 2, {token.rawText for token in _tokens(node)}))


class _TopWriter(_Writer):
    """The text of the top: what is fixed is a localparam, and each port has a number for its width."""

    def __init__(self, design, name, renamed, core):
        super().__init__(design, name, renamed)
        self.core = core

    def _node(self, node):
        if not isinstance(node, parsing.Token):
            if node.kind == SyntaxKind.ParameterPortList:
                self.text.append(self._parameters())
                return
            if node.kind == SyntaxKind.ImplicitAnsiPort:
                self._port(node)
                return
        super()._node(node)
        if not isinstance(node, parsing.Token) and node.kind == SyntaxKind.ModuleHeader:
            self.text.append(self._fixed())

    def _parameters(self):
        lines = [f"  parameter {name:<{self._column}} = {self.core.parameters[name]}{{}}  // {free.text}"
                 for name, free in self.core.free.items()]
        if not lines:
            return ""
        return " #(\n" + "\n".join(line.format("," if line is not lines[-1] else "") for line in lines) + "\n)"

    @property
    def _column(self):
        return max(map(len, self.core.parameters))

    def _fixed(self):
        lines = ["", "  // What this file is made for; with other values its modules would lack something."]
        lines += [f"  localparam {name:<{self._column}} = {value};{self._meaning(name)}"
                  for name, value in self.core.fixed.items()]
        if self.core.free:
            lines += ["", "  generate"]
            for name, free in self.core.free.items():
                lines += [f"    if ({free.forbidden}) begin : gen_bad_{name.lower()}",
                          f"      ERROR_{self.core.prefix}_{name.lower()}_is_not_one_of_those_above u_error ();",
                          "    end"]
            lines += ["  endgenerate"]
        return "\n".join(lines) + "\n"

    def _meaning(self, name):
        core = self.core
        meaning = {"ORG": core.organization.name, "FORMAT": core.number_format.name, "SCHEDULE": core.schedule,
                   "EVALUATOR": core.evaluator}.get(name)
        return f"  // {meaning}" if meaning else ""

    def _port(self, node):
        name = node.declarator.name.valueText
        _, width = self.design.ports[name]
        for child in node:
            for token in _tokens(child):
                if token.kind == parsing.TokenKind.OpenBracket:
                    self._before(token)
                    self.text.append(f"[{width - 1}:0]" if width > 1 else "")
                elif not _within_brackets(node, token):
                    self._token(token)


def _without_idle_genvars(text):
    """Without genvars whose loops are left out."""
    code = _COMMENT.sub("", text)

    def used(match):
        names = [name for name in re.findall(r"\w+", match[2]) if len(re.findall(rf"\b{name}\b", code)) > 1]
        return f"{match[1]}genvar {', '.join(names)};" if names else ""

    return re.sub(r"(\n *)genvar ([\w, ]+);", used, text)


def _constants(module):
    """Names of a module's parameters and localparams."""
    names = []

    def visit(node):
        if not isinstance(node, parsing.Token) and node.kind == SyntaxKind.ParameterDeclaration:
            names.extend(declarator.name.valueText for declarator in node.declarators
                         if not isinstance(declarator, parsing.Token))

    module.visit(visit)
    return names


def _tokens(node):
    if node is None:
        return
    if isinstance(node, parsing.Token):
        yield node
        return
    for child in node:
        yield from _tokens(child)


def _within_brackets(port, token):
    """Whether a token of a port is a part of its width."""
    dimensions = port.header.dataType.dimensions
    return any(token.location == other.location and token.rawText == other.rawText
               for dimension in dimensions for other in _tokens(dimension))


def _tidy(text):
    """Without blanks at ends of lines, without two blank lines, and with long lines of code in several."""
    lines = []
    for line in text.split("\n"):
        code, mark, comment = line.rstrip().partition("//")
        line = _BRACKETED.sub(r"\1", code).replace("( (", "((") + mark + comment
        if line or (lines and lines[-1]):
            lines += _wrapped(line)
    return "\n".join(lines).strip("\n") + "\n"


def _wrapped(line):
    """A line of code of at most WIDTH columns, or in several, broken at blanks."""
    lines, indent = [], " " * (len(line) - len(line.lstrip()) + 4)
    while len(line) > WIDTH and line.lstrip()[:2] not in ("//", "/*"):
        code, mark, comment = line.partition("  //")
        if mark and len(code) <= WIDTH:
            lines.append(indent[4:] + "//" + comment)
            line = code
            continue
        start = len(line) - len(line.lstrip()) + 20
        places = [match.start() for match in _BREAK.finditer(line, start, WIDTH)]
        at = places[-1] if places else line.rfind(" ", start, WIDTH)
        if at < 0 or '"' in line:
            break
        lines.append(line[:at].rstrip())
        line = indent + line[at:].strip()
    return [*lines, line]


def _header(path):
    """The comment with which a file begins."""
    lines = []
    with open(path, encoding="utf-8") as file:
        for line in file:
            if not line.startswith("//"):
                break
            lines.append(line)
    return "".join(lines)


def _refuse_hidden(prefix, body):
    """Raises Refused where something in the top is called as the top, which Verilator does not take."""
    if re.findall(r"\w+", _COMMENT.sub("", body)).count(prefix) > 1:
        raise Refused(f"--prefix {prefix}: a name within the core; take another one")


def text(core, design, version):
    """The file. Raises Refused."""
    names = new_names(design.modules, core.top, core.prefix)
    renamed = _Renaming(names)
    free = "\n".join(f"//   {name:<16} {of.text}" for name, of in core.free.items())
    pieces = [f"""// {core.prefix}: free-form deformation, {core.organization.name} in {core.number_format.name}
//
// This is {core.top} of hwffd {version} with all that it consists of, for one configuration: no other
// file is needed, and no macro. Paths in comments are those of the sources of hwffd. Made by
//
//   {core.command}
//
// Parameters that may be changed, which changes no bit of a result:
//
{free or '//   none'}
//
// SPDX-License-Identifier: Apache-2.0

// All modules are in one file; and a source with a time unit may stand before it, in which nothing
// takes time.
/* verilator lint_off DECLFILENAME */
/* verilator lint_off TIMESCALEMOD */
`default_nettype none
"""]
    for name in design.modules:
        tree = design.trees[name]
        node = next(member for member in _modules(tree) if member.header.name.valueText == name)
        writer = (_TopWriter(design, name, renamed, core) if name == core.top else _Writer(design, name, renamed))
        body = writer.module(node)
        if name == core.top:
            _refuse_hidden(core.prefix, body)
        body = body[re.match(r"\s*(//[^\n]*\n\s*)*", body).end():] if not body.startswith("module") else body
        pieces.append(renamed(_header(design.files[name])) + "\n" + _tidy(body))
    return "\n".join(pieces) + "\n/* verilator lint_on TIMESCALEMOD */\n/* verilator lint_on DECLFILENAME */\n`default_nettype wire\n"


def _modules(tree):
    root = tree.root
    return [root] if root.kind == SyntaxKind.ModuleDeclaration else [
        member for member in root.members if member.kind == SyntaxKind.ModuleDeclaration]
