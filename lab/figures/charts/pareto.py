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
    found = [one for one in throughputs(reports, CORE) if one.target == TARGET]
    routed = [one for one in found if one.per_second is not None]
    mapped = [dataclasses.replace(one, clock_mhz=None) for one in found]
    both = [("routed", "vertices per second", routed),
            ("mapped", "vertices per clock cycle", mapped)]
    return [one for one in both if one[2]] or both[1:]


def panel(axes, title, axis, found):
    best = unbeaten(found)
    axes.loglog()
    axes.scatter([one.size for one in found], [one.rate for one in found], s=16, color=LIGHT)
    axes.plot([one.size for one in best], [one.rate for one in best], "o-", color=BLUE,
              markersize=4, linewidth=1)
    axes.set(title=f"{CORE} on {TARGET}, {title}", xlabel="LUTs", ylabel=axis)
    axes.margins(0.12, 0.12)
    return best


def draw(reports, folder):
    shown = panels(reports)
    figure, grid = pyplot.subplots(1, len(shown), figsize=(5.5 * len(shown), 4.2), squeeze=False,
                                   layout="constrained")
    fronts = [panel(axes, *one) for axes, one in zip(grid.flat, shown)]
    figure.canvas.draw()
    for axes, (_, _, own), best in zip(grid.flat, shown, fronts):
        labels = Labels(axes)
        for one in own:
            labels.keep_free(one.size, one.rate)
        for before, after in zip(best, best[1:]):
            labels.keep_line_free((before.size, before.rate), (after.size, after.rate))
        for one in best:
            labels.beside(one.size, one.rate, one.label, BLUE)
    return [save(figure, folder / "pareto.svg")]
