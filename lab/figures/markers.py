"""Texts with markers: each figure and table that stands between two is put in from a report.

    <!--= EXPRESSION -->figure<!--/-->          in a line; expressions.py says what may be there

    <!-- figures: REPORT.TABLE ARGUMENT ...     lines of their own; the opening comment may go on
    LINE
    -->                                         over lines, which the table reads
    | a table |
    <!-- end figures -->

The word `text` behind the arguments makes the table one for a terminal, as a block of code.

SPDX-License-Identifier: Apache-2.0
"""

import re
import shlex
import textwrap

from figures import expressions
from figures.catalogue import module
from figures.reports import Missing, RequestError
from figures.table import Table, cell

_BLOCK = re.compile(r"^(?P<open><!-- figures: (?P<what>[^\n]*?)(?P<lines>\n(?:[^\n]*\n)*?)?"
                    r"(?(lines)-->| -->))\n(?P<inside>(?:(?!<!--)[^\n]*\n)*?)"
                    r"(?P<close><!-- end figures -->)$", re.MULTILINE)
_INLINE = re.compile(r"(?P<open><!--= (?P<what>[^\n]*?) -->)(?P<inside>[^\n]*?)(?P<close><!--/-->)")
# Whatever looks like a marker: one that the forms above do not cover is a fault.
_ANY = re.compile(r"<!-- figures:|<!-- end figures|<!--=|<!--/-->")
# Examples of markers, which stand as they are: in a block of code between fences.
_FENCE = re.compile(r"^```[^\n]*\n.*?^```$", re.MULTILINE | re.DOTALL)
_OPEN, _HIDDEN = "<!--", "\0"
_FIRST = re.compile(r"^<!--=", re.MULTILINE)


class Fault:
    """What is wrong with a marker; `unmeasured` where it is only that no report is there yet."""

    def __init__(self, text, offset, message, unmeasured=False):
        self.line, self.message = text.count("\n", 0, offset) + 1, message
        self.unmeasured = unmeasured


def rows_table(reports, report, words, lines):
    """A table of a report's rows: KEY=VALUE ... and `plain` choose them, each line is a column,
    heading | field:FORMAT, or heading | an expression over another report, joined by name.
    """
    wanted = expressions.pairs([word for word in words if word != "plain"])
    rows = reports.rows(report, **wanted)
    if "plain" in words:
        rows = [row for row in rows if len(row["name"].split("-")) == 3]
    if not rows:
        raise RequestError(f"no rows of {report} are {' '.join(words)}")
    columns = [[part.strip() for part in line.split("|", 1)] for line in lines]
    if not columns or any(len(column) != 2 for column in columns):
        raise RequestError(f"{report}.rows: each column is a line, heading | field")
    return Table([head for head, _ in columns],
                 [[_cell(reports, row, what) for _, what in columns] for row in rows])


def _cell(reports, row, what):
    if what.strip("`").partition(":")[0] in row:
        return cell(row, what)
    try:
        return expressions.written(reports, what, {"name": row["name"]})
    except Missing:
        if reports.has(what.split(".")[0]):
            return "-"  # the other report has no such row
        raise


def table(reports, what, lines=()):
    """The Table that a marker asks for. Raises Missing and RequestError."""
    name, *words = shlex.split(what)
    report, dot, kind = name.partition(".")
    found = module(report)
    if not dot or found is None:
        raise RequestError(f"'{name}' is not REPORT.TABLE")
    if kind == "rows":
        return rows_table(reports, report, words, lines)
    if kind not in found.TABLES:
        raise RequestError(f"{report} has no table '{kind}': one of "
                           f"{', '.join([*found.TABLES, 'rows'])}")
    try:
        return found.TABLES[kind](reports, *words, **({"lines": lines} if lines else {}))
    except TypeError as error:
        raise RequestError(f"'{what}': {error}") from error


def _block(reports, match):
    lines = [line for line in (match["lines"] or "").splitlines() if line.strip()]
    what = match["what"]
    if what.endswith(" text"):
        return "\n\n" + textwrap.indent(table(reports, what[:-5], lines).text(), " " * 4) + "\n\n"
    return "\n" + table(reports, what, lines).markdown() + "\n"


def _inline(reports, match):
    return expressions.written(reports, match["what"])


def fill(text, reports):
    """(the text with its figures put in, faults). Where there is no figure the text stays."""
    faults = []
    text = _FENCE.sub(lambda match: match.group().replace(_OPEN, _HIDDEN), text)

    def put_in(make):
        def replace(match):
            try:
                made = make(reports, match)
            except Missing as missing:
                faults.append(Fault(match.string, match.start(), f"no report yet: {missing}", True))
                return match.group()
            except (RequestError, ValueError, KeyError) as error:
                faults.append(Fault(match.string, match.start(), str(error)))
                return match.group()
            return match["open"] + made + match["close"]
        return replace

    for form, make in ((_BLOCK, _block), (_INLINE, _inline)):
        text = form.sub(put_in(make), text)
    rest = _INLINE.sub(_blank, _BLOCK.sub(_blank, text))
    faults += [Fault(rest, match.start(), f"a marker without its other half: {match.group()}")
               for match in _ANY.finditer(rest)]
    faults += [Fault(text, match.start(), "a figure may not begin a line: Markdown takes such a "
                     "line for HTML") for match in _FIRST.finditer(text)]
    return text.replace(_HIDDEN, _OPEN), faults


def _blank(match):
    return re.sub(r"[^\n]", " ", match.group())


def differences(before, after):
    """(line, what stands there, what the report says) of each line that differs, the first first."""
    old, new = before.splitlines(), after.splitlines()
    if len(old) != len(new):
        at = next((i for i, (a, b) in enumerate(zip(old, new)) if a != b), min(len(old), len(new)))
        return [(at + 1, old[at] if at < len(old) else "", new[at] if at < len(new) else "")]
    return [(number, a, b) for number, (a, b) in enumerate(zip(old, new), 1) if a != b]
