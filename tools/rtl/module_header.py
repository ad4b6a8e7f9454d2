"""Parameters and ports of a module, as its source declares them.

SPDX-License-Identifier: Apache-2.0
"""

import re
from dataclasses import dataclass

from tools import csv_table
from tools.rtl import rtl_sources
from tools.tables import organizations

_HEADER = re.compile(r"\bmodule\s+(\w+)\s*#\((.*?)\n\)\s*\((.*?)\n\);", re.DOTALL)
_PARAMETER = re.compile(r"\s*parameter\s+(\w+)\s*=\s*(\S+)")
_PORT = re.compile(r"\s*(input|output)\s+wire\s+(?:\[(\d+|`?[A-Z]\w*(?:/8)?-1):0\]\s*)?(\w+)")
_OF_ORG = "`FFD_ORG_N(ORG)"  # a default that is that of the organization
_DEFINE = re.compile(r"^`define\s+(\w+)\s+(\d+)\s*$", re.MULTILINE)


class HeaderError(csv_table.TableError):
    """A header that cannot be read, in one line."""


@dataclass(frozen=True)
class Port:
    direction: str
    width: int
    name: str
    high: str  # its highest bit as the source says it, with parameters; empty where it is one bit


@dataclass(frozen=True)
class Header:
    name: str
    parameters: dict  # name -> default, a number
    of_org: tuple  # those of them whose default is that of the organization
    ports: tuple


def _constants(sources):
    """name -> number: the macros of the headers that are plain numbers."""
    values = {}
    for path in sorted(sources.rtl.glob("*/*.vh")):
        values.update(_DEFINE.findall(rtl_sources.strip_comments(path.read_text())))
    return values


def _number(text, constants, where):
    value = constants.get(text[1:], "") if text.startswith("`") else text
    if not value.isdigit():
        raise HeaderError(f"{where} is '{text}', a number wanted")
    return int(value)


def _lists(sources, module):
    """Its parameters and its ports as text. Raises HeaderError."""
    if module not in sources.files:
        raise HeaderError(f"no module {module} in rtl/hwffd.f")
    match = _HEADER.search(sources.whole(module))
    if not match:
        raise HeaderError(f"{module}: parameters and ports not found")
    return match.group(2).split(","), match.group(3).split(",")


def _defaults(sources, module):
    """name -> default, as it stands in the source."""
    defaults = {}
    for part in _lists(sources, module)[0]:
        declared = _PARAMETER.fullmatch(part.rstrip())
        if not declared:
            raise HeaderError(f"{module}: not a parameter: '{part.strip()}'")
        defaults.update([declared.groups()])
    return defaults


def of_org(sources, module):
    """Names of the parameters whose default is that of the organization."""
    return tuple(name for name, value in _defaults(sources, module).items() if value == _OF_ORG)


def parameters(sources, module):
    """name -> default, of a module; what the organization decides as it is of the default one. Raises HeaderError."""
    constants, numbers = _constants(sources), {}
    for name, value in _defaults(sources, module).items():
        if value == _OF_ORG:
            rows = organizations.read(sources.rtl).values()
            numbers[name] = next(row.n for row in rows if row.number == numbers["ORG"])
        else:
            numbers[name] = _number(value, constants, f"{module}.{name}")
    return numbers


def _width(high, of_module, constants, where):
    """Of a port, whose highest bit is a number, or one below a parameter, an eighth of one or a macro."""
    name, of_bytes, _ = (high or "0").removesuffix("-1").partition("/8")
    if name.isdigit():
        return int(name) + 1
    if name.startswith("`"):
        return _number(name, constants, f"{where}: width")
    if name not in of_module:
        raise HeaderError(f"{where}: no parameter {name}")
    return of_module[name] // (8 if of_bytes else 1)


def read(sources, module):
    """The header of a module, with the widths that its ports have with its defaults. Raises HeaderError."""
    of_module, constants, ports = parameters(sources, module), _constants(sources), []
    for part in _lists(sources, module)[1]:
        declared = _PORT.fullmatch(part.rstrip())
        if not declared:
            raise HeaderError(f"{module}: not a port: '{part.strip()}'")
        direction, high, name = declared.groups()
        width = _width(high, of_module, constants, f"{module}: port {name}")
        ports.append(Port(direction, width, name, str(width - 1) if "`" in (high or "") else high or ""))
    return Header(module, of_module, of_org(sources, module), tuple(ports))
