#!/usr/bin/env python3
"""docs/datasheet.md, made from docs/datasheet.in.md: figures from the reports in build/reports/,
parameters and ports from the tops, registers and rows from their tables.

In the template, {{...}} stands for what is put in:

    {{version}}                              of the file VERSION
    {{REPORT FIELD[:FORMAT] KEY=VALUE ...}}  a field of the one row with these values
    {{registers}}                            offset, register, fields
    {{parameters TOP                         a table; each line a NAME: meaning
    {{ports TOP                              a table; each line a NAME or PREFIX*: meaning
    {{rows KEY=VALUE,VALUE ...               a table of rows of rtl/configurations.csv; each line a
                                             heading | field, of the table or of a report's row of
                                             that name; A / B divides; `plain` leaves out rows whose
                                             name says more than organization, format and schedule

The last four end with a line }}. A figure without a report is an error that names the command.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import re
import shlex
import sys

import configurations
import module_header
import register_texts
import registers
import reports
import rtl
import tables
import version

TEMPLATE, DOCUMENT = "docs/datasheet.in.md", "docs/datasheet.md"
GENERATED = f"Made from {TEMPLATE} by scripts/datasheet.py; changes here are lost."
_PLACE = re.compile(r"\{\{(.*?)\}\}", re.DOTALL)
_FIGURE = "\0"  # stands for any figure where a text is compared


class DatasheetError(Exception):
    """A fault of the template, in one line."""


def pairs(words):
    """KEY=VALUE ... as a dictionary."""
    for word in words:
        if "=" not in word:
            raise DatasheetError(f"'{word}' is not KEY=VALUE")
    return dict(word.split("=", 1) for word in words)


def shown(value, form):
    """A figure as text."""
    if value is None:
        return "-"
    if form:
        return format(value, form)
    if isinstance(value, float):
        return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"
    return f"{value:,}" if isinstance(value, int) else str(value)


def markdown(heads, rows, numbers=()):
    """A table; columns in `numbers` stand on the right."""
    rules = ["--:" if head in numbers else "---" for head in heads]
    return "\n".join("| " + " | ".join(line) + " |" for line in [heads, rules, *rows])


class Figures:
    """Figures of reports; `missing` collects the commands that make those that are not there."""

    def __init__(self, root):
        self.reports, self.missing = reports.Reports(root), []

    def _value(self, request, more):
        """(value, FORMAT) of REPORT FIELD[:FORMAT] KEY=VALUE ..."""
        report, field, *rest = shlex.split(request)
        field, _, form = field.partition(":")
        return self.reports.value(report, field, {**more, **pairs(rest)}), form

    def show(self, request, **more):
        """A figure, perhaps divided by another; `more` are keys that go without saying."""
        first, *divisors = request.split(" / ")
        try:
            value, form = self._value(first, more)
            for divisor in divisors:
                other, _ = self._value(divisor, more)
                value = value / other if value is not None and other else None
        except reports.Missing as missing:
            if str(missing) not in self.missing:
                self.missing.append(str(missing))
            return f"(`{missing}`)"
        return shown(value, form)


class AnyFigures:
    """In place of figures, where only the rest of the text is of interest."""

    def show(self, request, **more):
        return _FIGURE


class Datasheet:
    def __init__(self, root, figures):
        self.root, self.figures = pathlib.Path(root), figures
        self.sources = rtl.Sources(root)
        self.rows = configurations.read(self.root / "rtl" / "configurations.csv")
        self.registers = registers.read(self.root)

    def text(self):
        template = (self.root / TEMPLATE).read_text(encoding="utf-8")
        return f"<!-- {GENERATED} -->\n" + _PLACE.sub(self._put_in, template)

    def _put_in(self, match):
        first, *lines = match.group(1).rstrip("\n").split("\n")
        word, *words = first.split()
        blocks = {"parameters": self._parameters, "ports": self._ports, "rows": self._rows}
        if word in blocks:
            return blocks[word](words, lines)
        if word == "registers":
            return "\n".join(register_texts.summary_lines(self.registers))
        if word == "version":
            return str(version.read(self.root))
        return self.figures.show(first)

    def _meanings(self, lines):
        """[(name, meaning)]"""
        return [tuple(part.strip() for part in line.split(":", 1)) for line in lines]

    def _matched(self, top, names, lines):
        """name -> meaning, one each; every line must be of use."""
        found, used = {}, set()
        for name in names:
            for pattern, meaning in self._meanings(lines):
                if name == pattern or pattern[-1] == "*" and name.startswith(pattern[:-1]):
                    found.setdefault(name, meaning)
                    used.add(pattern)
            if name not in found:
                raise DatasheetError(f"{TEMPLATE}: {top}.{name} has no meaning")
        for pattern, _ in self._meanings(lines):
            if pattern not in used:
                raise DatasheetError(f"{TEMPLATE}: {top} has no {pattern}")
        return found

    def _parameters(self, words, lines):
        header = module_header.read(self.sources, words[0])
        meaning = self._matched(header.name, header.parameters, lines)
        return markdown(["parameter", "default", "meaning"], [
            [f"`{name}`", str(value), meaning[name]] for name, value in header.parameters.items()],
            ["default"])

    def _ports(self, words, lines):
        header = module_header.read(self.sources, words[0])
        meaning = self._matched(header.name, [port.name for port in header.ports], lines)
        return markdown(["port", "direction", "width", "meaning"], [
            [f"`{port.name}`", port.direction, str(port.width), meaning[port.name]]
            for port in header.ports], ["width"])

    def _rows(self, words, lines):
        wanted = pairs([word for word in words if word != "plain"])
        rows = [row for row in self.rows
                if all(str(getattr(row, key)) in value.split(",") for key, value in wanted.items())]
        if "plain" in words:
            rows = [row for row in rows if len(row.name.split("-")) == 3]
        if not rows:
            raise DatasheetError(f"{TEMPLATE}: no rows are {' '.join(words)}")
        columns = self._meanings([line.replace("|", ":", 1) for line in lines])
        numbers = [head for head, field in columns
                   if " " in field or isinstance(getattr(rows[0], field), int)]
        return markdown([head for head, _ in columns],
                        [[self._field(row, field) for _, field in columns] for row in rows],
                        numbers)

    def _field(self, row, field):
        """Of the table, or of a report's row of the same name."""
        if " " not in field:
            return str(getattr(row, field))
        return self.figures.show(field, name=row.name)


