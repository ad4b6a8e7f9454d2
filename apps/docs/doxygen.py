"""What Doxygen finds in the public headers: declarations and their comments, header by header.

SPDX-License-Identifier: Apache-2.0
"""

import re
import subprocess
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

HEADERS = ("api/include", "golden/include", "geometry/include", "driver/include", "api/gl/include")

_SETTINGS = """
INPUT = {input}
OUTPUT_DIRECTORY = {output}
STRIP_FROM_PATH = {root}
FILE_PATTERNS = *.h *.hpp
RECURSIVE = YES
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
WARNINGS = NO
QUIET = YES
"""
_MEMBERS = ("function", "variable", "typedef", "define", "enum")


class DoxygenError(Exception):
    """Doxygen did not run; one line."""


@dataclass
class Declaration:
    """A function, type, variable, macro, enumeration or class."""

    kind: str
    name: str
    text: str  # as one would write it in C++
    line: int
    comments: list  # elements <briefdescription> and <detaileddescription>
    members: list = field(default_factory=list)


@dataclass
class Header:
    """Its path below include/, and what it declares in the order of the file."""

    path: str
    comments: list
    declarations: list = field(default_factory=list)


def run(root, output):
    """Doxygen's XML in `output`/xml."""
    output.mkdir(parents=True, exist_ok=True)
    settings = _SETTINGS.format(root=root, output=output, input=" ".join(str(root / name) for name in HEADERS))
    try:
        result = subprocess.run(["doxygen", "-"], input=settings, capture_output=True, text=True, check=False)
    except FileNotFoundError as error:
        raise DoxygenError("doxygen not found: run tools/install docs") from error
    if result.returncode != 0:
        raise DoxygenError(f"doxygen failed: {result.stderr.strip().splitlines()[-1]}")
    return output / "xml"


def _words(element):
    return " ".join("".join(element.itertext()).split()) if element is not None else ""


def as_written(text):
    """C++ with the blanks of this project: Doxygen puts others around <, >, & and *."""
    text = re.sub(r"\s*<\s*", "<", text) if "operator<" not in text else text
    text = re.sub(r"\s+>", ">", text)
    text = re.sub(r" ([&*]+)(?=[\w(])", r"\1 ", text)
    return re.sub(r"\s+([&*]+)", r"\1", text).strip()


def _template(element):
    """"template <class F> ", or nothing."""
    parameters = element.find("templateparamlist")
    if parameters is None or not len(parameters):
        return ""
    words = [" ".join(filter(None, (_words(node.find("type")), _words(node.find("declname")))))
             + (f" = {_words(node.find('defval'))}" if node.find("defval") is not None else "") for node in parameters]
    return f"template <{', '.join(words)}> "


def _enum(element):
    name = _words(element.find("name")).lstrip("@0123456789")
    scoped = "enum class" if element.get("strong") == "yes" else "enum"
    base = _words(element.find("type"))
    return f"{scoped} {name}{' : ' + base if base else ''}".strip()


def _text(element, kind):
    name, words = _words(element.find("name")), []
    if kind == "enum":
        return _enum(element)
    if kind == "define":
        parameters = [_words(parameter) for parameter in element.findall("param")]
        return f"#define {name}" + (f"({', '.join(parameters)})" if parameters else "")
    if kind == "typedef":
        definition = _words(element.find("definition"))
        if definition.startswith("using"):
            return as_written(f"{_template(element)}using {name} = {_words(element.find('type'))}")
        return as_written(f"typedef {_words(element.find('type'))} {name}{_words(element.find('argsstring'))}")
    words += ["explicit"] if element.get("explicit") == "yes" else []
    words += ["static"] if element.get("static") == "yes" else []
    words += ["virtual"] if element.get("virt", "non-virtual") != "non-virtual" else []
    words += [_words(element.find("type")), name]
    text = " ".join(filter(None, words)) + _words(element.find("argsstring"))
    initial = _words(element.find("initializer"))
    if kind == "variable" and initial and len(initial) < 40:
        text += f" {initial}" if initial.startswith("=") else initial
    return as_written(_template(element) + text)


def _comments(element):
    return [part for part in (element.find("briefdescription"), element.find("detaileddescription"))
            if part is not None and _words(part)]


def _declaration(element):
    kind, name = element.get("kind"), _words(element.find("name"))
    text = _text(element, kind)
    kind = "values" if text == "enum" else kind  # without a name
    members = [Declaration("value", _words(value.find("name")), _words(value.find("name")), 0, _comments(value))
               for value in element.findall("enumvalue")]
    line = int(element.find("location").get("line"))
    return Declaration(kind, name, text, line, _comments(element), members)


def _public(compound):
    members = [element for element in compound.iter("memberdef")
               if element.get("kind") in _MEMBERS and element.get("prot") == "public"]
    return [(element, declaration) for element, declaration in zip(members, map(_declaration, members))
            if not re.search(r"=\s*delete$", declaration.text) and declaration.name[:1] != "~"]


def _members(compound, name):
    """Without the constructors of a base that a class takes over."""
    own = name.rpartition("::")[2]
    declarations = [member for element, member in _public(compound) if element.get("kind") != "function"
                    or _words(element.find("type")) or member.name == own or member.name.startswith("operator")]
    return sorted(declarations, key=lambda declaration: declaration.line)


def _class(compound):
    name = re.sub(r"^hwffd::", "", _words(compound.find("compoundname")))
    kind = compound.get("kind")
    bases = [as_written(_words(base)) for base in compound.findall("basecompoundref") if base.get("prot") == "public"]
    text = as_written(f"{_template(compound)}{kind} {name}") + (f" : public {', '.join(bases)}" if bases else "")
    line = int(compound.find("location").get("line"))
    return Declaration(kind, name, text, line, _comments(compound), _members(compound, name))


def _file_of(element):
    return element.find("location").get("file", "").rpartition("include/")[2]


def _is_inner(compound):
    """Of namespaces that are no part of the interface."""
    return bool(re.search(r"\bdetail\b|@|anonymous", _words(compound.find("compoundname"))))


def headers(folder):
    """Every header of Doxygen's XML, by its path."""
    compounds = [ElementTree.parse(path).getroot().find("compounddef") for path in sorted(folder.glob("*.xml"))
                 if path.name not in ("index.xml", "Doxyfile.xml")]
    by_file = {_file_of(node): Header(_file_of(node), _comments(node)) for node in compounds
               if node.get("kind") == "file"}
    for compound in compounds:
        kind = compound.get("kind")
        if kind in ("file", "namespace") and not _is_inner(compound):
            for element, declaration in _public(compound):
                by_file[_file_of(element)].declarations.append(declaration)
        elif kind in ("class", "struct", "union") and compound.get("prot") == "public" and not _is_inner(compound):
            by_file[_file_of(compound)].declarations.append(_class(compound))
    for header in by_file.values():
        header.declarations.sort(key=lambda declaration: declaration.line)
    return dict(sorted(by_file.items()))
