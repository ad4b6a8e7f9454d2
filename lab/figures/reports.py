"""Reports of one folder, each read once.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib

from figures.catalogue import REPORTS, module

COMMITTED, FRESH = "docs/reports", "build/reports"


class Missing(Exception):
    """A figure that no report has; its text is the command that makes it."""


class RequestError(Exception):
    """A request that no report can answer, in one line."""


def command(name, wanted=()):
    """The command that makes the rows in question."""
    words = [f"{key.upper()}={wanted[key]}" for key in REPORTS[name].selectors if key in wanted]
    return " ".join([REPORTS[name].command, *words])


def read(path):
    """Raises RequestError for what is no report."""
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
        if not isinstance(found, dict):
            raise ValueError("no object")
        return found
    except (OSError, ValueError) as error:
        raise RequestError(f"{path}: cannot be read: {error}") from error


def lookup(value, field):
    """A dotted field, of lists by number. Raises KeyError."""
    for part in field.split("."):
        if isinstance(value, list) and part.isdigit() and int(part) < len(value):
            value = value[int(part)]
        elif isinstance(value, dict):
            value = value[part]
        else:
            raise KeyError(field)
    return value


def is_wanted(row, wanted):
    """Whether each field is the one wanted, or one of several that commas part; KEY! negates."""
    for key, words in wanted.items():
        try:
            value = str(lookup(row, key.removesuffix("!")))
        except KeyError:
            return False
        if (value == words or value in words.split(",")) == key.endswith("!"):
            return False
    return True


class Reports:
    """Those in one folder of a checkout."""

    def __init__(self, root, folder=COMMITTED):
        self.root = pathlib.Path(root)
        self.folder = self.root / folder
        self.fresh = folder == FRESH
        self._read = {}

    def path(self, name):
        """Where a report lies: fresh ones under the name that their command gives them."""
        file = REPORTS[name].written if self.fresh and REPORTS[name].written else name
        return self.folder / f"{file}.json"

    def has(self, name):
        return self.path(name).is_file()

    def get(self, name):
        """A whole report. Raises Missing and RequestError."""
        if name not in REPORTS:
            raise RequestError(f"no report '{name}': one of {', '.join(REPORTS)}")
        if not self.has(name):
            raise Missing(command(name))
        if name not in self._read:
            self._read[name] = read(self.path(name))
        return self._read[name]

    def rows(self, name, /, **wanted):
        """Its rows, those that are as wanted; fields may be given as KEY! to exclude."""
        if name not in REPORTS:
            found = getattr(module(name), "rows", lambda _: [])(self) if module(name) else []
        else:
            found = self.get(name).get(REPORTS[name].rows)
        if not isinstance(found, list) or not found:
            raise RequestError(f"{name} has no rows")
        return [row for row in found if is_wanted(row, wanted)]

    def older(self, name):
        """How many rows were kept beside a part that was measured anew (measure.with_older)."""
        return sum(bool(row.get("older")) for row in self.get(name).get(REPORTS[name].rows) or [])

    def figure(self, name, field):
        """A field at the top of a report, or a figure that follows from it."""
        derived = getattr(module(name), "FIGURES", {}) if module(name) else {}
        if field in derived:
            return derived[field](self)
        if name not in REPORTS:
            raise RequestError(f"{name} has no {field}")
        try:
            return lookup(self.get(name), field)
        except KeyError:
            raise RequestError(f"{name}.json has no {field}") from None
