"""Vertices a second against size on each target, and which rows no other beats: docs/pareto.svg.

SPDX-License-Identifier: Apache-2.0
"""

from matplotlib import pyplot

from figures.charts import BLUE, LIGHT, save
from figures.charts.labels import Labels
from figures.studies.throughput import front, targets, throughputs

COLUMNS = 2


def of_panel(found, target):
    """Those of a target that its panel can compare: with a clock, or all if none has one."""
    own = [one for one in found if one.target == target]
    return [one for one in own if one.per_second is not None] or own


def panel(axes, found):
    best = front(found)
    axes.loglog()
    axes.scatter([one.size for one in found], [one.rate for one in found], s=16, color=LIGHT)
    axes.plot([one.size for one in best], [one.rate for one in best], "o-", color=BLUE,
              markersize=4, linewidth=1)
    axes.set(title=found[0].target, xlabel=found[0].unit,
             ylabel="vertices per second" if found[0].per_second else "vertices per clock cycle")
    axes.margins(0.12, 0.12)
    return best


def draw(reports, folder):
    found = throughputs(reports)
    names = targets(found)
    lines = -(-len(names) // COLUMNS)
    figure, grid = pyplot.subplots(lines, COLUMNS, figsize=(11, 4.2 * lines), squeeze=False,
                                   layout="constrained")
    panels = [of_panel(found, target) for target in names]
    fronts = [panel(axes, own) for axes, own in zip(grid.flat, panels)]
    for axes in grid.flat[len(names):]:
        axes.remove()
    figure.canvas.draw()
    for axes, own, best in zip(grid.flat, panels, fronts):
        labels = Labels(axes)
        for one in own:
            labels.keep_free(one.size, one.rate)
        for before, after in zip(best, best[1:]):
            labels.keep_line_free((before.size, before.rate), (after.size, after.rate))
        for one in best:
            labels.beside(one.size, one.rate, one.label, BLUE)
    return [save(figure, folder / "pareto.svg")]
