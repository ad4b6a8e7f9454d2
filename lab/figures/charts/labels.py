"""Names beside the marks of a chart, where they cover neither marks nor each other.

SPDX-License-Identifier: Apache-2.0
"""

from matplotlib.transforms import Bbox

# Places of a name, in points from its mark: where, and which side of the name is there.
PLACES = ((0, 6, "center", "bottom"), (-5, 3, "right", "bottom"), (5, 3, "left", "bottom"),
          (0, -6, "center", "top"), (7, 0, "left", "center"), (-7, 0, "right", "center"),
          (5, -4, "left", "top"), (-5, -4, "right", "top"), (0, 15, "center", "bottom"),
          (0, -15, "center", "top"), (8, 13, "left", "bottom"), (-8, 13, "right", "bottom"),
          (8, -13, "left", "top"), (-8, -13, "right", "top"))
RADIUS = 5  # pixels around a mark
MARGIN = 1.5  # pixels around a name


class Labels:
    """The names of one chart; all marks and lines come before the names."""

    def __init__(self, axes):
        self.axes, self.taken = axes, []
        self.renderer = axes.figure.canvas.get_renderer()

    def _pixels(self, x, y):
        return self.axes.transData.transform((x, y))

    def keep_free(self, x, y, radius=RADIUS):
        """A mark that no name may cover."""
        across, up = self._pixels(x, y)
        self.taken.append(Bbox([[across - radius, up - radius], [across + radius, up + radius]]))

    def keep_line_free(self, start, end, steps=40):
        """The same of a line between two points."""
        (left, low), (right, high) = self._pixels(*start), self._pixels(*end)
        for i in range(1, steps):
            x, y = left + (right - left) * i / steps, low + (high - low) * i / steps
            self.taken.append(Bbox([[x - 1, y - 1], [x + 1, y + 1]]))

    def _covered(self, box):
        return sum(shared.width * shared.height for shared in
                   (Bbox.intersection(box, other) for other in self.taken) if shared)

    def _extent(self, text):
        return text.get_window_extent(self.renderer).padded(MARGIN)

    def place_near(self, x, y, words, colour, above=True):
        """Puts a name at the first place that is free, else at the least covered one."""
        best = None
        for dx, dy, across, up in PLACES:
            if not above:
                dy, up = -dy, {"top": "bottom", "bottom": "top"}.get(up, up)
            text = self.axes.annotate(words, (x, y), (dx, dy), textcoords="offset points",
                                      ha=across, va=up, color=colour, fontsize=7.5)
            area = self._covered(self._extent(text))
            if best is None or area < best[0]:
                if best:
                    best[1].remove()
                best = (area, text)
            else:
                text.remove()
            if best[0] == 0:
                break
        self.taken.append(self._extent(best[1]))
        return best[1]
