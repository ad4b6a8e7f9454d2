"""The pages of the site as MkDocs takes them: the texts of the project at their places, without marks,
and beside them the files that they link to.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import re
import shutil

from apps.docs import flowchart

# Folders with pages, and the pages.
FOLDERS = ("docs", "synth")
TEXTS = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "docs/**/*.md", "synth/**/README.md")

_FENCED = re.compile(r"(^```.*?^```$)", re.MULTILINE | re.DOTALL)
_OWN_LINES = re.compile(r"^<!--.*?-->\n", re.MULTILINE | re.DOTALL)
_WORDS = re.compile(r"(?<!!)\[([^\[\]]*)\]\(([^()\s#:]+)(?:#[\w-]*)?\)")
_LINK = re.compile(r"\]\(([^()\s#:]+)(?:#[\w-]*)?\)")


class PageError(Exception):
    """A page that cannot be shown; one line."""


def without_comments(text):
    """Marks of blocks and commands are comments, which readers of the site have no use for."""
    segments = _FENCED.split(text)
    segments[::2] = [_OWN_LINES.sub("", part) for part in segments[::2]]
    return "".join(segments)


def without_outside(root, path, text):
    """A link to a text that is no page of the site becomes its words."""
    def words(match):
        file = pathlib.Path(os.path.abspath(path.parent / match[2]))
        inside = file.relative_to(root).parts if root in file.parents else ()
        outside = len(inside) > 1 and inside[0] not in FOLDERS and (file.suffix == ".md" or not file.is_file())
        return match[1] if outside else match[0]

    segments = _FENCED.split(text)
    segments[::2] = [_WORDS.sub(words, part) for part in segments[::2]]
    return "".join(segments)


def linked_files(root, path):
    """Files of the checkout that a page links to or shows, other than pages."""
    text = "".join(_FENCED.split(path.read_text(encoding="utf-8"))[::2])
    for target in _LINK.findall(text):
        file = (path.parent / target).resolve()
        if file.is_file() and file.suffix != ".md" and root in file.parents:
            yield file


def pages(root):
    return [path for pattern in TEXTS for path in sorted(root.glob(pattern))]


def stage(root, target):
    """Fills `target`, from nothing; the pages written."""
    shutil.rmtree(target, ignore_errors=True)
    written = []
    for path in pages(root):
        place = target / path.relative_to(root)
        place.parent.mkdir(parents=True, exist_ok=True)
        try:
            text = without_outside(root, path, path.read_text(encoding="utf-8"))
            text = flowchart.drawn(without_comments(text), place)
        except flowchart.FlowchartError as error:
            raise PageError(f"{path.relative_to(root)}: {error}") from error
        place.write_text(text, encoding="utf-8")
        written.append(place)
        for file in linked_files(root, path):
            copy = target / file.relative_to(root)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, copy)
    return written
