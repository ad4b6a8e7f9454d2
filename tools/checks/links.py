"""Links of the texts lead somewhere: to a file, to a heading of it, to a numbered section.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import re

from tools.checks import include_rules

_LINK = re.compile(r"\]\(([^()\s]+)\)")
_HEADING = re.compile(r"^#{1,6} +(.+?) *$", re.MULTILINE)
_FENCED = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
# "numerics.md section 5", "sections 1 to 5", and the same behind a link
_SECTIONS = re.compile(r"([\w./-]+\.md)(?:#[\w-]+)?\)?,?\s+(?:[/#*]+\s+)?sections? "
                       r"(\d+)(?:(?:,| and| to) (\d+))?")


def _without_code(text):
    return _FENCED.sub(lambda match: "\n" * match.group(0).count("\n"), text)


def anchors(text):
    """Names of a document's headings as GitHub makes them: lower case, words joined by hyphens."""
    counts = {}
    for heading in _HEADING.findall(_without_code(text)):
        name = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        counts[name] = counts.get(name, -1) + 1
    return {name if i == 0 else f"{name}-{i}" for name, last in counts.items()
            for i in range(last + 1)}


def _is_hidden(tree, file):
    """Whether it would be in the laboratory, and that is not here."""
    laboratory = tree.root / include_rules.LABORATORY
    return not laboratory.exists() and laboratory in pathlib.Path(os.path.abspath(file)).parents


def dead_links(tree, path):
    """(line, message) for each link of a Markdown file to what is not there."""
    text = _without_code(tree.text(path))
    for match in _LINK.finditer(text):
        target, _, anchor = match.group(1).partition("#")
        if ":" in target:  # another site
            continue
        line = text.count("\n", 0, match.start()) + 1
        file = path.parent / target if target else path
        if not file.exists() and not _is_hidden(tree, file):
            yield line, f"link to {target}, which is not there"
        elif file.exists() and anchor and anchor not in anchors(tree.text(file)):
            yield line, f"link to {match.group(1)}: no such heading"


def missing_sections(tree, path):
    """(line, message) for each mention of a numbered section that a document does not have."""
    text = tree.text(path)
    for match in _SECTIONS.finditer(text):
        places = [tree.root / "docs" / match.group(1).rpartition("/")[2], path.parent / match.group(1)]
        file = next((place for place in places if place.is_file()), None)
        if file is None:
            continue
        for number in filter(None, match.groups()[1:]):
            if not re.search(rf"^## {number}\. ", tree.text(file), re.MULTILINE):
                line = text.count("\n", 0, match.start()) + 1
                yield line, f"{match.group(1)} has no section {number}"
