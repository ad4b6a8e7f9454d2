"""A tree of modules: a line a module, its instances, its share of the LUTs as a bar:
structure-TOP-ROW.svg.

SPDX-License-Identifier: Apache-2.0
"""

from matplotlib import pyplot
from matplotlib.patches import FancyBboxPatch, Rectangle

from lab.figures.charts import save
from tools.reports.structure_tables import FIELDS

# Folder of rtl/ -> colour of its modules: box, ink.
COLOURS = {
    "top": ("#e3e5e8", "#24292f"), "bus": ("#fde2c8", "#7a3b00"), "stream": ("#d8e8fb", "#0b3d7a"),
    "cache": ("#f9dbe6", "#7d1544"), "common": ("#eef0c8", "#4d4f00"),
    "evaluator": ("#d9f0dc", "#0d5220"), "number": ("#e9e0fa", "#45207f"), "scatter": ("#d3f1f3", "#0b4f55"),
}
# In pixels, 96 an inch.
LINE, TOP, LEFT, STEP = 24, 84, 16, 22
BAR_AT, BAR, COLUMN = 520, 200, 72
WIDTH = BAR_AT + BAR + 60 + COLUMN * len(FIELDS) + 16
LETTER = 7.3  # of the monospaced names
PALE, MUTED = "#f1f3f5", "#57606a"


class Sheet:
    """An area of pixels from its upper left corner."""

    def __init__(self, width, height):
        self.figure = pyplot.figure(figsize=(width / 96, height / 96))
        self.axes = self.figure.add_axes((0, 0, 1, 1))
        self.axes.set(xlim=(0, width), ylim=(height, 0))
        self.axes.axis("off")

    def text(self, x, y, words, size=9, **style):
        self.axes.text(x, y, words, fontsize=size, va="center", **style)

    def number(self, x, y, words, size=9, colour="black"):
        self.text(x, y, words, size, ha="right", color=colour)

    def box(self, x, y, width, height, colour):
        self.axes.add_patch(FancyBboxPatch((x, y), width, height, boxstyle="round,pad=0,"
                                           "rounding_size=4", facecolor=colour, linewidth=0))

    def bar(self, x, y, width, height, colour):
        self.axes.add_patch(Rectangle((x, y), width, height, facecolor=colour, linewidth=0))

    def path(self, xs, ys):
        self.axes.plot(xs, ys, color="#8c959f", linewidth=0.8)


def _title(sheet, design):
    sheet.text(LEFT, 22, f"{design['top']}, {design['row']}", 13, fontweight="bold")
    sheet.text(LEFT, 45, "Instances and area of its modules on ECP5, each mapped by itself; what is "
               "under 1 % is counted with its parent", color=MUTED)
    sheet.text(BAR_AT, TOP - 16, "share of the LUTs; dark: in no module below it", 8, color=MUTED)
    for place, head in enumerate(FIELDS.values()):
        sheet.number(_column(place), TOP - 16, head, 8, MUTED)
    x = LEFT
    for folder in (name for name in COLOURS
                   if any(module["folder"] == name for module in design["modules"])):
        fill, ink = COLOURS[folder]
        width = 8 * len(folder) + 14
        sheet.box(x, 58, width, 18, fill)
        sheet.text(x + width / 2, 67, folder, 8, ha="center", color=ink)
        x += width + 6


def _column(place):
    return WIDTH - 16 - COLUMN * (len(FIELDS) - 1 - place)


def _line(sheet, module, x, y, everything):
    """Box, instances, bar and numbers of one module."""
    fill, ink = COLOURS[module["folder"]]
    width, middle = LETTER * len(module["module"]) + 14, y + 9.5
    sheet.box(x, y, width, 19, fill)
    sheet.text(x + 7, middle, module["module"], color=ink, family="DejaVu Sans Mono")
    if module["instances"] > 1:
        sheet.text(x + width + 6, middle, f"\N{MULTIPLICATION SIGN} {module['instances']:,}")
    sheet.bar(BAR_AT, y + 3, BAR, 13, PALE)
    sheet.bar(BAR_AT, y + 3, BAR * module["lut"] / everything, 13, "#a9c7ee")
    sheet.bar(BAR_AT, y + 3, BAR * module["own_lut"] / everything, 13, "#2f6db5")
    if module["lut"]:
        sheet.number(BAR_AT + BAR + 56, middle, f"{module['lut'] / everything:.1%}")
    for place, field in enumerate(FIELDS):
        if module[field]:
            sheet.number(_column(place), middle, f"{module[field]:,}")


def picture(design):
    modules = design["modules"]
    everything = modules[0]["lut"] or 1
    sheet = Sheet(WIDTH, TOP + LINE * len(modules) + 12)
    _title(sheet, design)
    bottom = {}  # depth -> where the stem of its children begins
    for number, module in enumerate(modules):
        depth, x, y = module["depth"], LEFT + STEP * module["depth"], TOP + LINE * number
        if depth:
            stem = x - STEP + 9
            sheet.path([stem, stem, x], [bottom[depth - 1], y + 9, y + 9])
        bottom[depth] = y + 19
        _line(sheet, module, x, y, everything)
    return sheet.figure


def file_name(design):
    return f"structure-{design['top']}-{design['row'].removesuffix('-overlapped')}.svg"


def draw(reports, folder):
    """All of a fresh report, of the committed one those that documents show."""
    return [save(picture(design), folder / file_name(design))
            for design in reports.rows("structure") if design["shown"] or reports.fresh]