def stale(root=rtl.ROOT):
    """Lines of the document that are not what the sources say, whatever the figures."""
    path = pathlib.Path(root) / DOCUMENT
    if not path.is_file():
        return []
    present = path.read_text(encoding="utf-8").splitlines()
    wanted = Datasheet(root, AnyFigures()).text().splitlines()
    cure = "run make docs"
    for number, (line, form) in enumerate(zip(present, wanted), 1):
        if not re.fullmatch(re.escape(form).replace(re.escape(_FIGURE), r"[^|]+"), line):
            return [f"{DOCUMENT}:{number}: not what {TEMPLATE} and the sources say: {cure}"]
    if len(present) != len(wanted):
        return [f"{DOCUMENT}: {len(present)} lines, {len(wanted)} wanted: {cure}"]
    return []


def write(root, partial, keep):
    """Writes the document; the exit status. Says which reports are missing."""
    figures = Figures(root)
    text = Datasheet(root, figures).text()
    for command in figures.missing:
        print(f"datasheet.py: figures are missing: {command}", file=sys.stderr)
    if not figures.missing or partial:
        configurations.write_if_changed(pathlib.Path(root) / DOCUMENT, text)
        print(f"wrote {DOCUMENT}")
        return 0
    print(f"datasheet.py: {DOCUMENT} left as it was", file=sys.stderr)
    return 0 if keep else 1


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Makes the datasheet, or checks it.")
    parser.add_argument("--root", type=pathlib.Path, default=rtl.ROOT, help="checkout to work on")
    parser.add_argument("--partial", action="store_true",
                        help="write: in place of a missing figure the command that makes it")
    parser.add_argument("--keep", action="store_true",
                        help="write: no fault if the document stays as it is, as figures are missing")
    parser.add_argument("command", choices=("write", "check"))
    options = parser.parse_args(arguments)
    try:
        if options.command == "write":
            return write(options.root, options.partial, options.keep)
        found = stale(options.root)
    except (tables.TableError, module_header.HeaderError,
            reports.RequestError, DatasheetError, OSError) as error:
        found = [str(error)]
    for line in found:
        print(f"datasheet.py: {line}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
