"""Pictures, a module each: draw(reports, folder) writes SVG and returns the files.

Neither date nor chance is in a file: the same reports give the same bytes. Files are small, since a repository keeps
them for ever: letters are text, and places have two decimals of a point.

SPDX-License-Identifier: Apache-2.0
"""

import io
import re

import matplotlib

from tools import whole_file

matplotlib.use("Agg")
matplotlib.rcParams.update({
    "svg.hashsalt": "hwffd", "svg.fonttype": "none", "font.family": ["DejaVu Sans", "sans-serif"],
    "font.size": 9, "axes.titlesize": 11, "axes.titlelocation": "left", "axes.grid": True,
    "axes.axisbelow": True, "grid.color": "#dddddd", "grid.linewidth": 0.8,
    "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False,
    "legend.fontsize": 8, "figure.facecolor": "white",
})

BLUE, RED, GREEN, PURPLE = "#0060a8", "#c04000", "#2a8000", "#7a30a0"
TEAL, BLACK, GREY, LIGHT = "#008080", "#222222", "#666666", "#bbbbbb"


_RECTANGLE = r"M (\S+) (\S+)\nL \1 (\S+)\nL (\S+) \3\nL \4 \2\nz\n"
_ALIKE = r'<path d="[^"]*"( clip-path[^>]*)/>\n(?:<path d="[^"]*"\1/>\n)+'


def _rounded(value):
    return re.sub(r"-?\d+\.\d{3,}", lambda number: f"{round(float(number.group()), 2):g}", value.group())


def _joined(paths):
    places = "".join(re.findall(r'd="([^"]*)"', paths.group()))
    return f'<path d="{places}"{paths.group(1)}/>\n'


def small(text):
    """The same picture in fewer bytes: no metadata, numbers rounded but in what is read, neighbours of one style joined."""
    text = re.sub(r"\s*<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = re.sub(r'="[^"]*"', _rounded, text)
    text = re.sub(r"\s*\n\s*", "\n", text)
    text = re.sub(_RECTANGLE, r"M\1 \2V\3H\4V\2z", text)
    return re.sub(_ALIKE, _joined, text)


def save(figure, path):
    """Writes a figure and closes it; the file."""
    text = io.StringIO()
    figure.savefig(text, format="svg", metadata={"Date": None, "Creator": None})
    whole_file.write(path, small(text.getvalue()))
    matplotlib.pyplot.close(figure)
    return path


import matplotlib.pyplot  # noqa: E402  pylint: disable=wrong-import-position
