"""Words that arrangements of the control points move, over the lattice's size: docs/streams.svg.

SPDX-License-Identifier: Apache-2.0
"""

import pandas
from matplotlib import pyplot
from matplotlib.ticker import NullLocator, ScalarFormatter

from lab.figures.charts import BLACK, BLUE, GREEN, GREY, PURPLE, RED, TEAL, save

COLOURS = {"interleaved": BLACK, "changed points": RED, "1 cell": PURPLE, "4 cells": BLUE,
           "16 cells": TEAL, "resident": GREEN, "packed": GREY}
DASHES = {"file": "-", "cell": "--", "curve": ":"}


def draw(reports, folder):
    frame = pandas.DataFrame(reports.rows("streams"))
    frame["points"] = frame["lattice"].str.split("x").str[0].astype(int)
    orders = frame.groupby("arrangement")["order"].nunique()
    meshes = frame.groupby("mesh", sort=False)
    figure, grid = pyplot.subplots(1, len(meshes), figsize=(4 * len(meshes) + 1.5, 4.8),
                                   sharey=True, squeeze=False, layout="constrained")
    for axes, (mesh, of_mesh) in zip(grid.flat, meshes):
        axes.set_yscale("log")
        for (arrangement, order), curve in of_mesh.groupby(["arrangement", "order"], sort=False):
            name = f"{arrangement}, by {order}" if orders[arrangement] > 1 else arrangement
            axes.plot(curve["points"], curve["words_per_vertex"], linewidth=1.6,
                      color=COLOURS[arrangement], linestyle=DASHES[order], label=name)
        axes.set(title=f"{mesh}, {of_mesh['vertices'].iloc[0]:,} vertices",
                 xlabel="control points an axis")
        axes.set_xticks(sorted(frame["points"].unique()))
        axes.set_yticks([2, 4, 10, 20, 50, 100, 200])
        axes.yaxis.set_major_formatter(ScalarFormatter())
        axes.yaxis.set_minor_locator(NullLocator())
    grid.flat[0].set_ylabel("words moved to the core per vertex")
    handles, names = grid.flat[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside right upper")
    return [save(figure, folder / "streams.svg")]
