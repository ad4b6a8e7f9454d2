"""Clocks against operators, at both schedules: docs/organizations.svg.

SPDX-License-Identifier: Apache-2.0
"""

import pandas
from matplotlib import pyplot

from lab.figures.charts import BLUE, GREEN, RED, save
from lab.figures.charts.labels import Labels
from tools.reports.organization_tables import rows
from tools.tables.organizations import label


def table(reports):
    """A line a row, with its operators summed: a fused one counts two."""
    frame = pandas.DataFrame(rows(reports))
    frame["label"] = [label(row) for row in rows(reports)]
    for source, target in (("operators", "built"), ("operators_drawn", "drawn")):
        counts = pandas.DataFrame(frame[source].tolist())
        frame[target] = counts["mul"] + counts["add"] + 2 * counts["fma"]
    frame["clocks"] = frame["clocks_paper"].where(frame["schedule"] == "paper",
                                                  frame["interval_overlapped"])
    return frame


def series(frame, word, schedule, fused):
    """Of several rows of an organization the first."""
    rows = frame[(frame["format"] == word) & (frame["schedule"] == schedule)
                 & (frame["fmac"] == fused)]
    return rows.drop_duplicates("label").dropna(subset=["clocks"])


def draw(reports, folder):
    frame = table(reports)
    # Of one format, because the others have the same operators and clocks.
    word = "fx18" if "fx18" in set(frame["format"]) else frame["format"].iloc[0]
    paper = series(frame, word, "paper", False)
    drawn = (  # points, field of their operators, name, colour, hollow, names above or below
        (paper, "drawn", "paper's schedule, units as drawn", RED, True, None),
        (paper, "built", "paper's schedule, as built", RED, False, True),
        (series(frame, word, "overlapped", False), "built", "overlapped", BLUE, False, False),
        (series(frame, "fp32", "paper", True), "built", "paper's schedule, fused, binary32", GREEN,
         False, None))
    figure, axes = pyplot.subplots(figsize=(9, 6.2), layout="constrained")
    axes.loglog()
    for points, field, name, colour, hollow, _ in drawn:
        if len(points):
            axes.scatter(points[field], points["clocks"], s=28, label=name, edgecolors=colour,
                         facecolors="white" if hollow else colour, linewidths=1.3, zorder=3)
    axes.set(xlim=(6, 2000), ylim=(0.7, 1000), ylabel="clock cycles per vertex, counted in RTL",
             xlabel="operators: multipliers + adders (a fused one counts two)",
             title=f"Clock cycles against operators, {word}")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter("{x:,.0f}")
    axes.legend(loc="upper right")
    figure.canvas.draw()
    labels = Labels(axes)
    for points, field, *_ in drawn:
        for x, y in zip(points[field], points["clocks"]):
            labels.keep_free(x, y)
    for points, field, _, colour, _, above in drawn:
        if above is not None:
            for x, y, name in zip(points[field], points["clocks"], points["label"]):
                labels.place_near(x, y, name, colour, above)
    return [save(figure, folder / "organizations.svg")]
