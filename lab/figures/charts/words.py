"""Error against word length, measured and proved: docs/words.svg.

SPDX-License-Identifier: Apache-2.0
"""

import pandas
from matplotlib import pyplot

from lab.figures.charts import BLACK, BLUE, GREEN, GREY, PURPLE, RED, save
from lab.figures.studies.words import HALF_PIXEL, PICTURE_WIDTH, is_fixed

CURVES = (  # field, name, style
    ("bound", "bound, proved", {"alpha": 0.45}), ("max_error", "largest", {}),
    ("rms_error", "root mean square", {"linestyle": ":"}))


def level(axes, value, name, colour, up):
    axes.axhline(value, color=colour, linestyle="--", linewidth=1.2)
    axes.annotate(name, (1.01, value), (0, up), xycoords=("axes fraction", "data"),
                  textcoords="offset points", va="center", color=colour, fontsize=8)


def draw(reports, folder):
    rows = reports.rows("words")
    frame = pandas.DataFrame(rows)
    fixed = frame[[is_fixed(row) for row in rows]]
    figure, axes = pyplot.subplots(figsize=(8.8, 5.4), layout="constrained")
    axes.set_yscale("log")
    for (form, curve), colour in zip(fixed.groupby("form", sort=False),
                                     (BLUE, RED, GREEN, PURPLE)):
        for field, name, style in CURVES:
            axes.plot(curve["word_length"], curve[field], color=colour, linewidth=1.8,
                      label=f"{form} form, {name}", **style)
    level(axes, HALF_PIXEL, f"half a pixel of {PICTURE_WIDTH:,}", GREY, 0)
    for name, words, up in (("fp32-sequential", "binary32, largest", 5),
                            ("fp32-tree", "binary32 tree, largest", -5)):
        for error in frame[frame["format"] == name]["max_error"]:
            level(axes, error, words, BLACK, up)
    axes.set(xlabel="word length in bits (fixed point)", title="Error against double precision, "
             "uniform cubic B-spline", ylabel="error of a component, points in [-1, 1)")
    axes.set_xticks(range(12, 33, 2))
    axes.legend(loc="lower left")
    return [save(figure, folder / "words.svg")]
