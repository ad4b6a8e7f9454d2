"""What stands in a marker: REPORT.FIELD[KEY=VALUE ...], perhaps inside sum(), max(), min() or
count(), perhaps divided by another, and how it is written: `:FORMAT`.

SPDX-License-Identifier: Apache-2.0
"""

import re
import shlex

from tools.reports.results import Missing, RequestError, lookup
from tools.reports.text_table import shown

_TERM = re.compile(r"""(?:(?P<function>sum|max|min|count)\()?
                       (?P<report>\w+)\.(?P<field>\w+(?:\.\w+)*)
                       (?:\[(?P<wanted>(?:"[^"]*"|[^\]"])*)\])?
                       (?P<closed>\))?""", re.VERBOSE)
_FUNCTIONS = {"sum": sum, "max": max, "min": min, "count": len}


def pairs(words):
    """KEY=VALUE ... as a dictionary. Raises RequestError."""
    values = {}
    for word in words:
        key, equal, value = word.partition("=")
        if not equal:
            raise RequestError(f"'{word}' is not KEY=VALUE")
        values[key] = value
    return values


def _rows(reports, report, field, wanted):
    """The field of every row that is as wanted. Raises Missing where none is."""
    rows = reports.rows(report, **wanted)
    if not rows:
        words = " ".join(f"{key}={value}" for key, value in wanted.items())
        raise Missing(f"{report}.json has no row {words}")
    try:
        return [lookup(row, field) for row in rows]
    except KeyError:
        raise RequestError(f"rows of {report} have no {field}") from None


def _term(reports, match, more):
    report, field = match["report"], match["field"]
    if bool(match["function"]) != bool(match["closed"]):
        raise RequestError(f"'{match.group()}': a bracket is missing")
    wanted = pairs(shlex.split(match["wanted"] or ""))
    if match["function"]:
        values = _rows(reports, report, field, wanted)
        return _FUNCTIONS[match["function"]]([value for value in values if value is not None])
    if match["wanted"] is None and not more:
        return reports.figure(report, field)
    values = _rows(reports, report, field, {**more, **wanted})
    if any(value != values[0] for value in values):
        raise RequestError(f"'{match.group()}': {len(values)} rows that differ")
    return values[0]


def value_and_format(reports, text, more=()):
    """The value of an expression, and its FORMAT; `more` are selectors that go without saying."""
    terms, form, at = [], "", 0
    while True:
        match = _TERM.match(text, at)
        if not match:
            raise RequestError(f"'{text}' is not REPORT.FIELD[KEY=VALUE ...]:FORMAT")
        terms.append(_term(reports, match, dict(more)))
        at = match.end()
        if text.startswith(" / ", at):
            at += 3
            continue
        rest = text[at:]
        if rest.startswith(":"):
            form = rest[1:]
        elif rest:
            raise RequestError(f"'{text}': what is '{rest}'?")
        break
    value, *divisors = terms
    for divisor in divisors:
        value = value / divisor if value is not None and divisor else None
    return value, form


def written(reports, text, more=()):
    """An expression as it stands in a text. Raises Missing and RequestError."""
    return shown(*value_and_format(reports, text.strip(), more))
