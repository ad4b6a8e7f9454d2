"""Which unit is busy in which clock of a vertex, at both schedules:
organizations/ORGANIZATION.svg.

SPDX-License-Identifier: Apache-2.0
"""

import pandas
from matplotlib import pyplot
from matplotlib.ticker import MaxNLocator

from lab.figures.charts import save
from tools.tables import organizations

COLOURS = ("#0060a8", "#e08000", "#2a8000", "#a03060")  # of vertices that follow each other
SCHEDULES = ("paper", "overlapped")
UNITS = 8  # of an organization that may have any number


def runs(lane, clocks):
    """(first clock, clocks, vertex) of each run in which the last operation to enter is of one
    vertex.
    """
    busy = pandas.Series([-1] * clocks)
    for begin, end, vertex in lane["spans"]:
        busy[begin:end] = vertex
    run = (busy != busy.shift()).cumsum()
    return [(part.index[0], len(part), int(part.iloc[0])) for _, part in busy.groupby(run)
            if part.iloc[0] >= 0]


def in_order(lanes):
    """{vertex: which of them it is}: those that follow each other have different colours."""
    return {vertex: number for number, vertex in enumerate(dict.fromkeys(
        span[2] for lane in lanes for span in sorted(lane["spans"])))}


def panel(axes, row):
    lanes = row["lanes"]
    numbers = in_order(lanes)
    for line, lane in enumerate(lanes):
        bars = {}
        for first, length, vertex in runs(lane, row["clocks"]):
            bars.setdefault(COLOURS[numbers[vertex] % len(COLOURS)], []).append((first, length))
        for colour, places in bars.items():
            axes.broken_barh(places, (line - 0.4, 0.8), linewidth=0, facecolors=colour)
    axes.axvline(row["first_done"], color="black", linewidth=1)
    axes.annotate("first vertex done", (row["first_done"], -0.6), (-3, 2), ha="right",
                  textcoords="offset points", fontsize=8)
    axes.set_yticks(range(len(lanes)), [lane["name"] for lane in lanes])
    axes.set(xlim=(0, row["clocks"]), ylim=(len(lanes) - 0.4, -1.2), title=row["name"])
    axes.xaxis.set_major_locator(MaxNLocator(12, integer=True))
    axes.grid(axis="y", visible=False)


def shown(rows):
    """Those of organizations that there are; of one of any number of units one, if it is there."""
    rows = [row for row in rows if row["org"] in organizations.known()]
    free = {row["org"] for row in rows if row["n"] == UNITS}
    return [row for row in rows if row["org"] not in free or row["n"] == UNITS]


def draw(reports, folder):
    kinds = {}
    for row in shown(reports.rows("timelines")):
        name = organizations.label(row, "").replace("/", "-")
        kinds.setdefault(name, {}).setdefault(row["schedule"], row)  # of several the first
    written = []
    for name, by_schedule in kinds.items():
        rows = [by_schedule[schedule] for schedule in SCHEDULES if schedule in by_schedule]
        heights = [len(row["lanes"]) + 3 for row in rows]
        figure, grid = pyplot.subplots(len(rows), 1, figsize=(11, 0.22 * sum(heights) + 0.4),
                                       height_ratios=heights, squeeze=False, layout="constrained")
        for axes, row in zip(grid.flat, rows):
            panel(axes, row)
        grid.flat[-1].set_xlabel("clock cycles from the start of the first vertex; a colour is a "
                                 "vertex, white is idle")
        written.append(save(figure, folder / "organizations" / f"{name}.svg"))
    return written
