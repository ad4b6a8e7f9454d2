"""What the tutorial shows of the method, from no report: docs/tutorial/*.svg.

SPDX-License-Identifier: Apache-2.0
"""

import numpy
from matplotlib import pyplot

from lab.figures.charts import BLUE, GREEN, GREY, LIGHT, PURPLE, RED, save

COLOURS = (BLUE, RED, GREEN, PURPLE)
VERTEX = (2.5, 1.6)  # in two dimensions, in cells of control points


def spline(x):
    """The four functions of a cubic B-spline."""
    return ((1 - x) ** 3 / 6, (3 * x**3 - 6 * x**2 + 4) / 6, (-3 * x**3 + 3 * x**2 + 3 * x + 1) / 6, x**3 / 6)


def curve(heights):
    """Places and heights of equation (1) along one axis, for control points one apart."""
    x = numpy.linspace(0, 1, 41)
    places = [cell + 1 + x for cell in range(len(heights) - 3)]
    values = [sum(h * w for h, w in zip(heights[cell:], spline(x))) for cell in range(len(heights) - 3)]
    return numpy.concatenate(places), numpy.concatenate(values)


def equation(path):
    """A control point is moved, and the curve follows nearby."""
    figure, axes = pyplot.subplots(figsize=(7, 2.8), layout="constrained")
    rest, moved = [0.0] * 8, [0.0] * 8
    moved[4] = 1.0
    for heights, colour, name in ((rest, LIGHT, "at rest"), (moved, BLUE, "deformed")):
        axes.plot(*curve(heights), color=colour, linewidth=2, label=f"what lies in the lattice, {name}")
    axes.plot(range(8), moved, "o--", color=RED, linewidth=0.8, markersize=6, label="control points")
    axes.set(xticks=range(8), xlabel="along the axis, in cells", ylim=(-0.15, 1.2),
             title="One control point is moved by 1; what lies below it follows by 2/3")
    axes.legend(loc="upper right")
    return save(figure, path)


def weights(path):
    figure, axes = pyplot.subplots(figsize=(7, 3.2), layout="constrained")
    x = numpy.linspace(0, 1, 101)
    for number, (values, colour) in enumerate(zip(spline(x), COLOURS)):
        axes.plot(x, values, color=colour, linewidth=2, label=f"B_{number}")
    axes.plot(x, sum(spline(x)), color=GREY, linestyle="--", label="their sum")
    axes.axvline(0.3, color="black", linewidth=0.8)
    axes.set(xlabel="s", xlim=(0, 1), ylim=(0, 1.1), title="The weights of a cubic B-spline; a line at s = 0.3")
    axes.legend(loc="center right")
    return save(figure, path)


def cell(path):
    """A vertex, its cell and the 4 x 4 points that move it, of a lattice of two dimensions."""
    figure, axes = pyplot.subplots(figsize=(5, 5), layout="constrained")
    first = [int(place) - 1 for place in VERTEX]  # of its points
    axes.add_patch(pyplot.Rectangle([place + 1 for place in first], 1, 1, facecolor="#ffe0b0"))
    for i in range(6):
        for j in range(6):
            near = all(0 <= n - low < 4 for n, low in zip((i, j), first))
            axes.plot(i, j, "o", color=RED if near else LIGHT, markersize=8 if near else 6)
    axes.plot(*VERTEX, "D", color=BLUE, markersize=7)
    axes.annotate("vertex", VERTEX, (6, 6), textcoords="offset points", color=BLUE)
    axes.set(xticks=range(6), yticks=range(6), xlabel="i, along s", ylabel="j, along t", aspect="equal",
             title="Cell (1, 0) and the 4 x 4 points that move its vertices")
    return save(figure, path)


def rounding(path):
    figure, axes = pyplot.subplots(figsize=(7, 3.2), layout="constrained")
    x = numpy.linspace(0, 1, 801)
    exact = spline(x)[1]
    axes.plot(x, exact, color=GREY, label="exact")
    for bits, colour in ((4, RED), (6, BLUE)):
        axes.plot(x, numpy.floor(exact * 2**bits + 0.5) / 2**bits, color=colour, linewidth=1.2,
                  label=f"rounded to {bits} bits behind the point")
    axes.set(xlabel="s", xlim=(0, 1), title="The weight B_1 in fixed point: a bit more halves the steps")
    axes.legend(loc="lower left")
    return save(figure, path)


def packet(path):
    """The beats of a packet with two vertices, a word each from right to left as on the bus."""
    rows = (("header", ("opcode 3", "count 2", "mode, results", "-")),
            ("vertex 0", ("s", "t", "u", "cell k j i, tag")), ("vertex 1, tlast", ("s", "t", "u", "cell k j i, tag")))
    figure, axes = pyplot.subplots(figsize=(7, 2.2), layout="constrained")
    for line, (name, words) in enumerate(rows):
        axes.text(-0.1, line + 0.5, name, ha="right", va="center")
        for number, word in enumerate(words):
            colour = "#e8eef8" if line else "#ffe0b0"
            axes.add_patch(pyplot.Rectangle((3 - number, line), 1, 0.9, facecolor=colour, edgecolor=GREY))
            axes.text(3.5 - number, line + 0.45, word, ha="center", va="center")
    for number in range(4):
        axes.text(3.5 - number, -0.3, f"word {number}", ha="center", va="center", color=GREY)
    axes.set(xlim=(-1.4, 4.05), ylim=(3, -0.6), title="A packet of two vertices: three beats of 128 bits")
    axes.axis("off")
    return save(figure, path)


def board(path):
    """What stands between a program and the core on a board."""
    boxes = ("host.py", "USB chip", "serial line\nffd_board_uart", "frames\nffd_board_bridge", "hwffd_stream\ncg1")
    figure, axes = pyplot.subplots(figsize=(7, 1.6), layout="constrained")
    axes.add_patch(pyplot.Rectangle((3.7, -0.2), 5.9, 1.25, facecolor="#f4f4f4", edgecolor=GREY))
    axes.text(3.95, 0.95, "FPGA", va="top", color=GREY)
    for number, name in enumerate(boxes):
        colour = "#e8eef8" if number > 1 else "#ffe0b0"
        axes.add_patch(pyplot.Rectangle((2 * number - 0.05, 0), 1.5, 0.75, facecolor=colour, edgecolor=BLUE))
        axes.text(2 * number + 0.7, 0.375, name, ha="center", va="center", fontsize=8)
        if number:
            axes.annotate("", (2 * number - 0.05, 0.375), (2 * number - 0.55, 0.375), arrowprops={"arrowstyle": "<->"})
    axes.set(xlim=(-0.2, 9.65), ylim=(-0.3, 1.15), title="A packet goes to the right, its results come back")
    axes.axis("off")
    return save(figure, path)


def draw(_, folder):
    drawings = (equation, weights, cell, rounding, packet, board)
    return [make(folder / "tutorial" / f"{make.__name__}.svg") for make in drawings]
