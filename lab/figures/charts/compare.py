"""Vertices a second of programs on one core and of routed cores: docs/compare.svg.

SPDX-License-Identifier: Apache-2.0
"""

from matplotlib import pyplot
from matplotlib.lines import Line2D

from lab.figures.charts import BLACK, BLUE, GREEN, PURPLE, RED, save
from lab.figures.studies.compare import KINDS, name, pairs

COLOURS = dict(zip(KINDS, (BLUE, PURPLE, RED, GREEN, BLACK)))
MEANINGS = dict(zip(KINDS, ("hwffd on one core", "its bit-true model", "other programs, one core",
                            "routed cores", "standard cells")))


def _label(row):
    """The same core stands on several chips."""
    chip = f", {row['device'].split(',')[0]}" if row["kind"] == "core" else ""
    return name(row).replace("`", "") + chip + (" (1)" if row.get("remark") else "")


def draw(reports, folder):
    shown = pairs(reports)[::-1]
    figure, axes = pyplot.subplots(figsize=(9.5, 1.0 + 0.24 * len(shown)), layout="constrained")
    axes.set_xscale("log")
    for height, (entry, in_order) in enumerate(shown):
        colour = COLOURS[entry["kind"]]
        rates = [row["vertices_per_s"] for row in (entry, in_order)]
        axes.plot(rates, [height, height], color=colour, linewidth=1.4)
        axes.plot(rates[0], height, "o", color=colour, markersize=6, markerfacecolor="white")
        axes.plot(rates[1], height, "o", color=colour, markersize=4)
    axes.set_yticks(range(len(shown)), [_label(entry) for entry, _ in shown])
    axes.set(xlabel="vertices per second", title="16 x 16 x 16 control points, cubic B-splines")
    kinds = [kind for kind in KINDS if any(entry["kind"] == kind for entry, _ in shown)]
    handles = [Line2D([], [], color=COLOURS[kind], label=MEANINGS[kind]) for kind in kinds]
    handles += [Line2D([], [], color="black", marker="o", markerfacecolor=face, linestyle="",
                       markersize=size, label=label)
                for face, size, label in (("white", 6, "vertices in any order"),
                                          ("black", 4, "sorted by cell"))]
    figure.legend(handles=handles, loc="outside lower center", ncols=4)
    return [save(figure, folder / "compare.svg")]
