"""Parameters and ports of a module, as its source declares them.

SPDX-License-Identifier: Apache-2.0
"""

import re
from dataclasses import dataclass

from tools import csv_table
from tools.rtl import rtl_sources

_HEADER = re.compile(r"\bmodule\s+(\w+)\s*#\((.*?)\n\)\s*\((.*?)\n\);", re.DOTALL)
_PARAMETER = re.compile(r"\s*parameter\s+(\w+)\s*=\s*(\S+)")
_PORT = re.compile(r"\s*(input|output)\s+wire\s+(?:\[(\d+|[A-Z]\w*(?:/8)?-1):0\]\s*)?(\w+)")
_DEFINE = re.compile(r"^`define\s+(\w+)\s+(\d+)\s*$", re.MULTILINE)


class HeaderError(csv_table.TableError):
    """A header that cannot be read, in one line."""


@dataclass(frozen=True)
class Port:
    direction: str
    width: int
    name: str


@dataclass(frozen=True)
class Header:
    name: str
    parameters: dict  # name -> default, a number
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


def read(sources, module):
    """The header of a module whose ports have the width of a number or a parameter, or an eighth of one,
    with its default. Raises HeaderError."""
    if module not in sources.files:
        raise HeaderError(f"no module {module} in rtl/hwffd.f")
    match = _HEADER.search(sources.whole(module))
    if not match:
        raise HeaderError(f"{module}: parameters and ports not found")
    constants = _constants(sources)
    parameters, ports = {}, []
    for part in match.group(2).split(","):
        declared = _PARAMETER.fullmatch(part.rstrip())
        if not declared:
            raise HeaderError(f"{module}: not a parameter: '{part.strip()}'")
        name, value = declared.groups()
        parameters[name] = _number(value, constants, f"{module}.{name}")
    for part in match.group(3).split(","):
        declared = _PORT.fullmatch(part.rstrip())
        if not declared:
            raise HeaderError(f"{module}: not a port: '{part.strip()}'")
        direction, high, name = declared.groups()
        of_parameter, of_bytes, _ = (high or "").removesuffix("-1").partition("/8")
        if of_parameter in parameters:
            width = parameters[of_parameter] // (8 if of_bytes else 1)
        elif (high or "0").isdigit():
            width = int(high or 0) + 1
        else:
            raise HeaderError(f"{module}: port {name}: no parameter {of_parameter}")
        ports.append(Port(direction, width, name))
    return Header(module, parameters, tuple(ports))
