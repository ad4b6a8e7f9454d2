"""How `walk` slides along a row: the planes that its four banks hold, clock by clock: organizations/walk-rows.svg.

Drawn from what the simulated core does, which a test of the live page's engine holds to this file.

SPDX-License-Identifier: Apache-2.0
"""

import csv

from matplotlib import pyplot
from matplotlib.ticker import MultipleLocator

from lab.figures.charts import BLACK, BLUE, GREEN, GREY, PURPLE, RED, save
from tools.project_root import ROOT

DATA = ROOT / "tests" / "web" / "engine" / "walk_rows.csv"
CELLS, IN_CELL, BANKS, PLANE = 4, 7, 4, 4  # of a row, of the core, clocks of a plane
PLANES, VERTICES = CELLS + BANKS - 1, CELLS * IN_CELL
COLOURS = (BLUE, GREEN, RED, PURPLE)  # of cells
READS, TAKEN = -1.5, BANKS + 0.5  # lines of what is read, above the banks, and of vertices


def events():
    """(clock, bank, plane) of each plane that is read, and the clock of each vertex that is taken, from the first clock on."""
    with DATA.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    first = min(int(row["clock"]) for row in rows)
    reads = [(int(row["clock"]) - first, int(row["bank"]), int(row["number"])) for row in rows if row["what"] == "read"]
    taken = [int(row["clock"]) - first for row in rows if row["what"] == "taken"]
    return reads, taken


def held(row, taken):
    """(bank, plane, cell in which it is new, first clock, end, end of that cell) of each plane of a row: from the first
    vertex that it is for until the first that no longer has it."""
    starts = [taken[VERTICES * row + IN_CELL * cell] for cell in range(CELLS)]
    starts.append(taken[VERTICES * (row + 1)] if len(taken) > VERTICES * (row + 1) else taken[-1] + 1)
    for plane in range(PLANES):
        new, last = max(0, plane - BANKS + 1), min(plane, CELLS - 1)
        yield plane % BANKS, plane, new, starts[new], starts[last + 1], starts[new + 1]


def bar(axes, line, begin, end, colour, alpha, parts=1):
    width = (end - begin) / parts
    axes.broken_barh([(begin + width * part, width) for part in range(parts)], (line - 0.38, 0.76), facecolors=colour, alpha=alpha, edgecolor="white",
                     linewidth=0.8)


def word(axes, line, begin, end, text, colour=BLACK):
    axes.text((begin + end) / 2, line, text, ha="center", va="center", fontsize=7.5, color=colour)


def draw(_, folder):
    reads, taken = events()
    rows = len(taken) // VERTICES
    figure, axes = pyplot.subplots(figsize=(11, 3.6), layout="constrained")
    for number, (clock, bank, plane) in enumerate(reads):
        if bank != plane % BANKS:
            raise ValueError(f"plane {plane} is read into bank {bank}")
        cell = max(0, plane - BANKS + 1)
        bar(axes, READS, clock, clock + PLANE, COLOURS[cell] if number < rows * PLANES else GREY, 0.9)
        word(axes, READS, clock, clock + PLANE, str(plane), "white")
    for row in range(rows):
        for bank, plane, new, begin, end, fresh in held(row, taken):
            bar(axes, bank, begin, min(fresh, end), COLOURS[new], 0.9)
            if end > fresh:
                bar(axes, bank, fresh, end, COLOURS[new], 0.25)
                word(axes, bank, fresh, end, f"{plane} stays", COLOURS[new])
            word(axes, bank, begin, min(fresh, end), f"plane {plane}", "white")
        for cell in range(CELLS):
            begin, *_, last = taken[VERTICES * row + IN_CELL * cell:][:IN_CELL]
            bar(axes, TAKEN, begin, last + 1, COLOURS[cell], 0.9, last + 1 - begin)
            word(axes, TAKEN + 0.75, begin, begin + IN_CELL, f"cell {cell}", COLOURS[cell])
        if row:
            axes.axvline(taken[VERTICES * row], color=BLACK, linewidth=1)
            axes.annotate("the next row", (taken[VERTICES * row], READS - 0.6), (3, 0), textcoords="offset points",
                          fontsize=8, va="bottom")
    lines = {READS: "planes that are read", **{bank: f"bank {bank} holds" for bank in range(BANKS)},
             TAKEN: "vertices"}
    axes.set_yticks(list(lines), list(lines.values()))
    axes.set(xlim=(0, taken[-1] + 1), ylim=(TAKEN + 1.3, READS - 1.2),
             xlabel="clock cycles from the first point that is read; strong: the plane is new, pale: it stays from the cell before",
             title=f"walk: {rows} rows of {CELLS} cells with {IN_CELL} vertices each; a cell further one plane is new")
    axes.xaxis.set_major_locator(MultipleLocator(PLANE * 2))
    axes.grid(axis="y", visible=False)
    return [save(figure, folder / "organizations" / "walk-rows.svg")]
