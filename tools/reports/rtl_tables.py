"""Parameters, ports and rows of the table of configurations, read off the RTL.

SPDX-License-Identifier: Apache-2.0
"""

import dataclasses

from tools.reports.results import RequestError
from tools.reports.text_table import Table
from tools.rtl import module_header, rtl_sources
from tools.tables import configurations, organizations, parameter_space


def _meanings(top, names, lines):
    """name -> meaning, of lines NAME: meaning or PREFIX*: meaning; every line must be of use."""
    meanings = [[part.strip() for part in line.split(":", 1)] for line in lines]
    if any(len(pair) != 2 for pair in meanings):
        raise RequestError(f"{top}: each line is NAME: meaning")
    by_name, used = {}, set()
    for name in names:
        for pattern, meaning in meanings:
            if name == pattern or pattern[-1] == "*" and name.startswith(pattern[:-1]):
                by_name.setdefault(name, meaning)
                used.add(pattern)
        if name not in by_name:
            raise RequestError(f"{top}.{name} has no meaning")
    for pattern, _ in meanings:
        if pattern not in used:
            raise RequestError(f"{top} has no {pattern}")
    return by_name


def _header(reports, top):
    try:
        return module_header.read(rtl_sources.Sources(reports.root), top)
    except module_header.HeaderError as error:
        raise RequestError(str(error)) from error


def parameters(reports, top, lines=()):
    header = _header(reports, top)
    meaning = _meanings(top, header.parameters, lines)
    known = _space(top)
    return Table(["parameter", "default", "values", "meaning"], [
        [f"`{name}`", str(value), str(known.parameters[top][name].values), meaning[name]]
        for name, value in header.parameters.items()])


def clocks(reports):
    """What each organization takes with units of one clock: by the paper's schedule, in which fused units spare an
    addition, and overlapped, with pipelined and with iterative evaluators."""
    rows = []
    for own in organizations.read(reports.root / "rtl").values():
        n = {"n": own.n} if own.n else {}
        cells = [own.formulas[column].said(**terms, **n) if own.formulas[column] else "-" for column, terms in (
            ("paper", {"poly": 6, "add": 1}), ("paper", {"poly": 3, "add": 0}), ("overlapped", {"start": 1}))]
        iterative = own.formulas["overlapped"].said(start=3, **n) if own.has_iterative else "-"
        rows.append([f"`{own.name}`", *cells, iterative])
    return Table(["organization", "paper, clocks a vertex", "fused", "overlapped, clocks between vertices", "iterative"],
                 rows)


def rules(reports, top):
    """What binds parameters of a top to each other; the guard is the module that stops elaboration."""
    _header(reports, top)
    return Table(["rule"], [[rule.text] for rule in _space(top).rules_of(top)])


def _space(top):
    known = parameter_space.Space()
    if top not in known.parameters:
        raise RequestError(f"{top}: no top of tools/tables/parameter_space.py: {', '.join(known.parameters)}")
    return known


def ports(reports, top, lines=()):
    """A row for each port; ports that a line PREFIX*: meaning names together share a row for each direction."""
    header = _header(reports, top)
    meaning = _meanings(top, [port.name for port in header.ports], lines)
    prefixes = [pattern[:-1] for pattern in (line.split(":", 1)[0].strip() for line in lines) if pattern.endswith("*")]
    named = {line.split(":", 1)[0].strip() for line in lines}
    groups = {}
    for port in header.ports:
        together = [prefix for prefix in prefixes if port.name.startswith(prefix) and port.name not in named]
        groups.setdefault((together[0] if together else port.name, port.direction), []).append(port)
    return Table(["port", "direction", "width", "meaning"], [
        [", ".join(f"`{port.name}`" for port in group), direction,
         ", ".join(str(port.width) for port in group), meaning[group[0].name]]
        for (_, direction), group in groups.items()])


def rows(reports):
    """Those of the table of configurations, as a report would have them."""
    table = configurations.read(reports.root / "rtl" / "configurations.csv")
    return [dataclasses.asdict(row) for row in table]


TABLES = {"parameters": parameters, "rules": rules, "ports": ports, "clocks": clocks}
