"""Flowcharts of the pages, in Mermaid, drawn by Graphviz: GitHub draws them itself, the site has pictures.

Arrows alone are read, "a --> b & c", from top to bottom (TB) or from left to right (LR).

SPDX-License-Identifier: Apache-2.0
"""

import re
import subprocess

_BLOCK = re.compile(r"^```mermaid\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_HEAD = re.compile(r"flowchart (TB|LR)$")
_ARROWS = re.compile(r"([\w-]+(?: & [\w-]+)*) --> ([\w-]+(?: & [\w-]+)*)$")
_STYLE = ('node [shape=box, style="rounded,filled", fillcolor="#e8eef8", color="#0060a8", fontname="DejaVu Sans", '
          'fontsize=11]; edge [color="#444444", arrowsize=0.7]; bgcolor="white"; pad=0.2;')


class FlowchartError(Exception):
    """A line that is not understood, or nothing to draw with."""


def dot(text):
    """The same graph for Graphviz."""
    head, *lines = [line.strip() for line in text.splitlines() if line.strip()]
    direction = _HEAD.match(head)
    if not direction:
        raise FlowchartError(f'flowchart: "{head}" is no "flowchart TB" or "flowchart LR"')
    edges = []
    for line in lines:
        arrows = _ARROWS.match(line)
        if not arrows:
            raise FlowchartError(f'flowchart: "{line}" is no "a --> b & c"')
        edges += [f'"{tail}" -> "{head}";' for tail in arrows.group(1).split(" & ")
                  for head in arrows.group(2).split(" & ")]
    return f"digraph {{ rankdir={direction.group(1)}; {_STYLE} {' '.join(edges)} }}"


def drawn(text, page):
    """The text of a page with pictures beside it in place of flowcharts."""
    numbers = iter(range(1, 100))

    def picture(block):
        name = f"{page.stem}-flowchart-{next(numbers)}.svg"
        try:
            result = subprocess.run(["dot", "-Tsvg"], input=dot(block.group(1)), stdout=subprocess.PIPE, text=True,
                                    check=True)
        except FileNotFoundError as error:
            raise FlowchartError("dot not found: run tools/install docs") from error
        (page.parent / name).write_text(result.stdout, encoding="utf-8")
        return f"![flowchart of the arrows in the text]({name})"
    return _BLOCK.sub(picture, text)
