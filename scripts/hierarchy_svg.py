"""A tree of modules as a picture: a line a module, its instances, its share of the LUTs as a bar.

Everything lies on an opaque ground, so that it reads the same on a light and on a dark page.

SPDX-License-Identifier: Apache-2.0
"""

from xml.sax.saxutils import escape

from hierarchy import FIELDS

# Folder of rtl/ -> colour of its modules: box, ink.
COLOURS = {
    "top": ("#e3e5e8", "#24292f"), "bus": ("#fde2c8", "#7a3b00"), "stream": ("#d8e8fb", "#0b3d7a"),
    "cache": ("#f9dbe6", "#7d1544"), "common": ("#eef0c8", "#4d4f00"),
    "evaluator": ("#d9f0dc", "#0d5220"), "number": ("#e9e0fa", "#45207f"),
}
HEADS = {"lut": "LUT", "ff": "FF", "dsp": "MULT18", "bram": "DP16KD"}
LINE, TOP, LEFT, STEP = 24, 84, 16, 22
BAR_AT, BAR, COLUMN = 500, 200, 72
WIDTH = BAR_AT + BAR + 60 + COLUMN * len(FIELDS) + 16


def _text(x, y, words, style=""):
    return f'<text x="{x}" y="{y}"{style}>{escape(str(words))}</text>'


def _rectangle(x, y, width, height, fill, more=""):
    return (f'<rect x="{x}" y="{y}" width="{width:.1f}" height="{height}" fill="{fill}"'
            f'{more}/>')


def _title(titles):
    out = [_text(LEFT, 30, titles[0], ' font-size="17" font-weight="bold"'),
           _text(LEFT, 50, titles[1], ' fill="#57606a"')]
    y = TOP - 14
    out.append(_text(BAR_AT, y, "share of the LUTs; dark: in no box below it",
                     ' fill="#57606a" font-size="11"'))
    for place, name in enumerate(FIELDS):
        out.append(_text(WIDTH - 16 - COLUMN * (len(FIELDS) - 1 - place), y, HEADS[name],
                         ' text-anchor="end" fill="#57606a" font-size="11"'))
    return out


def _legend(folders):
    out, x = [], LEFT
    for folder in folders:
        fill, ink = COLOURS[folder]
        width = 8 * len(folder) + 14
        out += [_rectangle(x, 58, width, 18, fill, ' rx="4"'),
                _text(x + width / 2, 71, folder,
                      f' text-anchor="middle" fill="{ink}" font-size="11"')]
        x += width + 6
    return out


def _line(node, y, x, folder, everything):
    """Box, instances, bar and numbers of one node."""
    fill, ink = COLOURS[folder]
    width = 7.4 * len(node.module) + 14
    out = [_rectangle(x, y, width, 19, fill, ' rx="4"'),
           _text(x + 7, y + 14, node.module,
                 f' fill="{ink}" font-family="monospace" font-size="12"')]
    if node.instances > 1:
        out.append(_text(x + width + 6, y + 14, f"\N{MULTIPLICATION SIGN} {node.instances:,}",
                         ' fill="#24292f"'))
    share = node.counts["lut"] / everything
    own = node.own()["lut"] / everything
    out += [_rectangle(BAR_AT, y + 3, BAR, 13, "#f1f3f5"),
            _rectangle(BAR_AT, y + 3, BAR * share, 13, "#a9c7ee"),
            _rectangle(BAR_AT, y + 3, BAR * own, 13, "#2f6db5"),
            *([_text(BAR_AT + BAR + 56, y + 14, f"{100 * share:.1f} %", ' text-anchor="end"')]
              if node.counts["lut"] else [])]
    for place, name in enumerate(FIELDS):
        if node.counts[name]:
            out.append(_text(WIDTH - 16 - COLUMN * (len(FIELDS) - 1 - place), y + 14,
                             f"{node.counts[name]:,}", ' text-anchor="end"'))
    return out


def picture(root, titles, folder_of):
    """SVG of a tree; `folder_of` says which folder of rtl/ a module is from."""
    lines = list(root.walk())
    height = TOP + LINE * len(lines) + 12
    everything = root.counts["lut"] or 1
    folders = [folder for folder in COLOURS
               if folder in {folder_of(node.module) for _, node in lines}]
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" '
           f'viewBox="0 0 {WIDTH} {height}" font-family="sans-serif" font-size="12">',
           f'<title>{escape(titles[0])}</title>',
           _rectangle(0.5, 0.5, WIDTH - 1, height - 1, "#ffffff", ' rx="8" stroke="#d0d7de"'),
           *_title(titles), *_legend(folders)]
    bottom = {}  # depth -> where the stem of its children begins
    for number, (depth, node) in enumerate(lines):
        x, y = LEFT + STEP * depth, TOP + LINE * number
        if depth:
            stem = x - STEP + 9
            out.append(f'<path d="M{stem} {bottom[depth - 1]}V{y + 9}H{x}" fill="none" '
                       'stroke="#8c959f"/>')
        bottom[depth] = y + 19
        out += _line(node, y, x, folder_of(node.module), everything)
    return "\n".join([*out, "</svg>"]) + "\n"
