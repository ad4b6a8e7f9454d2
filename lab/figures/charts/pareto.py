"""Vertices a second against size of whole cores, and which rows no other beats: docs/pareto.svg.

SPDX-License-Identifier: Apache-2.0
"""

import dataclasses

from matplotlib import pyplot

from lab.figures.charts import BLUE, LIGHT, save
from lab.figures.charts.labels import Labels
from tools.reports.throughput import CORE, throughputs, unbeaten

TARGET = "ecp5"


def panels(reports):
    """[(title, axis, rows)]: those that have been routed by the second, all by the clock."""
    entries = [entry for entry in throughputs(reports, CORE) if entry.target == TARGET]
    routed = [entry for entry in entries if entry.per_second is not None]
    mapped = [dataclasses.replace(entry, clock_mhz=None) for entry in entries]
    both = [("routed", "vertices per second", routed),
            ("mapped", "vertices per clock cycle", mapped)]
    return [panel for panel in both if panel[2]] or both[1:]


def panel(axes, title, axis, entries):
    best = unbeaten(entries)
    axes.loglog()
    axes.scatter([entry.size for entry in entries], [entry.rate for entry in entries], s=16, color=LIGHT)
    axes.plot([entry.size for entry in best], [entry.rate for entry in best], "o-", color=BLUE,
              markersize=4, linewidth=1)
    axes.set(title=f"{CORE} on {TARGET}, {title}", xlabel="LUTs", ylabel=axis)
    axes.margins(0.12, 0.12)
    return best


def draw(reports, folder):
    shown = panels(reports)
    figure, grid = pyplot.subplots(1, len(shown), figsize=(5.5 * len(shown), 4.2), squeeze=False,
                                   layout="constrained")
    fronts = [panel(axes, *arguments) for axes, arguments in zip(grid.flat, shown)]
    figure.canvas.draw()
    for axes, (_, _, own), best in zip(grid.flat, shown, fronts):
        labels = Labels(axes)
        for entry in own:
            labels.keep_free(entry.size, entry.rate)
        for before, after in zip(best, best[1:]):
            labels.keep_line_free((before.size, before.rate), (after.size, after.rate))
        for entry in best:
            labels.place_near(entry.size, entry.rate, entry.label, BLUE)
    return [save(figure, folder / "pareto.svg")]
