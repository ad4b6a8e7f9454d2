"""Reports of one folder, each read once: those of a release, docs/results/VERSION, which the laboratory has
measured on one commit, or those that commands have just written, build/reports.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import re

RELEASED, FRESH = "docs/results", "build/reports"
RELEASE = "release.json"  # of a release whose results are whole: its version, commit and studies
# The field with the rows of a report, where it is not `rows`.
ROWS = {"bfp": "errors", "boards": "boards", "dma": "runs", "formal": "properties", "glapi": "commands",
        "plates": "plates", "sim": "runs", "structure": "designs", "tests": "suites"}
_VERSION = re.compile(r"\d+\.\d+\.\d+")


class Missing(Exception):
    """A figure that no report has, in one line."""


class RequestError(Exception):
    """A request that no report can answer, in one line."""


def read(path):
    """Raises RequestError for what is no report."""
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
        if not isinstance(content, dict):
            raise ValueError("no object")
        return content
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


def versions(root):
    """Those whose results are whole, the newest last."""
    names = [path.parent.name for path in (pathlib.Path(root) / RELEASED).glob(f"*/{RELEASE}")
             if _VERSION.fullmatch(path.parent.name)]
    return sorted(names, key=lambda name: [int(part) for part in name.split(".")])


def released(root, version="", modules=()):
    """The results of a version, or of the newest. Raises RequestError where there are none."""
    known = versions(root)
    if not known or version and version not in known:
        raise RequestError(f"{version or RELEASED} has no results: " + (
            f"one of {', '.join(known)}, or make -C lab results" if known else "make -C lab results"))
    return Results(root, f"{RELEASED}/{version or known[-1]}", modules)


class Results:
    """Those of one folder of a checkout. `modules` has by name what makes tables and figures of a report,
    for texts (text_blocks.py)."""

    def __init__(self, root, folder=FRESH, modules=()):
        self.root = pathlib.Path(root)
        self.folder = self.root / folder
        self.fresh = folder == FRESH
        self.modules = dict(modules)
        self._read = {}

    def path(self, name):
        """Where a report lies."""
        return self.folder / f"{name}.json"

    def has(self, name):
        return self.path(name).is_file()

    def get(self, name):
        """A whole report. Raises Missing and RequestError."""
        if not self.has(name):
            raise Missing(f"{self.path(name).relative_to(self.root)} is not there")
        if name not in self._read:
            self._read[name] = read(self.path(name))
        return self._read[name]

    def rows(self, name, /, **wanted):
        """Its rows, those that are as wanted; fields may be given as KEY! to exclude. A module without a
        report may have rows of its own."""
        own = getattr(self.modules.get(name), "rows", None)
        entries = own(self) if own and not self.has(name) else self.get(name).get(ROWS.get(name, "rows"))
        if not isinstance(entries, list) or not entries:
            raise RequestError(f"{name} has no rows")
        return [row for row in entries if is_wanted(row, wanted)]

    def figure(self, name, field):
        """A field at the top of a report, or a figure that follows from it."""
        derived = getattr(self.modules.get(name), "FIGURES", {})
        if field in derived:
            return derived[field](self)
        try:
            return lookup(self.get(name), field)
        except KeyError:
            raise RequestError(f"{name}.json has no {field}") from None
