"""Pages of the C and C++ interfaces, as Markdown, from what Doxygen finds in the headers: a page for each folder
of headers, a heading for each header and type, a row for each declaration.

SPDX-License-Identifier: Apache-2.0
"""

import html
import re

# The name of a page, its title, what it begins with, and the headers on it: a folder or a file below include/.
PAGES = (
    ("c", "C", "The library `libhwffd` for C and for everything that calls C; [hwffd](../hwffd.md) has examples.",
     ("hwffd/hwffd.h", "hwffd/version.h")),
    ("devices", "C++: devices and deformers", "What evaluates, and lattices and meshes that are moved by it.",
     ("hwffd/device/",)),
    ("lattices", "C++: lattices", "Lattices of all kinds, how points are embedded in them and how they are deformed; "
     "[lattices](../lattice.md) explains them.", ("hwffd/lattice/",)),
    ("meshes", "C++: meshes and points", "Meshes and their files, points, threads and errors.",
     ("hwffd/mesh/", "hwffd/points.hpp", "hwffd/on_threads.hpp", "hwffd/atomic_file.hpp", "hwffd/error.hpp",
      "hwffd/excerpt.hpp")),
    ("streams", "C++: packets of the stream", "Words and packets that the core takes and gives; "
     "[interface](../interface.md) describes them.", ("hwffd/stream/",)),
    ("model", "C++: the model", "The bit-true model of the core, its configurations and organizations; "
     "[architecture](../architecture.md) explains them.", ("hwffd/model/",)),
    ("numbers", "C++: numbers, oracle and bounds", "The number formats bit by bit, equation (1) in double, and proved "
     "bounds of errors; [numerics](../numerics.md) explains them.",
     ("hwffd/numerics/", "hwffd/oracle/", "hwffd/bounds/")),
    ("driver", "C++: the driver", "What software needs to work `hwffd_axi` through its "
     "[registers](../registers.md).", ("hwffd/driver.hpp", "hwffd/register_port.hpp", "hwffd/registers.h")),
    ("opengl", "C: OpenGL calls", "The calls of the paper beside those of OpenGL; [opengl](../opengl.md) explains "
     "them.", ("hwffd/glffd.h",)),
)

_HEADED = ("class", "struct", "union", "enum")
_PAGE = re.compile(r"docs/([\w/-]+\.md)")


class HeaderError(Exception):
    """A header that no page has; one line."""


def escaped(text):
    """Text that Markdown leaves as it is, also in a table."""
    text = html.escape(text, quote=False)
    for letter in "\\`*_[]|":
        text = text.replace(letter, f"&#{ord(letter)};")
    return text


def code(text):
    return f"<code>{escaped(text)}</code>"


def _text(words):
    """With links to the pages that it names."""
    return _PAGE.sub(r"[\g<0>](../\1)", escaped(words or ""))


def _list(element):
    return "".join(f"<br>• {_inline(item).strip()}" for item in element.findall("listitem"))


def _parameters(element):
    entries = []
    for item in element.findall("parameteritem"):
        names = ", ".join(code("".join(name.itertext())) for name in item.iter("parametername"))
        words = _inline(item.find("parameterdescription")).strip()
        verb = {"exception": "throws ", "retval": "returns "}.get(element.get("kind"), "")
        entries.append(f"<br>{verb}{names}{' ' if verb else ': '}{words}")
    return "".join(entries)


def _section(element):
    kind = element.get("kind")
    return f"<br>{kind + 's ' if kind == 'return' else ''}{_inline(element).strip()}"


_ELEMENTS = {
    "computeroutput": lambda element: code("".join(element.itertext())),
    "emphasis": lambda element: f"<em>{_inline(element)}</em>",
    "bold": lambda element: f"<strong>{_inline(element)}</strong>",
    "parameterlist": _parameters,
    "simplesect": _section,
    "itemizedlist": _list,
    "orderedlist": _list,
    "verbatim": lambda element: code("".join(element.itertext())),
    "linebreak": lambda element: "<br>",
    "para": lambda element: f"<br>{_inline(element).strip()}",
}


def _inline(element):
    """One line of Markdown and HTML, paragraphs parted by breaks."""
    words = _text(element.text)
    for child in element:
        words += _ELEMENTS.get(child.tag, _inline)(child) + _text(child.tail)
    words = " ".join(words.split())
    return words[4:] if words.startswith("<br>") else words


def comment(declaration):
    return "<br>".join(filter(None, map(_inline, declaration.comments)))


def _paragraphs(words):
    """What is one line with breaks in a table."""
    return words.replace("<br>• ", "\n\n- ").replace("<br>", "\n\n")


def _rows(declarations):
    """A table, or the declarations alone where none has a comment."""
    if not declarations:
        return ""
    if not any(declaration.comments or declaration.members for declaration in declarations):
        return "```cpp\n" + "\n".join(declaration.text for declaration in declarations) + "\n```\n\n"
    lines = ['<div class="declarations" markdown>', "", "| declaration | meaning |", "|---|---|"]
    for declaration in declarations:
        words = comment(declaration)
        if declaration.members:
            words += "".join(f"<br>{code(value.name)}{': ' if value.comments else ''}{comment(value)}"
                             for value in declaration.members)
        lines.append(f"| {code(declaration.text)} | {words.removeprefix('<br>')} |")
    return "\n".join(lines) + "\n\n</div>\n\n"


def _header(header):
    text = f"## {header.path}\n\n"
    about = comment(header)
    text += f"{_paragraphs(about)}\n\n" if about else ""
    text += _rows([declaration for declaration in header.declarations if declaration.kind not in _HEADED])
    for entry in header.declarations:
        if entry.kind in _HEADED:
            about = _paragraphs(comment(entry))
            text += f"### {escaped(entry.name)}\n\n```cpp\n{entry.text}\n```\n\n{about}\n\n{_rows(entry.members)}"
    return text


def pages(headers):
    """{name: text} of all pages; each header on one of them."""
    left, written = dict(headers), {}
    for name, title, about, wanted in PAGES:
        chosen = [left.pop(path) for path in list(left) if path.startswith(wanted)]
        written[name] = f"# {title}\n\n{about}\n\n" + "".join(map(_header, chosen))
    if left:
        raise HeaderError(f"{', '.join(left)}: on no page; name a page in apps/docs/reference.py")
    return written
