"""A drawing of a core: its blocks in the order in which data flows, boxed by what they belong to.

SVG without colours of its own: `currentColor`, and classes that a page styles. A block is the element
block-ID. It is narrow, so that its text can be read on a telephone.

SPDX-License-Identifier: Apache-2.0
"""

from collections import Counter
from dataclasses import dataclass
from xml.sax.saxutils import escape, quoteattr

WIDTH = 480
MARGIN = 10      # around a group, and within it
LABEL = 24       # height of a group's name
LEFT = 28        # of the first block, with room for wires
BOX = (128, 44)  # of a block
GAP = (22, 16)   # between blocks
A_ROW = 3


@dataclass(frozen=True)
class Place:
    """Where a block is: row and column of all, and its upper left corner."""
    row: int
    column: int
    x: int
    y: int


class _Canvas:
    def __init__(self):
        self.parts = []

    def box(self, name, x, y, width, height, rounding):
        self.parts.append(f'<rect class="{name}" x="{x}" y="{y}" width="{width}" height="{height}" '
                          f'rx="{rounding}" fill="none" stroke="currentColor"/>')

    def text(self, name, x, y, text, anchor="middle"):
        self.parts.append(f'<text class="{name}" x="{x}" y="{y}" text-anchor="{anchor}" '
                          f'fill="currentColor">{escape(text)}</text>')

    def arrow(self, *points):
        """A line with right angles, and a head where it ends."""
        (x0, y0), (x, y) = points[-2:]
        along = ((x > x0) - (x < x0), (y > y0) - (y < y0))
        back = (x - 6 * along[0], y - 6 * along[1])
        wings = [(back[0] + side * along[1], back[1] + side * along[0]) for side in (4, -4)]
        line = "L".join(f"{a} {b}" for a, b in points)
        head = f"M{wings[0][0]} {wings[0][1]}L{x} {y}L{wings[1][0]} {wings[1][1]}"
        self.parts.append(f'<path class="wire" d="M{line}{head}" fill="none" stroke="currentColor"/>')


class _Wires:
    """Wires run over the blocks of a row, or down between rows and columns, where each has a lane."""

    def __init__(self, canvas):
        self.canvas = canvas
        self.used = Counter()

    def _lane(self, *channel):
        self.used[channel] += 1
        return 4 * ((self.used[channel] - 1) % 3)

    def draw(self, source, target):
        middle, half = BOX[0] // 2, BOX[1] // 2
        bottom = source.y + BOX[1]
        if source.row == target.row and target.column == source.column + 1:
            self.canvas.arrow((source.x + BOX[0], source.y + half), (target.x, target.y + half))
        elif source.row == target.row:
            over = source.y - 4
            self.canvas.arrow((source.x + middle + 20, source.y), (source.x + middle + 20, over),
                              (target.x + middle, over), (target.x + middle, target.y))
        elif source.column == target.column and target.row == source.row + 1:
            self.canvas.arrow((source.x + middle, bottom), (target.x + middle, target.y))
        else:
            low = bottom + 4 + self._lane("below", source.row) // 2
            lane = target.x - 14 + self._lane("beside", target.column)
            self.canvas.arrow((source.x + middle, bottom), (source.x + middle, low), (lane, low),
                              (lane, target.y + 10), (target.x, target.y + 10))


def _place(groups):
    """{id: Place}, [(group, y, height)] from the top, and the height of all."""
    places, frames, y, row = {}, [], MARGIN, 0
    for group, blocks in groups:
        rows = -(-len(blocks) // A_ROW)
        for i, block in enumerate(blocks):
            places[block.id] = Place(row + i // A_ROW, i % A_ROW,
                                     LEFT + i % A_ROW * (BOX[0] + GAP[0]),
                                     y + LABEL + i // A_ROW * (BOX[1] + GAP[1]))
        height = LABEL + rows * BOX[1] + (rows - 1) * GAP[1] + MARGIN
        frames.append((group, y, height))
        y, row = y + height + GAP[1], row + rows
    return places, frames, y - GAP[1] + MARGIN


def _draw_block(canvas, block, place):
    canvas.parts.append(f'<g id="block-{block.id}" class="block" data-module={quoteattr(block.module)}>')
    canvas.parts.append(f"<title>{escape(block.described)}</title>")
    canvas.box("body", place.x, place.y, *BOX, 4)
    count = f" x {block.count}" if block.count > 1 else ""
    canvas.text("name", place.x + BOX[0] // 2, place.y + 27, block.title + count)
    canvas.parts.append("</g>")


def svg(title, groups):
    """The drawing of [(group, [block, ...])]."""
    places, frames, height = _place(groups)
    canvas = _Canvas()
    for group, y, tall in frames:
        canvas.parts.append(f'<g class="group" data-group={quoteattr(group)}>')
        canvas.box("frame", MARGIN, y, WIDTH - 2 * MARGIN, tall, 6)
        canvas.text("group-name", LEFT, y + 17, group, "start")
        canvas.parts.append("</g>")
    blocks = [block for _, inside in groups for block in inside]
    wires = _Wires(canvas)
    for block in blocks:
        for source in block.sources:
            wires.draw(places[source], places[block.id])
    for block in blocks:
        _draw_block(canvas, block, places[block.id])
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" role="img" '
            f'aria-label={quoteattr(title)} font-family="sans-serif" font-size="15">\n'
            + "\n".join(canvas.parts) + "\n</svg>\n")
