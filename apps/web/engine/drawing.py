"""A drawing of a core: its blocks in the order in which data flows, boxed by what they belong to.

SVG without colours of its own: `currentColor`, and classes that a page styles. A block is the element
block-ID. It is narrow, so that its text can be read on a telephone.

SPDX-License-Identifier: Apache-2.0
"""

from xml.sax.saxutils import escape, quoteattr

WIDTH = 480
MARGIN = 10      # around a group, and within it
LABEL = 24       # height of a group's name
BOX = (132, 44)  # of a block
GAP = (22, 16)   # between blocks
A_ROW = 3


class _Canvas:
    def __init__(self):
        self.parts = []

    def box(self, name, x, y, width, height, rounding):
        self.parts.append(f'<rect class="{name}" x="{x}" y="{y}" width="{width}" height="{height}" '
                          f'rx="{rounding}" fill="none" stroke="currentColor"/>')

    def text(self, name, x, y, text, anchor):
        self.parts.append(f'<text class="{name}" x="{x}" y="{y}" text-anchor="{anchor}" '
                          f'fill="currentColor">{escape(text)}</text>')

    def arrow(self, points):
        """A line with right angles, with a head at its end, to the right or down."""
        (x0, y0), (x, y) = points[-2:]
        head = f"M{x - 6} {y - 4}L{x} {y}L{x - 6} {y + 4}" if x > x0 else (
            f"M{x - 4} {y - 6}L{x} {y}L{x + 4} {y - 6}" if y > y0 else "")
        line = "M" + "L".join(f"{a} {b}" for a, b in points)
        self.parts.append(f'<path class="wire" d="{line}{head}" fill="none" stroke="currentColor"/>')


def _place(groups):
    """[(group, y, height, [(block, x, y)])] from the top, and the height of all."""
    placed, y = [], MARGIN
    for group, blocks in groups:
        rows = -(-len(blocks) // A_ROW)
        height = LABEL + rows * BOX[1] + (rows - 1) * GAP[1] + MARGIN
        at = [(block, 2 * MARGIN + (i % A_ROW) * (BOX[0] + GAP[0]),
               y + LABEL + i // A_ROW * (BOX[1] + GAP[1])) for i, block in enumerate(blocks)]
        placed.append((group, y, height, at))
        y += height + GAP[1]
    return placed, y - GAP[1] + MARGIN


def _wires(canvas, blocks):
    """From each block to the next: along a row, or back to the start of the next one."""
    for (_, x0, y0), (_, x1, y1) in zip(blocks, blocks[1:]):
        middle = BOX[1] // 2
        if y0 == y1:
            canvas.arrow([(x0 + BOX[0], y0 + middle), (x1, y1 + middle)])
            continue
        turn = y1 - GAP[1] // 2
        canvas.arrow([(x0 + BOX[0] // 2, y0 + BOX[1]), (x0 + BOX[0] // 2, turn),
                      (x1 + BOX[0] // 2, turn), (x1 + BOX[0] // 2, y1)])


def _block(canvas, block, x, y):
    canvas.parts.append(f'<g id="block-{block.id}" class="block" data-module={quoteattr(block.module)}>')
    canvas.parts.append(f"<title>{escape(block.described)}</title>")
    canvas.box("body", x, y, *BOX, 4)
    count = f" x {block.count}" if block.count > 1 else ""
    canvas.text("name", x + BOX[0] / 2, y + 27, block.title + count, "middle")
    canvas.parts.append("</g>")


def svg(title, groups):
    """The drawing of [(group, [block, ...])]."""
    placed, height = _place(groups)
    canvas = _Canvas()
    for group, y, tall, blocks in placed:
        canvas.parts.append(f'<g class="group" data-group={quoteattr(group)}>')
        canvas.box("frame", MARGIN, y, WIDTH - 2 * MARGIN, tall, 6)
        canvas.text("group-name", 2 * MARGIN, y + 17, group, "start")
        canvas.parts.append("</g>")
    _wires(canvas, [block for _, _, _, blocks in placed for block in blocks])
    for _, _, _, blocks in placed:
        for block, x, y in blocks:
            _block(canvas, block, x, y)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" role="img" '
            f'aria-label={quoteattr(title)} font-family="sans-serif" font-size="15">\n'
            + "\n".join(canvas.parts) + "\n</svg>\n")
