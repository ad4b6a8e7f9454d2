"""Parameters, ports and rows of the table of configurations, read off the RTL.

SPDX-License-Identifier: Apache-2.0
"""

import dataclasses
import re

from tools.reports.results import RequestError
from tools.reports.text_table import Table
from tools.rtl import module_header, rtl_sources
from tools.tables import configurations, parameter_space


def _meanings(top, names, lines):
    """[(names, meaning)] of a table as it stands in a text: names in the first column, meaning in the last. Each of
    `names` must be there once, and nothing else."""
    cells = [line.strip("|").split("|") for line in lines if line.startswith("| `")]
    meanings = [(re.findall(r"`(\w+)`", first), last.strip()) for first, *_, last in cells]
    there = [name for together, meaning in meanings if meaning for name in together]
    for name in names:
        if there.count(name) != 1:
            raise RequestError(f"{top}.{name} has {there.count(name) or 'no'} meaning: a row of the table wanted")
    for name in there:
        if name not in names:
            raise RequestError(f"{top} has no {name}")
    return meanings


def _header(reports, top):
    try:
        return module_header.read(rtl_sources.Sources(reports.root), top)
    except module_header.HeaderError as error:
        raise RequestError(str(error)) from error


def parameters(reports, top, lines=()):
    header = _header(reports, top)
    meaning = {name: text for names, text in _meanings(top, header.parameters, lines) for name in names}
    known = _space(top)
    return Table(["parameter", "default", "values", "meaning"], [
        [f"`{name}`", "of `ORG`" if name in header.of_org else str(value), str(known.parameters[top][name].values), meaning[name]]
        for name, value in header.parameters.items()])


def _space(top):
    known = parameter_space.Space()
    if top not in known.parameters:
        raise RequestError(f"{top}: no top of tools/tables/parameter_space.py: {', '.join(known.parameters)}")
    return known


def ports(reports, top, lines=()):
    """The rows that stand in the text, each of one port or of several of one direction."""
    by_name = {port.name: port for port in _header(reports, top).ports}
    table = []
    for names, meaning in _meanings(top, by_name, lines):
        directions = {by_name[name].direction for name in names}
        if len(directions) != 1:
            raise RequestError(f"{top}: {', '.join(names)} in one row are of both directions")
        table.append([", ".join(f"`{name}`" for name in names), *directions,
                      ", ".join(str(by_name[name].width) for name in names), meaning])
    return Table(["port", "direction", "width", "meaning"], table)


def rows(reports):
    """Those of the table of configurations, as a report would have them."""
    table = configurations.read(reports.root / "rtl" / "configurations.csv")
    return [dataclasses.asdict(row) for row in table]


TABLES = {"parameters": parameters, "ports": ports}
BY_HAND = ("parameters", "ports")  # their last column
