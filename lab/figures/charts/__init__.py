"""Pictures, a module each: draw(reports, folder) writes SVG and returns the files.

Letters are drawn as paths, and neither date nor chance is in a file: the same reports give the same
bytes.

SPDX-License-Identifier: Apache-2.0
"""

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams.update({
    "svg.hashsalt": "hwffd", "svg.fonttype": "path", "font.family": "DejaVu Sans",
    "font.size": 9, "axes.titlesize": 11, "axes.titlelocation": "left", "axes.grid": True,
    "axes.axisbelow": True, "grid.color": "#dddddd", "grid.linewidth": 0.8,
    "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False,
    "legend.fontsize": 8, "figure.facecolor": "white",
})

BLUE, RED, GREEN, PURPLE = "#0060a8", "#c04000", "#2a8000", "#7a30a0"
TEAL, BLACK, GREY, LIGHT = "#008080", "#222222", "#666666", "#bbbbbb"


def save(figure, path):
    """Writes a figure and closes it; the file."""
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, format="svg", metadata={"Date": None, "Creator": None})
    matplotlib.pyplot.close(figure)
    return path


import matplotlib.pyplot  # noqa: E402  pylint: disable=wrong-import-position
