"""Figures out of build/reports/, by report, field and what the row must be.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib

# Report -> where its rows are, and the command that makes it.
REPORTS = {
    "sim": ("runs", "make sim"),
    "organizations": ("rows", "make organizations"),
    "tangents": ("rows", "make tangents"),
    "bfp": ("errors", "make bfp"),
    "synth": ("rows", "make synth"),
    "pnr": ("rows", "make pnr"),
}
# Of `make synth`: what narrows it to the rows in question.
SELECTORS = {"synth": ("target", "org", "n", "format")}


class Missing(Exception):
    """A figure that no report has; its text is the command that makes it."""


class RequestError(Exception):
    """A request that no report can answer, in one line."""


def command(report, wanted):
    """The command that makes the rows in question."""
    words = [f"{key.upper()}={wanted[key]}" for key in SELECTORS.get(report, ()) if key in wanted]
    return " ".join([REPORTS[report][1], *words])


class Reports:
    """The reports of one checkout, each read once."""

    def __init__(self, root):
        self.folder = pathlib.Path(root) / "build" / "reports"
        self._rows = {}

    def rows(self, report):
        if report not in self._rows:
            path = self.folder / f"{report}.json"
            if not path.is_file():
                return None
            try:
                self._rows[report] = json.loads(path.read_text())[REPORTS[report][0]]
            except (OSError, ValueError, KeyError, TypeError) as error:
                raise RequestError(f"{path}: cannot be read: {error!r}: {REPORTS[report][1]}") \
                    from error
        return self._rows[report]

    def value(self, report, field, wanted):
        """The field of the one row that is as wanted. Raises Missing and RequestError."""
        if report not in REPORTS:
            raise RequestError(f"no report '{report}': one of {', '.join(REPORTS)}")
        found = [row for row in self.rows(report) or ()
                 if all(str(row.get(key)) == value for key, value in wanted.items())]
        if not found:
            raise Missing(command(report, wanted))
        asked = f"{report} {field} " + " ".join(f"{k}={v}" for k, v in wanted.items())
        if field not in found[0]:
            raise RequestError(f"{asked}: rows of {report}.json have no {field}")
        if any(row[field] != found[0][field] for row in found):
            raise RequestError(f"{asked}: {len(found)} rows that differ")
        return found[0][field]
